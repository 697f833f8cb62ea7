// Visits all edges, sorted so that the two sides of each are neighbours, and measures the distance from each reflex edge to its bridge. The
// search for the nearest face starts at the last bridge, goes through a tree of faces, and stops as soon as the notch cannot be the
// deepest.
#include "decompose/acd/notches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/looks.h"
#include "decompose/box_tree.h"

namespace collision_hulls {

namespace {

constexpr double kFlat = 1 - 1e-10;    // an edge is flat if the cosine between its faces is above this
constexpr double kOpensTowards = 0.1;  // least cosine between the direction out of a notch and the normal of its bridge
constexpr double kRounding = 1e-12;    // of a bound on normals, and as a share of the lengths in one on distances
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

/// The faces of a hull, by what their normals and offsets are.
class Bridges {
 public:
  explicit Bridges(const ConvexHull& hull) : hull_(hull) {
    const Eigen::AlignedBox3d box = boundingBox(hull);
    middle_ = box.center();
    if (const double diagonal = box.diagonal().norm(); diagonal > 0) size_ = diagonal;
    std::vector<Faces::Key> keys;
    for (const HalfSpace& face : hull.faces) {
      keys.emplace_back();
      keys.back() << face.normal, -face.distance(middle_) / size_;
    }
    faces_ = Faces(keys);
  }

  /// [m] How far p lies below the nearest of the faces that the direction `out` opens towards; infinite without any. May stop at a face
  /// that is no further than `enough`.
  double distance(const Eigen::Vector3d& p, const Eigen::Vector3d& out, double enough) {
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t f) {
      if (hull_.faces[f].normal.dot(out) < kOpensTowards) return;
      least = std::min(least, -hull_.faces[f].distance(p));
      if (least <= enough) last_ = f;
    };
    if (hull_.faces.empty()) return least;
    look(last_);  // neighbouring notches usually have the same bridge
    if (least <= enough) return least;
    const Eigen::Vector3d way = middle_ - p;
    const double rounding = kRounding * (size_ + way.norm());
    const auto bound = [&](const Faces::Box& box) {
      const Eigen::Vector3d low = box.min().head<3>(), high = box.max().head<3>();
      if (least <= enough || out.cwiseProduct(low).cwiseMax(out.cwiseProduct(high)).sum() < kOpensTowards - kRounding)
        return std::numeric_limits<double>::infinity();
      return box.min()[3] * size_ + way.cwiseProduct(low).cwiseMin(way.cwiseProduct(high)).sum() - rounding;
    };
    const auto visit = [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last && least > enough; ++i) look(static_cast<std::size_t>(faces_.order()[i]));
      return least;
    };
    faces_.search(bound, visit, least);
    return least;
  }

 private:
  using Faces = BoxTree<4, 8>;

  const ConvexHull& hull_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
  double size_ = 1;  // [m]
  Faces faces_;      // normals, and how far the middle lies below, as a share of the size
  std::size_t last_ = 0;
};

class Search {
 public:
  Search(const SurfacePiece& piece, const ConvexHull& hull, bool two_sided) : piece_(piece), bridges_(hull), two_sided_(two_sided) {
    deepest_.concavity = kNil * boundingBox(piece).sizes().maxCoeff();
  }

  Notch run(const RunControl& control) {
    Looks look(control);
    const std::vector<Side> sides = sortedSides(piece_, look);
    const double nil = deepest_.concavity;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      look();
      if (sides[i].along(sides[i + 1]) && sides[i].forward != sides[i + 1].forward) visit(sides[i], sides[i + 1]);
    }
    return deepest_.concavity > nil ? deepest_ : Notch{};
  }

 private:
  void visit(const Side& first, const Side& second) {
    const Eigen::Vector3d n1 = normalOf(piece_, first.triangle), n2 = normalOf(piece_, second.triangle);
    if (n1.isZero(0) || n2.isZero(0) || n1.dot(n2) > kFlat) return;
    const Eigen::Vector3d &a = piece_.vertices[static_cast<std::size_t>(first.low)],
                          &b = piece_.vertices[static_cast<std::size_t>(first.high)];
    const Eigen::Vector3d edge = first.forward ? Eigen::Vector3d(b - a) : Eigen::Vector3d(a - b);
    const double turn = edge.cross(n1).dot(n2);  // > 0: a convex edge, where the second face bends back from the plane of the first
    if (turn == 0 || (turn > 0 && !two_sided_)) return;
    const Eigen::Vector3d out = ((turn < 0 ? 1.0 : -1.0) * (n1 + n2)).normalized();
    const Eigen::Vector3d bisector = edge.cross(out).normalized();
    for (const Eigen::Vector3d& p : {Eigen::Vector3d((a + b) / 2), a, b}) {
      const double concavity = bridges_.distance(p, out, deepest_.concavity);
      if (std::isfinite(concavity) && concavity > deepest_.concavity) deepest_ = {concavity, p, bisector};
    }
  }

  const SurfacePiece& piece_;
  Bridges bridges_;
  bool two_sided_;
  Notch deepest_;
};

}  // namespace

Notch deepestNotch(const SurfacePiece& piece, const ConvexHull& hull, bool two_sided, const RunControl& control) {
  return Search(piece, hull, two_sided).run(control);
}

}  // namespace collision_hulls
