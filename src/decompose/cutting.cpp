// cut(piece):
//   H = hull of the piece; if the oracle finds H within the tolerance: a leaf
//   (also with its vertices capped: if only that takes it beyond, the piece is halved)
//   if the piece falls into components: cut(each)
//   else, of all candidate planes, take the one with the best score and cut(both sides)
//
// A plane's score: of the intruders (points of H outside the solid by more than the tolerance), those that lie in neither side's
// hull are cured by it; beside that, volume that leaves the hulls is good, and so is a side that is done. Scores are reckoned on
// a simplified piece; what is cut is the piece itself.
#include "decompose/cutting.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "collision_hulls/decompose/reduce_vertices.h"
#include "decompose/cut_planes.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kScoringVertices = 400;         // of the simplified piece
constexpr std::size_t kEdgesOfPiece = 4000;           // a piece with fewer triangles shows its own reflex edges
constexpr double kOnPlane = 1e-9;                     // in extents of the whole mesh
constexpr double kVolumeGain = 0.5, kSideDone = 0.1;  // weights of a score, against 1 for all intruders cured
constexpr std::size_t kMostLeaves = 5000;             // beyond so many the rest is left uncut
constexpr int kDeepest = 200;                         // cuts above a piece; only rounding could bring more

using Points = std::vector<Eigen::Vector3d>;
constexpr double kUseless = std::numeric_limits<double>::infinity();

/// What all planes are scored on.
struct Scene {
  SurfacePiece piece;
  std::vector<std::pair<int, int>> edges;
  std::vector<OutsideDistance::Intruder> intruders;
  double weight = 0;  // of the intruders
  double volume = 0;  // of the whole hull
};

struct Sides {
  Points beneath, above;
};

Sides divided(const Scene& scene, const HalfSpace& plane) {
  Sides sides;
  std::vector<double> distance;
  for (const Eigen::Vector3d& v : scene.piece.vertices) {
    distance.push_back(plane.distance(v));
    if (distance.back() <= 0) sides.beneath.push_back(v);
    if (distance.back() >= 0) sides.above.push_back(v);
  }
  for (const auto& [a, b] : scene.edges) {
    const double da = distance[static_cast<std::size_t>(a)], db = distance[static_cast<std::size_t>(b)];
    if (da * db >= 0) continue;
    const Eigen::Vector3d& p = scene.piece.vertices[static_cast<std::size_t>(a)];
    const Eigen::Vector3d crossing = p + (da / (da - db)) * (scene.piece.vertices[static_cast<std::size_t>(b)] - p);
    sides.beneath.push_back(crossing);
    sides.above.push_back(crossing);
  }
  return sides;
}

bool holds(const ConvexHull& hull, const Eigen::Vector3d& p) {
  return std::none_of(hull.faces.begin(), hull.faces.end(), [&](const HalfSpace& f) { return f.distance(p) > 0; });
}

/// Less is better.
double score(const Scene& scene, const HalfSpace& plane) {
  const Sides sides = divided(scene, plane);
  if (sides.beneath.size() < 3 || sides.above.size() < 3) return kUseless;
  const ConvexHull beneath = convexHull(sides.beneath), above = convexHull(sides.above);
  double left_beneath = 0, left_above = 0;
  for (const OutsideDistance::Intruder& i : scene.intruders) {
    const bool is_beneath = plane.distance(i.p) <= 0;
    if (holds(is_beneath ? beneath : above, i.p)) (is_beneath ? left_beneath : left_above) += i.weight;
  }
  const double gain = scene.volume > 0 ? 1 - (volume(beneath) + volume(above)) / scene.volume : 0;
  const bool side_done = left_beneath == 0 || left_above == 0;
  return (left_beneath + left_above) / scene.weight - kVolumeGain * gain - (side_done ? kSideDone : 0);
}

class Cutting {
 public:
  Cutting(ProtrusionOracle& oracle, int max_vertices, const SurfacePiece& whole, const std::function<void(double)>& progress)

      : oracle_(oracle),
        max_vertices_(max_vertices),
        extent_(boundingBox(whole).sizes().maxCoeff()),
        area_(area(whole)),
        progress_(progress) {}

  void run(SurfacePiece piece, int depth) {
    const ConvexHull hull = convexHull(piece.vertices);
    const double protrusion = oracle_.within(hull);
    const bool within = protrusion <= oracle_.tolerance();
    if (depth >= kDeepest || leaves.size() >= kMostLeaves || (within && withinWhenCapped(hull))) return leaf(piece, hull, protrusion);
    std::vector<SurfacePiece> parts = components(piece);
    if (parts.size() == 1) parts = within ? halves(piece) : bestCut(piece, hull);
    if (parts.size() == 1) return leaf(piece, hull, protrusion);
    piece = {};
    for (SurfacePiece& part : parts) run(std::move(part), depth + 1);
  }

  std::vector<Leaf> leaves;

 private:
  void leaf(const SurfacePiece& piece, const ConvexHull& hull, double protrusion) {
    leaves.push_back({hull, protrusion});
    done_ += area(piece);
    if (area_ > 0) progress_(std::min(1.0, done_ / area_));
  }

  bool withinWhenCapped(const ConvexHull& hull) {
    if (max_vertices_ == 0 || hull.vertices.size() <= static_cast<std::size_t>(max_vertices_)) return true;
    return std::isfinite(oracle_.within(reduceVertices(hull, max_vertices_).hull));
  }

  /// The piece cut in the middle of its longest side: half of a round hull is within reach of fewer vertices.
  std::vector<SurfacePiece> halves(const SurfacePiece& piece) const {
    const Eigen::AlignedBox3d box = boundingBox(piece);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    return divide(piece, {Eigen::Vector3d::Unit(axis), box.center()[axis]});
  }

  std::vector<SurfacePiece> divide(const SurfacePiece& piece, const HalfSpace& plane) const {
    auto [beneath, above] = cut(piece, plane, kOnPlane * extent_);
    if (beneath.triangles.empty() || above.triangles.empty()) return {piece};
    return {std::move(beneath), std::move(above)};
  }

  /// Both sides of the best plane that divides the piece; the piece alone if none does.
  std::vector<SurfacePiece> bestCut(const SurfacePiece& piece, const ConvexHull& hull) {
    Scene scene;
    scene.intruders = oracle_.intruders(hull);
    scene.piece = simplified(piece, kScoringVertices);
    scene.edges = edgesOf(scene.piece);
    scene.volume = volume(hull);
    for (const OutsideDistance::Intruder& i : scene.intruders) scene.weight += i.weight;
    const bool fine = piece.triangles.size() <= kEdgesOfPiece;
    const std::vector<HalfSpace> planes = cutPlanes(fine ? piece : scene.piece, scene.intruders, oracle_.solid(), oracle_.tolerance());
    std::vector<double> scores(planes.size());
    tbb::parallel_for(std::size_t{0}, planes.size(), [&](std::size_t i) { scores[i] = score(scene, planes[i]); });
    std::vector<std::size_t> order(planes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
    for (std::size_t i : order) {
      if (scores[i] == kUseless) break;
      std::vector<SurfacePiece> parts = divide(piece, planes[i]);
      if (parts.size() > 1) return parts;  // what divides the simplified piece may pass the real one by
    }
    return halves(piece);
  }

  ProtrusionOracle& oracle_;
  int max_vertices_;
  double extent_, area_, done_ = 0;
  const std::function<void(double)>& progress_;
};

SurfacePiece wholeSurface(const RepairedMesh& mesh) {
  SurfacePiece piece = mesh.mesh;
  for (const Eigen::Vector3d& p : mesh.loose) {
    const int i = static_cast<int>(piece.vertices.size());
    piece.vertices.push_back(p);
    piece.triangles.push_back({i, i, i});
  }
  return piece;
}

}  // namespace

std::vector<Leaf> cutIntoLeaves(const RepairedMesh& mesh, ProtrusionOracle& oracle, int max_vertices,
                                const std::function<void(double)>& progress) {
  SurfacePiece whole = wholeSurface(mesh);
  Cutting cutting(oracle, max_vertices, whole, progress);
  cutting.run(std::move(whole), 0);
  return std::move(cutting.leaves);
}

}  // namespace collision_hulls
