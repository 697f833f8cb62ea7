// Errors that say where they happened.
#pragma once

#include <functional>
#include <string>

#include "collision_hulls/error.h"

namespace collision_hulls {

/// Runs `action`; prefixes the text of any Error it throws with "label: ", and keeps its code.
inline void inContext(const std::string& label, const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    throw Error(error.code(), label + ": " + error.what());
  }
}

}  // namespace collision_hulls
