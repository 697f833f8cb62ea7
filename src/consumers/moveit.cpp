// MoveIt takes the URDF as it is: several <collision> elements a link, a mesh each (a tree of triangles with FCL, a btConvexHullShape with
// Bullet). What it needs beside that is an SRDF, so that neighbours are not checked, nor pairs that can never meet. The latter are proved
// (reach/), where MoveIt's Setup Assistant samples. A link of which some geometry is not from this output is only judged by its joints.
#include <atomic>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "collision_hulls/error.h"
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

constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;  // of all pairs: as much as may be read again

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
    control.check();
    known.push_back(hullOfLink(link, model));
    hulls.push_back(known.back().value_or(ConvexHull()));
  }
  const auto has_geometry = [&](std::size_t i) { return !known[i] || !known[i]->vertices.empty(); };
  const ReachProver prover(kinematics, hulls, Scene());
  std::vector<std::vector<DisabledPair>> of_links(robot.links.size());
  std::atomic<std::uintmax_t> bytes{0};
  forEach(robot.links.size(), [&](std::size_t a) {
    const auto disable = [&](std::size_t b, const std::string& reason, const std::string& proof) {
      of_links[a].push_back({robot.links[a].name, robot.links[b].name, reason, proof});
      bytes += sizeof(DisabledPair) + robot.links[a].name.size() + robot.links[b].name.size();
      if (bytes > kMostBytes)
        throw Error(ErrorCode::kTooLarge, "more pairs of links need no check than 256 MiB hold; join links that are fixed to each other");
    };
    for (std::size_t b = a + 1; b < robot.links.size(); ++b) {
      control.check();
      if (!has_geometry(a) || !has_geometry(b)) continue;
      if (kinematics.adjacent(a, b)) {
        disable(b, "Adjacent", "");
      } else if (known[a] && known[b] && kinematics.settled(a, b)) {
        const Reach reach = prover.betweenLinks(a, b, 0, {}, control);
        if (reach.outcome == Reach::Outcome::kProved) disable(b, "Never", "never within " + leastLengthText(reach.bound) + ", proved");
      }
    }
  });
  std::vector<DisabledPair> disabled;
  for (std::vector<DisabledPair>& some : of_links) std::move(some.begin(), some.end(), std::back_inserter(disabled));
  return disabled;
}

ConsumerFiles moveitFiles(const WrittenModel& model, const RunControl& control) {
  const std::string& name = model.robot().name;
  return {{"config/" + fileName(name) + ".srdf", srdfFragment(name, pairsWithoutCheck(model, control), spheresOf(model.robot()))}};
}

}  // namespace collision_hulls
