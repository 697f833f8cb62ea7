// Links whose hulls touch with all joints at rest, though their meshes do not.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/mesh_uses.h"

namespace collision_hulls {

/// Two links (indices) whose hulls touch.
struct RestContact {
  std::size_t first = 0, second = 0;
  double apart = 0;       ///< [m] the least distance between meshes whose hulls touch
  bool at_least = false;  ///< they are further apart than that, which is 1 mm more than the hulls protrude: one is inside the other
};

/// The pairs of links that no joint joins whose hulls, or the primitives in place of hulls, touch at Kinematics::rest(), though no meshes
/// there do; those with the largest gap first. Meshes count as surfaces, as in FCL and MoveIt. Of what stays as it was, such as the
/// description's own primitives, nothing is asked. Looks at no more than 1,000 pairs of meshes whose boxes meet. Throws kCancelled, and
/// the errors of Kinematics.
std::vector<RestContact> restContacts(const RobotDescription& robot, const std::vector<MeshUse>& uses, const MeshResults& results,
                                      std::size_t model, const RunControl& control = {});

/// One note on all of them, which names what touches (hulls, primitives, spheres), with the remedy; none if there are none. Where the
/// joints are at fault, it says so.
std::vector<std::string> notesOnRestContacts(const RobotDescription& robot, const std::vector<MeshUse>& uses, const MeshResults& results,
                                             std::size_t model, const RunControl& control = {});

}  // namespace collision_hulls
