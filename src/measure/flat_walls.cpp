// Where the surface in a ball lies in a few slabs, thin as rounding, what is left of the ball falls into convex spaces that it does not
// enter: those on the given sides of all planes. The winding number is the same all over such a space, so one probe tells which side of
// the surface it is on. Only points in slabs are left, and near each of these is a point outside all slabs, which fill too little of any
// larger ball.
#include "measure/flat_walls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/looks.h"

namespace collision_hulls {

namespace {

constexpr double kSlab = 1e-6;          // largest deviation from a plane, as a share of the extent
constexpr std::size_t kMostPlanes = 3;  // of two walls, and of a third that they end at; with five, nothing was faster
constexpr std::size_t kMostWalls = 64;  // triangles; more seldom lie in so few planes
constexpr double kSamePlane = 1e-4;     // step to which normals, and offsets as shares of the extent, are rounded to compare planes
constexpr int kRounds = 24;             // in which to find a point of a space, or that there is none

// In half thicknesses t of slabs: how far the nearest point outside all slabs is at most, as n slabs fill no more than 2 n pi t rho^2 of a
// ball of radius rho, which is less than all of it from rho = 1.5 n t; and the nearest such point under a slab from one in it: that ball is
// moved down by as much, and by the slab's thickness.
constexpr double kWayOut = 5, kWayUnder = 2 * kWayOut + 2;
static_assert(kWayOut > 1.5 * kMostPlanes);

// The least cosine between planes' normals and a direction away from all of them; and the distance, in t, from which the distance surely
// grows that way: kLeastRise (k - m) > sqrt(2 m k), where m is kWayUnder and one more.
constexpr double kLeastRise = 0.5, kWayAside = 130;
static_assert(kLeastRise * kLeastRise * (kWayAside - kWayUnder - 1) * (kWayAside - kWayUnder - 1) > 2 * (kWayUnder + 1) * kWayAside);

struct Slab {
  Eigen::Vector3d normal;
  double offset = 0;     // [m]
  double thickness = 0;  // [m] half of it
  double height(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
};

/// The surface of a tree in a ball.
struct InBall {
  const TriangleBvh& tree;
  const Eigen::Vector3d& middle;
  double radius;
  std::vector<int> near;  // the triangles that may meet it; no more than one too many

  InBall(const TriangleBvh& the_tree, const Eigen::Vector3d& p, double r) : tree(the_tree), middle(p), radius(r) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(r);
    near = tree.trianglesNear({p - reach, p + reach}, kMostWalls);
  }
  bool isTooMuch() const { return near.size() > kMostWalls; }
  bool holds(const std::array<Eigen::Vector3d, 3>& triangle) const {
    return (closestPoint(triangle[0], triangle[1], triangle[2], middle) - middle).norm() <= radius;
  }
  /// Whether something is so for all its triangles; this is asked first, as it is quick.
  template <typename IsSo>
  bool all(const IsSo& isSo) const {
    return std::all_of(near.begin(), near.end(), [&](int t) { return isSo(tree.corners(t)) || !holds(tree.corners(t)); });
  }
};

/// Whether a slab holds a triangle; it may get thicker for that, up to `most` [m].
bool fits(const std::array<Eigen::Vector3d, 3>& triangle, double most, Slab& slab) {
  double thickness = slab.thickness;
  for (const Eigen::Vector3d& corner : triangle) thickness = std::max(thickness, std::abs(slab.height(corner)));
  if (thickness > most) return false;
  slab.thickness = thickness;
  return true;
}

/// The slabs that hold the surface in a ball; nullopt if that takes too many, or thicker ones than `most` [m].
std::optional<std::vector<Slab>> slabsOf(const InBall& walls, double most) {
  std::vector<Slab> slabs;
  for (const int t : walls.near) {
    const std::array<Eigen::Vector3d, 3>& triangle = walls.tree.corners(t);
    const auto isFit = [&](Slab& slab) { return fits(triangle, most, slab); };
    if (std::any_of(slabs.begin(), slabs.end(), isFit) || !walls.holds(triangle)) continue;
    const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
    if (slabs.size() == kMostPlanes || normal.isZero()) return std::nullopt;
    slabs.push_back({normal, normal.dot(triangle[0])});
    if (!isFit(slabs.back())) return std::nullopt;
  }
  return slabs;
}

/// The space of a ball above some slabs and below the others.
struct Space {
  const std::vector<Slab>& slabs;
  unsigned above = 0;  // a bit per slab
  Eigen::Vector3d centre;
  double radius = 0;

  double side(std::size_t i) const { return (above >> i & 1U) != 0 ? 1 : -1; }
  /// [m] How far a point is from one of its borders, inward.
  double depth(std::size_t i, const Eigen::Vector3d& p) const { return side(i) * slabs[i].height(p) - slabs[i].thickness; }

  /// Whether it is empty; if not, `point` receives a point of it, unless none is found. By fictitious play: the least depth of a point is
  /// at most any mean of the depths, whose maximum over the ball is known. The mean of where these maxima are is the candidate, and the
  /// border that it is least deep inside gets more weight.
  bool isEmpty(std::optional<Eigen::Vector3d>& point) const {
    std::array<double, kMostPlanes> weight{};
    std::fill_n(weight.begin(), slabs.size(), 1.0 / static_cast<double>(slabs.size()));
    Eigen::Vector3d candidate = centre;
    for (int round = 0; round < kRounds; ++round) {
      Eigen::Vector3d along = Eigen::Vector3d::Zero();
      double at_centre = 0;
      for (std::size_t i = 0; i < slabs.size(); ++i) {
        along += weight[i] * side(i) * slabs[i].normal;
        at_centre += weight[i] * depth(i, centre);
      }
      if (at_centre + radius * along.norm() <= 0) return true;
      const double step = 1.0 / (round + 1);
      candidate += step * (centre + radius * along.normalized() - candidate);
      std::size_t least = 0;
      for (std::size_t i = 1; i < slabs.size(); ++i)
        if (depth(i, candidate) < depth(least, candidate)) least = i;
      if (depth(least, candidate) > 0) {
        point = candidate;
        return false;
      }
      for (double& w : weight) w *= 1 - step;
      weight[least] += step;
    }
    return false;
  }
};

/// Whether the outside is what lies in front of all planes of `some` (a bit each), none of the surfaces reaches there, and a common
/// direction leads away from these planes. No space in front is inside then, as nothing divides them. `outside`: a bit per space.
bool isInFront(const std::vector<Slab>& slabs, unsigned some, unsigned outside, const InBall& walls, const InBall& surface) {
  unsigned front = 0;  // a bit per plane: on which side of it the first space outside is
  while ((outside >> front & 1U) == 0) ++front;
  for (unsigned space = 0; space < 1U << slabs.size(); ++space)
    if ((outside >> space & 1U) != 0 && ((space ^ front) & some) != 0) return false;
  const auto side = [&](std::size_t i) { return (front >> i & 1U) != 0 ? 1.0 : -1.0; };
  const auto isOfThem = [&](std::size_t i) { return (some >> i & 1U) != 0; };
  Eigen::Vector3d away = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < slabs.size(); ++i)
    if (isOfThem(i)) away += side(i) * slabs[i].normal;
  if (away.norm() < kLeastRise) return false;  // they face each other
  for (std::size_t i = 0; i < slabs.size(); ++i)
    if (isOfThem(i) && side(i) * slabs[i].normal.dot(away) < kLeastRise * away.norm()) return false;
  const auto isBehind = [&](const std::array<Eigen::Vector3d, 3>& triangle) {
    for (std::size_t i = 0; i < slabs.size(); ++i)
      if (isOfThem(i) && std::all_of(triangle.begin(), triangle.end(), [&](const Eigen::Vector3d& corner) {
            return side(i) * slabs[i].height(corner) <= slabs[i].thickness;
          }))
        return true;
    return false;
  };
  return walls.all(isBehind) && surface.all(isBehind);
}

}  // namespace

bool someFaceEachOther(const TriangleMesh& mesh, const RunControl& control) {
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  if (box.isEmpty()) return false;
  const double extent = box.sizes().maxCoeff();
  using Plane = std::array<long long, 4>;  // normal and offset, rounded
  std::vector<std::pair<Plane, bool>> planes;
  Looks look(control);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    look();
    const Eigen::Vector3d corner = mesh.corner(t, 0) - box.center();
    Eigen::Vector4d plane;
    plane.head<3>() = (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)).normalized();
    plane[3] = plane.head<3>().dot(corner) / extent;
    Plane rounded;
    for (Eigen::Index i = 0; i < 4; ++i) rounded[static_cast<std::size_t>(i)] = std::llround(plane[i] / kSamePlane);
    Plane opposite = rounded;
    for (long long& x : opposite) x = -x;
    planes.emplace_back(std::max(rounded, opposite), rounded < opposite);
  }
  std::sort(planes.begin(), planes.end(), [&](const auto& a, const auto& b) { return look(), a < b; });
  return std::adjacent_find(planes.begin(), planes.end(),
                            [](const auto& a, const auto& b) { return a.first == b.first && a.second != b.second; }) != planes.end();
}

AmongFlatWalls amongFlatWalls(const TriangleBvh& closed, const TriangleBvh& surface, const Eigen::Vector3d& p, double radius) {
  const double blur = closed.blur(), flat = kSlab * closed.extent();
  const double inner = radius + kWayUnder * (flat + 2 * blur), outer = inner + 2 * blur;
  const InBall walls(closed, p, outer);
  if (walls.isTooMuch()) return {};
  std::optional<std::vector<Slab>> slabs = slabsOf(walls, flat);
  if (!slabs) return {};
  double thickest = 0;
  for (Slab& slab : *slabs) thickest = std::max(thickest, slab.thickness += 2 * blur);
  const unsigned spaces = 1U << slabs->size();
  unsigned inside = 0, outside = 0;  // a bit per space
  for (unsigned above = 0; above < spaces; ++above) {
    std::optional<Eigen::Vector3d> point;
    if (Space{*slabs, above, p, inner}.isEmpty(point)) continue;
    if (!point) return {};
    (closed.signedCrossings(*point) > 0 ? inside : outside) |= 1U << above;
  }
  if (inside == 0) return {};
  if (outside == 0) return {kWayOut * thickest, kWayUnder * thickest};
  const InBall all(surface, p, outer);
  if (all.isTooMuch()) return {};
  for (const std::size_t count : {1, 2, 3})
    for (unsigned some = 1; some < spaces; ++some)
      if (std::bitset<kMostPlanes>(some).count() == count && isInFront(*slabs, some, outside, walls, all))
        return {std::numeric_limits<double>::infinity(), (count == 1 ? kWayUnder : kWayAside) * thickest};
  return {};
}

}  // namespace collision_hulls
