// The score of a plane: the share of intruders (weighted by the volume that each stands for) that stay in the hull of their side, less a
// reward for volume that neither hull contains and for a side without intruders. Lower is better.
//
// Intruders, not protrusion: the largest protrusion after a split is often the same for every plane, as many dents remain; how many of the
// intruders are got rid of tells planes apart. Each score builds two hulls of at most some hundred points and tests each intruder
// against one of them; hundreds of planes are scored in parallel for each split.
//
// Nothing is left to rounding where it can be helped: of planes that score the same a slight preference takes one (geometry/lean.h).
#include "decompose/certified/plane_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.h"
#include "decompose/certified/protrusion_oracle.h"
#include "geometry/lean.h"

namespace collision_hulls {

namespace {

using Points = std::vector<Eigen::Vector3d>;
constexpr double kUseless = std::numeric_limits<double>::infinity();
constexpr double kNearPlane = 1e-3;      // in extents of the piece
constexpr double kLeanOfScore = 1e-3;    // most that position counts in a score
constexpr double kOutward = 1e-3;        // how far intruders are moved, as a share of their distance from the middle
constexpr double kAside = 0.1;           // how far that middle is from the middle of the box, in extents of the piece
constexpr std::size_t kLeastPoints = 4;  // per side

struct Sides {
  Points beneath, above;
};

/// Divides like split(): vertices in the plane belong to the side that their edges lead to, and below if all of these stay in the plane.
Sides divided(const SurfacePiece& piece, const std::vector<std::pair<int, int>>& edges, const HalfSpace& plane, double on_plane) {
  std::vector<double> distance;
  distance.reserve(piece.vertices.size());
  for (const Eigen::Vector3d& v : piece.vertices) {
    const double d = plane.distance(v);
    distance.push_back(std::abs(d) <= on_plane ? 0 : d);
  }
  Sides sides;
  std::vector<char> is_beneath(distance.size(), 0), is_above(distance.size(), 0);
  for (const auto& [a, b] : edges) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    const double da = distance[i], db = distance[j];
    is_beneath[i] |= da < 0 || (da == 0 && db <= 0), is_beneath[j] |= db < 0 || (db == 0 && da <= 0);
    is_above[i] |= da > 0 || (da == 0 && db > 0), is_above[j] |= db > 0 || (db == 0 && da > 0);
    if (da * db >= 0) continue;
    const Eigen::Vector3d crossing = piece.vertices[i] + (da / (da - db)) * (piece.vertices[j] - piece.vertices[i]);
    sides.beneath.push_back(crossing);
    sides.above.push_back(crossing);
  }
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (is_beneath[i]) sides.beneath.push_back(piece.vertices[i]);
    if (is_above[i]) sides.above.push_back(piece.vertices[i]);
  }
  return sides;
}

}  // namespace

PlaneScore::PlaneScore(const SurfacePiece& piece, std::size_t vertices, std::vector<OutsideDistance::Intruder> intruders, double volume,
                       const ScoreWeights& weights, const RunControl& control)
    : piece_(simplified(piece, vertices, control)),
      edges_(edgesOf(piece_)),
      intruders_(std::move(intruders)),
      volume_(volume),
      weights_(weights) {
  const Eigen::AlignedBox3d box = boundingBox(piece_);
  const double size = box.sizes().maxCoeff();
  // Many intruders lie in a face of the hull or in a candidate plane, where rounding would decide what holds them. Moved away from near the
  // middle, those on a face are in no hull, and those in a plane on the same side every time.
  const Eigen::Vector3d middle = box.center() + kAside * size * aslant();
  for (OutsideDistance::Intruder& i : intruders_) {
    weight_ += i.weight;
    i.p += kOutward * (i.p - middle);
  }
  on_plane_ = kNearPlane * size;
}

/// Lower is better.
double PlaneScore::operator()(const HalfSpace& plane) const {
  const Sides sides = divided(piece_, edges_, plane, on_plane_);
  if (sides.beneath.size() < kLeastPoints || sides.above.size() < kLeastPoints) return kUseless;
  const ConvexHull beneath = roughHull(sides.beneath, Corners::kAsFound), above = roughHull(sides.above, Corners::kAsFound);
  double left_beneath = 0, left_above = 0;
  for (const OutsideDistance::Intruder& i : intruders_) {
    const bool is_beneath = plane.distance(i.p) <= 0;
    if (holds(is_beneath ? beneath : above, i.p)) (is_beneath ? left_beneath : left_above) += i.weight;
  }
  double score = (left_beneath + left_above) / weight_;
  if (!(volume_ > 0)) return score;
  const double v_beneath = volume(beneath), v_above = volume(above);
  const double finished = std::max(left_beneath == 0 ? v_beneath : 0, left_above == 0 ? v_above : 0) / volume_;
  score -= weights_.volume_gain * (1 - (v_beneath + v_above) / volume_);
  score -= weights_.finished_share * finished + (finished > 0 ? weights_.finished : 0);
  return score;
}

std::vector<HalfSpace> PlaneScore::best(const std::vector<HalfSpace>& planes, std::size_t most) const {
  std::vector<double> scores(planes.size());
  const double size = boundingBox(piece_).diagonal().norm();
  forEach(planes.size(), [&](std::size_t i) { scores[i] = (*this)(planes[i]) - kLeanOfScore * lean(planes[i], size); });
  std::vector<std::size_t> order(planes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
  std::vector<HalfSpace> result;
  for (std::size_t i : order)
    if (result.size() < most && scores[i] < kUseless) result.push_back(planes[i]);
  return result;
}

}  // namespace collision_hulls
