// Probes are biased toward contact: most are anchored on the original or in a hull and moved off by a log-uniform distance. Each query has
// its own random stream, so any query can be repeated alone.
#include "check/validate_probes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "check/validate_exact.h"
#include "geometry/box_hull.h"
#include "geometry/hull_support.h"

namespace collision_hulls {

namespace {

// The following are shares of the element's size.
constexpr double kSurroundings = 0.25;          // how far around the element free poses extend
constexpr double kNudge = 1e-4;                 // displacement of a neighbour's first pose; its rotation in radians
constexpr double kNearest = 1e-5, kNear = 0.1;  // distances of poses near contact
constexpr double kBoxSides[][3] = {{0.001, 0.001, 0.001}, {0.02, 0.02, 0.02}, {0.1, 0.06, 0.04},
                                   {0.3, 0.01, 0.01},     {0.2, 0.15, 0.005}, {0.35, 0.25, 0.2}};

/// A random point of a triangle: a corner, a point on an edge, or an inner point.
Eigen::Vector3d pointOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, Random& random) {
  const std::size_t kind = random.below(4);
  if (kind == 0) return a;
  const double u = random.uniform(0, 1), v = random.uniform(0, 1);
  if (kind == 1) return a + (b - a) * u;
  return u + v <= 1 ? a + (b - a) * u + (c - a) * v : a + (b - a) * (1 - u) + (c - a) * (1 - v);
}

Eigen::Vector3d pointOf(const TriangleMesh& mesh, std::size_t triangle, Random& random) {
  const int t = static_cast<int>(triangle), first = static_cast<int>(random.below(3));
  return pointOf(mesh.corner(t, first), mesh.corner(t, (first + 1) % 3), mesh.corner(t, (first + 2) % 3), random);
}

}  // namespace

ProbeShape::ProbeShape(std::string probe_name, const ConvexHull& probe_hull)
    : name(std::move(probe_name)), hull(probe_hull), convex(probe_hull), mesh(surface(probe_hull)) {}

std::vector<ProbeShape> boxShapes() {
  std::vector<ProbeShape> shapes;
  for (const auto& sides : kBoxSides) shapes.emplace_back("box", hullOfBox({sides[0], sides[1], sides[2]}));
  return shapes;
}

Probe sphere(const Eigen::Vector3d& centre, double radius) {
  Probe probe;
  probe.centre = centre;
  probe.radius = radius;
  probe.box = Eigen::AlignedBox3d(centre.array() - radius, centre.array() + radius);
  return probe;
}

Probe placed(const ProbeShape& shape, const Eigen::Isometry3d& pose) {
  Probe probe;
  probe.shape = &shape;
  probe.pose = pose;
  probe.body = transformed(shape.hull, pose);
  probe.centre = meanOfVertices(probe.body);
  for (const Eigen::Vector3d& v : probe.body.vertices) probe.radius = std::max(probe.radius, (v - probe.centre).norm());
  probe.box = boundingBox(probe.body);
  return probe;
}

PoseSampler::PoseSampler(const TriangleMesh& original, const std::vector<ConvexHull>& hulls)
    : original_(original), hulls_(hulls), surroundings_(boundingBox(original)) {
  for (const ConvexHull& hull : hulls) surroundings_.extend(boundingBox(hull));
  surroundings_.min().array() -= kSurroundings;
  surroundings_.max().array() += kSurroundings;
  double sum = 0;
  for (int t = 0; t < static_cast<int>(original.triangles.size()); ++t) {
    const Eigen::Vector3d& a = original.corner(t, 0);
    sum += (original.corner(t, 1) - a).cross(original.corner(t, 2) - a).norm();
    area_below_.push_back(sum);
  }
}

Eigen::Vector3d PoseSampler::onOriginal(Random& random) const {
  // Half by area, half by triangle: small parts have many small triangles.
  std::size_t triangle = random.below(area_below_.size());
  if (random.below(2) == 0) {
    const auto chosen = std::upper_bound(area_below_.begin(), area_below_.end() - 1, random.uniform(0, area_below_.back()));
    triangle = static_cast<std::size_t>(chosen - area_below_.begin());
  }
  return pointOf(original_, triangle, random);
}

Eigen::Vector3d PoseSampler::inHull(Random& random) const {
  const ConvexHull& hull = hulls_[random.below(hulls_.size())];
  const TriangleMesh skin = surface(hull);
  const Eigen::Vector3d p = pointOf(skin, random.below(skin.triangles.size()), random);
  if (random.below(2) == 0) return p;
  const Eigen::Vector3d q = pointOf(skin, random.below(skin.triangles.size()), random);
  return p + (q - p) * random.uniform(0, 1);
}

/// A place to touch: on the original, on or in a hull, or anywhere around.
Eigen::Vector3d PoseSampler::anchor(Random& random) const {
  const std::size_t kind = random.below(5);
  if (kind < 2) return onOriginal(random);
  if (kind < 4 && !hulls_.empty()) return inHull(random);
  Eigen::Vector3d p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(surroundings_.min()[axis], surroundings_.max()[axis]);
  return p;
}

Eigen::Vector3d PoseSampler::offset(Random& random) const {
  const double length = random.logUniform(kNearest, kNear);
  return random.direction() * length;
}

Eigen::Vector3d PoseSampler::sphereCentre(Random& random, double radius) const {
  Eigen::Vector3d centre = anchor(random);
  centre += offset(random);
  if (random.below(2) == 0) centre += random.direction() * radius;
  return centre;
}

Eigen::Isometry3d PoseSampler::pose(Random& random, const ConvexHull& probe) const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = random.rotation().toRotationMatrix();
  const TriangleMesh skin = surface(probe);
  const Eigen::Vector3d handle = pointOf(skin, random.below(skin.triangles.size()), random);
  pose.translation() = anchor(random) - pose.linear() * handle;
  pose.translation() += offset(random);
  return pose;
}

Eigen::Isometry3d PoseSampler::nudge(Random& random) const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(kNudge, random.direction()).toRotationMatrix();
  pose.translation() = random.direction() * kNudge;
  return pose;
}

}  // namespace collision_hulls
