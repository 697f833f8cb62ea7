// Which triangle of the surface a patch meets. Boxes are compared with its plane and with the planes through its edges, upright on it, four
// boxes at a time in single precision. A triangle of the surface crosses its plane in a segment, which is compared with the edges.
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_bvh.h"

namespace collision_hulls {

namespace {

// As a share of the tree's extent: what is nearer than this may be met. Larger than the rounding error of a sum of three products in
// single precision, of coordinates that are at most 2 extents large, and of the boxes; and than the error of the point in which an edge
// crosses a plane, by whose two sides its ends differ by more than this.
constexpr double kTouch = 4e-6;
// As a share of the extent: what is further than this from a triangle's plane lies on one side of it. More than the blur, and a thousand
// times the rounding error in double precision, to which coordinates far from the origin add.
constexpr double kOffPlane = 4e-9, kCoordinateRounding = 1e-12;
// If the sine of a patch's angle is more than this, its corners lie within a fifth of kOffPlane of the plane that is computed.
constexpr double kThinPatch = 1e-6;

}  // namespace

/// A patch's plane and its edges'.
struct TriangleBvh::PatchPlanes {
  PatchPlanes(const std::array<Eigen::Vector3d, 3>& patch, double touch, double side) : corner(patch), margin(touch), off_plane(side) {
    const Eigen::Vector3d one = patch[1] - patch[0], other = patch[2] - patch[0];
    Eigen::Vector3d normal = one.cross(other);
    // Nothing is known to lie on one side of a sliver.
    normal = normal.norm() > kThinPatch * one.norm() * other.norm() ? normal.normalized() : Eigen::Vector3d(Eigen::Vector3d::Zero());
    plane = {normal, normal.dot(patch[0])};
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d outward = (patch[(i + 1) % 3] - patch[i]).cross(normal).normalized();
      edge[i] = {outward, outward.dot(patch[i])};
    }
  }

  /// Whether a triangle of the surface may meet the patch.
  bool mayMeet(const std::array<Eigen::Vector3d, 3>& other) const {
    std::array<double, 3> height;
    for (std::size_t i = 0; i < 3; ++i) height[i] = plane.distance(other[i]);
    const auto [low, high] = std::minmax_element(height.begin(), height.end());
    if (*low > off_plane || *high < -off_plane) return false;
    const Eigen::Vector3d normal = (other[1] - other[0]).cross(other[2] - other[0]);
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Eigen::Vector3d& p : corner) {
      const double above = normal.dot(p - other[0]);
      lowest = std::min(lowest, above), highest = std::max(highest, above);
    }
    const double level = off_plane * normal.norm();
    if (lowest > level || highest < -level) return false;
    // The part in the patch's plane: a segment, or what lies in the plane.
    std::array<Eigen::Vector3d, 6> part;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double from = height[i], to = height[(i + 1) % 3];
      if (std::abs(from) <= margin) part[count++] = other[i];
      if ((from < 0) != (to < 0) && std::abs(from - to) > margin)
        part[count++] = other[i] + (other[(i + 1) % 3] - other[i]) * (from / (from - to));
    }
    return std::none_of(edge.begin(), edge.end(), [&](const HalfSpace& e) {
      return std::all_of(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count),
                         [&](const Eigen::Vector3d& p) { return e.distance(p) > margin; });
    });
  }

  std::array<Eigen::Vector3d, 3> corner;
  double margin, off_plane;  // [m]
  HalfSpace plane;
  std::array<HalfSpace, 3> edge;  // distances are positive outside the patch
};

const std::array<Eigen::Vector3d, 3>* TriangleBvh::metBy(const std::array<Eigen::Vector3d, 3>& patch) const {
  if (fours_.empty()) return nullptr;
  const PatchPlanes planes(patch, kTouch * unit_, kOffPlane * unit_ + kCoordinateRounding * centre_.cwiseAbs().maxCoeff());
  const float touch = static_cast<float>(kTouch);
  const Eigen::Vector3f a = inUnits(patch[0]), b = inUnits(patch[1]), c = inUnits(patch[2]);
  const Eigen::Vector3f low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  struct Single {
    Eigen::Vector3f normal;
    float offset;
  };
  const auto single = [&](const HalfSpace& p) -> Single {
    return {p.normal.cast<float>(), static_cast<float>((p.offset - p.normal.dot(centre_)) / unit_)};
  };
  const Single plane = single(planes.plane);
  const std::array<Single, 3> edges{single(planes.edge[0]), single(planes.edge[1]), single(planes.edge[2])};
  // The lowest (or highest) height of each box's points.
  const auto extreme = [](const FourBoxes& four, const Single& p, bool lowest) {
    Eigen::Array4f sum = Eigen::Array4f::Constant(-p.offset);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      sum += p.normal[axis] * ((p.normal[axis] > 0) == lowest ? four.low[i] : four.high[i]);
    }
    return sum;
  };
  int stack[kDeepestFours];
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const FourBoxes& four = fours_[static_cast<std::size_t>(stack[--top])];
    Eigen::Array4f away = extreme(four, plane, true).max(-extreme(four, plane, false));
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      away = away.max(four.low[i] - high[axis]).max(low[axis] - four.high[i]);
    }
    for (const Single& e : edges) away = away.max(extreme(four, e, true));
    for (int i = 0; i < four.count; ++i) {
      if (away[i] > touch) continue;
      const int child = four.child[static_cast<std::size_t>(i)];
      if (child >= 0)
        stack[top++] = child;
      else if (const auto& corners = corners_[static_cast<std::size_t>(~child)]; planes.mayMeet(corners))
        return &corners;
    }
  }
  return nullptr;
}

}  // namespace collision_hulls
