// Occupancy maps as OctoMap keeps them, in files and in messages, as boxes of a scene.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

/// A map as octomap_msgs/Octomap has it. Hornung et al. 2013; the format is OctoMap's, read without that library.
struct Octomap {
  bool binary = true;          ///< two bits for each child of a node; else a log-odds value for each node
  std::string id = "OcTree";   ///< kind of tree: OcTree, or ColorOcTree, whose colours are passed over
  double resolution = 0;       ///< [m] side of the smallest cells
  std::string_view data = {};  ///< the nodes, depth first
};

/// Boxes that together are the map's occupied cells (probability of 0.5 and more), in its frame [m]. They do not overlap; boxes that
/// together are a larger one are joined, along x, y, z in turn, until none are. Throws kBadScene for a kind of tree that is not known, a
/// resolution that is no length, nodes below the 16th level, and data that ends early or goes on; kTooLarge for more than 10,000 boxes.
std::vector<Eigen::AlignedBox3d> occupiedBoxes(const Octomap& map);

/// Appends them as bodies "name/1", "name/2", ..., at a pose of the map's frame. Throws the same.
void addOctomap(Scene& scene, const std::string& name, const Octomap& map, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());

}  // namespace collision_hulls
