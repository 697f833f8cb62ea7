// A regular expression on the names of links.
#pragma once

#include <regex>
#include <set>
#include <string>
#include <variant>

namespace collision_hulls {

/// Matches whole names (ECMAScript, without back-references). An expression that is a list of names, "left_arm|right_arm", may have any
/// length and is no slower for it. Others take less than a second for a name of 1,000 bytes, whatever they say.
class LinkPattern {
 public:
  /// Throws kBadOption for what is no regular expression, and, unless it is a list of names, for one that has more than 1,000 characters
  /// with its repetitions written out, or more than 100 groups in each other. `option`: what it is called.
  LinkPattern(const std::string& expression, const std::string& option);

  /// Throws kBadOption where look-aheads would read a name too often.
  bool matches(const std::string& link) const;

  /// All that a list of names matches; nullptr for another expression.
  const std::set<std::string>* names() const { return std::get_if<std::set<std::string>>(&compiled_); }

 private:
  std::string expression_, option_;
  std::variant<std::set<std::string>, std::regex> compiled_;
};

/// "; did you mean 'wrist_.*'?" for 'wrist_*', as a shell would have it: where a star repeats nothing that it is usually told to repeat.
/// Empty for other expressions.
std::string didYouMeanAny(const std::string& expression);

}  // namespace collision_hulls
