// Starts the program again with an environment that asks for large pages.
#include "base/large_pages.h"

#include <limits.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/auxv.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "base/sanitizer.h"

namespace collision_hulls {
namespace {

constexpr const char* kVariable = "GLIBC_TUNABLES";
constexpr rlim_t kLittle = 1 << 30;  // [bytes] a smaller limit may leave too little for these pieces

bool kernelWantsToBeAsked() {
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string choices;
  return std::getline(file, choices) && choices.find("[madvise]") != std::string::npos;
}

bool isMemoryScarce() {
  const auto is_low = [](auto resource) {
    rlimit limit{};
    return getrlimit(resource, &limit) == 0 && limit.rlim_cur < kLittle;
  };
  return is_low(RLIMIT_DATA) || is_low(RLIMIT_AS);
}

/// Whether the program was started as such, and not by a dynamic loader that was given its name: what runs is the loader then.
bool isItself() {
  struct stat running {};
  struct stat named {};
  const auto* const name = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
  return name && stat("/proc/self/exe", &running) == 0 && stat(name, &named) == 0 && running.st_dev == named.st_dev &&
         running.st_ino == named.st_ino;
}

}  // namespace

void takeLargePages(char** arguments) {
#ifdef __GLIBC__
  if (kSanitized || std::getenv(kVariable) || isMemoryScarce() || !kernelWantsToBeAsked() || !isItself()) return;
  char program[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", program, sizeof program);
  if (length <= 0 || length == sizeof program) return;
  program[length] = '\0';
  putenv(const_cast<char*>(kLargePages));  // which keeps the text itself
  execv(program, arguments);
  unsetenv(kVariable);  // as it is still here
#else
  static_cast<void>(arguments);
#endif
}

void giveBackFreedMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace collision_hulls
