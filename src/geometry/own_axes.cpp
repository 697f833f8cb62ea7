// Groups a sample of the triangles by normal. The group with the largest area gives the first axis, the largest group at right angles to it
// the second. The new axes are used only if clearly more of the area is axis-aligned with them than without.
#include "geometry/own_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace collision_hulls {

namespace {

constexpr double kLike = 1 - 1e-6;        // normals whose cosine is above this have the same direction
constexpr double kUpright = 0.01;         // directions whose cosine is below this are at right angles
constexpr double kMuch = 0.15;            // gain, as a share of the area, that makes turning the mesh worthwhile
constexpr std::size_t kTriangles = 5000;  // size of the sample
constexpr std::size_t kMostKinds = 300;   // directions that are distinguished

/// Faces with the same direction, regardless of which side is out.
struct Kind {
  Eigen::Vector3d normal;
  double area;
};

/// Area vectors (twice the area, along the normal) of at most kTriangles triangles, largest first.
std::vector<Eigen::Vector3d> areas(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> result;
  const std::size_t count = mesh.triangles.size();
  for (std::size_t i = 0; i < std::min(count, kTriangles); ++i) {
    const auto t = static_cast<int>(i * count / std::min(count, kTriangles));
    result.emplace_back((mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)));
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.squaredNorm() > b.squaredNorm(); });
  return result;
}

std::vector<Kind> kindsOf(const std::vector<Eigen::Vector3d>& areas) {
  std::vector<Kind> kinds;
  for (const Eigen::Vector3d& a : areas) {
    const double area = a.norm();
    const auto like = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return std::abs(k.normal.dot(a)) > kLike * area; });
    if (like != kinds.end())
      like->area += area;
    else if (area > 0 && kinds.size() < kMostKinds)
      kinds.push_back({a / area, area});
  }
  return kinds;
}

/// The kind with the largest area at right angles to `axis`; null if there is none.
const Kind* largestAcross(const std::vector<Kind>& kinds, const Eigen::Vector3d& axis) {
  const Kind* best = nullptr;
  for (const Kind& kind : kinds)
    if (std::abs(kind.normal.dot(axis)) < kUpright && (!best || kind.area > best->area)) best = &kind;
  return best;
}

/// The share of the area whose normals lie along the axes (rows).
double flatShare(const std::vector<Eigen::Vector3d>& areas, const Eigen::Matrix3d& axes) {
  double flat = 0, all = 0;
  for (const Eigen::Vector3d& a : areas) {
    const double area = a.norm();
    all += area;
    if ((axes * a).cwiseAbs().maxCoeff() > kLike * area) flat += area;
  }
  return all > 0 ? flat / all : 0;
}

}  // namespace

Eigen::Matrix3d ownAxes(const TriangleMesh& mesh) {
  const std::vector<Eigen::Vector3d> faces = areas(mesh);
  const std::vector<Kind> kinds = kindsOf(faces);
  const Kind* first = largestAcross(kinds, Eigen::Vector3d::Zero());
  const Kind* second = first ? largestAcross(kinds, first->normal) : nullptr;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (!first) return axes;
  const Eigen::Vector3d across = second ? second->normal : first->normal.unitOrthogonal();
  axes.row(0) = first->normal;
  axes.row(1) = (across - across.dot(first->normal) * first->normal).normalized();
  axes.row(2) = first->normal.cross(Eigen::Vector3d(axes.row(1)));
  const Eigen::Matrix3d as_it_is = Eigen::Matrix3d::Identity();
  return flatShare(faces, axes) > flatShare(faces, as_it_is) + kMuch ? axes : as_it_is;
}

}  // namespace collision_hulls
