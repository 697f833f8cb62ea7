// Steps that a deadline may end.
#pragma once

#include "collision_hulls/error.h"

namespace collision_hulls {

/// Runs a step. False: the deadline of its control ended it (RunControl::stops_at_deadline).
template <typename Step>
bool inTime(const Step& step) {
  try {
    step();
    return true;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kOutOfTime) throw;
    return false;
  }
}

}  // namespace collision_hulls
