// What goes over the socket between the library and a reader program.
//
// A question is a QuestionHeader, which carries the writing end of a pipe for the answer and, if there is one, the file to read; and two
// texts: what to do, and the bytes to do it with. The worker writes the answer; when it has ended, an Ending follows over the socket.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/descriptor.h"

namespace collision_hulls {

/// Differs between programs that would misunderstand each other.
constexpr std::array<char, 8> kWireVersion{'c', 'h', 'r', 'e', 'a', 'd', '0', '2'};

/// What a worker may use.
struct WorkerLimits {
  std::uint64_t memory = 0;       ///< [bytes] address space
  std::uint64_t cpu_seconds = 0;  ///< [s] computing
};

struct QuestionHeader {
  std::array<char, 8> version = kWireVersion;
  WorkerLimits limits;
  std::uint64_t head_size = 0;  ///< [bytes] of the first text
  std::uint64_t body_size = 0;  ///< [bytes] of the second
};

/// How a worker ended.
struct Ending {
  enum class Kind : std::uint32_t { kExit, kSignal, kNotForked, kOtherVersion } kind = Kind::kExit;
  std::int32_t code = 0;  ///< exit status, number of the signal, or errno
};

/// A question, understood by all reader programs: what protection is in force?
constexpr std::string_view kAskProtection = "protection";

/// Exit status of a worker that has run out of memory.
constexpr int kWorkerOutOfMemory = 71;

/// The last byte that a worker writes says what the bytes before it are.
enum class AnswerKind : char {
  kAnswer = 'a',
  kError = 'e',     ///< an Error: code and text
  kException = 'x'  ///< the text of any other exception
};

/// One or two descriptors; those that are negative do not count.
using Descriptors = std::array<Descriptor, 2>;
using Numbers = std::array<int, 2>;

/// Sends some bytes with descriptors, or receives both, with one system call that returns what sendmsg() or recvmsg() does.
long sendWith(int socket, const void* bytes, std::size_t size, const Numbers& descriptors, int flags);
long receiveWith(int socket, void* bytes, std::size_t size, Descriptors& descriptors, int flags);

/// Writes all of some bytes. Returns false if that fails.
bool writeAll(int file, std::string_view bytes);

}  // namespace collision_hulls
