// Loops over many small items that can be cancelled.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// Between two looks at the control, if an item takes less than a microsecond; and if it takes some ten.
constexpr std::size_t kItemsBetweenLooks = 1 << 14, kLargeItemsBetweenLooks = 1 << 8;

/// Looks at a control now and then: `Looks look(control);` before a loop, `look();` for each item. Each thread needs its own.
class Looks {
 public:
  explicit Looks(const RunControl& control, std::size_t items = kItemsBetweenLooks) : control_(control), items_(items), left_(items) {}

  /// Throws what RunControl::check() throws.
  void operator()() {
    if (--left_ > 0) return;
    left_ = items_;
    control_.check();
  }

 private:
  const RunControl& control_;
  const std::size_t items_;
  std::size_t left_;
};

/// Makes a vector larger, bit by bit: the kernel takes its time over much memory. Throws what RunControl::check() throws.
template <class Item>
void enlarge(std::vector<Item>& items, std::size_t size, const RunControl& control) {
  items.reserve(size);
  for (; items.size() < size; items.resize(std::min(size, items.size() + kItemsBetweenLooks))) control.check();
}

}  // namespace collision_hulls
