// What goes over the socket between the library and a reader program.
//
// The library sends questions, one after the other: a QuestionHeader, then the three texts whose sizes it names. The reader program sends
// back what its worker wrote: pieces, each behind its size (32 bits), then a size of zero and an Ending.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace collision_hulls {

/// Differs between programs that would misunderstand each other.
constexpr std::array<char, 8> kWireVersion{'c', 'h', 'r', 'e', 'a', 'd', '0', '1'};

constexpr std::size_t kMostPiece = std::size_t{1} << 18;  ///< [bytes]

struct QuestionHeader {
  std::array<char, 8> version = kWireVersion;
  std::uint64_t memory = 0;       ///< [bytes] address space of the worker
  std::uint64_t cpu_seconds = 0;  ///< [s] CPU time of the worker
  std::uint64_t file_size = 0;    ///< characters of the path of a file to open for reading; 0: none
  std::uint64_t head_size = 0;    ///< bytes of the question
  std::uint64_t body_size = 0;    ///< bytes that the question is about
};

/// How a worker ended.
struct Ending {
  enum class Kind : std::uint32_t { kExit, kSignal, kNotForked, kNotOpened, kOtherVersion } kind = Kind::kExit;
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

/// Sends, or receives, all of some bytes over a blocking socket. Returns false if the other end is closed.
bool sendAll(int socket, const void* bytes, std::size_t size);
bool receiveAll(int socket, void* bytes, std::size_t size);

}  // namespace collision_hulls
