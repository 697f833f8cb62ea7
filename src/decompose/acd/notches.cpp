// Visits all edges, sorted so that the two sides of each are neighbours, and measures the distance from each reflex edge to its bridge. The
// scan for the nearest face starts at the last bridge and stops as soon as the notch cannot be the deepest.
#include "decompose/acd/notches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/looks.h"

namespace collision_hulls {

namespace {

constexpr double kFlat = 1 - 1e-10;    // an edge is flat if the cosine between its faces is above this
constexpr double kOpensTowards = 0.1;  // least cosine between the direction out of a notch and the normal of its bridge
constexpr double kNil = 1e-9;          // concavity, in extents of the piece, that counts as zero

/// A triangle's side, in the direction in which it runs around the triangle.
struct Side {
  int low, high, triangle;
  bool forward;  // from low to high
  bool operator<(const Side& o) const { return low != o.low ? low < o.low : high != o.high ? high < o.high : triangle < o.triangle; }
  bool along(const Side& o) const { return low == o.low && high == o.high; }
};

std::vector<Side> sortedSides(const SurfacePiece& piece, Looks& look) {
  std::vector<Side> sides;
  sides.reserve(3 * piece.triangles.size());
  for (std::size_t t = 0; t < piece.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      look();
      const int a = piece.triangles[t][k], b = piece.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
    }
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return look(), a < b; });
  return sides;
}

Eigen::Vector3d normalOf(const SurfacePiece& piece, int t) {
  const Eigen::Vector3d n = (piece.corner(t, 1) - piece.corner(t, 0)).cross(piece.corner(t, 2) - piece.corner(t, 0));
  return n.norm() > 0 ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d::Zero();
}

class Search {
 public:
  Search(const SurfacePiece& piece, const ConvexHull& hull, bool two_sided) : piece_(piece), hull_(hull), two_sided_(two_sided) {
    deepest_.concavity = kNil * boundingBox(piece).sizes().maxCoeff();
  }

  Notch run(const RunControl& control) {
    Looks look(control);
    const std::vector<Side> sides = sortedSides(piece_, look);
    const double nil = deepest_.concavity;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      look();
      if (sides[i].along(sides[i + 1]) && sides[i].forward != sides[i + 1].forward) visit(sides[i], sides[i + 1], control);
    }
    return deepest_.concavity > nil ? deepest_ : Notch{};
  }

 private:
  void visit(const Side& first, const Side& second, const RunControl& control) {
    const Eigen::Vector3d n1 = normalOf(piece_, first.triangle), n2 = normalOf(piece_, second.triangle);
    if (n1.isZero(0) || n2.isZero(0) || n1.dot(n2) > kFlat) return;
    control.check();  // the scan may take as many steps as the hull has faces
    const Eigen::Vector3d &a = piece_.vertices[static_cast<std::size_t>(first.low)],
                          &b = piece_.vertices[static_cast<std::size_t>(first.high)];
    const Eigen::Vector3d edge = first.forward ? Eigen::Vector3d(b - a) : Eigen::Vector3d(a - b);
    const double turn = edge.cross(n1).dot(n2);  // > 0: a convex edge, where the second face bends back from the plane of the first
    if (turn == 0 || (turn > 0 && !two_sided_)) return;
    const Eigen::Vector3d out = ((turn < 0 ? 1.0 : -1.0) * (n1 + n2)).normalized();
    const Eigen::Vector3d bisector = edge.cross(out).normalized();
    for (const Eigen::Vector3d& p : {Eigen::Vector3d((a + b) / 2), a, b}) {
      const double concavity = distanceToBridge(p, out);
      if (concavity > deepest_.concavity) deepest_ = {concavity, p, bisector};
    }
  }

  /// 0 if the notch opens towards no face. Stops early, with a distance that is too large, only once the notch is known not to be the
  /// deepest.
  double distanceToBridge(const Eigen::Vector3d& p, const Eigen::Vector3d& out) {
    double least = std::numeric_limits<double>::infinity();
    const std::size_t count = hull_.faces.size();
    for (std::size_t i = 0; i < count && least > deepest_.concavity; ++i) {
      const std::size_t f = (last_bridge_ + i) % count;  // neighbouring notches usually have the same bridge
      if (hull_.faces[f].normal.dot(out) < kOpensTowards) continue;
      const double d = -hull_.faces[f].distance(p);
      if (d < least) {
        least = d;
        if (least <= deepest_.concavity) last_bridge_ = f;
      }
    }
    return std::isfinite(least) ? least : 0;
  }

  const SurfacePiece& piece_;
  const ConvexHull& hull_;
  bool two_sided_;
  Notch deepest_;
  std::size_t last_bridge_ = 0;
};

}  // namespace

Notch deepestNotch(const SurfacePiece& piece, const ConvexHull& hull, bool two_sided, const RunControl& control) {
  return Search(piece, hull, two_sided).run(control);
}

}  // namespace collision_hulls
