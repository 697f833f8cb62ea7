// Numbers are parsed with the classic locale, since a process with a German locale would read "1.5" as 1.
#include "base/finite_number.h"

#include <cmath>
#include <locale>
#include <sstream>
#include <string>

namespace collision_hulls {

bool parseFinite(std::string_view word, double& value) {
  std::istringstream in{std::string(word)};
  in.imbue(std::locale::classic());
  return in >> value && in.peek() == std::istringstream::traits_type::eof() && std::isfinite(value);
}

}  // namespace collision_hulls
