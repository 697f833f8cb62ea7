// Uses FCL's broad phase as MoveIt does. For the settings, and why bodies are enlarged, see fcl_bodies.cpp.
#include "query/query_model.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision.h>

#include <deque>
#include <set>

#include "query/fcl_bodies.h"

namespace collision_hulls {
namespace {

using Object = fcl::CollisionObjectd;
using LinkPair = std::pair<std::size_t, std::size_t>;

/// An object's link and its place there.
struct Seat {
  std::size_t link;
  Eigen::Isometry3d origin;  // in the link's frame
};

const Seat& seatOf(const Object* object) {
  return *static_cast<const Seat*>(object->getUserData());
}

std::size_t linkOf(const Object* object) {
  return seatOf(object).link;
}

/// State of a traversal of the tree.
struct Search {
  const IgnoredPairs* ignored = nullptr;  // null: none
  bool all = false;                       // all pairs in collision, not the first one only
  std::set<LinkPair> pairs;
};

bool isIgnored(const Search& search, const Object* a, const Object* b) {
  return search.ignored && (linkOf(a) == linkOf(b) || (*search.ignored)(linkOf(a), linkOf(b)));
}

bool collidePair(Object* a, Object* b, void* data) {
  Search& search = *static_cast<Search*>(data);
  if (isIgnored(search, a, b)) return false;
  fcl::CollisionResultd result;
  if (answered([&] { return fcl::collide(a, b, contactRequest(), result); }) > 0) search.pairs.insert(std::minmax(linkOf(a), linkOf(b)));
  return !search.all && !search.pairs.empty();
}

}  // namespace

struct QueryModel::Impl {
  void add(const Seat& seat, const std::shared_ptr<fcl::CollisionGeometryd>& geometry) {
    seats.push_back(seat);
    objects.push_back(std::make_unique<Object>(geometry));
    objects.back()->setUserData(&seats.back());
  }

  std::deque<Seat> seats;  // of the objects, which point at them
  std::vector<std::unique_ptr<Object>> objects;
  fcl::DynamicAABBTreeCollisionManagerd tree;
};

QueryModel::QueryModel() : impl_(std::make_unique<Impl>()) {}
QueryModel::~QueryModel() = default;
QueryModel::QueryModel(QueryModel&&) noexcept = default;

void QueryModel::add(std::size_t link, const QueryBody& body, const Eigen::Isometry3d& origin) {
  if (!body.empty()) impl_->add({link, origin * body.impl()->origin}, body.impl()->geometry);
}

void QueryModel::place(const std::vector<Eigen::Isometry3d>& links) {
  for (const std::unique_ptr<Object>& object : impl_->objects) {
    const Seat& seat = seatOf(object.get());
    object->setTransform(enlarged(links[seat.link] * seat.origin));
    object->computeAABB();
  }
  if (impl_->tree.empty()) {
    for (const std::unique_ptr<Object>& object : impl_->objects) impl_->tree.registerObject(object.get());
    impl_->tree.setup();
  } else {
    impl_->tree.update();
  }
}

bool QueryModel::collides(const QueryModel& other) const {
  Search search;
  impl_->tree.collide(&other.impl_->tree, &search, collidePair);
  return !search.pairs.empty();
}

bool QueryModel::collides(const QueryModel& other, const IgnoredPairs& ignored) const {
  Search search;
  search.ignored = &ignored;
  impl_->tree.collide(&other.impl_->tree, &search, collidePair);
  return !search.pairs.empty();
}

bool QueryModel::collides(const IgnoredPairs& ignored) const {
  Search search;
  search.ignored = &ignored;
  impl_->tree.collide(&search, collidePair);
  return !search.pairs.empty();
}

std::vector<LinkPair> QueryModel::touching(const IgnoredPairs& ignored) const {
  Search search;
  search.ignored = &ignored;
  search.all = true;
  impl_->tree.collide(&search, collidePair);
  return {search.pairs.begin(), search.pairs.end()};
}

}  // namespace collision_hulls
