// What is wrong with a regular expression (ECMAScript), in our words: those of the standard libraries differ, and name no remedy.
#pragma once

#include <regex>
#include <string>

namespace collision_hulls {

/// "a '[' is not closed; add ']', or write \[ for the character itself". Some codes of libstdc++ stand for several faults.
inline std::string patternFault(std::regex_constants::error_type fault) {
  namespace rc = std::regex_constants;
  if (fault == rc::error_brack) return "a '[' is not closed; add ']', or write \\[ for the character itself";
  if (fault == rc::error_brace) return "a '{' is not closed; add '}', or write \\{ for the character itself";
  if (fault == rc::error_paren || fault == rc::error_badrepeat)
    return "a '(' or ')' lacks its partner, or a '*', '+' or '?' what it repeats; write \\( or \\* for the character itself";
  if (fault == rc::error_badbrace) return "a '{' has no valid number of repetitions; give it as in {2} or {1,3}";
  if (fault == rc::error_range)
    return "a '-' within [...] has no range around it, or a reversed one; give one as in [a-z], or write \\- for the character itself";
  if (fault == rc::error_collate || fault == rc::error_ctype)
    return "a class within [...] is unknown; use one such as [:alpha:] or [:digit:]";
  if (fault == rc::error_escape) return "a '\\' escapes nothing; write \\\\ for the character itself";
  if (fault == rc::error_backref || fault == rc::error_complexity)
    return "\\1 and its like, back-references, are not taken; write the group again instead";
  return "it is too long or repeats too often; divide it, or repeat less";
}

}  // namespace collision_hulls
