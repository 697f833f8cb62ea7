// Asks a reader program, and turns everything that can befall it into an Error.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "geometry/bytes.h"
#include "sandbox/reader_process.h"

namespace collision_hulls {

/// A program installed with the library, run as often as threads ask at the same time. Thread safe.
class ReaderProgram {
 public:
  /// `name` of the program; the environment variable `variable`, if set, gives the path of another.
  ReaderProgram(std::string name, std::string variable) : name_(std::move(name)), variable_(std::move(variable)) {}

  /// The worker's answer. The question may be put again to another process. `subject` stands in messages: the file. `remedy`: what to do
  /// where a limit was reached. Throws the Error that the worker threw; kReaderFailed if it crashed or cannot be started; kOutOfMemory
  /// or kOutOfTime if it reached a limit; kCancelled, and then the worker is gone.
  std::string ask(const ReaderQuestion& question, const ReadingLimits& limits, const std::string& subject, const std::string& remedy,
                  const RunControl& control);

  /// What is in force in its workers, in words.
  std::string protection();

  /// Where the program is.
  std::string path() const;

 private:
  ReaderOutcome outcomeOf(const ReaderQuestion& question, const ReadingLimits& limits, const RunControl& control);
  std::unique_ptr<ReaderProcess> takeIdle(const std::string& program);

  std::string name_, variable_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<ReaderProcess>> idle_;
  std::string program_;  // that those in idle_ run
  pid_t owner_ = -1;     // the process that started them: a fork of it must leave them alone
};

/// The answer in what a worker wrote; throws the Error that it wrote instead, kReaderFailed for any other exception, and ByteFault for
/// bytes that no worker of ours writes. For ask().
std::string answerIn(std::string bytes, const std::string& subject);

/// Throws kReaderFailed for an answer that no worker of ours gives.
[[noreturn]] void failAtAnswer(const std::string& subject, const ByteFault& fault, const std::string& remedy);

/// What `make` makes of an answer; its ByteFault is turned into kReaderFailed. `subject`, `remedy`: for the message.
template <class Make>
auto madeOfAnswer(const std::string& subject, const std::string& remedy, const Make& make) {
  try {
    return make();
  } catch (const ByteFault& fault) {
    failAtAnswer(subject, fault, remedy);
  }
}

}  // namespace collision_hulls
