// A reader program's side: answers the library's questions, each in a process of its own.
#pragma once

#include <functional>
#include <string>

namespace collision_hulls {

struct Question {
  std::string head;  ///< what to do
  std::string body;  ///< with these bytes
  int file = -1;     ///< or with this file, open for reading
};

/// Bytes that the library understands. May throw.
using AnswerFunction = std::function<std::string(const Question&)>;

/// What main() of a reader program returns. Questions come over standard input, a socket; without one it says what it is for, and returns
/// 2. For each question, a worker is forked and confined (confine.h) before it calls `answer`: so each has memory that no other question's
/// bytes have touched. Ends when the library does, or closes the socket. The process must have no other threads.
int serve(const AnswerFunction& answer);

}  // namespace collision_hulls
