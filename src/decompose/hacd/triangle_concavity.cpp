// A ray leaves a convex hull through the face whose plane it reaches first. Branch and bound finds that face in a tree over the planes
// (normal, offset): of all planes in a box, the ray reaches none before the least possible distance to a plane over the largest possible
// component of a normal along the ray. Planes that the ray reaches soon are neighbours on the hull, so few boxes are opened. Comparing all
// planes instead made the decimation quadratic on round surfaces, whose hulls have a face for each triangle.
#include "decompose/hacd/triangle_concavity.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "decompose/convex_polygon.h"

namespace collision_hulls {

namespace {

// A face whose normal has a smaller component than this along a ray counts as parallel to it; the ray then passes it by at most this share
// of the hull's extent.
constexpr double kParallel = 1e-6;
// The bounds of a triangle's concavity have met once they differ by less than this share.
constexpr double kBoundsMeet = 1e-9;
// Most faces that a cutting-plane search examines: far more than it needs, a guard against cycling due to rounding.
constexpr int kMostCuts = 100;
// More than the rounding error of a point's distance to a plane, as a share of the coordinates.
constexpr double kPlaneRounding = 1e-13;

const double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

ExitFaces::ExitFaces(const ConvexHull& hull) : hull_(hull) {
  const Eigen::AlignedBox3d box = boundingBox(hull);
  centre_ = box.center();
  scale_ = box.diagonal().norm();
  rounding_ = kPlaneRounding * (1 + centre_.cwiseAbs().maxCoeff() / scale_);
  std::vector<Eigen::Vector4d> planes;
  planes.reserve(hull.faces.size());
  for (const HalfSpace& face : hull.faces)
    planes.emplace_back(face.normal.x(), face.normal.y(), face.normal.z(), -face.distance(centre_) / scale_);
  tree_ = Planes(planes);
}

int ExitFaces::firstExit(const Eigen::Vector3d& origin, const Eigen::Vector3d& m, const Eigen::Vector3d& along) const {
  const Eigen::Vector3d start = (origin + m - centre_) / scale_;
  const auto most = [](const Eigen::AlignedBox<double, 4>& box, const Eigen::Vector3d& v) {
    return (box.min().head<3>().array() * v.array()).max(box.max().head<3>().array() * v.array()).sum();
  };
  const auto bound = [&](const Eigen::AlignedBox<double, 4>& box) {
    const double facing = most(box, along), height = box.min()[3] - most(box, start) - rounding_;
    if (facing < kParallel / 2) return kInfinity;
    return height > 0 ? scale_ * height / facing : -kInfinity;
  };
  int first = -1;
  double least = kInfinity;
  const auto visit = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const int f = tree_.order()[i];
      if (!(hull_.faces[static_cast<std::size_t>(f)].normal.dot(along) > kParallel)) continue;
      const double t = exitFunction(f, origin, along)(m);
      if (t < least || (t == least && f < first)) least = t, first = f;
    }
    return least;
  };
  tree_.search(bound, visit, least);
  return first;
}

ExitFunction ExitFaces::exitFunction(int f, const Eigen::Vector3d& origin, const Eigen::Vector3d& along) const {
  const HalfSpace& face = hull_.faces[static_cast<std::size_t>(f)];
  const double facing = face.normal.dot(along);
  return {-face.normal / facing, -face.distance(origin) / facing};
}

double concavityOfTriangle(const ExitFaces& faces, const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& normal,
                           double known) {
  const Eigen::Vector3d& origin = corners[0];
  const ConvexPolygon whole{Eigen::Vector3d::Zero(), corners[1] - origin, corners[2] - origin};
  ConvexPolygon polygon, scratch;
  std::vector<ExitFunction> cuts;
  Eigen::Vector3d m = (whole[1] + whole[2]) / 3;
  double lower = 0, upper = kInfinity;
  for (int cut = 0; cut < kMostCuts && upper > known; ++cut) {
    const int f = faces.firstExit(origin, m, normal);
    if (f < 0) return 0;
    const ExitFunction exit = faces.exitFunction(f, origin, normal);
    lower = std::max(lower, exit(m));
    if (upper <= lower * (1 + kBoundsMeet)) break;
    polygon = whole;
    for (const ExitFunction& other : cuts)
      clip(
          polygon, [&](const Eigen::Vector3d& p) { return other(p) - exit(p); }, scratch);
    if (polygon.empty()) break;  // f was below the others only by rounding
    cuts.push_back(exit);
    m = largest(polygon, exit);
    upper = exit(m);
  }
  return lower;
}

}  // namespace collision_hulls
