// A robot's model in a scene, as planners ask about it: is this state free?
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planning/robot_model.h"

namespace collision_hulls {

/// Who checks.
enum class CheckerKind {
  kBoxes,  ///< BoxedModel; hulls are convex bodies
  kTrees,  ///< FCL's dynamic trees over all bodies; hulls are convex bodies
  kMoveIt  ///< the same as MoveIt has it: hulls are meshes of triangles, like any mesh of a description
};
const char* name(CheckerKind kind);  ///< "boxes", "trees", "moveit"
std::optional<CheckerKind> checkerNamed(const std::string& name);

/// Asks the scene first, then the robot against itself, up to the first contact. As in FCL and MoveIt, meshes are surfaces without an
/// inside. Primitives of the robot are FCL's own. Not thread safe.
class Checker {
 public:
  virtual ~Checker() = default;
  /// `links`: poses in the root link's frame, one for each link.
  virtual bool collides(const std::vector<Eigen::Isometry3d>& links) = 0;
};

/// `ignored`: see SceneModels.
std::unique_ptr<Checker> makeChecker(CheckerKind kind, const RobotModel& robot, std::size_t links, const Scene& scene,
                                     const IgnoredPairs& ignored);

/// The pairs of links that touch each other, without ignored ones.
std::vector<std::pair<std::size_t, std::size_t>> touchingLinks(const RobotModel& robot, const IgnoredPairs& ignored,
                                                               const std::vector<Eigen::Isometry3d>& links);

}  // namespace collision_hulls
