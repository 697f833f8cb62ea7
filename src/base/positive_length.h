// Lengths that callers give, such as tolerances.
#pragma once

#include <cmath>
#include <string>

#include "base/decimal.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

/// Throws kBadOption unless `value` [m] is positive and finite. `name`: what the message calls it.
inline void expectPositiveLength(const std::string& name, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw Error(ErrorCode::kBadOption, name + " is " + decimal(value) + " m; it must be a positive length");
}

}  // namespace collision_hulls
