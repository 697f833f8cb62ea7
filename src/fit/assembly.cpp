// Pieces share the tree of their mesh; a body of the scene is one piece that never moves.
#include "fit/assembly.h"

#include <map>
#include <variant>

namespace collision_hulls {
namespace {

QueryBody queryBodyOf(const ConvexHull& hull, const RunControl&) {
  return QueryBody(hull);
}

QueryBody queryBodyOf(const TriangleMesh& mesh, const RunControl& control) {
  return QueryBody(mesh, control);
}

}  // namespace

Assembly::Assembly(const FitProblem& problem, std::uint64_t seed, const RunControl& control)
    : problem_(problem),
      kinematics_(problem.robot),
      even_(kinematics_, seed),
      independent_(kinematics_, seed, Sampling::kIndependent),
      of_part_(parts()) {
  std::map<const FitMesh*, std::shared_ptr<const DetailTree>> trees;  // elements with the same mesh share its tree
  for (const FitElement& element : problem.elements) {
    std::shared_ptr<const DetailTree>& tree = trees[element.mesh.get()];
    if (!tree) tree = std::make_shared<const DetailTree>(element.mesh);
    pieces_.push_back({element.link, element.origin, tree});
  }
  const auto add = [&](std::size_t part, const auto& body) {
    const QueryBody query = std::visit([&](const auto& shape) { return queryBodyOf(shape, control); }, body.shape);
    pieces_.push_back({part, Eigen::Isometry3d::Identity(), std::make_shared<const DetailTree>(query)});
  };
  for (const KeptBody& kept : problem.kept) add(kept.link, kept);
  for (std::size_t i = 0; i < problem.scene.bodies.size(); ++i) add(links() + i, problem.scene.bodies[i]);
  for (std::size_t i = 0; i < pieces_.size(); ++i) of_part_[pieces_[i].part].push_back(static_cast<int>(i));
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t part = links(); part < parts(); ++part) {
    const DetailTree& tree = *pieces_[static_cast<std::size_t>(of_part_[part].front())].tree;
    boxes.push_back(placed(tree.body(tree.root()).box(), problem.scene.bodies[part - links()].pose));
  }
  body_boxes_ = BoxGroups(boxes);
}

const std::string& Assembly::name(std::size_t part) const {
  return isLink(part) ? problem_.robot.links[part].name : problem_.scene.bodies[part - links()].name;
}

Cuts Assembly::roots() const {
  Cuts cuts;
  for (const Piece& piece : pieces_) cuts.push_back({piece.tree->root()});
  return cuts;
}

Cuts Assembly::cheapest(const Cuts& cuts) const {
  Cuts result = cuts;
  for (std::size_t i = 0; i < problem_.elements.size(); ++i)
    for (int& node : result[i]) node = pieces_[i].tree->cheapest(node);
  return result;
}

std::size_t Assembly::hulls(const Cuts& cuts) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < problem_.elements.size(); ++i) count += cuts[i].size();
  return count;
}

Configuration Assembly::sample(std::size_t index) const {
  if (!problem_.configurations.empty()) return problem_.configurations[index];
  return index < kIndependentFrom ? even_(index) : independent_(index - kIndependentFrom);
}

std::vector<Eigen::Isometry3d> Places::all() const {
  std::vector<Eigen::Isometry3d> poses = links_;
  for (const SceneBody& body : *bodies_) poses.push_back(body.pose);
  return poses;
}

Places Assembly::places(const Configuration& configuration) const {
  return {kinematics_.poses(configuration), problem_.scene.bodies};
}

}  // namespace collision_hulls
