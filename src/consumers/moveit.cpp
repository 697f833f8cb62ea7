// MoveIt takes the URDF as it is: several <collision> elements a link, a mesh each (a tree of triangles with FCL, a btConvexHullShape with
// Bullet). What it needs beside that is an SRDF, so that neighbours are not checked, nor pairs that can never meet. The latter are proved
// (reach/), where MoveIt's Setup Assistant samples. A link of which some geometry is not from this output is only judged by its joints.
#include <optional>

#include "base/parallel.h"
#include "collision_hulls/reach/reach.h"
#include "collision_hulls/scene/srdf.h"
#include "consumers/written_model.h"
#include "fit/enclosing.h"
#include "scene/text.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

/// A hull around all that a link collides with; nothing if that is not known.
std::optional<ConvexHull> hullOfLink(const LinkDescription& link, const WrittenModel& model) {
  std::vector<Eigen::Vector3d> points;
  for (const GeometryElement& element : link.collisions) {
    if (element.kind == GeometryElement::Kind::kNone) continue;
    const bool is_mesh = element.kind == GeometryElement::Kind::kMesh;
    const ConvexHull* const known = is_mesh ? model.hullOf(element) : nullptr;
    if (!element.fault.empty() || (is_mesh && !known)) return std::nullopt;
    const ConvexHull hull = is_mesh ? transformed(*known, element.origin) : hullAbout(element);
    points.insert(points.end(), hull.vertices.begin(), hull.vertices.end());
  }
  return points.empty() ? ConvexHull() : convexHull(points);
}

struct Pair {
  std::size_t a, b;
  DisabledPair disabled;  // without a reason: it stays enabled
};

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

std::vector<DisabledPair> pairsWithoutCheck(const WrittenModel& model, const RunControl& control) {
  const RobotDescription& robot = model.robot();
  const Kinematics kinematics(robot);
  std::vector<std::optional<ConvexHull>> known;
  std::vector<ConvexHull> hulls;
  for (const LinkDescription& link : robot.links) {
    known.push_back(hullOfLink(link, model));
    hulls.push_back(known.back().value_or(ConvexHull()));
  }
  const auto has_geometry = [&](std::size_t i) { return !known[i] || !known[i]->vertices.empty(); };
  const ReachProver prover(kinematics, hulls, Scene());
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < robot.links.size(); ++a)
    for (std::size_t b = a + 1; b < robot.links.size(); ++b)
      if (has_geometry(a) && has_geometry(b)) pairs.push_back({a, b, {robot.links[a].name, robot.links[b].name, "", ""}});
  forEach(pairs.size(), [&](std::size_t i) {
    Pair& pair = pairs[i];
    if (kinematics.adjacent(pair.a, pair.b)) {
      pair.disabled.reason = "Adjacent";
    } else if (known[pair.a] && known[pair.b] && kinematics.settled(pair.a, pair.b)) {
      const Reach reach = prover.betweenLinks(pair.a, pair.b, 0, {}, control);
      if (reach.outcome != Reach::Outcome::kProved) return;
      pair.disabled.reason = "Never";
      pair.disabled.known = "never within " + leastLengthText(reach.bound) + ", proved";
    }
  });
  std::vector<DisabledPair> disabled;
  for (const Pair& pair : pairs)
    if (!pair.disabled.reason.empty()) disabled.push_back(pair.disabled);
  return disabled;
}

ConsumerFiles moveitFiles(const WrittenModel& model, const RunControl& control) {
  const std::string& name = model.robot().name;
  return {{"config/" + fileName(name) + ".srdf", srdfFragment(name, pairsWithoutCheck(model, control), spheresOf(model.robot()))}};
}

}  // namespace collision_hulls
