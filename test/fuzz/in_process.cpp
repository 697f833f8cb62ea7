// Stands in for the library's askAboutText(): what a worker would do is done here, where the fuzzer sees it. The linker prefers a program's
// functions to those of shared libraries.
#include "decode/answer.h"
#include "sandbox/file_reader.h"

namespace collision_hulls {

std::string askAboutText(const std::string& head, const std::string& text, const std::string& /*subject*/, const RunControl& /*control*/) {
  return answerReading({head, text, -1});
}

}  // namespace collision_hulls
