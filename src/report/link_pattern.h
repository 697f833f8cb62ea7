// A regular expression on the names of links.
#pragma once

#include <regex>
#include <string>

namespace collision_hulls {

/// Matches whole names (ECMAScript, without back-references). The time grows with the lengths of expression and name, whatever they say.
class LinkPattern {
 public:
  /// Throws kBadOption for what is no regular expression, and for one of more than 50,000 characters or with more than 100 groups in each
  /// other. `option`: what it is called.
  LinkPattern(const std::string& expression, const std::string& option);
  bool matches(const std::string& link) const { return std::regex_match(link, compiled_); }

 private:
  std::regex compiled_;
};

}  // namespace collision_hulls
