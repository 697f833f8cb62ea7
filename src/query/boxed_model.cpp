// Distances are a best-first search: pairs of boxes wait in a heap by a lower bound of their distance, and the search ends once that
// exceeds the least distance found. Links of a scene are in groups of neighbours. For FCL's settings, and why, see fcl_bodies.cpp.
#include "collision_hulls/query/boxed_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "query/box_groups.h"

namespace collision_hulls {
namespace {

struct Body {
  QueryBody body;
  Eigen::Isometry3d origin, inverse;  // in the link's frame
  Eigen::AlignedBox3d box;            // in the link's frame
};

struct Link {
  std::size_t index = 0;
  std::vector<Body> bodies;
  Eigen::AlignedBox3d box;  // in its own frame
};

using Boxes = std::vector<Eigen::AlignedBox3d>;

bool touch(const Body& a, const Body& b, const Eigen::Isometry3d& of_links) {
  const Eigen::Isometry3d pose = a.inverse * of_links * b.origin;
  return !apart(a.body.box(), b.body.box(), pose) && collision_hulls::touch(a.body, b.body, pose);
}

/// `pose`: the second link's in the first one's frame.
bool touch(const Link& a, const Link& b, const Eigen::Isometry3d& pose) {
  if (a.bodies.size() == 1 && b.bodies.size() == 1) return touch(a.bodies[0], b.bodies[0], pose);
  if (apart(a.box, b.box, pose)) return false;
  std::vector<const Body*> near;  // of b
  for (const Body& body : b.bodies)
    if (!apart(a.box, body.box, pose)) near.push_back(&body);
  if (near.empty()) return false;
  for (const Body& of_a : a.bodies) {
    if (apart(of_a.box, b.box, pose)) continue;
    for (const Body* of_b : near)
      if (!apart(of_a.box, of_b->box, pose) && touch(of_a, *of_b, pose)) return true;
  }
  return false;
}

/// Two things that may be near each other: bodies of two links, two links, or a link and a group of links.
struct Near {
  std::size_t a, b;
  double bound;  // [m] lower bound on their distance
};

/// Calls `measure` on the pairs, nearest first, as long as a pair's bound is below the least distance so far, which `measure` returns.
template <typename Measure>
double leastDistance(std::vector<Near> near, double least, const Measure& measure) {
  const auto further = [](const Near& a, const Near& b) { return a.bound > b.bound; };
  std::make_heap(near.begin(), near.end(), further);
  for (; !near.empty() && near.front().bound < least; near.pop_back()) {
    std::pop_heap(near.begin(), near.end(), further);
    least = measure(near.back(), least);
  }
  return least;
}

/// [m] The distance between two links, or `limit` if they are no closer than that.
double linkDistanceBelow(double limit, const Link& a, const Link& b, const Eigen::Isometry3d& pose) {
  // Box against the box around the other box, in either frame.
  const auto boxesOf = [](const Link& link, const Eigen::Isometry3d& place) {
    Boxes boxes;
    for (const Body& body : link.bodies) boxes.push_back(placed(body.box, place));
    return boxes;
  };
  const Boxes of_a = boxesOf(a, pose.inverse()), of_b = boxesOf(b, pose);
  std::vector<Near> near;
  for (std::size_t i = 0; i < of_a.size(); ++i)
    for (std::size_t j = 0; j < of_b.size(); ++j) {
      const double bound =
          std::sqrt(std::max(a.bodies[i].box.squaredExteriorDistance(of_b[j]), of_a[i].squaredExteriorDistance(b.bodies[j].box)));
      if (bound < limit) near.push_back({i, j, bound});
    }
  return leastDistance(std::move(near), limit, [&](const Near& pair, double least) {
    const Body &first = a.bodies[pair.a], &second = b.bodies[pair.b];
    return distanceBelow(least, first.body, second.body, first.inverse * pose * second.origin);
  });
}

struct TwoLinks {
  std::size_t a, b;
};

}  // namespace

struct BoxedModel::Impl {
  explicit Impl(IgnoredPairs pairs_ignored) : ignored(std::move(pairs_ignored)) {}

  IgnoredPairs ignored;
  bool placed = true;  // all bodies are
  std::vector<Link> links;
  std::map<std::size_t, std::size_t> of_index;
  std::vector<Eigen::Isometry3d> poses;  // of the links
  Boxes boxes;                           // of the links as placed

  // For queries on the model itself.
  bool paired = false;
  std::vector<TwoLinks> pairs;  // of links, without ignored ones

  // For queries against this model as a scene, once it is placed.
  bool grouped = false;
  BoxGroups groups;  // of the links' boxes

  void checkPlaced() const {
    if (!placed)
      throw Error(ErrorCode::kInternal, "a collision model was queried before its bodies were placed; call place() after the last add()");
  }

  bool ignores(std::size_t a, const Impl& other, std::size_t b) const { return ignored(links[a].index, other.links[b].index); }

  void pairUp() {
    checkPlaced();
    if (paired) return;
    pairs.clear();
    for (std::size_t a = 0; a < links.size(); ++a)
      for (std::size_t b = a + 1; b < links.size(); ++b)
        if (!ignores(a, *this, b)) pairs.push_back({a, b});
    paired = true;
  }

  Eigen::Isometry3d between(std::size_t a, const Impl& other, std::size_t b) const { return poses[a].inverse() * other.poses[b]; }

  bool touches(std::size_t a, const Impl& other, std::size_t b) const { return touch(links[a], other.links[b], between(a, other, b)); }

  double distanceBelow(double limit, std::size_t a, const Impl& other, std::size_t b) const {
    return linkDistanceBelow(limit, links[a], other.links[b], between(a, other, b));
  }

  void group() {
    checkPlaced();
    if (grouped) return;
    groups = BoxGroups(boxes);
    grouped = true;
  }
};

BoxedModel::BoxedModel(IgnoredPairs ignored) : impl_(std::make_unique<Impl>(std::move(ignored))) {}
BoxedModel::~BoxedModel() = default;
BoxedModel::BoxedModel(BoxedModel&&) noexcept = default;

void BoxedModel::add(std::size_t link, const QueryBody& body, const Eigen::Isometry3d& origin) {
  if (!std::isfinite(origin.matrix().sum()))
    throw Error(ErrorCode::kNonFiniteCoordinate, "the origin of a body of link " + std::to_string(link) + " is not finite; correct it");
  if (body.empty()) return;
  const auto [at, is_new] = impl_->of_index.emplace(link, impl_->links.size());
  if (is_new) impl_->links.emplace_back().index = link;
  Link& carrier = impl_->links[at->second];
  carrier.bodies.push_back({body, origin, origin.inverse(), placed(body.box(), origin)});
  carrier.box.extend(carrier.bodies.back().box);
  impl_->paired = impl_->placed = false;
}

void BoxedModel::place(const std::vector<Eigen::Isometry3d>& links) {
  const std::size_t count = impl_->links.size();
  impl_->placed = impl_->grouped = false;
  impl_->boxes.resize(count);
  impl_->poses.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Link& link = impl_->links[i];
    if (link.index >= links.size())
      throw Error(ErrorCode::kIndexOutOfRange, "link " + std::to_string(link.index) + " has no pose, as only " +
                                                   std::to_string(links.size()) + " were given; give one for each link");
    impl_->poses[i] = links[link.index];
    if (!std::isfinite(impl_->poses[i].matrix().sum()))
      throw Error(ErrorCode::kNonFiniteCoordinate, "the pose of link " + std::to_string(link.index) + " is not finite; correct it");
    impl_->boxes[i] = placed(link.box, impl_->poses[i]);
  }
  impl_->placed = true;
}

bool BoxedModel::collides() {
  const Impl& own = *impl_;
  impl_->pairUp();
  return std::any_of(own.pairs.begin(), own.pairs.end(), [&](const TwoLinks& pair) {
    return own.boxes[pair.a].intersects(own.boxes[pair.b]) && own.touches(pair.a, own, pair.b);
  });
}

double BoxedModel::distance(double limit) {
  const Impl& own = *impl_;
  impl_->pairUp();
  std::vector<Near> near;
  for (const TwoLinks& pair : own.pairs) {
    const double bound = own.boxes[pair.a].exteriorDistance(own.boxes[pair.b]);
    if (bound < limit) near.push_back({pair.a, pair.b, bound});
  }
  return leastDistance(std::move(near), limit,
                       [&](const Near& pair, double least) { return own.distanceBelow(least, pair.a, own, pair.b); });
}

bool BoxedModel::collides(BoxedModel& scene) {
  const Impl &own = *impl_, &other = *scene.impl_;
  own.checkPlaced();
  scene.impl_->group();
  for (std::size_t a = 0; a < own.links.size(); ++a) {
    const auto touches = [&](std::size_t b) { return !own.ignores(a, other, b) && own.touches(a, other, b); };
    if (other.groups.visitMeeting(own.boxes[a], touches)) return true;
  }
  return false;
}

double BoxedModel::distance(BoxedModel& scene, double limit) {
  const Impl &own = *impl_, &other = *scene.impl_;
  own.checkPlaced();
  scene.impl_->group();
  std::vector<Near> near;
  for (std::size_t a = 0; a < own.links.size(); ++a)
    for (std::size_t g = 0; g < other.groups.count(); ++g) {
      const double bound = own.boxes[a].exteriorDistance(other.groups.box(g));
      if (bound < limit) near.push_back({a, g, bound});
    }
  return leastDistance(std::move(near), limit, [&](const Near& pair, double least) {
    std::vector<Near> members;
    for (const BoxGroups::Member* member = other.groups.begin(pair.b); member != other.groups.end(pair.b); ++member)
      if (!own.ignores(pair.a, other, member->index))
        members.push_back({pair.a, member->index, own.boxes[pair.a].exteriorDistance(member->box)});
    return leastDistance(std::move(members), least,
                         [&](const Near& member, double so_far) { return own.distanceBelow(so_far, member.a, other, member.b); });
  });
}

}  // namespace collision_hulls
