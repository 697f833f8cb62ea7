// What no hulls replace is in the new description as it was in the old one, and a planner checks it all the same. A link that is kept and
// of which a part is unknown does not take part: pairs with the rest of it might count as never meeting, and be disabled.
#include "pipeline/scene/kept_bodies.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/fit_scene.h"
#include "fit/enclosing.h"
#include "pipeline/mesh_uses.h"
#include "robot/far_away.h"
#include "scene/reading.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

constexpr std::size_t kMostLinksNamed = 3;  // in a note

bool isMesh(const GeometryElement& element) {
  return element.kind == Kind::kMesh;
}

/// Reads what links keep. A mesh that cannot be read is tried once.
class KeptShapes {
 public:
  KeptShapes(const RobotDescription& robot, const SceneReading& how) : robot_(robot), how_(how), meshes_(how, "the links that are kept") {}

  /// All of these elements, or none. Dummies without a size are none.
  void add(std::size_t link, const std::vector<GeometryElement>& elements) {
    std::vector<KeptBody> bodies;
    for (const GeometryElement& element : elements) {
      how_.control.check();
      const std::string fault = isMesh(element) ? addMesh(link, element, bodies) : addPrimitive(link, element, bodies);
      if (!fault.empty()) return without(link, fault);
    }
    std::move(bodies.begin(), bodies.end(), std::back_inserter(kept));
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> result;
    for (const auto& [fault, links] : left_out_) {
      const bool one = links.size() == 1;
      result.push_back(fault + ": the fit ignores the elements that " + (one ? "link " : "links ") + listedFirst(links, kMostLinksNamed) +
                       (one ? " keeps" : " keep") + ", so collisions with them were not checked");
    }
    if (!flat_.empty())
      result.push_back((flat_.size() == 1 ? "link " : "links ") +
                       listedFirst(std::vector<std::string>(flat_.begin(), flat_.end()), kMostLinksNamed) +
                       (flat_.size() == 1 ? " has" : " have") + " a primitive without a size; the fit ignores it");
    return result;
  }

  std::vector<KeptBody> kept;

 private:
  /// The reason why it cannot take part, or nothing.
  std::string addMesh(std::size_t link, const GeometryElement& element, std::vector<KeptBody>& bodies) {
    if (!element.fault.empty()) return element.fault;
    std::string& fault = faults_[element.uri];
    if (!fault.empty() || !full_.empty()) return fault.empty() ? full_ : fault;
    try {
      TriangleMesh mesh = transformed(meshes_.read(element.uri, element.scale, robot_.path), element.origin);
      const bool is_far = std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Eigen::Vector3d& v) { return isFarAway(v); });
      if (is_far) return "'" + element.uri + "' reaches more than 1000 km away; correct its scale";
      bodies.push_back({link, std::move(mesh)});
    } catch (const Error& error) {
      if (error.code() == ErrorCode::kCancelled) throw;
      if (error.code() == ErrorCode::kBadScale) return error.what();  // of this element, and not of the file
      fault = error.what();
      if (meshes_.isFull()) full_ = fault;
      return fault;
    }
    return "";
  }

  std::string addPrimitive(std::size_t link, const GeometryElement& element, std::vector<KeptBody>& bodies) {
    if (!element.fault.empty()) return element.fault;
    if (element.kind == Kind::kNone) return "";
    if (!isSolidPrimitive(element)) {
      flat_.insert(quoted(link));
      return "";
    }
    try {
      bodies.push_back({link, hullAbout(element)});
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  void without(std::size_t link, const std::string& fault) { left_out_[fault].push_back(quoted(link)); }
  std::string quoted(std::size_t link) const { return "'" + shortened(robot_.links[link].name) + "'"; }

  const RobotDescription& robot_;
  const SceneReading& how_;
  MeshLibrary meshes_;
  std::map<std::string, std::string> faults_;                 // by URI; empty: none
  std::string full_;                                          // why no more are read; empty: they are
  std::map<std::string, std::vector<std::string>> left_out_;  // quoted links by reason
  std::set<std::string> flat_;                                // quoted links with primitives that nothing can hit
};

}  // namespace

std::vector<KeptBody> keptBodies(const RobotDescription& robot, const LinkDecisions& decisions, const std::set<std::string>& failed,
                                 const PackageFinder& find_package, const Options& options, std::vector<std::string>& notes,
                                 const RunControl& control) {
  const MeshLimits limits = meshLimits(options);
  const SceneReading how{find_package, limits, control};
  KeptShapes shapes(robot, how);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const LinkDescription& link = robot.links[i];
    const LinkOptions* const decided = decisions.of(link.name);
    const CollisionFate fate = collisionFate(link, decided, failed.count(link.name) > 0);
    if (fate == CollisionFate::kStay) shapes.add(i, link.collisions);
    if (fate != CollisionFate::kReplaced) continue;
    const SourceElements source = sourceElements(link, decided->source);
    std::vector<GeometryElement> others;  // beside the hulls
    for (const GeometryElement& element : source.elements)
      if (!isMesh(element) && !(source.visual && element.fault.empty() && !isSolidPrimitive(element))) others.push_back(element);
    shapes.add(i, others);
  }
  for (std::string& note : shapes.notes()) notes.push_back(std::move(note));
  return std::move(shapes.kept);
}

}  // namespace collision_hulls
