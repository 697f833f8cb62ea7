// Expressions come with requests, and so do the names that they match. By default libstdc++ backtracks: some expressions then take longer
// than anybody waits, and a long name overflows the stack. Its polynomial mode follows all ways at once, and refuses back-references. For
// each character of a name it takes time that grows with the expression, so that lists of names, which grow with the robot, do without it.
#include "report/link_pattern.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>

#include "base/pattern_fault.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kLongest = 1000;        // characters: 0.3 s for a name of 1,000 bytes
constexpr int kDeepestGroup = 100;            // groups in each other: libstdc++ calls itself for each
constexpr std::size_t kMostWork = 1'000'000;  // steps of look-aheads through a name, times characters of the expression

/// Nothing for an expression that says more than names.
std::optional<std::set<std::string>> listedNames(const std::string& expression) {
  std::set<std::string> names;
  std::string name;
  for (std::size_t i = 0; i < expression.size(); ++i) {
    const char c = expression[i];
    if (c == '|') {
      names.insert(std::exchange(name, ""));
    } else if (c == '\\') {  // in front of letters and digits it has a meaning of its own
      if (++i == expression.size() || !std::ispunct(static_cast<unsigned char>(expression[i]))) return std::nullopt;
      name += expression[i];
    } else if (std::strchr("^$.*+?()[]{}", c)) {  // and the byte 0
      return std::nullopt;
    } else {
      name += c;
    }
  }
  names.insert(name);
  return names;
}

/// An upper bound on the length with repetitions, as in "[0-9]{1,3}", written out: each may hold all others. Ends above kLongest.
std::size_t writtenOut(const std::string& expression) {
  std::size_t length = expression.size(), times = 1, number = 0;
  bool in_braces = false;
  for (const char c : expression) {
    if (c == '{') in_braces = true, times = 1;
    const bool is_digit = in_braces && c >= '0' && c <= '9';
    number = is_digit ? std::min(10 * number + static_cast<std::size_t>(c - '0'), kLongest + 1) : 0;
    times = std::max(times, number);
    if (c == '}') in_braces = false, length *= std::exchange(times, 1);
    if (length > kLongest) break;
  }
  return length;
}

bool nestsTooDeep(const std::string& expression) {
  int depth = 0;
  for (const char c : expression) {
    depth += (c == '(') - (c == ')');
    if (depth > kDeepestGroup) return true;
  }
  return false;
}

std::regex compiled(const std::string& expression, const std::string& option) {
  auto syntax = std::regex::ECMAScript | std::regex::nosubs;  // else each way that is followed has copies of all groups
#ifdef __GLIBCXX__
  syntax |= std::regex_constants::__polynomial;
#endif
  if (writtenOut(expression) > kLongest)
    throw Error(ErrorCode::kBadOption, option + " has an expression of " + std::to_string(expression.size()) +
                                           " characters, which begins '" + expression.substr(0, 40) +
                                           "': with repetitions written out it may have " + std::to_string(kLongest) +
                                           "; divide it, repeat less, or list names alone, as in a|b, which may be any number");
  if (nestsTooDeep(expression))
    throw Error(ErrorCode::kBadOption, option + " has an expression with more than " + std::to_string(kDeepestGroup) +
                                           " groups in each other, which begins '" + expression.substr(0, 40) + "'; nest less");
  try {
    return std::regex(expression, syntax);
  } catch (const std::regex_error& e) {
    const std::string meant = expression.rfind('*', 0) == 0 ? didYouMeanAny(expression) : "";
    throw Error(ErrorCode::kBadOption,
                option + " '" + expression + "' is invalid: " +
                    (meant.empty() ? patternFault(e.code()) : "use a regular expression (ECMAScript, no back-references)" + meant));
  }
}

struct TooManySteps {};

/// A place in a name, whose copies share the number of steps that are left. A look-ahead reads the name from each place anew, and one
/// within another from each of those.
class Place {
 public:
  using iterator_category = std::bidirectional_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Place() = default;
  Place(const char* at, std::size_t& steps_left) : at_(at), steps_left_(&steps_left) {}

  const char& operator*() const { return *at_; }
  Place& operator++() {
    if ((*steps_left_)-- == 0) throw TooManySteps();
    ++at_;
    return *this;
  }
  Place& operator--() {
    --at_;
    return *this;
  }
  Place operator++(int) {
    const Place before = *this;
    ++*this;
    return before;
  }
  Place operator--(int) {
    const Place before = *this;
    --*this;
    return before;
  }
  bool operator==(const Place& other) const { return at_ == other.at_; }
  bool operator!=(const Place& other) const { return at_ != other.at_; }

 private:
  const char* at_ = nullptr;
  std::size_t* steps_left_ = nullptr;
};

}  // namespace

std::string didYouMeanAny(const std::string& expression) {
  std::string meant;
  char before = 0;
  for (std::size_t i = 0; i < expression.size(); ++i) {
    if (expression[i] == '*' && !(before && std::strchr(".)][", before))) meant += '.';
    before = expression[i];
    meant += before;
    if (before != '\\' || ++i == expression.size()) continue;
    meant += expression[i];
    before = ']';  // "\w" stands for several characters, as "[a-z]" does
  }
  return meant == expression ? "" : "; did you mean '" + meant + "'?";
}

LinkPattern::LinkPattern(const std::string& expression, const std::string& option) : option_(option) {
  if (std::any_of(expression.begin(), expression.end(), isControl))  // which a configuration could not hold
    throw Error(ErrorCode::kBadOption, option + " '" + shown(expression) + "' holds a control character; leave it out");
  if (std::optional<std::set<std::string>> names = listedNames(expression)) {
    compiled_ = std::move(*names);
    return;
  }
  expression_ = expression;
  compiled_ = compiled(expression, option);
}

bool LinkPattern::matches(const std::string& link) const {
  if (names()) return names()->count(link) > 0;
  std::size_t steps_left = link.size() + kMostWork / expression_.size();
  try {
    return std::regex_match(Place(link.data(), steps_left), Place(link.data() + link.size(), steps_left), std::get<std::regex>(compiled_));
  } catch (const TooManySteps&) {
    throw Error(ErrorCode::kBadOption, option_ + " '" + expression_ + "' looks ahead too often in the name '" + shown(link) +
                                           "': look ahead at the beginning alone, as in (?!.*finger).*");
  }
}

}  // namespace collision_hulls
