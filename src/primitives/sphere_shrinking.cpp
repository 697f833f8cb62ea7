// The choice among candidates takes spheres as large as the space allows, so that there are few. Where they overlap they need not be so
// large.
//
// One sphere after the other, those that protrude most first: the surface that no other sphere holds is found by halving triangles, as
// pieces (as in sphere_cover.cpp). Any sphere that holds their corners can take its place. Its bound is the signed distance of its centre
// plus its radius, so a pattern search looks for the centre where that is least: often deeper in the solid than before, with a larger
// radius.
//
// What others hold counts as held from a depth on, and what the new sphere has to hold, it holds by that depth, so that the proof of the
// cover, which follows (covers()), need not divide without end.
#include "primitives/sphere_shrinking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "primitives/smallest_ball.h"
#include "primitives/sphere_candidates.h"

namespace collision_hulls {

namespace {

constexpr int kPasses = 2;
constexpr double kHeld = 0.01;        // of the tolerance: how deep a sphere must hold what it holds,
constexpr double kLeastHeld = 4e-6;   // and of the coordinates, above the depth of covers()
constexpr double kPiece = 0.05;       // of the tolerance: pieces no longer than this are not divided
constexpr double kFirstStep = 0.5;    // of the radius: of the pattern search,
constexpr double kLastStep = 0.01;    // of the tolerance
constexpr double kWorthwhile = 1e-3;  // of the tolerance, by which a bound must fall
constexpr int kTrianglesAtOnce = 64;  // consecutive ones share a box

using Corners = std::array<Eigen::Vector3d, 3>;
using Points = std::vector<Eigen::Vector3d>;

double roundedUp(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest >= x ? nearest : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

class Shrinking {
 public:
  Shrinking(std::vector<Sphere> spheres, const TriangleMesh& mesh, const TolerableSpace& space, double size)
      : spheres_(std::move(spheres)), mesh_(mesh), space_(space), held_(std::max(kHeld * space.tolerance(), kLeastHeld * size)) {
    const int count = static_cast<int>(mesh.triangles.size());
    for (int begin = 0; begin < count; begin += kTrianglesAtOnce) {
      Eigen::AlignedBox3d box;
      for (int t = begin; t < std::min(begin + kTrianglesAtOnce, count); ++t)
        for (int k = 0; k < 3; ++k) box.extend(mesh.corner(t, k));
      boxes_.push_back(box);
    }
    for (const Sphere& sphere : spheres_) bounds_.push_back(space.bound(sphere));
  }

  void pass(const RunControl& control) {
    std::vector<std::size_t> order(spheres_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return bounds_[a] > bounds_[b]; });
    for (const std::size_t s : order) {
      control.check();
      if (spheres_[s].radius >= 0) shrink(s);
    }
  }

  std::vector<Sphere> left() const {
    std::vector<Sphere> result;
    std::copy_if(spheres_.begin(), spheres_.end(), std::back_inserter(result), [](const Sphere& sphere) { return sphere.radius >= 0; });
    return result;
  }

 private:
  bool holds(std::size_t s, const Eigen::Vector3d& p, double more = 0) const {
    const double radius = spheres_[s].radius - held_ + more;
    return radius >= 0 && (p - spheres_[s].centre).squaredNorm() <= radius * radius;
  }

  void shrink(std::size_t s) {
    const Points points = ownPoints(s);
    if (points.empty()) {
      spheres_[s].radius = -1;  // gone
      return;
    }
    leastProtruding(points, spheres_[s], bounds_[s]);
  }

  /// Corners of pieces that together hold all surface that only this sphere holds.
  Points ownPoints(std::size_t s) {
    const Sphere& sphere = spheres_[s];
    near_.clear();
    for (std::size_t other = 0; other < spheres_.size(); ++other)
      if (other != s && spheres_[other].radius >= 0 &&
          (spheres_[other].centre - sphere.centre).norm() <= spheres_[other].radius + sphere.radius)
        near_.push_back(other);
    Points points;
    for (std::size_t block = 0; block < boxes_.size(); ++block) {
      if (boxes_[block].exteriorDistance(sphere.centre) > sphere.radius) continue;
      const int begin = static_cast<int>(block) * kTrianglesAtOnce,
                end = std::min(begin + kTrianglesAtOnce, static_cast<int>(mesh_.triangles.size()));
      for (int t = begin; t < end; ++t) collect(s, {mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, 0, near_.size(), points);
    }
    return points;
  }

  /// near_[begin, end): the other spheres that the piece may meet.
  void collect(std::size_t s, const Corners& piece, std::size_t begin, std::size_t end, Points& points) {
    const auto length = [&](std::size_t k) { return (piece[k] - piece[(k + 1) % 3]).norm(); };
    const std::size_t a = length(1) > length(0) ? (length(2) > length(1) ? 2 : 1) : (length(2) > length(0) ? 2 : 0);
    const Eigen::Vector3d middle = (piece[0] + piece[1] + piece[2]) / 3;
    if (!holds(s, middle, held_ + length(a))) return;  // outside: others hold it
    const std::size_t last = near_.size();
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t other = near_[i];
      if (holds(other, piece[0]) && holds(other, piece[1]) && holds(other, piece[2])) {
        near_.resize(last);
        return;
      }
      if (holds(other, middle, length(a))) near_.push_back(other);
    }
    if (near_.size() == last || length(a) <= kPiece * space_.tolerance()) {
      points.insert(points.end(), piece.begin(), piece.end());
    } else {
      const std::size_t b = (a + 1) % 3, narrowed = near_.size();
      Corners one = piece, two = piece;
      one[b] = two[a] = (piece[a] + piece[b]) / 2;
      collect(s, one, last, narrowed, points);
      collect(s, two, last, narrowed, points);
    }
    near_.resize(last);
  }

  /// About a centre, the sphere that holds the points.
  Sphere sphereAbout(const Eigen::Vector3d& centre, const Points& points) const {
    Sphere sphere;
    sphere.centre = inSinglePrecision(centre);
    double square = 0;
    for (const Eigen::Vector3d& p : points) square = std::max(square, (p - sphere.centre).squaredNorm());
    sphere.radius = roundedUp(std::sqrt(square) + held_);
    return sphere;
  }

  /// Replaces the sphere if another that holds the points protrudes less.
  void leastProtruding(Points points, Sphere& sphere, double& bound) const {
    thin(points);
    const auto offer = [&](const Eigen::Vector3d& centre) {
      const Sphere other = sphereAbout(centre, points);
      const double of_other = space_.boundByDistance(other);
      if (!(of_other < bound - kWorthwhile * space_.tolerance())) return false;
      sphere = other, bound = of_other;
      return true;
    };
    offer(sphere.centre);
    offer(smallestBall(points).centre);
    for (double step = kFirstStep * sphere.radius; step > kLastStep * space_.tolerance(); step /= 2) {
      bool found = true;
      while (found) {
        found = false;
        for (int k = 0; k < 6; ++k) found = offer(sphere.centre + (k % 2 ? step : -step) * Eigen::Vector3d::Unit(k / 2)) || found;
      }
    }
  }

  /// The corners of neighbouring pieces are the same.
  static void thin(Points& points) {
    const auto before = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }

  std::vector<Sphere> spheres_;  // of radius -1: gone
  std::vector<double> bounds_;
  const TriangleMesh& mesh_;
  const TolerableSpace& space_;
  const double held_;  // [m]
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<std::size_t> near_;  // as a stack: of the current piece and those that it is part of
};

}  // namespace

std::vector<Sphere> shrunk(std::vector<Sphere> spheres, const TriangleMesh& mesh, const TolerableSpace& space, const RunControl& control) {
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  const double size = box.isEmpty() ? 0 : box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  Shrinking shrinking(std::move(spheres), mesh, space, size);
  for (int pass = 0; pass < kPasses; ++pass) shrinking.pass(control);
  return shrinking.left();
}

}  // namespace collision_hulls
