// Progress on standard error: a bar on a terminal; elsewhere a line at once, and another every few seconds. Once it is clear that the run
// takes minutes, a line says how to finish sooner.
#pragma once

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "base/standard_files.h"
#include "collision_hulls/pipeline/progress_text.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

class ProgressDisplay {
 public:
  /// `to_wait_less`: a sentence for those who wait long; may be empty.
  explicit ProgressDisplay(bool quiet, std::string to_wait_less = "")
      : quiet_(quiet), bar_(!quiet && isatty(STDERR_FILENO)), to_wait_less_(std::move(to_wait_less)) {}
  ~ProgressDisplay() { clear(); }

  void step(const Step& step) {
    if (step.total == 0) return;            // no mesh: a note says why
    if (!takesLine(STDERR_FILENO)) return;  // a thread that waited for a reader would hear of no interrupt
    if (!quiet_ && !to_wait_less_.empty() && step.seconds_left > kLong) {
      clear();
      std::fprintf(stderr, "%s\n", to_wait_less_.c_str());
      to_wait_less_.clear();
    }
    if (bar_) {
      drawn_ = true;
      draw(step);
    } else if (!quiet_ && is_due_()) {
      std::fprintf(stderr, "%s\n", progressLine(step).c_str());
    }
  }

  /// Takes the bar away, so that other text can be written.
  void clear() {
    if (drawn_ && takesLine(STDERR_FILENO)) std::fputs("\r\033[K", stderr);
    drawn_ = false;
  }

 private:
  static constexpr double kLong = 300;  // [s]

  static std::size_t columns() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
  }

  /// A line that wrapped could not be drawn over: it ends before the last column.
  static void draw(const Step& step) {
    constexpr std::size_t kWidth = 20;
    const std::size_t full = kWidth * static_cast<std::size_t>(percent(step)) / 100;
    char start[64];
    std::snprintf(start, sizeof start, "[%s%s] %3d %%  ", std::string(full, '#').c_str(), std::string(kWidth - full, '.').c_str(),
                  percent(step));
    const std::string line = start + stepText(step);
    std::fprintf(stderr, "\r\033[K%s", line.substr(0, columns() - 1).c_str());
  }

  bool quiet_, bar_, drawn_ = false;
  std::string to_wait_less_;
  Throttle is_due_;
};

}  // namespace collision_hulls
