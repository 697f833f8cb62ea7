// Candidate planes for one split, in three families, because no single one serves all shapes:
//
//   at reflex edges, where the surface bends inward: the planes of both faces (they finish a flat side at once) and the bisector;
//   through an intruder, normal to the axes and, for the deepest, to the diagonals: shapes without sharp edges, such as bowls;
//   across and along the line from an intruder to the nearest surface: walls that face each other.
//
// Like planes are joined and their weights added, so a long straight edge of many triangles counts once and first. No plane is proposed
// twice, and of what ties a slight preference takes one (geometry/lean.h), so that turning the mesh changes nothing. Scoring a plane
// (plane_score.h) is what takes time, hence the limits. O(n log n) for the edges, O(n k) for joining n planes into at most k = kMostKinds.
// Principal axes of the piece were tried as a fourth family: they made mechanical parts worse.
#include "decompose/certified/split_planes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "geometry/lean.h"

namespace collision_hulls {

namespace {

constexpr double kFlat = 0.995;          // an edge is not reflex if the cosine between its faces is above this
constexpr double kLevel = 1e-3;          // how far a face must rise above its neighbour's plane, in tolerances
constexpr double kLike = 0.9995;         // planes count as one if the cosine between their normals is larger than this ...
constexpr double kNear = 0.1;            // ... and their offsets differ by less than this, in tolerances
constexpr double kLean = 1e-3;           // most that position counts, as a share of a weight or in tolerances
constexpr std::size_t kMostKinds = 300;  // reflex planes that are distinguished
constexpr std::size_t kMostReflex = 60;  // ... and those of them that are tried

struct Weighted {
  HalfSpace plane;
  double weight = 0;
  double forward = 0;  // weight of those joined whose normals point the same way, less that of the others
};

HalfSpace reversed(const HalfSpace& plane) {
  return {-plane.normal, -plane.offset};
}

HalfSpace through(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
  return {normal, normal.dot(p)};
}

Eigen::Vector3d normalOf(const SurfacePiece& piece, int t) {
  const Eigen::Vector3d n = (piece.corner(t, 1) - piece.corner(t, 0)).cross(piece.corner(t, 2) - piece.corner(t, 0));
  return n.norm() > 0 ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d::Zero();
}

/// Adds three planes at the edge a-b between two faces if it is reflex. Their weight is the edge's length times the angle.
void addReflexPlanes(const SurfacePiece& piece, int first, int second, int a, int b, double tolerance, std::vector<Weighted>& planes) {
  const Eigen::Vector3d n1 = normalOf(piece, first), n2 = normalOf(piece, second);
  const double cosine = n1.dot(n2);
  if (cosine > kFlat || n1.isZero(0) || n2.isZero(0)) return;
  const Eigen::Vector3d &pa = piece.vertices[static_cast<std::size_t>(a)], &pb = piece.vertices[static_cast<std::size_t>(b)];
  double rise = 0;
  for (int k = 0; k < 3; ++k) rise = std::max(rise, n1.dot(piece.corner(second, k) - pa));
  if (rise <= kLevel * tolerance) return;
  const double weight = (pb - pa).norm() * std::acos(std::clamp(cosine, -1.0, 1.0));
  planes.push_back({through(pa, n1), weight});
  planes.push_back({through(pa, n2), weight});
  const Eigen::Vector3d bisector = (pb - pa).cross(n1 + n2);
  if (bisector.norm() > 0) planes.push_back({through(pa, bisector.normalized()), weight});
}

std::vector<Weighted> reflexPlanes(const SurfacePiece& piece, double tolerance) {
  struct HalfEdge {
    int low, high, triangle;
    bool operator<(const HalfEdge& o) const { return low != o.low ? low < o.low : high != o.high ? high < o.high : triangle < o.triangle; }
  };
  std::vector<HalfEdge> edges;
  for (int t = 0; t < static_cast<int>(piece.triangles.size()); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& c = piece.triangles[static_cast<std::size_t>(t)];
      const auto [low, high] = std::minmax(c[k], c[(k + 1) % 3]);
      edges.push_back({low, high, t});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<Weighted> planes;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const HalfEdge &e = edges[i], &f = edges[i + 1];
    if (e.low == f.low && e.high == f.high) addReflexPlanes(piece, e.triangle, f.triangle, e.low, e.high, tolerance, planes);
  }
  return planes;
}

bool alike(const HalfSpace& a, const HalfSpace& b, double tolerance) {
  const double cosine = a.normal.dot(b.normal), sign = cosine > 0 ? 1 : -1;
  return std::abs(cosine) > kLike && std::abs(a.offset - sign * b.offset) < kNear * tolerance;
}

/// Joins similar planes and adds up their weights; heaviest first. Each points the way that most of its weight does.
std::vector<Weighted> joined(std::vector<Weighted> planes, double size, double tolerance) {
  const auto sort = [size](std::vector<Weighted>& some) {
    const auto key = [size](const Weighted& w) { return w.weight * (1 + kLean * lean(w.plane, size)); };
    std::stable_sort(some.begin(), some.end(), [&](const Weighted& a, const Weighted& b) { return key(a) > key(b); });
  };
  sort(planes);
  std::vector<Weighted> kinds;
  for (const Weighted& p : planes) {
    auto like = std::find_if(kinds.begin(), kinds.end(), [&](const Weighted& k) { return alike(k.plane, p.plane, tolerance); });
    if (like == kinds.end()) {
      if (kinds.size() == kMostKinds) continue;
      like = kinds.insert(kinds.end(), {p.plane, 0, 0});
    }
    like->weight += p.weight;
    like->forward += like->plane.normal.dot(p.plane.normal) > 0 ? p.weight : -p.weight;
  }
  sort(kinds);
  for (Weighted& k : kinds)
    if (k.forward + kLean * k.weight * lean(k.plane.normal, 1) < 0) k.plane = reversed(k.plane);
  return kinds;
}

void addAxisPlanes(const Eigen::Vector3d& p, bool diagonals, std::vector<HalfSpace>& planes) {
  for (int axis = 0; axis < 3; ++axis) planes.push_back(through(p, Eigen::Vector3d::Unit(axis)));
  if (!diagonals) return;
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {1.0, -1.0})
      planes.push_back(through(p, (Eigen::Vector3d::Unit((axis + 1) % 3) + sign * Eigen::Vector3d::Unit((axis + 2) % 3)).normalized()));
}

/// The axis furthest from a direction, made normal to it; of several the first.
Eigen::Vector3d sideways(const Eigen::Vector3d& direction) {
  Eigen::Index axis = 0;
  (direction.cwiseAbs() + kLean * Eigen::Vector3d(0, 1, 2)).minCoeff(&axis);
  const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
  return (unit - unit.dot(direction) * direction).normalized();
}

/// Planes across and along the shortest line from the solid to an intruder; of two as short, the one on the same side every time.
void addNearestPlanes(const Eigen::Vector3d& p, const Solid& solid, double tolerance, std::vector<HalfSpace>& planes) {
  const Eigen::Vector3d aside = p + kLean * tolerance * aslant();
  const Eigen::Vector3d nearest = solid.surface().nearest(aside).point, way = p - nearest;
  if (!(way.norm() > 0)) return;
  const Eigen::Vector3d across = way.normalized(), along = sideways(across);
  planes.push_back(through(p, across));
  planes.push_back(through(nearest, across));
  planes.push_back(through(p, along));
  planes.push_back(through(p, across.cross(along)));
}

}  // namespace

std::vector<HalfSpace> splitPlanes(const SurfacePiece& piece, const std::vector<OutsideDistance::Intruder>& intruders, const Solid& solid,
                                   double tolerance) {
  std::vector<HalfSpace> planes;
  const double size = boundingBox(piece).diagonal().norm();
  const std::vector<Weighted> reflex = joined(reflexPlanes(piece, tolerance), size, tolerance);
  for (std::size_t i = 0; i < std::min(kMostReflex, reflex.size()); ++i) planes.push_back(reflex[i].plane);
  std::vector<OutsideDistance::Intruder> deepest = intruders;
  const auto depth = [&](const OutsideDistance::Intruder& i) { return i.distance + kLean * tolerance * lean(i.p, size); };
  std::stable_sort(deepest.begin(), deepest.end(), [&](const auto& a, const auto& b) { return depth(a) > depth(b); });
  for (std::size_t quarter = 0; quarter < 4 && quarter < deepest.size(); ++quarter) {
    const Eigen::Vector3d& p = deepest[quarter * deepest.size() / 4].p;
    addAxisPlanes(p, quarter == 0, planes);
    addNearestPlanes(p, solid, tolerance, planes);
  }
  std::vector<HalfSpace> different;
  for (const HalfSpace& plane : planes)
    if (std::none_of(different.begin(), different.end(), [&](const HalfSpace& known) { return alike(known, plane, tolerance); }))
      different.push_back(plane);
  return different;
}

}  // namespace collision_hulls
