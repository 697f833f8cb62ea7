// Distances with FCL's faults turned into values. For FCL's settings, and why bodies are enlarged, see fcl_bodies.cpp; beyond them:
// - A sphere is queried as its centre, and its radius subtracted: GJK stops up to 1e-5 early on a curved body, and for a sphere that
//   overlaps a BVH's triangle the distance is left uninitialised.
// - Polyhedra are queried against a mesh as meshes: BVH against BVH is exact up to rounding, BVH against Convex only to 2e-5.
#include "query/fcl_queries.h"

#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "base/looks.h"
#include "query/fcl_bodies.h"

namespace collision_hulls {

namespace {

FclAnswer ask(const fcl::CollisionGeometryd& first, const fcl::CollisionGeometryd& second, const Eigen::Isometry3d& pose,
              bool nearest_points) {
  FclAnswer answer;
  const fcl::DistanceRequestd request = distanceRequest(nearest_points);
  fcl::DistanceResultd result;
  const auto start = std::chrono::steady_clock::now();
  try {
    fcl::distance(&first, fcl::Transform3d::Identity(), &second, enlarged(pose), request, result);
  } catch (const std::exception& error) {
    answer.status = FclAnswer::Status::kException;
    answer.error = error.what();
  }
  answer.microseconds = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  if (answer.status == FclAnswer::Status::kException) return answer;
  if (std::isnan(result.min_distance)) answer.status = FclAnswer::Status::kNan;
  answer.distance = std::max(0.0, result.min_distance) / kFclEnlarged;
  if (nearest_points) {
    answer.on_first = result.nearest_points[0] / kFclEnlarged;
    answer.on_second = result.nearest_points[1] / kFclEnlarged;
  }
  return answer;
}

FclAnswer askPoint(const fcl::CollisionGeometryd& body, const Eigen::Vector3d& point) {
  return ask(body, fcl::Sphered(0), Eigen::Isometry3d(Eigen::Translation3d(point)), false);
}

}  // namespace

/// Fits boxes along the coordinate axes, expressed as rounded rectangles (RSS), which FCL's distance queries also use for an OBBRSS. FCL's
/// own fitter aligns boxes with the axes of inertia: it takes ten times as long and makes queries little faster.
class BoxFitter : public fcl::detail::BVFitterBase<fcl::RSSd> {
 public:
  BoxFitter(const std::vector<Eigen::Vector3d>& vertices, const std::vector<fcl::Triangle>& triangles, const RunControl& control)
      : look_(control) {
    boxes_.reserve(triangles.size());
    for (const fcl::Triangle& t : triangles) {
      look_();
      const Eigen::Vector3d &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
      boxes_.emplace_back(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
    }
  }
  void set(Eigen::Vector3d*, fcl::Triangle*, fcl::BVHModelType) override {}
  void set(Eigen::Vector3d*, Eigen::Vector3d*, fcl::Triangle*, fcl::BVHModelType) override {}
  void clear() override { boxes_ = {}; }

  /// The rectangle lies halfway up the box's shortest side; half of that side is the radius. FCL asks for each node, so that what a look
  /// throws ends its building.
  fcl::RSSd fit(unsigned int* indices, int count) override {
    Eigen::AlignedBox3d box;
    for (int i = 0; i < count; ++i) look_(), box.extend(boxes_[indices[i]]);
    const Eigen::Vector3d size = box.sizes();
    Eigen::Index longest = 0;
    size.maxCoeff(&longest);
    Eigen::Index middle = (longest + 1) % 3, shortest = (longest + 2) % 3;
    if (size[middle] < size[shortest]) std::swap(middle, shortest);
    fcl::RSSd rss;
    rss.axis.col(0) = Eigen::Vector3d::Unit(longest);  // FCL splits nodes along it
    rss.axis.col(1) = Eigen::Vector3d::Unit(middle);
    rss.axis.col(2) = rss.axis.col(0).cross(rss.axis.col(1));
    rss.l[0] = size[longest];
    rss.l[1] = size[middle];
    rss.r = size[shortest] / 2;
    rss.To = box.min() + rss.r * Eigen::Vector3d::Unit(shortest);
    return rss;
  }

 private:
  Looks look_;
  std::vector<Eigen::AlignedBox3d> boxes_;  // of the triangles
};

struct FclMesh::Impl {
  std::shared_ptr<const fcl::BVHModel<fcl::RSSd>> model = std::make_shared<fcl::BVHModel<fcl::RSSd>>();
};

FclMesh::FclMesh(const TriangleMesh& mesh, const RunControl& control) : impl_(std::make_unique<Impl>()) {
  if (mesh.triangles.empty()) return;
  impl_->model = fclTree<fcl::RSSd, BoxFitter>(mesh.vertices, fclTriangles(mesh.triangles), kFclEnlarged, control);
}

FclMesh::~FclMesh() = default;
FclMesh::FclMesh(FclMesh&&) noexcept = default;

bool FclMesh::empty() const {
  return impl_->model->num_tris == 0;
}

struct FclHull::Impl {
  std::shared_ptr<const fcl::Convexd> convex;
};

FclHull::FclHull(const ConvexHull& hull) : impl_(std::make_unique<Impl>(Impl{fclConvex(hull)})) {}

FclHull::~FclHull() = default;
FclHull::FclHull(FclHull&&) noexcept = default;

FclAnswer fclDistance(const FclMesh& mesh, const Eigen::Vector3d& point) {
  return askPoint(*mesh.impl().model, point);
}

FclAnswer fclDistance(const FclHull& hull, const Eigen::Vector3d& point) {
  const std::vector<Eigen::Vector3d>& vertices = hull.impl().convex->getVertices();
  const bool is_vertex = std::find(vertices.begin(), vertices.end(), kFclEnlarged * point) != vertices.end();
  if (is_vertex) return {};  // otherwise one of FCL's asserts would end the process
  return askPoint(*hull.impl().convex, point);
}

FclAnswer fclDistance(const FclMesh& mesh, const FclMesh& other, const Eigen::Isometry3d& pose) {
  return ask(*mesh.impl().model, *other.impl().model, pose, false);
}

FclAnswer fclDistance(const FclHull& hull, const FclHull& other, const Eigen::Isometry3d& pose) {
  return ask(*hull.impl().convex, *other.impl().convex, pose, true);
}

}  // namespace collision_hulls
