// What permissions new files lack.
#pragma once

#include <sys/stat.h>

namespace collision_hulls {

/// That of the process, until the end of its scope.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_(umask(mask)) {}
  ~Umask() { umask(before_); }
  Umask(const Umask&) = delete;
  Umask& operator=(const Umask&) = delete;

 private:
  const mode_t before_;
};

}  // namespace collision_hulls
