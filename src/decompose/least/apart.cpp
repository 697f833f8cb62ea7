// Branch and bound over the segment or triangle between the points, in search of one point that is further from the solid than the
// tolerance. The part with the largest bound is halved first: the distance of its middle, which is negative inside the solid, plus its
// radius. Bounds only steer the search; what counts is one distance in the end, and that is bounded from below.
#include "decompose/least/apart.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace collision_hulls {

namespace {

constexpr int kMostLooks = 100;      // parts that are looked at
constexpr int kMostUnproved = 8;     // middles that seem to be outside, but near openings cannot be proved to be
constexpr double kFinest = 0.01;     // parts of a radius below this share of the tolerance are not halved
constexpr double kRounding = 1e-12;  // of a distance, as a share of the coordinates: as in measure/protrusion.cpp

template <std::size_t N>
using Corners = std::array<Eigen::Vector3d, N>;

template <std::size_t N>
struct Part {
  Corners<N> corners;
  double bound;  // [m] on the distance of its points, apart from openings
  bool operator<(const Part& other) const { return bound < other.bound; }
};

template <std::size_t N>
Eigen::Vector3d middleOf(const Corners<N>& corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : corners) sum += p;
  return sum / static_cast<double>(N);
}

/// The two halves, cut at the middle of the longest edge.
template <std::size_t N>
std::array<Corners<N>, 2> halves(const Corners<N>& corners) {
  std::size_t a = 0, b = 1;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i + 1; j < N; ++j)
      if ((corners[i] - corners[j]).squaredNorm() > (corners[a] - corners[b]).squaredNorm()) a = i, b = j;
  std::array<Corners<N>, 2> result{corners, corners};
  result[0][a] = result[1][b] = (corners[a] + corners[b]) / 2;
  return result;
}

}  // namespace

Apart::Apart(const Solid& solid, double tolerance, double size)
    : solid_(solid), tolerance_(tolerance), proved_(tolerance + kRounding * std::max(size, solid.surface().extent())) {}

template <std::size_t N>
bool Apart::search(const Corners<N>& points) const {
  std::vector<Part<N>> queue;
  int near = -1;     // the triangle nearest to the last point
  int unproved = 0;  // middles
  const auto isOutside = [&](const Corners<N>& corners) {
    const Eigen::Vector3d middle = middleOf(corners);
    double radius = 0;
    for (const Eigen::Vector3d& p : corners) radius = std::max(radius, (p - middle).norm());
    const TriangleBvh::Nearest nearest = solid_.surface().nearest(middle, std::numeric_limits<double>::infinity(), near);
    near = nearest.triangle;
    if (nearest.distance + radius <= tolerance_) return false;
    const double distance = solid_.signedDistance(middle, nearest.distance);
    if (distance > tolerance_) {
      if (solid_.isFurther(proved_, middle, nearest.distance)) return true;
      ++unproved;
    }
    if (distance + radius > tolerance_ && radius > kFinest * tolerance_) {
      queue.push_back({corners, distance + radius});
      std::push_heap(queue.begin(), queue.end());
    }
    return false;
  };
  if (isOutside(points)) return true;
  for (int looks = 1; looks < kMostLooks && unproved < kMostUnproved && !queue.empty(); looks += 2) {
    std::pop_heap(queue.begin(), queue.end());
    const Corners<N> corners = queue.back().corners;
    queue.pop_back();
    for (const Corners<N>& half : halves<N>(corners))
      if (isOutside(half)) return true;
  }
  return false;
}

bool Apart::operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  return (b - a).norm() > 2 * tolerance_ && search<2>({a, b});  // the surface is within the tolerance of all nearer ones
}

bool Apart::operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const {
  return search<3>({a, b, c});
}

}  // namespace collision_hulls
