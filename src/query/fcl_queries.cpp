// Which of FCL's queries are used, and which are not:
// - Unsigned distance by libccd's GJK with a distance tolerance of 1e-9. Signed distance and penetration depth run EPA, whose asserts end
//   the process; the other solver, GST_INDEP, is wrong for some pairs, and for most at millimetre scale. Even so, if faces of two hulls
//   line up one answer in a hundred is wrong: it counts only if its nearest points prove it, see proved().
// - A sphere is queried as its centre, and its radius subtracted: GJK stops up to 1e-5 early on a curved body, and for a sphere that
//   overlaps a BVH's triangle the distance is left uninitialised.
// - Bodies are enlarged: FCL's thresholds are absolute, and libccd's GJK reports 6 % of the overlaps of millimetre cubes (in metres) as
//   separated.
// - Polyhedra are queried against a mesh as meshes: BVH against BVH is exact up to rounding, BVH against Convex only to 2e-5.
#include "query/fcl_queries.h"

#include <fcl/config.h>
// FCL 0.6 and 0.7 agree in everything used here; 0.5 has a different Convex (plane arrays instead of a face array) and no scalar type.
#if FCL_MAJOR_VERSION == 0 && FCL_MINOR_VERSION < 6
#error "collision_hulls needs FCL 0.6 or newer; on Ubuntu 20.04 that is the package ros-noetic-fcl or a build from source"
#endif
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "collision_hulls/error.h"

namespace collision_hulls {

namespace {

constexpr double kDistanceTolerance = 1e-9;  // libccd's default, 1e-6, is off by up to 5e-4 near contact
constexpr double kEnlarged = 1024;           // a power of two, so that nothing is rounded

std::vector<Eigen::Vector3d> enlarged(std::vector<Eigen::Vector3d> vertices) {
  for (Eigen::Vector3d& v : vertices) v *= kEnlarged;
  return vertices;
}

FclAnswer ask(const fcl::CollisionGeometryd& first, const fcl::CollisionGeometryd& second, Eigen::Isometry3d pose, bool nearest_points) {
  pose.translation() *= kEnlarged;
  FclAnswer answer;
  const fcl::DistanceRequestd request(nearest_points, false, 0, 0, kDistanceTolerance, fcl::GST_LIBCCD);
  fcl::DistanceResultd result;
  const auto start = std::chrono::steady_clock::now();
  try {
    fcl::distance(&first, fcl::Transform3d::Identity(), &second, pose, request, result);
  } catch (const std::exception& error) {
    answer.status = FclAnswer::Status::kException;
    answer.error = error.what();
  }
  answer.microseconds = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  if (answer.status == FclAnswer::Status::kException) return answer;
  if (std::isnan(result.min_distance)) answer.status = FclAnswer::Status::kNan;
  answer.distance = std::max(0.0, result.min_distance) / kEnlarged;
  if (nearest_points) {
    answer.on_first = result.nearest_points[0] / kEnlarged;
    answer.on_second = result.nearest_points[1] / kEnlarged;
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
  explicit BoxFitter(const TriangleMesh& mesh) {
    boxes_.reserve(mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      const Eigen::Vector3d &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
      boxes_.emplace_back(kEnlarged * a.cwiseMin(b).cwiseMin(c), kEnlarged * a.cwiseMax(b).cwiseMax(c));
    }
  }
  void set(Eigen::Vector3d*, fcl::Triangle*, fcl::BVHModelType) override {}
  void set(Eigen::Vector3d*, Eigen::Vector3d*, fcl::Triangle*, fcl::BVHModelType) override {}
  void clear() override { boxes_ = {}; }

  /// The rectangle lies halfway up the box's shortest side; half of that side is the radius.
  fcl::RSSd fit(unsigned int* indices, int count) override {
    Eigen::AlignedBox3d box;
    for (int i = 0; i < count; ++i) box.extend(boxes_[indices[i]]);
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
  std::vector<Eigen::AlignedBox3d> boxes_;  // of the triangles
};

struct FclMesh::Impl {
  fcl::BVHModel<fcl::RSSd> model;
};

FclMesh::FclMesh(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>()) {
  if (mesh.triangles.empty()) return;
  impl_->model.bv_fitter = std::make_shared<BoxFitter>(mesh);
  impl_->model.beginModel(static_cast<int>(mesh.triangles.size()), static_cast<int>(mesh.vertices.size()));
  {
    std::vector<fcl::Triangle> triangles;
    for (const Triangle& t : mesh.triangles)
      triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2]));
    impl_->model.addSubModel(enlarged(mesh.vertices), triangles);
  }
  if (impl_->model.endModel() != fcl::BVH_OK)
    throw Error(ErrorCode::kInternal, "FCL rejected a mesh of " + std::to_string(mesh.triangles.size()) + " triangles");
}

FclMesh::~FclMesh() = default;
FclMesh::FclMesh(FclMesh&&) noexcept = default;

bool FclMesh::empty() const {
  return impl_->model.num_tris == 0;
}

struct FclHull::Impl {
  std::unique_ptr<fcl::Convexd> convex;
};

FclHull::FclHull(const ConvexHull& hull) : impl_(std::make_unique<Impl>()) {
  // FCL's face array: for each face its number of vertices, followed by their indices counter-clockwise.
  const auto faces = std::make_shared<std::vector<int>>();
  for (const Triangle& t : hull.triangles) faces->insert(faces->end(), {3, t[0], t[1], t[2]});
  const auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>(enlarged(hull.vertices));
  impl_->convex = std::make_unique<fcl::Convexd>(vertices, static_cast<int>(hull.triangles.size()), faces);
}

FclHull::~FclHull() = default;
FclHull::FclHull(FclHull&&) noexcept = default;

FclAnswer fclDistance(const FclMesh& mesh, const Eigen::Vector3d& point) {
  return askPoint(mesh.impl().model, point);
}

FclAnswer fclDistance(const FclHull& hull, const Eigen::Vector3d& point) {
  const std::vector<Eigen::Vector3d>& vertices = hull.impl().convex->getVertices();
  const bool is_vertex = std::find(vertices.begin(), vertices.end(), kEnlarged * point) != vertices.end();
  if (is_vertex) return {};  // otherwise one of FCL's asserts would end the process
  return askPoint(*hull.impl().convex, point);
}

FclAnswer fclDistance(const FclMesh& mesh, const FclMesh& other, const Eigen::Isometry3d& pose) {
  return ask(mesh.impl().model, other.impl().model, pose, false);
}

FclAnswer fclDistance(const FclHull& hull, const FclHull& other, const Eigen::Isometry3d& pose) {
  return ask(*hull.impl().convex, *other.impl().convex, pose, true);
}

}  // namespace collision_hulls
