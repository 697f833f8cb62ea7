// A reader program for tests. It does what the first word of the question says, or, of a question about a mesh, that of the mesh file.
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <new>
#include <stdexcept>
#include <vector>

#include "collision_hulls/error.h"
#include "geometry/bytes.h"
#include "sandbox/serve.h"
#include "sandbox/wire.h"

namespace collision_hulls {
namespace {

constexpr int kMostDescriptors = 256;

int g_calls = 0;  // a worker's memory is its own, so this never exceeds one

/// "done", or the name of the error, of a system call's result.
std::string result(long returned) {
  return returned >= 0 ? "done" : std::strerror(errno);
}

int overflow(int depth) {
  volatile char much[4096];
  much[0] = static_cast<char>(depth);
  return depth > 0 ? overflow(depth + 1) + much[0] : 0;
}

std::string allocateWithoutEnd() {
  std::vector<char*> all;
  for (;;) all.push_back(static_cast<char*>(std::memset(new char[1 << 20], 1, 1 << 20)));
}

[[noreturn]] void computeWithoutEnd() {
  for (volatile unsigned i = 0;;) i = i + 1;
}

std::string openDescriptors() {
  std::string list;
  for (int i = 0; i < kMostDescriptors; ++i)
    if (fcntl(i, F_GETFD) >= 0) list += std::to_string(i) + " ";
  return list;
}

std::string environmentText() {
  std::string variables;
  for (char** variable = environ; *variable != nullptr; ++variable) variables += std::string(*variable) + " ";
  return variables;
}

/// A mesh's fields in the order of LoadedMesh, with triangles that the caller chooses.
std::string mesh(const Eigen::Vector3d& corner, int index, int submeshes = 1, double resolution = 0) {
  TriangleMesh mesh;
  mesh.vertices = {corner, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, index}};
  return toBytes(mesh, submeshes, std::size_t{0}, resolution);
}

std::string startProgram() {
  char* const arguments[] = {const_cast<char*>("/bin/true"), nullptr};
  return result(execv(arguments[0], arguments));
}

std::string closePipeAndRunOn() {
  for (int i = 3; i < kMostDescriptors; ++i) close(i);
  computeWithoutEnd();
}

const std::map<std::string, std::function<std::string(const Question&)>>& deeds() {
  static const std::map<std::string, std::function<std::string(const Question&)>> all{
      {"echo", [](const Question& q) { return q.body; }},
      {"calls", [](const Question&) { return std::to_string(++g_calls); }},
      {"pids", [](const Question&) { return std::to_string(getpid()); }},
      {"descriptors", [](const Question&) { return openDescriptors(); }},
      {"environment", [](const Question&) { return environmentText(); }},
      {"file",
       [](const Question& q) {
         std::string bytes(1000, ' ');  // more than a test gives it
         const ssize_t got = pread(q.file, bytes.data(), bytes.size(), 0);
         return got >= 0 ? bytes.substr(0, static_cast<std::size_t>(got)) : std::strerror(errno);
       }},
      {"signals", [](const Question&) { return result(fcntl(STDERR_FILENO, F_SETOWN, getppid())); }},
      {"cancelled", [](const Question&) -> std::string { throw Error(ErrorCode::kCancelled, "cancelled"); }},
      {"crash", [](const Question&) { return std::to_string(raise(SIGSEGV)); }},
      {"abort", [](const Question&) -> std::string { std::abort(); }},
      {"overflow", [](const Question&) { return std::to_string(overflow(1)); }},
      {"memory", [](const Question&) { return allocateWithoutEnd(); }},
      {"bad_alloc", [](const Question&) -> std::string { throw std::bad_alloc(); }},
      {"loop", [](const Question&) -> std::string { computeWithoutEnd(); }},
      {"sleep",
       [](const Question&) -> std::string {
         for (;;) pause();
       }},
      {"exit", [](const Question&) -> std::string { _exit(3); }},
      {"silent", [](const Question&) -> std::string { _exit(0); }},
      {"run_on", [](const Question&) { return closePipeAndRunOn(); }},
      {"error", [](const Question&) -> std::string { throw Error(ErrorCode::kTooFarFromOrigin, "too far"); }},
      {"exception", [](const Question&) -> std::string { throw std::runtime_error("out\nof order"); }},
      {"open", [](const Question&) { return result(open("/dev/null", O_RDONLY)); }},
      {"create", [](const Question& q) { return result(open(q.body.c_str(), O_CREAT | O_WRONLY, 0600)); }},
      {"remove", [](const Question& q) { return result(unlink(q.body.c_str())); }},
      {"socket", [](const Question&) { return result(socket(AF_INET, SOCK_STREAM, 0)); }},
      {"start", [](const Question&) { return startProgram(); }},
      {"fork", [](const Question&) { return result(fork()); }},
      {"trace", [](const Question&) { return result(ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr)); }},
      {"kill", [](const Question&) { return result(kill(getppid(), SIGKILL)); }},
      {"code",
       [](const Question&) {
         return result(reinterpret_cast<long>(mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)));
       }},
      {"garbage", [](const Question&) { return std::string(1000, '\xa5'); }},
      {"good_mesh",
       [](const Question&) {
         return mesh({0, 0, 0}, 2);
       }},
      {"huge_count", [](const Question&) { return toBytes(std::uint64_t{1} << 60, 1.0, 1.0, 1.0); }},
      {"no_triangles", [](const Question&) { return toBytes(TriangleMesh{}, 1, std::size_t{0}, 0.0); }},
      {"index_above",
       [](const Question&) {
         return mesh({0, 0, 0}, 3);
       }},
      {"index_below",
       [](const Question&) {
         return mesh({0, 0, 0}, -1);
       }},
      {"not_finite",
       [](const Question&) {
         return mesh({0, std::numeric_limits<double>::quiet_NaN(), 0}, 2);
       }},
      {"negative_count",
       [](const Question&) {
         return mesh({0, 0, 0}, 2, -1);
       }},
      {"bad_resolution",
       [](const Question&) {
         return mesh({0, 0, 0}, 2, 1, -1);
       }},
      {"too_short",
       [](const Question&) {
         return mesh({0, 0, 0}, 2).substr(0, 80);
       }},
      {"too_much",
       [](const Question&) {
         return mesh({0, 0, 0}, 2) + "more";
       }},
  };
  return all;
}

std::string doAsTold(const Question& question) {
  const auto firstWord = [](const std::string& text) { return text.substr(0, text.find_first_of(" \n")); };
  const auto deed = deeds().count(question.head) ? deeds().find(question.head) : deeds().find(firstWord(question.body));
  if (deed == deeds().end()) throw std::runtime_error("no such deed");
  return deed->second(question);
}

}  // namespace
}  // namespace collision_hulls

int main() {
  return collision_hulls::serve(collision_hulls::doAsTold);
}
