// A file that is opened takes the least number that is free, so they are looked at in their order.
#include "base/standard_files.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <initializer_list>

namespace collision_hulls {

void holdStandardFiles() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(number, F_GETFD) < 0) open("/dev/null", number == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

bool takesLine(int file) {
  pollfd place{file, POLLOUT, 0};  // of a pipe it means a page at least
  return poll(&place, 1, 0) > 0;
}

}  // namespace collision_hulls
