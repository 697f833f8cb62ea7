// Numbers as text with a decimal point. printf and std::to_string follow LC_NUMERIC, which belongs to whoever runs the process: in a
// German one they would write "1,5", which splits columns of a table and which no other program reads.
#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace collision_hulls {

/// A stream for many numbers, each as decimal() writes it; whole numbers get no thousands separators.
inline std::ostringstream decimalStream(int digits = 6) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(digits);
  return stream;
}

/// With that many significant digits, without trailing zeros: "%.6g" of printf in the C locale.
inline std::string decimal(double value, int digits = 6) {
  std::ostringstream stream = decimalStream(digits);
  stream << value;
  return stream.str();
}

/// With that many decimals, and no exponent: "%.6f" of printf in the C locale, as std::to_string has it there.
inline std::string fixedDecimal(double value, int decimals = 6) {
  std::ostringstream stream = decimalStream(decimals);
  stream << std::fixed << value;
  return stream.str();
}

}  // namespace collision_hulls
