// Progress on standard error: a bar on a terminal, a line per step elsewhere.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <string>

#include "collision_hulls/pipeline/decompose_robot.h"

namespace collision_hulls {

class ProgressDisplay {
 public:
  explicit ProgressDisplay(bool quiet) : quiet_(quiet), bar_(!quiet && isatty(STDERR_FILENO)) {}
  ~ProgressDisplay() { clear(); }

  void fraction(double fraction) {
    const int percent = static_cast<int>(100 * fraction);
    if (!bar_ || percent == percent_) return;
    percent_ = percent;
    draw();
  }

  void step(const Step& step) {
    if (quiet_) return;
    step_ = step;
    if (bar_) {
      draw();
    } else {
      std::fprintf(stderr, "%s\n", text().c_str());
    }
  }

  /// Takes the bar away, so that other text can be written.
  void clear() const {
    if (bar_) std::fputs("\r\033[K", stderr);
  }

 private:
  std::string text() const {
    if (step_.total == 0) return "";  // nothing is finished yet
    return step_.stage + " " + std::to_string(step_.done) + "/" + std::to_string(step_.total) + ", " + std::to_string(step_.hulls) +
           " hulls" + (step_.item.empty() ? "" : ": " + step_.item);
  }

  void draw() const {
    constexpr std::size_t kWidth = 30;
    const std::size_t full = kWidth * static_cast<std::size_t>(percent_) / 100;
    const std::string bar = std::string(full, '#') + std::string(kWidth - full, '.');
    std::fprintf(stderr, "\r\033[K[%s] %3d%%  %.60s", bar.c_str(), percent_, text().c_str());
  }

  bool quiet_, bar_;
  int percent_ = 0;
  Step step_;
};

}  // namespace collision_hulls
