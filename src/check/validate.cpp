// Checks pairs in parallel and sums up the results in the order of the pairs.
#include "collision_hulls/check/validate.h"

#include <algorithm>
#include <mutex>

#include "base/median.h"
#include "base/parallel.h"
#include "check/validate_pair.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kMostNeighbours = 4;
constexpr double kNeighbourhood = 0.25;  // how far away neighbours may be, as a share of the element's diagonal

/// The boxes of a pair; empty for a pair that cannot be checked.
struct Boxes {
  Eigen::AlignedBox3d all;
  std::vector<Eigen::AlignedBox3d> hulls;
};

Boxes boxesOf(const ValidationPair& pair) {
  Boxes boxes;
  boxes.all = boundingBox(pair.original);
  for (const ConvexHull& hull : pair.hulls) {
    boxes.hulls.push_back(boundingBox(hull));
    boxes.all.extend(boxes.hulls.back());
  }
  return boxes;
}

/// The hulls of other elements whose boxes are nearest to the element's.
std::vector<Neighbour> neighboursOf(std::size_t index, const std::vector<ValidationPair>& pairs, const std::vector<Boxes>& boxes) {
  const Eigen::AlignedBox3d& box = boxes[index].all;
  std::vector<std::pair<double, Neighbour>> near;
  for (std::size_t other = 0; other < pairs.size(); ++other) {
    for (std::size_t h = 0; other != index && h < boxes[other].hulls.size(); ++h) {
      const double apart = box.exteriorDistance(boxes[other].hulls[h]);
      if (apart <= kNeighbourhood * box.diagonal().norm()) near.push_back({apart, {pairs[other].name, &pairs[other].hulls[h]}});
    }
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Neighbour> result;
  for (std::size_t i = 0; i < std::min(near.size(), kMostNeighbours); ++i) result.push_back(near[i].second);
  return result;
}

Validation merged(const std::vector<std::vector<PairResult>>& results) {
  Validation sum;
  std::vector<double> mesh_us, hull_us;
  std::vector<PairResult> all;
  for (const std::vector<PairResult>& of_pair : results) all.insert(all.end(), of_pair.begin(), of_pair.end());
  for (const PairResult& result : all) {
    const Validation& counts = result.counts;
    sum.queries += counts.queries;
    sum.missed += counts.missed;
    sum.phantom += counts.phantom;
    sum.max_underestimate = std::max(sum.max_underestimate, counts.max_underestimate);
    sum.exceptions += counts.exceptions;
    sum.timeouts += counts.timeouts;
    sum.nan += counts.nan;
    sum.disagreements += counts.disagreements;
    for (const std::string& remark : counts.remarks)
      if (sum.remarks.size() < kMostRemarks) sum.remarks.push_back(remark);
    mesh_us.insert(mesh_us.end(), result.mesh_us.begin(), result.mesh_us.end());
    hull_us.insert(hull_us.end(), result.hull_us.begin(), result.hull_us.end());
  }
  sum.mesh_query_us = median(std::move(mesh_us));
  sum.hull_query_us = median(std::move(hull_us));
  return sum;
}

/// Reports a pair that was not checked; if that is due to a fault, its queries count as NaN.
PairResult notChecked(const ValidationPair& pair, const std::string& why, std::size_t queries) {
  PairResult result;
  result.counts.queries = result.counts.nan = queries;
  result.counts.remarks.push_back(pair.name + ": not checked, " + why);
  return result;
}

/// Reports the share of finished pairs from any thread.
class Finished {
 public:
  Finished(std::size_t total, const RunControl& control) : total_(total), control_(control) {}
  void one() {
    const std::lock_guard<std::mutex> lock(mutex_);
    control_.report(static_cast<double>(++done_) / static_cast<double>(total_));
  }

 private:
  std::mutex mutex_;
  std::size_t done_ = 0;
  const std::size_t total_;
  const RunControl& control_;
};

}  // namespace

Validation validate(std::vector<ValidationPair> pairs, const ValidationOptions& options, const RunControl& control) {
  if (options.queries_per_pair < 0)
    throw Error(ErrorCode::kBadOption,
                "validation: the number of queries per pair is " + std::to_string(options.queries_per_pair) + "; give 0 or more");
  std::vector<std::string> faults;
  std::vector<Boxes> pair_boxes(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    control.check();
    faults.push_back(fault(pairs[i]));
    control.check();
    if (faults[i].empty()) pair_boxes[i] = boxesOf(pairs[i]);
  }
  const std::vector<ProbeShape> boxes = boxShapes();
  std::vector<std::vector<PairResult>> results(pairs.size());
  Finished finished(pairs.size(), control);
  const auto check = [&](std::size_t i) {
    control.check();
    if (!faults[i].empty())
      results[i] = {notChecked(pairs[i], faults[i], static_cast<std::size_t>(options.queries_per_pair))};
    else if (pairs[i].original.triangles.empty())
      results[i] = {notChecked(pairs[i], "its original has no triangles", 0)};
    else
      results[i] = validatePair(pairs[i], i, boxes, neighboursOf(i, pairs, pair_boxes), options, control);
    finished.one();
  };
  forEach(pairs.size(), check);
  return merged(results);
}

}  // namespace collision_hulls
