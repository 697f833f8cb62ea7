// What is asked of FCL and why: see fcl_queries.cpp.
#include "collision_hulls/check/boxed_model.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/sphere.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace collision_hulls {
namespace {

struct Body {
  QueryBody body;
  Eigen::Isometry3d origin, pose;  // in the link's frame; in the world
  Eigen::AlignedBox3d box;         // in the world
};

struct Link {
  std::size_t index = 0;
  std::vector<Body> bodies;
  Eigen::AlignedBox3d own_box, box;  // in the link's frame; in the world
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  bool placed = false;  // its bodies
};

void placeBodies(Link& link) {
  if (link.placed) return;
  for (Body& body : link.bodies) {
    body.pose = link.pose * body.origin;
    body.box = placed(body.body.box(), body.pose);
  }
  link.placed = true;
}

bool touch(const Body& a, const Body& b) {
  const Eigen::Isometry3d pose = a.pose.inverse() * b.pose;
  return !apart(a.body.box(), b.body.box(), pose) && collision_hulls::touch(a.body, b.body, pose);
}

/// Of links whose boxes meet.
bool touch(Link& a, Link& b) {
  placeBodies(a);
  placeBodies(b);
  for (const Body& of_a : a.bodies) {
    if (!of_a.box.intersects(b.box)) continue;
    for (const Body& of_b : b.bodies)
      if (of_a.box.intersects(of_b.box) && touch(of_a, of_b)) return true;
  }
  return false;
}

/// [m] The distance between two links, or `limit` where they are no closer than that.
double distanceBelow(double limit, Link& a, Link& b) {
  placeBodies(a);
  placeBodies(b);
  for (const Body& of_a : a.bodies)
    for (const Body& of_b : b.bodies)
      if (limit > 0 && of_a.box.exteriorDistance(of_b.box) < limit)
        limit = collision_hulls::distanceBelow(limit, of_a.body, of_b.body, of_a.pose.inverse() * of_b.pose);
  return limit;
}

/// A link's box as FCL's trees know it; of the sphere nothing is asked.
class BoxObject : public fcl::CollisionObjectd {
 public:
  BoxObject() : fcl::CollisionObjectd(std::make_shared<fcl::Sphered>(1)) {}
  void set(Link& link) {
    aabb.min_ = link.box.min();
    aabb.max_ = link.box.max();
    setUserData(&link);
  }
};

Link& linkOf(const fcl::CollisionObjectd* object) {
  return *static_cast<Link*>(object->getUserData());
}

/// What a traversal of the tree carries along.
struct Search {
  const IgnoredPairs& ignored;
  bool found = false;
  double distance = std::numeric_limits<double>::infinity();
};

bool askPair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
  Search& search = *static_cast<Search*>(data);
  Link &first = linkOf(a), &second = linkOf(b);
  search.found = !search.ignored(first.index, second.index) && touch(first, second);
  return search.found;
}

bool measurePair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data, double& least) {
  Search& search = *static_cast<Search*>(data);
  Link &first = linkOf(a), &second = linkOf(b);
  if (!search.ignored(first.index, second.index)) search.distance = distanceBelow(search.distance, first, second);
  least = search.distance;
  return search.distance <= 0;
}

struct LinkPair {
  Link *a, *b;
  double bound = 0;  // [m] no more than the links' distance
};

}  // namespace

struct BoxedModel::Impl {
  explicit Impl(IgnoredPairs pairs_ignored) : ignored(std::move(pairs_ignored)) {}

  IgnoredPairs ignored;
  std::deque<Link> links;
  std::map<std::size_t, Link*> of_index;
  std::vector<LinkPair> pairs;  // of links that are not ignored
  BoxObject probe;

  fcl::DynamicAABBTreeCollisionManagerd tree;  // of the links' boxes
  std::deque<BoxObject> leaves;
  bool planted = false;  // the tree, since the links were placed

  Link& link(std::size_t index) {
    Link*& link = of_index[index];
    if (link) return *link;
    links.emplace_back().index = index;
    link = &links.back();
    return *link;
  }

  void pairUp() {
    if (!pairs.empty()) return;
    for (auto a = links.begin(); a != links.end(); ++a)
      for (auto b = a + 1; b != links.end(); ++b)
        if (!ignored(a->index, b->index)) pairs.push_back({&*a, &*b});
  }

  void plant() {
    if (planted) return;
    tree.clear();
    leaves.resize(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
      leaves[i].set(links[i]);
      tree.registerObject(&leaves[i]);
    }
    tree.setup();
    planted = true;
  }
};

BoxedModel::BoxedModel(IgnoredPairs ignored) : impl_(std::make_unique<Impl>(std::move(ignored))) {}
BoxedModel::~BoxedModel() = default;
BoxedModel::BoxedModel(BoxedModel&&) noexcept = default;

void BoxedModel::add(std::size_t link, const QueryBody& body, const Eigen::Isometry3d& origin) {
  if (body.empty()) return;
  Link& carrier = impl_->link(link);
  carrier.bodies.push_back({body, origin, origin, {}});
  carrier.own_box.extend(placed(body.box(), origin));
  impl_->pairs.clear();
}

void BoxedModel::place(const std::vector<Eigen::Isometry3d>& links) {
  for (Link& link : impl_->links) {
    link.pose = links[link.index];
    link.box = placed(link.own_box, link.pose);
    link.placed = false;
  }
  impl_->planted = false;
}

bool BoxedModel::collides() {
  impl_->pairUp();
  return std::any_of(impl_->pairs.begin(), impl_->pairs.end(),
                     [](const LinkPair& pair) { return pair.a->box.intersects(pair.b->box) && touch(*pair.a, *pair.b); });
}

double BoxedModel::distance() {
  impl_->pairUp();
  std::vector<LinkPair> nearest = impl_->pairs;
  for (LinkPair& pair : nearest) pair.bound = pair.a->box.exteriorDistance(pair.b->box);
  std::sort(nearest.begin(), nearest.end(), [](const LinkPair& a, const LinkPair& b) { return a.bound < b.bound; });
  double least = std::numeric_limits<double>::infinity();
  for (const LinkPair& pair : nearest) {
    if (least <= pair.bound) break;
    least = distanceBelow(least, *pair.a, *pair.b);
  }
  return least;
}

bool BoxedModel::collides(BoxedModel& scene) {
  scene.impl_->plant();
  Search search{impl_->ignored};
  for (Link& link : impl_->links) {
    impl_->probe.set(link);
    scene.impl_->tree.collide(&impl_->probe, &search, askPair);
    if (search.found) return true;
  }
  return false;
}

double BoxedModel::distance(BoxedModel& scene) {
  scene.impl_->plant();
  Search search{impl_->ignored};
  for (Link& link : impl_->links) {
    impl_->probe.set(link);
    scene.impl_->tree.distance(&impl_->probe, &search, measurePair);
  }
  return search.distance;
}

}  // namespace collision_hulls
