// The answers to all questions that the library asks its reader program.
#pragma once

#include <string>

#include "sandbox/serve.h"

namespace collision_hulls {

/// For serve(): the worker's end of each Reading (sandbox/file_reader.h). Throws what the decoders of this room throw, and kInternal for a
/// question of no known kind.
std::string answerReading(const Question& question);

}  // namespace collision_hulls
