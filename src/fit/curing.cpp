// Greedy set cover over contacts. The cost of clearing a contact by opening one side is found by recursion down that side's tree, cut off
// at kMostCost nodes; each contact votes for both of its nodes with the inverse costs. After a node is opened only the contacts of that
// node are recomputed. An exact cover would be NP-hard, and closed() removes what the greedy choice opened in vain.
#include "fit/curing.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "base/parallel.h"

namespace collision_hulls {
namespace {

constexpr double kMostCost = 64;                    // nodes opened; the search gives up on a side that takes more
constexpr double kLeastVote = 1 / (2 * kMostCost);  // of contacts that neither side alone can cure
constexpr double kImpossible = std::numeric_limits<double>::infinity();

const DetailTree& treeOf(const Assembly& assembly, int piece) {
  return *assembly.pieces()[static_cast<std::size_t>(piece)].tree;
}

/// The contact with another node on one side.
Contact with(Contact contact, int side, int node) {
  contact.node[side] = node;
  return contact;
}

bool touches(const Assembly& assembly, const Contact& contact) {
  return collision_hulls::touches(assembly, contact, contact.node[0], contact.node[1]);
}

/// The side whose node protrudes more, among those that have children.
int coarserSide(const Assembly& assembly, const Contact& contact) {
  const DetailTree &first = treeOf(assembly, contact.piece[0]), &second = treeOf(assembly, contact.piece[1]);
  if (first.children(contact.node[0]).empty()) return 1;
  if (second.children(contact.node[1]).empty()) return 0;
  return first.protrusion(contact.node[0]) >= second.protrusion(contact.node[1]) ? 0 : 1;
}

}  // namespace

bool touchesAtLeaves(const Assembly& assembly, const Contact& contact) {
  const int side = coarserSide(assembly, contact);
  const std::vector<int> children = treeOf(assembly, contact.piece[side]).children(contact.node[side]);
  if (children.empty()) return true;
  return std::any_of(children.begin(), children.end(), [&](int child) {
    const Contact finer = with(contact, side, child);
    return touches(assembly, finer) && touchesAtLeaves(assembly, finer);
  });
}

std::vector<int> Curing::children(const Node& node) const {
  const DetailTree& tree = treeOf(assembly_, node.first);
  if (opens_ == Opens::kPrimitives && !tree.primitive(node.second)) return {};
  return tree.children(node.second);
}

/// How many nodes to open on one side until none of it touches; infinite if more than `limit`, or if leaves touch.
double Curing::cost(const Contact& contact, int side, double limit) const {
  const std::vector<int> children = this->children({contact.piece[side], contact.node[side]});
  if (children.empty()) return kImpossible;
  double sum = 1;
  for (const int child : children) {
    if (sum > limit) return kImpossible;
    const Contact finer = with(contact, side, child);
    if (touches(assembly_, finer)) sum += cost(finer, side, limit - sum);
  }
  return sum <= limit ? sum : kImpossible;
}

std::array<double, 2> Curing::votes(const Contact& contact) const {
  const double first = cost(contact, 0, kMostCost), second = cost(contact, 1, kMostCost);
  if (first < kImpossible || second < kImpossible) return {1 / first, 1 / second};
  std::array<double, 2> votes{0, 0};
  const auto side = static_cast<std::size_t>(coarserSide(assembly_, contact));
  if (!treeOf(assembly_, contact.piece[side]).children(contact.node[side]).empty()) votes[side] = kLeastVote;
  return votes;
}

void Curing::add(const std::vector<Contact>& contacts) {
  const std::size_t first = cases_.size();
  for (const Contact& contact : contacts) cases_.push_back({contact});
  forEach(contacts.size(), [&](std::size_t i) { cases_[first + i].votes = votes(contacts[i]); });
  for (std::size_t i = first; i < cases_.size(); ++i) {
    for (std::size_t side = 0; side < 2; ++side) {
      // Even if it votes for the other side only: other contacts may open this node.
      Ballot& ballot = ballots_[{cases_[i].contact.piece[side], cases_[i].contact.node[side]}];
      ballot.votes += cases_[i].votes[side];
      ++ballot.open;
      ballot.cases.push_back(i);
    }
  }
}

bool Curing::mayOpen(const Node& node) const {
  const DetailTree& tree = treeOf(assembly_, node.first);
  const std::size_t hulls = cuts_[static_cast<std::size_t>(node.first)].size() + tree.children(node.second).size() - 1;
  return tree.mostHulls() == 0 || hulls <= static_cast<std::size_t>(tree.mostHulls());
}

const Curing::Node* Curing::winner() const {
  const Node* best = nullptr;
  double most = 0;
  for (const auto& [node, ballot] : ballots_)
    if (ballot.open > 0 && ballot.votes > most && mayOpen(node)) most = ballot.votes, best = &node;
  return best;
}

void Curing::settle(std::size_t index) {
  Case& at = cases_[index];
  at.open = false;
  for (std::size_t side = 0; side < 2; ++side) {
    Ballot& ballot = ballots_.at({at.contact.piece[side], at.contact.node[side]});
    ballot.votes -= at.votes[side];
    --ballot.open;
  }
}

void Curing::open(const Node& opened) {
  const Node node = opened;
  const std::vector<int> children = this->children(node);
  std::vector<int>& cut = cuts_[static_cast<std::size_t>(node.first)];
  cut.erase(std::find(cut.begin(), cut.end(), node.second));
  cut.insert(cut.end(), children.begin(), children.end());

  const std::vector<std::size_t> cases = std::move(ballots_.at(node).cases);
  std::vector<std::vector<Contact>> left(cases.size());
  forEach(cases.size(), [&](std::size_t i) {
    const Case& at = cases_[cases[i]];
    if (!at.open) return;
    const int side = at.contact.piece[0] == node.first && at.contact.node[0] == node.second ? 0 : 1;
    for (const int child : children)
      if (touches(assembly_, with(at.contact, side, child))) left[i].push_back(with(at.contact, side, child));
  });
  std::vector<Contact> all;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases_[cases[i]].open) settle(cases[i]);
    all.insert(all.end(), left[i].begin(), left[i].end());
  }
  ballots_.erase(node);
  add(all);
}

void Curing::run(const RunControl& control) {
  while (const Node* node = winner()) {
    control.check();
    open(*node);
  }
  cases_.clear();
  ballots_.clear();
}

namespace {

/// Whether a node, put in place of its descendants in the cut, touches any of the other pieces that these contacts involve.
bool touchesAnything(const Assembly& assembly, const Cuts& cuts, int piece, int node, const std::vector<const Contact*>& contacts) {
  std::atomic<bool> found{false};
  forEach(contacts.size(), [&](std::size_t i) {
    const Contact& contact = *contacts[i];
    const int side = contact.piece[0] == piece ? 0 : 1;
    for (const int other : cuts[static_cast<std::size_t>(contact.piece[1 - side])]) {
      if (found.load(std::memory_order_relaxed)) return;
      if (touches(assembly, with(with(contact, side, node), 1 - side, other))) found = true;
    }
  });
  return found;
}

/// The least parent above `after` whose children are all in the cut; -1: none.
int closableAfter(const DetailTree& tree, const std::vector<int>& cut, int after) {
  const auto in_cut = [&](int node) { return std::find(cut.begin(), cut.end(), node) != cut.end(); };
  int least = -1;
  for (const int node : cut) {
    const int parent = tree.parent(node);
    if (parent <= after || (least >= 0 && parent >= least)) continue;
    const std::vector<int> children = tree.children(parent);
    if (std::all_of(children.begin(), children.end(), in_cut)) least = parent;
  }
  return least;
}

}  // namespace

Cuts closed(const Assembly& assembly, Cuts cuts, const std::vector<Contact>& contacts, const RunControl& control) {
  std::vector<std::vector<const Contact*>> of_piece(cuts.size());
  for (const Contact& contact : contacts)
    for (const int piece : contact.piece) of_piece[static_cast<std::size_t>(piece)].push_back(&contact);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const DetailTree& tree = treeOf(assembly, static_cast<int>(i));
    std::vector<int>& cut = cuts[i];
    // Parents have larger indices than their children, so one pass also finds nodes that become closable on the way.
    for (int node = closableAfter(tree, cut, -1); node >= 0; node = closableAfter(tree, cut, node)) {
      control.check();
      if (touchesAnything(assembly, cuts, static_cast<int>(i), node, of_piece[i])) continue;
      for (const int child : tree.children(node)) cut.erase(std::find(cut.begin(), cut.end(), child));
      cut.push_back(node);
    }
  }
  for (std::vector<int>& cut : cuts) std::sort(cut.begin(), cut.end());
  return cuts;
}

}  // namespace collision_hulls
