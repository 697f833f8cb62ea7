// Of two balls in the space that touch its border at the same point, the larger contains the smaller. So only those need to be candidates
// that cannot be enlarged about such a point: the balls of the space's medial axis. Each is found on the ray from the border point inward,
// by doubling and bisection of its radius.
#include "primitives/sphere_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision_hulls {

namespace {

constexpr int kBisections = 5;
constexpr double kShare = 0.98;  // of the radius that it ought to have: a ball that has this much counts as touching the border point

/// A single-precision number that is no larger, for a positive x.
double roundedDown(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest <= x ? nearest : std::nextafter(nearest, 0.0F);
}

/// The largest ball found that touches `border`, with its centre on the ray along `inward`; `least`: a radius to start with.
Sphere touching(const Eigen::Vector3d& border, const Eigen::Vector3d& inward, double least, const TolerableSpace& space) {
  Sphere best = sphereAt(border + least * inward, space);
  const auto fits = [&](double radius) {
    const Sphere sphere = sphereAt(border + radius * inward, space);
    if (sphere.radius < kShare * radius) return false;
    best = sphere;
    return true;
  };
  double low = least, high = 2 * least;
  while (fits(high)) low = high, high *= 2;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = (low + high) / 2;
    (fits(middle) ? low : high) = middle;
  }
  return best;
}

}  // namespace

std::vector<SurfacePoint> spreadOver(const TriangleMesh& mesh, std::size_t count) {
  std::vector<SurfacePoint> points;
  const double share = area(mesh) / static_cast<double>(count);
  double passed = share / 2;  // of the area, beyond the last point
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3d &a = mesh.corner(t, 0), u = mesh.corner(t, 1) - a, v = mesh.corner(t, 2) - a;
    const Eigen::Vector3d twice_area = u.cross(v);
    if (!(twice_area.norm() > 0)) continue;
    for (passed += twice_area.norm() / 2; passed > share && points.size() < count; passed -= share) {
      // The additive sequence of the plastic number, folded into the triangle.
      const auto i = static_cast<double>(points.size() + 1);
      double x = std::fmod(0.7548776662466927 * i, 1), y = std::fmod(0.5698402909980532 * i, 1);
      if (x + y > 1) x = 1 - x, y = 1 - y;
      points.push_back({a + x * u + y * v, twice_area.normalized()});
    }
  }
  if (points.empty()) points.push_back({mesh.corner(0, 0), Eigen::Vector3d::Zero()});
  return points;
}

// GCC 12 at -O3 makes a copy of p.cast<float>().cast<double>(), when it does two coordinates at once; volatile numbers it does not put
// together.
Eigen::Vector3d inSinglePrecision(const Eigen::Vector3d& p) {
  const volatile auto x = static_cast<float>(p.x()), y = static_cast<float>(p.y()), z = static_cast<float>(p.z());
  return {x, y, z};
}

Sphere sphereAt(const Eigen::Vector3d& centre, const TolerableSpace& space) {
  Sphere sphere;
  sphere.centre = inSinglePrecision(centre);
  sphere.radius = std::max(0.0, roundedDown(space.radius(sphere.centre)));
  return sphere;
}

Sphere enlarged(const Sphere& sphere, const TolerableSpace& space) {
  const Eigen::Vector3d border = space.nearestOutside(sphere.centre), inward = sphere.centre - border;
  if (!(inward.norm() > 0)) return sphere;
  const Sphere larger = touching(border, inward.normalized(), inward.norm(), space);
  return larger.radius > sphere.radius ? larger : sphere;
}

std::vector<Sphere> largestAt(const SurfacePoint& at, const TolerableSpace& space) {
  const double t = space.tolerance();
  std::vector<Sphere> spheres{enlarged(sphereAt(at.p, space), space)};
  if (at.normal.squaredNorm() > 0) spheres.push_back(touching(at.p + t * at.normal, -at.normal, t, space));
  return spheres;
}

}  // namespace collision_hulls
