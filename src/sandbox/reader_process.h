// The library's side of a reader program: one process and its socket.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "base/descriptor.h"
#include "collision_hulls/control.h"
#include "sandbox/wire.h"

namespace collision_hulls {

/// What one question may use.
struct ReadingLimits {
  WorkerLimits worker;
  std::uint64_t answer = 0;  ///< [bytes] length of the answer
  double clock_seconds = 0;  ///< [s] on the clock, all waiting included
};

/// A question to a reader program. What it refers to must outlive the call that takes it.
struct ReaderQuestion {
  std::string_view head;  ///< what to do
  std::string_view body;  ///< with these bytes
  int file = -1;          ///< or with this regular file
};

/// How a question ended.
struct ReaderOutcome {
  enum class Kind { kAnswered, kTooSlow, kTooLong, kReaderEnded } kind = Kind::kAnswered;
  Ending worker;       ///< of kAnswered
  std::string answer;  ///< of kAnswered: what the worker wrote
};

/// A running reader program. Ends with this object, and with the program that has it.
class ReaderProcess {
 public:
  /// Starts the program; throws kReaderFailed if that is impossible. `variable` stands in the message: what names another program.
  ReaderProcess(const std::string& program, const std::string& variable);
  ~ReaderProcess();
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;

  /// Only after kAnswered can the process take another question. Throws kCancelled.
  ReaderOutcome ask(const ReaderQuestion& question, const ReadingLimits& limits, const RunControl& control);

 private:
  Descriptor socket_;
  pid_t process_ = -1;
};

}  // namespace collision_hulls
