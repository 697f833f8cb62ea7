// Spelling suggestions for messages about unknown names.
#include "base/nearest_name.h"

#include <algorithm>
#include <numeric>

namespace collision_hulls {

std::size_t editDistance(const std::string& a, const std::string& b) {
  // Three rows of the usual table: row[j] is the distance between a's first i + 1 letters and b's first j; a swap needs the row before the
  // last.
  std::vector<std::size_t> above(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = last[j] + (a[i] == b[j] ? 0 : 1);
      row[j + 1] = std::min({replaced, row[j] + 1, last[j + 1] + 1});
      const bool swaps = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
      if (swaps) row[j + 1] = std::min(row[j + 1], above[j - 1] + 1);
    }
    above.swap(last);
    last.swap(row);
  }
  return last.back();
}

std::string nearestName(const std::string& text, const std::vector<std::string>& names) {
  constexpr std::size_t kShortest = 2;  // letters; less begins too many names
  constexpr std::size_t kLongest = 60;  // what is longer would take long to compare with many names
  if (text.size() < kShortest || text.size() > kLongest) return "";
  std::size_t least = std::max(kShortest, text.size() / 3) + 1;
  std::string nearest;
  for (const std::string& name : names) {
    const bool begins = name.compare(0, text.size(), text) == 0;
    if (!begins && (name.size() >= text.size() + least || text.size() >= name.size() + least))
      continue;  // the lengths alone differ by as much
    const std::size_t distance = begins ? 0 : editDistance(text, name);
    if (distance >= least || distance >= name.size()) continue;
    least = distance;
    nearest = name;
  }
  return nearest;
}

std::string didYouMean(const std::string& text, const std::vector<std::string>& names) {
  const std::string nearest = nearestName(text, names);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

}  // namespace collision_hulls
