// Numbers in the text of mesh files: one grammar for all formats.
#pragma once

#include <cstdint>
#include <string_view>

namespace collision_hulls {

/// Parses the whole word as what std::from_chars takes for a double, which is what strtod takes in the C locale without hexadecimal
/// numbers: digits with an optional point and exponent, or nan, inf or infinity in any case; a plus sign in front is allowed as well. The
/// value is the nearest double: infinite beyond the range of double, 0 below it. False if the word is anything else, such as "1,5", "1.0f",
/// "0x10" or "1.#QNAN". Does not depend on the process's locale.
bool parseNumber(std::string_view word, double* value);

/// Parses the whole word as a decimal integer without a plus sign; false if it is not one, or too large.
bool parseInteger(std::string_view word, std::int64_t* value);

/// The nearest number of single precision; infinite beyond its range.
float toSingle(double value);

}  // namespace collision_hulls
