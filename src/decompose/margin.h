// The margin that a bound includes: with less than the surfaces are really apart, it would prove nothing.
#pragma once

#include <cmath>

#include "base/millimetres.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

/// Throws kBadOption for a margin [m] that is less than the least, or not finite. `least`: [m] how far repair() moved the surface, if it
/// did.
inline void expectMargin(double margin, double least = 0) {
  if (margin >= least && std::isfinite(margin)) return;
  throw Error(ErrorCode::kBadOption, "the margin is " + millimetres(margin) + ", and the bound includes it; it must be finite, and " +
                                         (least > 0 ? millimetres(least) + ", which is how far repairing moved the surface," : "0") +
                                         " or more");
}

}  // namespace collision_hulls
