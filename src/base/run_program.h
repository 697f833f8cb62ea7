// Other programs, run without a shell.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

struct ProgramResult {
  int status = 0;           ///< exit status; 128 + signal where a signal ended it
  std::string out, errors;  ///< what it wrote to stdout and stderr
};

/// What a program may use, with those that it starts.
struct ProgramLimits {
  std::uint64_t output = std::uint64_t{256} << 20;  ///< [bytes] to stdout, and to stderr
  std::uint64_t memory = std::uint64_t{4} << 30;    ///< [bytes] address space of each process
  double seconds = 120;                             ///< [s] on the clock
};

/// Runs arguments[0], looked up on PATH, with an empty stdin, and waits for it. `variables`, as "NAME=VALUE", are added to its environment,
/// or replaced there. nullopt where there is no such program. When it has ended, is cancelled or has reached a limit, so does every process
/// of its group; when we are killed, the program itself does. Throws kTooLarge for too much output, kOutOfTime, kCancelled;
/// std::system_error where it cannot be run for another reason. A program that needs more memory fails by itself.
std::optional<ProgramResult> runProgram(const std::vector<std::string>& arguments, const RunControl& control = {},
                                        const ProgramLimits& limits = {}, const std::vector<std::string>& variables = {});

}  // namespace collision_hulls
