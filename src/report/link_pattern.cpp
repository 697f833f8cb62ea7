// Expressions come with requests, and so do the names that they match. By default libstdc++ backtracks: some expressions then take longer
// than anybody waits, and a long name overflows the stack. Its polynomial mode follows all ways at once, and refuses back-references.
#include "report/link_pattern.h"

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kLongest = 50'000;  // characters; a request may name every link
constexpr int kDeepest = 100;             // groups in each other: libstdc++ calls itself for each

bool nestsTooDeep(const std::string& expression) {
  int depth = 0;
  for (const char c : expression) {
    depth += (c == '(') - (c == ')');
    if (depth > kDeepest) return true;
  }
  return false;
}

std::regex compiled(const std::string& expression, const std::string& option) {
  auto syntax = std::regex::ECMAScript;
#ifdef __GLIBCXX__
  syntax |= std::regex_constants::__polynomial;
#endif
  if (expression.size() > kLongest)
    throw Error(ErrorCode::kBadOption, option + " has an expression of " + std::to_string(expression.size()) +
                                           " characters, which begins '" + expression.substr(0, 40) +
                                           "'; divide it, so that none has more than " + std::to_string(kLongest));
  if (nestsTooDeep(expression))
    throw Error(ErrorCode::kBadOption, option + " has an expression with more than " + std::to_string(kDeepest) +
                                           " groups in each other, which begins '" + expression.substr(0, 40) + "'; nest less");
  try {
    return std::regex(expression, syntax);
  } catch (const std::regex_error& e) {
    throw Error(ErrorCode::kBadOption,
                option + " '" + expression + "' is invalid: use a regular expression (ECMAScript, no back-references): " + e.what());
  }
}

}  // namespace

LinkPattern::LinkPattern(const std::string& expression, const std::string& option) : compiled_(compiled(expression, option)) {}

}  // namespace collision_hulls
