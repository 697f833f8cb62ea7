// Ear clipping in the plane of the polygon's mean normal (Newell), O(n^2) for typical polygons; convex ones are a fan in O(n).
#include "mesh/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <utility>

#include "base/at.h"

namespace collision_hulls {
namespace {

using Point = Eigen::Vector2d;

/// Of a polygon's triangles, the length of the sum of their normals, as a share of their area: 1 if they all face the same way.
constexpr double kFlat = 0.999;

/// Twice the signed area of a triangle in the plane.
double area(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The corners projected along the longest component of Newell's normal; this makes the polygon run counter-clockwise.
std::vector<Point> projected(const std::vector<Eigen::Vector3d>& corners) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<Point> points;
  for (const Eigen::Vector3d& p : corners) {
    const Eigen::Vector3d q = p - corners[0];
    points.emplace_back(normal[axis] >= 0 ? Point(q[u], q[v]) : Point(q[v], q[u]));
  }
  return points;
}

/// The corners not cut off yet, in order.
class EarCutter {
 public:
  EarCutter(const std::vector<Eigen::Vector3d>& corners, const RunControl& control)
      : points_(projected(corners)), rest_(corners.size()), control_(control) {
    std::iota(rest_.begin(), rest_.end(), 0);
  }

  std::vector<Triangle> cut() {
    std::vector<Triangle> triangles;
    if (fanFits()) return fan({});
    while (rest_.size() > 3) {
      const std::size_t ear = findEar();
      if (ear == rest_.size()) break;
      triangles.push_back(triangle(ear));
      rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
      start_ = ear > 0 ? ear - 1 : 0;
    }
    return fan(std::move(triangles));
  }

 private:
  /// `triangles`, followed by a fan from the first remaining corner.
  std::vector<Triangle> fan(std::vector<Triangle> triangles) const {
    for (std::size_t i = 1; i + 1 < rest_.size(); ++i) triangles.push_back({rest_[0], rest_[i], rest_[i + 1]});
    return triangles;
  }

  /// Whether the first corner sees all others, as in every convex polygon.
  bool fanFits() const {
    for (std::size_t i = 1; i + 1 < rest_.size(); ++i)
      if (area(point(rest_[0]), point(rest_[i]), point(rest_[i + 1])) < 0) return false;
    return true;
  }

  Triangle triangle(std::size_t i) const { return {rest_[(i + rest_.size() - 1) % rest_.size()], rest_[i], rest_[(i + 1) % rest_.size()]}; }
  const Point& point(int corner) const { return points_[static_cast<std::size_t>(corner)]; }

  /// The position of an ear: a convex corner whose triangle contains no other corner; the number of corners left if there is none.
  std::size_t findEar() const {
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      control_.check();
      const std::size_t i = (start_ + k) % rest_.size();
      const Triangle t = triangle(i);
      if (area(point(t[0]), point(t[1]), point(t[2])) > 0 && isEmpty(t)) return i;
    }
    return rest_.size();
  }

  bool isEmpty(const Triangle& t) const {
    const Point &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    return std::none_of(rest_.begin(), rest_.end(), [&](int other) {
      const Point& p = point(other);
      if (p == a || p == b || p == c) return false;
      return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
    });
  }

  std::vector<Point> points_;
  std::vector<int> rest_;
  const RunControl& control_;
  std::size_t start_ = 0;  // where to start looking for the next ear
};

}  // namespace

std::vector<Triangle> triangulate(const std::vector<Eigen::Vector3d>& corners, const RunControl& control) {
  if (corners.size() == 3) return {{0, 1, 2}};
  return EarCutter(corners, control).cut();
}

std::vector<Triangle> otherReading(const std::vector<Eigen::Vector3d>& corners, const std::vector<Triangle>& cut) {
  double area = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Triangle& t : cut) {
    const Eigen::Vector3d normal = (corners[at(t[1])] - corners[at(t[0])]).cross(corners[at(t[2])] - corners[at(t[0])]);
    area += normal.norm();
    mean += normal;
  }
  if (mean.norm() >= kFlat * area) return {};
  std::vector<Triangle> sorted = cut, other;
  std::sort(sorted.begin(), sorted.end());
  for (int k = 1; at(k + 1) < corners.size(); ++k)
    if (!std::binary_search(sorted.begin(), sorted.end(), Triangle{0, k, k + 1})) other.push_back({0, k, k + 1});
  return other;
}

}  // namespace collision_hulls
