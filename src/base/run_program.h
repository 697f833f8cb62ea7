// Other programs, run without a shell.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace collision_hulls {

struct ProgramResult {
  int status = 0;           ///< exit status; 128 + signal where a signal ended it
  std::string out, errors;  ///< what it wrote to stdout and stderr
};

/// Runs arguments[0], looked up on PATH, with an empty stdin, and waits for it. nullopt where there is no such program.
/// Throws std::system_error where it cannot be run for another reason.
std::optional<ProgramResult> runProgram(const std::vector<std::string>& arguments);

}  // namespace collision_hulls
