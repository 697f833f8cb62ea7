// Counts the looks at a control: what a cancel needs in order to be heeded. No time is measured.
#pragma once

#include <atomic>
#include <cstddef>
#include <limits>

#include "base/looks.h"
#include "collision_hulls/error.h"

/// A control that knows how often it was looked at, and ends the run at the look with number `last`, counted from 1.
class CountedLooks {
 public:
  explicit CountedLooks(std::size_t last = std::numeric_limits<std::size_t>::max()) {
    control_.ends = [this, last] { return ++count_ >= last; };
  }

  const collision_hulls::RunControl& control() const { return control_; }
  std::size_t count() const { return count_; }

 private:
  std::atomic<std::size_t> count_{0};
  collision_hulls::RunControl control_;
};

/// How often `work(control)` looks.
template <class Work>
std::size_t looksOf(const Work& work) {
  const CountedLooks looks;
  work(looks.control());
  return looks.count();
}

/// How often `work(control)` looks once it was told, at a look with this number, to end; 0 if it does not end.
template <class Work>
std::size_t looksAfterCancel(std::size_t at, const Work& work) {
  const CountedLooks looks(at);
  try {
    work(looks.control());
  } catch (const collision_hulls::Error& error) {
    if (error.code() == collision_hulls::ErrorCode::kCancelled) return looks.count() - at + 1;
  }
  return 0;
}

/// The looks that a loop over so many small items takes.
inline std::size_t looksFor(std::size_t items) {
  return items / collision_hulls::kItemsBetweenLooks;
}
