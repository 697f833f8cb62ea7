// Sorts the hulls' centres along one axis: O(n log n). Hulls at one place keep their order. The halves depend on the hulls alone, never on
// the number of threads, and so the results of whoever searches them in parallel do not either.
#include "measure/halves_by_place.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace collision_hulls {

std::pair<std::vector<std::size_t>, std::vector<std::size_t>> halvesByPlace(const std::vector<ConvexHull>& hulls,
                                                                            const std::vector<std::size_t>& some) {
  std::vector<std::pair<Eigen::Vector3d, std::size_t>> centres;
  Eigen::AlignedBox3d box;
  for (const std::size_t i : some) box.extend(centres.emplace_back(boundingBox(hulls[i]).center(), i).first);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  std::stable_sort(centres.begin(), centres.end(), [axis](const auto& a, const auto& b) { return a.first[axis] < b.first[axis]; });
  std::pair<std::vector<std::size_t>, std::vector<std::size_t>> halves;
  for (std::size_t k = 0; k < centres.size(); ++k) (k < centres.size() / 2 ? halves.first : halves.second).push_back(centres[k].second);
  return halves;
}

}  // namespace collision_hulls
