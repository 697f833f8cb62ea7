// What is asked of FCL and why: see fcl_queries.cpp. Bodies are enlarged as there.
#include "check/query_model.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <deque>
#include <limits>
#include <set>

namespace collision_hulls {
namespace {

constexpr double kDistanceTolerance = 1e-9;
constexpr double kEnlarged = 1024;

using Object = fcl::CollisionObjectd;
using LinkPair = std::pair<std::size_t, std::size_t>;

std::vector<Eigen::Vector3d> enlarged(std::vector<Eigen::Vector3d> vertices) {
  for (Eigen::Vector3d& v : vertices) v *= kEnlarged;
  return vertices;
}

std::size_t linkOf(const Object* object) {
  return *static_cast<const std::size_t*>(object->getUserData());
}

/// What a traversal of the tree carries along.
struct Search {
  const IgnoredPairs* ignored = nullptr;  // null: between two models
  bool all = false;                       // all pairs in collision, not the first one only
  std::set<LinkPair> pairs;
  double distance = std::numeric_limits<double>::infinity();
};

bool isIgnored(const Search& search, const Object* a, const Object* b) {
  return search.ignored && (linkOf(a) == linkOf(b) || (*search.ignored)(linkOf(a), linkOf(b)));
}

bool collidePair(Object* a, Object* b, void* data) {
  Search& search = *static_cast<Search*>(data);
  if (isIgnored(search, a, b)) return false;
  fcl::CollisionRequestd request(1, false);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::CollisionResultd result;
  if (fcl::collide(a, b, request, result) > 0) search.pairs.insert(std::minmax(linkOf(a), linkOf(b)));
  return !search.all && !search.pairs.empty();
}

bool measurePair(Object* a, Object* b, void* data, double& least) {
  Search& search = *static_cast<Search*>(data);
  least = search.distance;
  if (isIgnored(search, a, b)) return false;
  const fcl::DistanceRequestd request(false, false, 0, 0, kDistanceTolerance, fcl::GST_LIBCCD);
  fcl::DistanceResultd result;
  result.min_distance = std::numeric_limits<double>::max();
  fcl::distance(a, b, request, result);
  search.distance = least = std::min(search.distance, std::max(0.0, result.min_distance));
  return search.distance <= 0;
}

}  // namespace

struct QueryModel::Impl {
  void add(std::size_t link, const std::shared_ptr<fcl::CollisionGeometryd>& geometry) {
    links.push_back(link);
    objects.push_back(std::make_unique<Object>(geometry));
    objects.back()->setUserData(&links.back());
  }

  std::deque<std::size_t> links;  // of the objects, which point at them
  std::vector<std::unique_ptr<Object>> objects;
  fcl::DynamicAABBTreeCollisionManagerd tree;
};

QueryModel::QueryModel() : impl_(std::make_unique<Impl>()) {}
QueryModel::~QueryModel() = default;
QueryModel::QueryModel(QueryModel&&) noexcept = default;

void QueryModel::add(std::size_t link, const TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Eigen::Vector3d &a = mesh.corner(static_cast<int>(i), 0), u = mesh.corner(static_cast<int>(i), 1) - a;
    if (u.cross(mesh.corner(static_cast<int>(i), 2) - a).isZero(0)) continue;
    triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2]));
  }
  if (triangles.empty()) return;
  const auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
  model->addSubModel(enlarged(mesh.vertices), triangles);
  model->endModel();
  impl_->add(link, model);
}

void QueryModel::add(std::size_t link, const ConvexHull& hull) {
  const auto faces = std::make_shared<std::vector<int>>();
  for (const Triangle& t : hull.triangles) faces->insert(faces->end(), {3, t[0], t[1], t[2]});
  const auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>(enlarged(hull.vertices));
  impl_->add(link, std::make_shared<fcl::Convexd>(vertices, static_cast<int>(hull.triangles.size()), faces));
}

void QueryModel::place(const std::vector<Eigen::Isometry3d>& links) {
  for (const std::unique_ptr<Object>& object : impl_->objects) {
    Eigen::Isometry3d pose = links[linkOf(object.get())];
    pose.translation() *= kEnlarged;
    object->setTransform(pose);
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

double QueryModel::distance(const QueryModel& other) const {
  Search search;
  impl_->tree.distance(&other.impl_->tree, &search, measurePair);
  return search.distance / kEnlarged;
}

bool QueryModel::collides(const IgnoredPairs& ignored) const {
  Search search;
  search.ignored = &ignored;
  impl_->tree.collide(&search, collidePair);
  return !search.pairs.empty();
}

double QueryModel::distance(const IgnoredPairs& ignored) const {
  Search search;
  search.ignored = &ignored;
  impl_->tree.distance(&search, measurePair);
  return search.distance / kEnlarged;
}

std::vector<LinkPair> QueryModel::touching(const IgnoredPairs& ignored) const {
  Search search;
  search.ignored = &ignored;
  search.all = true;
  impl_->tree.collide(&search, collidePair);
  return {search.pairs.begin(), search.pairs.end()};
}

}  // namespace collision_hulls
