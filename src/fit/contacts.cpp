// Cheap tests first: boxes of whole parts, boxes of nodes in the scene's frame, oriented boxes (apart), and only then FCL (touch). There is
// no tree over the nodes of links, since cuts are small and change with every node opened.
#include "fit/contacts.h"

namespace collision_hulls {
namespace {

/// A node placed in the scene.
struct PlacedNode {
  int piece, node;
  const QueryBody* body;
  Eigen::Isometry3d place;
  Eigen::AlignedBox3d box;
};

using PlacedNodes = std::vector<PlacedNode>;

Eigen::AlignedBox3d boxOf(const PlacedNodes& nodes) {
  Eigen::AlignedBox3d box;
  for (const PlacedNode& node : nodes) box.extend(node.box);
  return box;
}

PlacedNodes placedPart(const Assembly& assembly, const Cuts& cuts, std::size_t part, const Places& places) {
  PlacedNodes nodes;
  for (const int i : assembly.piecesOf(part)) {
    const Piece& piece = assembly.pieces()[static_cast<std::size_t>(i)];
    const Eigen::Isometry3d place = places[part] * piece.origin;
    for (const int node : cuts[static_cast<std::size_t>(i)]) {
      const QueryBody& body = piece.tree->body(node);
      nodes.push_back({i, node, &body, place, placed(body.box(), place)});
    }
  }
  return nodes;
}

/// Visits all contacts between the parts of these pairs until `visit` returns false.
template <typename Visit>
void visitContacts(const Assembly& assembly, const Cuts& cuts, const CheckedPairs& pairs, const Places& places, const Visit& visit) {
  std::vector<PlacedNodes> links;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t link = 0; link < assembly.links(); ++link) {
    links.push_back(placedPart(assembly, cuts, link, places));
    boxes.push_back(boxOf(links.back()));
  }
  for (const std::size_t index : pairs.near(boxes, 0)) {
    const PartPair& pair = pairs.all()[index];
    const PlacedNodes of_body = assembly.isLink(pair.b) ? PlacedNodes() : placedPart(assembly, cuts, pair.b, places);
    const PlacedNodes &a = links[pair.a], &b = assembly.isLink(pair.b) ? links[pair.b] : of_body;
    const Eigen::AlignedBox3d around_b = boxOf(b);
    for (const PlacedNode& m : a) {
      if (!m.box.intersects(around_b)) continue;
      for (const PlacedNode& n : b) {
        if (!m.box.intersects(n.box)) continue;
        const Eigen::Isometry3d pose = m.place.inverse() * n.place;
        if (!apart(m.body->box(), n.body->box(), pose) && touch(*m.body, *n.body, pose) && !visit(m, n, pose)) return;
      }
    }
  }
}

}  // namespace

bool touches(const Assembly& assembly, const Contact& contact, int first, int second) {
  const auto body = [&](int side, int node) -> const QueryBody& {
    return assembly.pieces()[static_cast<std::size_t>(contact.piece[side])].tree->body(node);
  };
  const QueryBody &a = body(0, first), &b = body(1, second);
  return !apart(a.box(), b.box(), contact.pose) && touch(a, b, contact.pose);
}

std::vector<Contact> contacts(const Assembly& assembly, const Cuts& cuts, const CheckedPairs& pairs, const Places& places,
                              std::size_t sample) {
  std::vector<Contact> result;
  visitContacts(assembly, cuts, pairs, places, [&](const PlacedNode& m, const PlacedNode& n, const Eigen::Isometry3d& pose) {
    result.push_back({sample, {m.piece, n.piece}, {m.node, n.node}, pose});
    return true;
  });
  return result;
}

std::set<PartIndices> partsOf(const Assembly& assembly, const std::vector<Contact>& contacts) {
  const auto part = [&](int piece) { return assembly.pieces()[static_cast<std::size_t>(piece)].part; };
  std::set<PartIndices> parts;
  for (const Contact& contact : contacts) parts.emplace(part(contact.piece[0]), part(contact.piece[1]));
  return parts;
}

bool inContact(const Assembly& assembly, const Cuts& cuts, const CheckedPairs& pairs, const Places& places) {
  bool found = false;
  visitContacts(assembly, cuts, pairs, places, [&](const PlacedNode&, const PlacedNode&, const Eigen::Isometry3d&) {
    found = true;
    return false;
  });
  return found;
}

}  // namespace collision_hulls
