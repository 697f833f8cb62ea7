// Contacts are found by brute force over pairs of nodes, with cheap tests first: boxes of whole parts, boxes of nodes in the scene's frame,
// oriented boxes (apart), and only then FCL (touch). There is no tree over the nodes, since cuts are small and change with every node
// opened.
#include "fit/assembly.h"

#include <map>
#include <variant>

namespace collision_hulls {
namespace {

/// A node placed in the scene.
struct PlacedNode {
  int piece, node;
  const QueryBody* body;
  const Eigen::Isometry3d* place;
  Eigen::AlignedBox3d box;
};

struct PlacedPart {
  std::vector<PlacedNode> nodes;
  Eigen::AlignedBox3d box;
};

std::vector<Eigen::Isometry3d> placesOfPieces(const Assembly& assembly, const Places& places) {
  std::vector<Eigen::Isometry3d> result;
  for (const Piece& piece : assembly.pieces()) result.push_back(places[piece.part] * piece.origin);
  return result;
}

std::vector<PlacedPart> placedParts(const Assembly& assembly, const Cuts& cuts, const std::vector<Eigen::Isometry3d>& of_pieces) {
  std::vector<PlacedPart> parts(assembly.parts());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Piece& piece = assembly.pieces()[i];
    PlacedPart& part = parts[piece.part];
    for (const int node : cuts[i]) {
      const QueryBody& body = piece.tree->body(node);
      part.nodes.push_back({static_cast<int>(i), node, &body, &of_pieces[i], placed(body.box(), of_pieces[i])});
      part.box.extend(part.nodes.back().box);
    }
  }
  return parts;
}

/// Visits all contacts between the parts of these pairs until `visit` returns false.
template <typename Visit>
void visitContacts(const Assembly& assembly, const Cuts& cuts, const std::vector<PartPair>& pairs, const Places& places,
                   const Visit& visit) {
  const std::vector<Eigen::Isometry3d> of_pieces = placesOfPieces(assembly, places);
  const std::vector<PlacedPart> parts = placedParts(assembly, cuts, of_pieces);
  for (const PartPair& pair : pairs) {
    const PlacedPart &a = parts[pair.a], &b = parts[pair.b];
    if (!a.box.intersects(b.box)) continue;
    for (const PlacedNode& m : a.nodes) {
      if (!m.box.intersects(b.box)) continue;
      for (const PlacedNode& n : b.nodes) {
        if (!m.box.intersects(n.box)) continue;
        const Eigen::Isometry3d pose = m.place->inverse() * *n.place;
        if (!apart(m.body->box(), n.body->box(), pose) && touch(*m.body, *n.body, pose) && !visit(m, n, pose)) return;
      }
    }
  }
}

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
  const auto add = [&](std::size_t part, const QueryBody& body) {
    pieces_.push_back({part, Eigen::Isometry3d::Identity(), std::make_shared<const DetailTree>(body)});
  };
  for (const KeptBody& kept : problem.kept) add(kept.link, QueryBody(kept.hull));
  for (std::size_t i = 0; i < problem.scene.bodies.size(); ++i)
    add(links() + i, std::visit([&](const auto& shape) { return queryBodyOf(shape, control); }, problem.scene.bodies[i].shape));
  for (std::size_t i = 0; i < pieces_.size(); ++i) of_part_[pieces_[i].part].push_back(static_cast<int>(i));
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

bool touches(const Assembly& assembly, const Contact& contact, int first, int second) {
  const auto body = [&](int side, int node) -> const QueryBody& {
    return assembly.pieces()[static_cast<std::size_t>(contact.piece[side])].tree->body(node);
  };
  const QueryBody &a = body(0, first), &b = body(1, second);
  return !apart(a.box(), b.box(), contact.pose) && touch(a, b, contact.pose);
}

std::vector<Contact> contacts(const Assembly& assembly, const Cuts& cuts, const std::vector<PartPair>& pairs, const Places& places,
                              std::size_t sample) {
  std::vector<Contact> result;
  visitContacts(assembly, cuts, pairs, places, [&](const PlacedNode& m, const PlacedNode& n, const Eigen::Isometry3d& pose) {
    result.push_back({sample, {m.piece, n.piece}, {m.node, n.node}, pose});
    return true;
  });
  return result;
}

bool inContact(const Assembly& assembly, const Cuts& cuts, const std::vector<PartPair>& pairs, const Places& places) {
  bool found = false;
  visitContacts(assembly, cuts, pairs, places, [&](const PlacedNode&, const PlacedNode&, const Eigen::Isometry3d&) {
    found = true;
    return false;
  });
  return found;
}

}  // namespace collision_hulls
