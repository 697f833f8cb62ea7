// One program reads all kinds of files, so that a run starts it once. Limits for texts: tinyxml2, urdfdom and yaml-cpp take some 100 bytes
// of memory for each byte of a dense text, and less than a second for a megabyte.
#include "sandbox/file_reader.h"

namespace collision_hulls {
namespace {

constexpr std::uint64_t kMemory = std::uint64_t{512} << 20, kMemoryPerByte = 200;  // [bytes]
constexpr double kSeconds = 4, kSecondsPerByte = 2e-6;                             // [s] of computing
constexpr double kClockPerComputing = 10;                                          // on a machine with much else to do

}  // namespace

ReaderProgram& fileReader() {
  static auto* const reader = new ReaderProgram("collision_hulls_reader", "COLLISION_HULLS_READER");
  return *reader;
}

std::string askAboutText(const std::string& head, const std::string& text, const std::string& subject, const RunControl& control) {
  ReadingLimits limits;
  limits.worker.memory = kMemory + kMemoryPerByte * text.size();
  limits.answer = limits.worker.memory / 4;
  const double seconds = kSeconds + kSecondsPerByte * static_cast<double>(text.size());
  limits.worker.cpu_seconds = static_cast<std::uint64_t>(seconds);
  limits.clock_seconds = kClockPerComputing * seconds;
  return fileReader().ask({head, text, -1}, limits, subject, "it is malicious, or far larger than any that we know: make it smaller",
                          control);
}

char kindOf(const std::string& head) {
  return head.empty() ? '\0' : head.front();
}

}  // namespace collision_hulls
