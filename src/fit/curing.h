// Cures counterexamples: opens as few tree nodes as possible until no contact is left that should not be there.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "collision_hulls/control.h"
#include "fit/contacts.h"

namespace collision_hulls {

/// Whether even the finest hulls below the contact's nodes touch.
bool touchesAtLeaves(const Assembly& assembly, const Contact& contact);

/// A cut per piece, and contacts that it must not have.
///
///   while contacts are left
///     for each contact and each of its two nodes: find the cost of clearing it by opening this side alone; vote with 1 / cost
///     open the node with the most votes; contacts of its children stay, the others are cured
///
/// A greedy set cover. Deterministic; contacts are processed in parallel.
class Curing {
 public:
  enum class Opens { kHulls, kPrimitives };  ///< kPrimitives: a primitive gives way to the next one, the last to its hull; hulls stay
  Curing(const Assembly& assembly, Cuts cuts, Opens opens = Opens::kHulls) : assembly_(assembly), cuts_(std::move(cuts)), opens_(opens) {}

  /// Adds contacts between nodes of the cuts.
  void add(const std::vector<Contact>& contacts);

  /// Opens nodes until no contact is left that opening could cure.
  void run(const RunControl& control);

  const Cuts& cuts() const { return cuts_; }

 private:
  using Node = std::pair<int, int>;  // piece, node of its tree
  struct Case {
    Contact contact;
    std::array<double, 2> votes{0, 0};
    bool open = true;
  };
  struct Ballot {
    double votes = 0;
    std::size_t open = 0;  // cases
    std::vector<std::size_t> cases;
  };

  std::vector<int> children(const Node& node) const;
  double cost(const Contact& contact, int side, double limit) const;
  std::array<double, 2> votes(const Contact& contact) const;
  bool mayOpen(const Node& node) const;
  const Node* winner() const;
  void open(const Node& node);
  void settle(std::size_t index);

  const Assembly& assembly_;
  Cuts cuts_;
  const Opens opens_;
  std::vector<Case> cases_;
  std::map<Node, Ballot> ballots_;
};

/// Closes each node that can replace its children without bringing back any of `contacts`, which are contacts of the roots.
Cuts closed(const Assembly& assembly, Cuts cuts, const std::vector<Contact>& contacts, const RunControl& control);

}  // namespace collision_hulls
