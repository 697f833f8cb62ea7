// Links are few, and all of their pairs are looked at. The scene may have thousands of bodies, which stay: each link's box is compared with
// groups of them.
#include "fit/checked_pairs.h"

#include <algorithm>
#include <utility>

namespace collision_hulls {

CheckedPairs::CheckedPairs(const Assembly& assembly, std::vector<PartPair> pairs)
    : assembly_(assembly), pairs_(std::move(pairs)), with_bodies_(assembly.links()) {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const PartPair& pair = pairs_[i];
    clearance_ = std::max(clearance_, pair.clearance);
    if (assembly.isLink(pair.b)) {
      of_links_.push_back(i);
      continue;
    }
    std::vector<int>& bodies = with_bodies_[pair.a];
    bodies.resize(assembly.parts() - assembly.links(), -1);
    bodies[pair.b - assembly.links()] = static_cast<int>(i);
  }
}

std::vector<std::size_t> CheckedPairs::near(const std::vector<Eigen::AlignedBox3d>& links, double distance) const {
  std::vector<std::size_t> result;
  for (const std::size_t i : of_links_)
    if (links[pairs_[i].a].exteriorDistance(links[pairs_[i].b]) <= distance) result.push_back(i);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(distance);
  for (std::size_t link = 0; link < links.size(); ++link) {
    const std::vector<int>& bodies = with_bodies_[link];
    if (bodies.empty()) continue;
    assembly_.bodyBoxes().visitMeeting({links[link].min() - margin, links[link].max() + margin}, [&](std::size_t body) {
      if (bodies[body] >= 0) result.push_back(static_cast<std::size_t>(bodies[body]));
      return false;
    });
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace collision_hulls
