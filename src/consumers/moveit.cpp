// MoveIt takes the URDF as it is: several <collision> elements a link, a mesh each (a tree of triangles with FCL, a btConvexHullShape with
// Bullet). What it needs beside that is an SRDF, with the pairs that it need not check.
#include "collision_hulls/scene/srdf.h"
#include "consumers/written_model.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

/// For planners and distance fields that take spheres (moveit_core's collision_distance_field): where a link has nothing but them.
std::vector<SphereApproximation> spheresOf(const RobotDescription& robot) {
  std::vector<SphereApproximation> all;
  for (const LinkDescription& link : robot.links) {
    SphereApproximation spheres{link.name, {}};
    bool has_others = false;
    for (const GeometryElement& element : link.collisions) {
      if (element.kind == GeometryElement::Kind::kSphere)
        spheres.spheres.push_back({element.origin.translation(), element.size.x()});
      else
        has_others = has_others || element.kind != GeometryElement::Kind::kNone;
    }
    if (!has_others && !spheres.spheres.empty()) all.push_back(std::move(spheres));
  }
  return all;
}

}  // namespace

ConsumerFiles moveitFiles(const WrittenModel& model, const std::vector<DisabledPair>& pairs) {
  const std::string& name = model.robot().name;
  return {{"config/" + robotFileName(name) + ".srdf", srdfFragment(name, pairs, spheresOf(model.robot()))}};
}

}  // namespace collision_hulls
