// The program lies beside the library: in a build, in catkin's devel space and where it is installed, the library's folder holds a folder
// collision_hulls with all programs.
#include "sandbox/reader_program.h"

#include <dlfcn.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "base/string_parts.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

constexpr ReadingLimits kToAskProtection{{std::uint64_t{1} << 30, 10}, 1000, 60};

/// The folder of this library, or of the program that it is linked into.
std::filesystem::path ownFolder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&ownFolder), &info) == 0 || info.dli_fname == nullptr) return {};
  return std::filesystem::absolute(info.dli_fname).parent_path();
}

std::string millions(std::uint64_t bytes) {
  return std::to_string(bytes / 1'000'000) + " MB";
}

constexpr const char* kDamaged = "the file is damaged or malicious: replace it";

/// What stands in a message beside what befell the file.
struct Circumstances {
  const std::string& subject;
  const std::string& remedy;
  const std::string& program;
};

[[noreturn]] void failWith(const Circumstances& about, const std::string& what, const std::string& remedy,
                           ErrorCode code = ErrorCode::kReaderFailed) {
  throw Error(code, about.subject + ": " + what + "; " + remedy);
}

[[noreturn]] void failOfWorker(const Ending& ending, const ReadingLimits& limits, const Circumstances& about) {
  if (ending.kind == Ending::Kind::kExit && ending.code == kWorkerOutOfMemory)
    failWith(about, "reading it takes more memory than the limit of " + millions(limits.worker.memory), about.remedy,
             ErrorCode::kOutOfMemory);
  if (ending.kind == Ending::Kind::kExit)
    failWith(about, "its reader ended with status " + std::to_string(ending.code) + " instead of an answer", kDamaged);
  if (ending.code == SIGXCPU)
    failWith(about, "reading it takes more computing than the limit of " + std::to_string(limits.worker.cpu_seconds) + " s", about.remedy,
             ErrorCode::kOutOfTime);
  const std::string signal = "(signal " + std::to_string(ending.code) + ", " + strsignal(ending.code) + ")";
  if (ending.code == SIGKILL) failWith(about, "its reader was killed " + signal, "free some memory and run again", ErrorCode::kOutOfMemory);
  failWith(about, "its reader crashed " + signal, kDamaged);
}

[[noreturn]] void failOfReader(const Ending& ending, const Circumstances& about) {
  if (ending.kind == Ending::Kind::kNotForked)
    failWith(about, std::string("no process can be started to read it: ") + std::strerror(ending.code), "end some others and run again");
  failWith(about, "'" + about.program + "' is of another version than the library", "install both together");
}

[[noreturn]] void fail(const ReaderOutcome& outcome, const ReadingLimits& limits, const Circumstances& about) {
  const auto whole = [](double seconds) { return std::to_string(std::lround(seconds)) + " s"; };
  switch (outcome.kind) {
    case ReaderOutcome::Kind::kTooSlow:
      failWith(about, "reading it takes longer than the limit of " + whole(limits.clock_seconds), about.remedy, ErrorCode::kOutOfTime);
    case ReaderOutcome::Kind::kTooLong:
      failWith(about, "its content takes more memory than the limit of " + millions(limits.answer), about.remedy, ErrorCode::kOutOfMemory);
    case ReaderOutcome::Kind::kReaderEnded:
      failWith(about, "'" + about.program + "', which reads files, ended without an answer", "run it by hand to see why");
    case ReaderOutcome::Kind::kAnswered: break;
  }
  const bool of_worker = outcome.worker.kind == Ending::Kind::kExit || outcome.worker.kind == Ending::Kind::kSignal;
  of_worker ? failOfWorker(outcome.worker, limits, about) : failOfReader(outcome.worker, about);
}

/// Text from a process that may be hostile.
std::string printable(std::string text) {
  text = shortened(text, 4000);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
  return text;
}

[[noreturn]] void throwAsTold(const std::string& bytes) {
  auto code = ErrorCode::kInternal;
  std::string text;
  fromBytes(bytes, code, text);
  if (name(code) == std::string("Unknown") || code == ErrorCode::kCancelled) throw ByteFault("it names an error that it cannot have");
  throw Error(code, printable(text));
}

}  // namespace

std::string answerIn(std::string bytes, const std::string& subject) {
  if (bytes.empty()) throw ByteFault("it is empty");
  const auto kind = static_cast<AnswerKind>(bytes.back());
  bytes.pop_back();
  if (kind == AnswerKind::kError) throwAsTold(bytes);
  if (kind == AnswerKind::kException)
    throw Error(ErrorCode::kReaderFailed, subject + ": cannot be read (" + printable(bytes) + "); check the file or export it again");
  if (kind != AnswerKind::kAnswer) throw ByteFault("it is of no known kind");
  return bytes;
}

std::string ReaderProgram::path() const {
  if (const char* const named = std::getenv(variable_.c_str()); named != nullptr && *named != '\0') return named;
  const std::filesystem::path folder = ownFolder();
  const std::filesystem::path beside = folder / name_;  // of a program that holds the library
  return std::filesystem::exists(beside) ? beside : folder / "collision_hulls" / name_;
}

std::unique_ptr<ReaderProcess> ReaderProgram::takeIdle(const std::string& program) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (owner_ != getpid() || program_ != program) idle_.clear();
  owner_ = getpid();
  program_ = program;
  if (idle_.empty()) return nullptr;
  std::unique_ptr<ReaderProcess> taken = std::move(idle_.back());
  idle_.pop_back();
  return taken;
}

ReaderOutcome ReaderProgram::outcomeOf(const ReaderQuestion& question, const ReadingLimits& limits, const RunControl& control) {
  const std::string program = path();
  ReaderOutcome outcome;
  outcome.kind = ReaderOutcome::Kind::kReaderEnded;
  for (bool fresh = false; !fresh && outcome.kind == ReaderOutcome::Kind::kReaderEnded;) {  // an idle one may have been killed meanwhile
    std::unique_ptr<ReaderProcess> process = takeIdle(program);
    fresh = process == nullptr;
    if (fresh) process = std::make_unique<ReaderProcess>(program, variable_);
    outcome = process->ask(question, limits, control);
    if (outcome.kind != ReaderOutcome::Kind::kAnswered) continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(process));
  }
  return outcome;
}

std::string ReaderProgram::ask(const ReaderQuestion& question, const ReadingLimits& limits, const std::string& subject,
                               const std::string& remedy, const RunControl& control) {
  ReaderOutcome outcome = outcomeOf(question, limits, control);
  if (outcome.kind != ReaderOutcome::Kind::kAnswered || outcome.worker.kind != Ending::Kind::kExit || outcome.worker.code != 0)
    fail(outcome, limits, {subject, remedy, path()});
  return madeOfAnswer(subject, kDamaged, [&] { return answerIn(std::move(outcome.answer), subject); });
}

void failAtAnswer(const std::string& subject, const ByteFault& fault, const std::string& remedy) {
  throw Error(ErrorCode::kReaderFailed, subject + ": its reader's answer makes no sense (" + fault.what() + "); " + remedy);
}

std::string ReaderProgram::protection() {
  return ask({kAskProtection, {}, -1}, kToAskProtection, "protection", "", {});
}

}  // namespace collision_hulls
