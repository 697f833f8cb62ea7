// Progress on standard error: a bar on a terminal; elsewhere a line at once, and another every few seconds. Once it is clear that the run
// takes minutes, a line says how to finish sooner. Where nothing is reported for a while, as within one hard part of a mesh, a thread shows
// that time passes.
#pragma once

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "base/standard_files.h"
#include "collision_hulls/pipeline/progress_text.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

class ProgressDisplay {
 public:
  /// `to_wait_less`: a sentence for those who wait long; may be empty. `patience` [s]: how long nothing may be reported.
  explicit ProgressDisplay(bool quiet, std::string to_wait_less = "", double patience = kPatience)
      : quiet_(quiet), bar_(!quiet && isatty(STDERR_FILENO)), patience_(patience), to_wait_less_(std::move(to_wait_less)) {
    if (quiet_) return;
    try {
      clock_ = std::thread([this] { watch(); });
    } catch (const std::system_error&) {  // no more threads are allowed: the display does without
    }
  }
  ~ProgressDisplay() {
    clear();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ended_ = true;
    }
    wake_.notify_all();
    if (clock_.joinable()) clock_.join();
  }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void step(const Step& step) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (step.total == 0) return;  // no mesh: a note says why
    last_ = step;
    last_.seconds_left = -1;  // an old estimate says nothing
    is_waiting_ = true;
    last_time_ = Clock::now();
    looks_ = 0;
    if (!takesLine(STDERR_FILENO)) return;  // a thread that waited for a reader would hear of no interrupt
    if (!quiet_ && !to_wait_less_.empty() && step.seconds_left > kLong) {
      erase();
      std::fprintf(stderr, "%s\n", to_wait_less_.c_str());
      to_wait_less_.clear();
    }
    if (bar_) {
      drawn_ = true;
      draw(step, "");
    } else if (!quiet_ && is_due_()) {
      std::fprintf(stderr, "%s\n", progressLine(step).c_str());
    }
  }

  /// Takes the bar away, so that other text can be written.
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_waiting_ = false;
    erase();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kLong = 300;    // [s]
  static constexpr double kPatience = 5;  // [s] between the looks of those who wait; in a log, a line for each would be many
  static constexpr int kLooksALine = 12;

  void erase() {
    if (drawn_ && takesLine(STDERR_FILENO)) std::fputs("\r\033[K", stderr);
    drawn_ = false;
  }

  /// Until the end: how long it has been since the last step.
  void watch() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!wake_.wait_for(lock, std::chrono::duration<double>(patience_), [&] { return ended_; })) {
      const double seconds = std::chrono::duration<double>(Clock::now() - last_time_).count();
      if (!is_waiting_ || seconds < patience_ || !takesLine(STDERR_FILENO)) continue;
      const std::string text = ", " + std::to_string(static_cast<long long>(seconds)) + " s at this step";
      if (bar_) {
        drawn_ = true;
        draw(last_, text);
      } else if (looks_++ % kLooksALine == 0) {
        std::fprintf(stderr, "%s%s\n", progressLine(last_).c_str(), text.c_str());
      }
    }
  }

  static std::size_t columns() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
  }

  /// A line that wrapped could not be drawn over: it ends before the last column.
  static void draw(const Step& step, const std::string& waited) {
    constexpr std::size_t kWidth = 20;
    const std::size_t full = kWidth * static_cast<std::size_t>(percent(step)) / 100;
    char start[64];
    std::snprintf(start, sizeof start, "[%s%s] %3d %%  ", std::string(full, '#').c_str(), std::string(kWidth - full, '.').c_str(),
                  percent(step));
    const std::string line = start + stepText(step) + waited;
    std::fprintf(stderr, "\r\033[K%s", line.substr(0, columns() - 1).c_str());
  }

  const bool quiet_, bar_;
  const double patience_;
  std::string to_wait_less_;
  Throttle is_due_;
  std::mutex mutex_;  // for all below
  std::condition_variable wake_;
  bool drawn_ = false, is_waiting_ = false, ended_ = false;
  Step last_;
  Clock::time_point last_time_;
  int looks_ = 0;  // at it since then
  std::thread clock_;
};

}  // namespace collision_hulls
