// Turns OctoMap's occupancy maps, from files and messages, into boxes of a scene.
//
// For example:
//
//     Scene scene;
//     const Octomap map{true, "OcTree", 0.05, bytes};  // [m]; the data of octomap_msgs/Octomap
//     addOctomap(scene, "office", map);
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

/// A map as in octomap_msgs/Octomap (Hornung et al. 2013). OctoMap's library is not needed to read
/// the format.
struct Octomap {
  /// two bits per child of a node; otherwise one log-odds value per node
  bool binary = true;
  std::string id = "OcTree";   ///< kind of tree: OcTree, or ColorOcTree, whose colours are ignored
  double resolution = 0;       ///< [m] side of the smallest cells
  std::string_view data = {};  ///< the nodes, depth first
};

/// The map's occupied cells (probability 0.5 or more) as boxes in its frame [m]. The boxes do not
/// overlap; boxes that together form a larger box are merged, along x, y and z in turn, until none
/// are left to merge. Throws kBadScene for an unknown kind of tree, a resolution that is not a
/// positive length, nodes below the 16th level, and data that ends early or continues past the last
/// node, or holds values that are not numbers; kTooLarge for more than 20 million cells or 100,000
/// boxes; kCancelled.
std::vector<Eigen::AlignedBox3d> occupiedBoxes(const Octomap& map, const RunControl& control = {});

/// Appends these boxes as bodies "name/1", "name/2", ...; `pose` places the map's frame in the
/// scene. Throws as occupiedBoxes() and addBody() do.
void addOctomap(Scene& scene, const std::string& name, const Octomap& map,
                const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity(),
                const RunControl& control = {});

}  // namespace collision_hulls
