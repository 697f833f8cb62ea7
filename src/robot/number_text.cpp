// Numbers as the shortest text that reads back as the same double.
#include "robot/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "base/decimal.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

std::string scientific(double value, int decimals) {
  std::ostringstream out = decimalStream(decimals);
  out << std::scientific << value;
  return out.str();
}

double parsed(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;
  return value;
}

// Decimals after the point that the shortest exact text of `value` needs; negative where zeros stand before the point.
int decimalsNeeded(double value) {
  constexpr int kMostDigits = std::numeric_limits<double>::max_digits10;
  std::string text;
  int digits = 0;
  do {
    text = scientific(value, digits++);
  } while (digits < kMostDigits && parsed(text) != value);
  const int exponent = std::stoi(text.substr(text.find('e') + 1));
  return digits - 1 - exponent;
}

}  // namespace

std::string numberText(double value) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) throw Error(ErrorCode::kBadOption, "a number of a description is " + decimal(value) + "; it must be finite");
  return fixedDecimal(value, std::max(0, decimalsNeeded(value)));
}

std::string vectorText(const Eigen::Vector3d& vector) {
  return numberText(vector.x()) + " " + numberText(vector.y()) + " " + numberText(vector.z());
}

}  // namespace collision_hulls
