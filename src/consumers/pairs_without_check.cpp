// Neighbours, links whose originals touch at rest, as MoveIt's Setup Assistant leaves them out, too, and pairs that can never meet. The
// latter are proved (reach/), where the Setup Assistant samples. A link of which some geometry is not from this output is never proved
// apart. Links of which the hulls alone touch at rest stay checked: that contact is not the robot's.
#include <atomic>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "base/counted.h"
#include "base/parallel.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/query/query_body.h"
#include "collision_hulls/reach/reach.h"
#include "consumers/written_model.h"
#include "fit/detail_tree.h"
#include "fit/enclosing.h"
#include "pipeline/mesh_uses.h"
#include "scene/text.h"

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

constexpr const char* kTouchesAtRest = "Default";  // what the Setup Assistant calls it

constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;  // of all pairs: as much as may be read again

/// What links collided with before they had hulls: the meshes that were decomposed, and the primitives that stay. In a link where others
/// stand in place of hulls these are not told apart, and are left out. Immutable, thread safe.
class OriginalsAtRest {
 public:
  OriginalsAtRest(const WrittenModel& model, const Kinematics& kinematics, const RunControl& control)
      : of_link_(model.robot().links.size()), places_(kinematics.poses(kinematics.rest())) {
    const std::vector<LinkDescription>& links = model.robot().links;
    std::map<std::string, std::size_t> index;
    for (std::size_t i = 0; i < links.size(); ++i) index[links[i].name] = i;
    const std::vector<ElementResult>& elements = model.result().elements;
    const std::vector<QueryBody> meshes = bodiesOf(model, control);
    std::vector<char> has_new_primitives(links.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (meshes[i].empty()) continue;
      const std::size_t link = index.at(elements[i].link);
      of_link_[link].push_back({meshes[i], elements[i].source.origin});
      if (!elements[i].primitives.empty()) has_new_primitives[link] = 1;
    }
    for (std::size_t i = 0; i < links.size(); ++i)
      for (const GeometryElement& element : links[i].collisions)
        if (!has_new_primitives[i] && isSolidPrimitive(element)) of_link_[i].push_back({queryBody(element), Eigen::Isometry3d::Identity()});
  }

  bool touch(std::size_t a, std::size_t b) const {
    const Eigen::Isometry3d to_first = places_[a].inverse() * places_[b];
    for (const Body& first : of_link_[a]) {
      for (const Body& second : of_link_[b]) {
        const Eigen::Isometry3d pose = first.origin.inverse() * to_first * second.origin;
        if (!apart(first.body.box(), second.body.box(), pose) && collision_hulls::touch(first.body, second.body, pose)) return true;
      }
    }
    return false;
  }

 private:
  /// Of each element; a mesh that is used many times has one tree.
  static std::vector<QueryBody> bodiesOf(const WrittenModel& model, const RunControl& control) {
    const std::vector<ElementResult>& elements = model.result().elements;
    std::map<std::tuple<std::string, double, double, double>, std::size_t> first;  // by content and scale
    std::vector<std::size_t> like(elements.size()), own;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Eigen::Vector3d& scale = elements[i].source.scale;
      const auto [known, is_new] =
          first.emplace(std::make_tuple(model.result().report.links[i].sha256, scale.x(), scale.y(), scale.z()), i);
      like[i] = known->second;
      if (is_new) own.push_back(i);
    }
    std::vector<QueryBody> bodies(elements.size(), QueryBody(TriangleMesh()));
    forEach(own.size(), [&](std::size_t k) { bodies[own[k]] = QueryBody(elements[own[k]].original, control); });
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i] = bodies[like[i]];
    return bodies;
  }

  struct Body {
    QueryBody body;
    Eigen::Isometry3d origin;  // in the link's frame
  };
  std::vector<std::vector<Body>> of_link_;
  std::vector<Eigen::Isometry3d> places_;
};

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
  const OriginalsAtRest originals(model, kinematics, control);
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
      } else if (originals.touch(a, b)) {
        disable(b, kTouchesAtRest, "the originals touch at rest");
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

std::vector<std::string> notesOn(const std::vector<DisabledPair>& pairs) {
  constexpr std::size_t kMostNamed = 3;
  std::string names;
  std::size_t count = 0;
  for (const DisabledPair& pair : pairs)
    if (pair.reason == kTouchesAtRest && ++count <= kMostNamed)
      names += (count == 1 ? "'" : ", '") + shortened(pair.link1) + "' and '" + shortened(pair.link2) + "'";
  if (count == 0) return {};
  const std::string more = count > kMostNamed ? ", and " + counted(count - kMostNamed, "more pair") : "";
  return {"links that touch at rest in the original already are not checked against each other by the files of --for: " + names + more +
          "; delete there what has to be checked"};
}

}  // namespace collision_hulls
