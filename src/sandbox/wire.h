// What goes over the socket between the library and a reader program.
//
// A question is a QuestionHeader, which carries the descriptor of the file to read, and the text that says what to do with it. Its answer
// is an Ending, which carries the descriptor of the file that the worker wrote. Files that are no files of a disk lie in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/descriptor.h"

namespace collision_hulls {

/// Differs between programs that would misunderstand each other.
constexpr std::array<char, 8> kWireVersion{'c', 'h', 'r', 'e', 'a', 'd', '0', '1'};

/// What a worker may use.
struct WorkerLimits {
  std::uint64_t memory = 0;       ///< [bytes] address space
  std::uint64_t answer = 0;       ///< [bytes] length of its answer, which lies in memory beside that
  std::uint64_t cpu_seconds = 0;  ///< [s] computing
};

struct QuestionHeader {
  std::array<char, 8> version = kWireVersion;
  WorkerLimits limits;
  std::uint64_t head_size = 0;  ///< bytes of the text that follows
};

/// How a worker ended.
struct Ending {
  enum class Kind : std::uint32_t { kExit, kSignal, kNotForked, kOtherVersion } kind = Kind::kExit;
  std::int32_t code = 0;  ///< exit status, number of the signal, or errno
};

/// A question, understood by all reader programs: what protection is in force?
constexpr std::string_view kAskProtection = "protection";

/// Exit status of a worker that has run out of memory.
constexpr int kOutOfMemory = 71;

/// The last byte that a worker writes says what the bytes before it are.
enum class AnswerKind : char {
  kAnswer = 'a',
  kError = 'e',     ///< an Error: code and text
  kException = 'x'  ///< the text of any other exception
};

/// An empty file in memory; none if that fails, with errno.
Descriptor memoryFile();

/// Sends some bytes with a descriptor (negative: none), or receives both, with one system call that returns what sendmsg() or recvmsg()
/// does.
long sendWith(int socket, const void* bytes, std::size_t size, int descriptor, int flags);
long receiveWith(int socket, void* bytes, std::size_t size, Descriptor& descriptor, int flags);

/// Writes all of some bytes, or reads them from the file's start. Returns false if that fails, with errno, or zero if the file is shorter.
bool writeAll(int file, std::string_view bytes);
bool readAll(int file, std::string& bytes);

/// The size of a regular file or one in memory.
std::optional<std::uint64_t> sizeOf(int file);

}  // namespace collision_hulls
