// What no hulls replace is in the new description as it was in the old one, and a planner checks it all the same.
#include "pipeline/scene/kept_bodies.h"

#include <utility>

#include "base/counted.h"
#include "collision_hulls/error.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/pipeline/fit_scene.h"
#include "fit/enclosing.h"
#include "scene/reading.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

/// Reads what links keep.
class KeptShapes {
 public:
  KeptShapes(const RobotDescription& robot, const SceneReading& how) : robot_(robot), meshes_(how) {}

  void add(std::size_t link, const GeometryElement& element) {
    try {
      if (element.kind == Kind::kMesh)
        kept.push_back({link, transformed(meshes_.read(element.uri, element.scale, robot_.path), element.origin)});
      else if (element.kind != Kind::kNone)
        kept.push_back({link, hullAbout(element)});
    } catch (const Error& error) {
      if (error.code() == ErrorCode::kCancelled) throw;
      if (unused_++ == 0) first_unused_ = "link '" + robot_.links[link].name + "': " + error.what();
    }
  }

  std::vector<std::string> notes() const {
    if (unused_ == 0) return {};
    const std::string others = unused_ > 1 ? ", and of " + counted(unused_ - 1, "more element") + " like it" : "";
    return {first_unused_ + "; the fit knows nothing of this element" + others + ", so collisions there were not sampled"};
  }

  std::vector<KeptBody> kept;

 private:
  const RobotDescription& robot_;
  MeshLibrary meshes_;
  std::size_t unused_ = 0;
  std::string first_unused_;
};

}  // namespace

std::vector<KeptBody> keptBodies(const RobotDescription& robot, const LinkDecisions& decisions, const std::set<std::string>& absent,
                                 const PackageFinder& find_package, const Options& options, std::vector<std::string>& notes,
                                 const RunControl& control) {
  const MeshLimits limits = meshLimits(options);
  const SceneReading how{find_package, limits, control};
  KeptShapes shapes(robot, how);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const LinkDescription& link = robot.links[i];
    const LinkOptions* const decided = decisions.of(link.name);
    const Action action = decided ? decided->action : Action::kKeep;
    if (action == Action::kKeep)
      for (const GeometryElement& element : link.collisions) shapes.add(i, element);
    if (action == Action::kDecompose && absent.count(link.name) == 0)
      for (const GeometryElement& element : sourceElements(link, decided->source).elements)
        if (element.kind != Kind::kMesh) shapes.add(i, element);
  }
  for (std::string& note : shapes.notes()) notes.push_back(std::move(note));
  return std::move(shapes.kept);
}

}  // namespace collision_hulls
