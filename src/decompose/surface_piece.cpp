// Splitting triangle by triangle, components by union-find, and simplification by clustering vertices in a grid. All linear in the piece
// (expected, where hashing is involved).
#include "decompose/surface_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/looks.h"

namespace collision_hulls {

namespace {

std::uint64_t key(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint64_t>(high);
}

/// Collects the triangles of one side and the vertices they use.
class Part {
 public:
  explicit Part(const SurfacePiece& source) : source_(source), index_(source.vertices.size(), -1) {}

  int vertex(int i) {
    int& known = index_[at(i)];
    if (known < 0) known = add(source_.vertices[at(i)]);
    return known;
  }
  int add(const Eigen::Vector3d& p) {
    piece.vertices.push_back(p);
    return static_cast<int>(piece.vertices.size()) - 1;
  }
  /// With only two different corners, a segment remains.
  void addFan(std::array<int, 4> corners, std::size_t count) {
    count = static_cast<std::size_t>(std::unique(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(count)) - corners.begin());
    if (corners[count - 1] == corners[0]) --count;
    if (count == 2) piece.triangles.push_back({corners[0], corners[1], corners[1]});
    for (std::size_t k = 2; k < count; ++k) piece.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }

  SurfacePiece piece;

 private:
  const SurfacePiece& source_;
  std::vector<int> index_;
};

/// Divides a piece triangle by triangle; a divided edge gets one new vertex on each side.
class Cutter {
 public:
  Cutter(const SurfacePiece& piece, const HalfSpace& plane, double tolerance, const RunControl& control)
      : piece_(piece), look_(control), beneath_(piece), above_(piece) {
    for (const Eigen::Vector3d& v : piece.vertices) {
      look_();
      const double d = plane.distance(v);
      distance_.push_back(std::abs(d) <= tolerance ? 0 : d);
    }
  }

  std::pair<SurfacePiece, SurfacePiece> run() {
    for (const Triangle& t : piece_.triangles) look_(), divide(t);
    return {std::move(beneath_.piece), std::move(above_.piece)};
  }

 private:
  void divide(const Triangle& t) {
    const bool any_above = distance_[at(t[0])] > 0 || distance_[at(t[1])] > 0 || distance_[at(t[2])] > 0;
    const bool any_beneath = distance_[at(t[0])] < 0 || distance_[at(t[1])] < 0 || distance_[at(t[2])] < 0;
    if (!any_above || !any_beneath) {
      Part& part = any_above ? above_ : beneath_;
      part.piece.triangles.push_back({part.vertex(t[0]), part.vertex(t[1]), part.vertex(t[2])});
      return;
    }
    std::array<int, 4> low{}, high{};
    std::size_t lows = 0, highs = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (distance_[at(a)] <= 0) low[lows++] = beneath_.vertex(a);
      if (distance_[at(a)] >= 0) high[highs++] = above_.vertex(a);
      if (distance_[at(a)] * distance_[at(b)] < 0) {
        const auto [beneath, above] = crossing(a, b);
        low[lows++] = beneath;
        high[highs++] = above;
      }
    }
    beneath_.addFan(low, lows);
    above_.addFan(high, highs);
  }

  std::pair<int, int> crossing(int a, int b) {
    const auto [place, fresh] = crossings_.try_emplace(key(a, b));
    if (fresh) {
      if (a > b) std::swap(a, b);  // gives the same point for both triangles
      const double share = distance_[at(a)] / (distance_[at(a)] - distance_[at(b)]);
      const Eigen::Vector3d p = piece_.vertices[at(a)] + share * (piece_.vertices[at(b)] - piece_.vertices[at(a)]);
      place->second = {beneath_.add(p), above_.add(p)};
    }
    return place->second;
  }

  const SurfacePiece& piece_;
  Looks look_;
  std::vector<double> distance_;
  Part beneath_, above_;
  std::unordered_map<std::uint64_t, std::pair<int, int>> crossings_;
};

/// 21 bits of a grid cell's number. Vertices of no triangle lie anywhere, also outside of the box that the grid begins at.
std::uint64_t cellBits(double number) {
  constexpr double kLast = (1 << 21) - 1;
  return static_cast<std::uint64_t>(number >= 0 ? std::min(number, kLast) : kLast);
}

/// The piece with the vertices in each grid cell merged into one, if at most `most` remain. Drops triangles that collapse, but keeps what
/// was a segment or a point before.
std::optional<SurfacePiece> clustered(const SurfacePiece& piece, const Eigen::AlignedBox3d& box, double side, std::size_t most,
                                      Looks& look) {
  SurfacePiece result;
  std::unordered_map<std::uint64_t, int> cells;
  std::vector<int> index;
  for (const Eigen::Vector3d& v : piece.vertices) {
    look();
    const Eigen::Vector3d cell = ((v - box.min()) / side).array().floor();
    const std::uint64_t id = cellBits(cell.x()) << 42 | cellBits(cell.y()) << 21 | cellBits(cell.z());
    const auto [place, fresh] = cells.try_emplace(id, static_cast<int>(result.vertices.size()));
    if (fresh && result.vertices.size() == most) return std::nullopt;
    if (fresh) result.vertices.push_back(v);
    index.push_back(place->second);
  }
  for (const Triangle& t : piece.triangles) {
    look();
    const Triangle c{index[at(t[0])], index[at(t[1])], index[at(t[2])]};
    const bool was_flat = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    if (was_flat || (c[0] != c[1] && c[1] != c[2] && c[2] != c[0])) result.triangles.push_back(c);
  }
  return result;
}

}  // namespace

std::pair<SurfacePiece, SurfacePiece> split(const SurfacePiece& piece, const HalfSpace& plane, double tolerance,
                                            const RunControl& control) {
  return Cutter(piece, plane, tolerance, control).run();
}

std::vector<SurfacePiece> parted(const SurfacePiece& piece, const HalfSpace& plane, double tolerance, const RunControl& control) {
  auto [beneath, above] = split(piece, plane, tolerance, control);
  if (beneath.triangles.empty() || above.triangles.empty()) return {piece};
  return {std::move(beneath), std::move(above)};
}

HalfSpace middlePlane(const SurfacePiece& piece) {
  const Eigen::AlignedBox3d box = boundingBox(piece);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  return {Eigen::Vector3d::Unit(axis), box.center()[axis]};
}

std::vector<SurfacePiece> components(const SurfacePiece& piece, const RunControl& control) {
  DisjointSets sets(piece.vertices.size());
  Looks look(control);
  for (const Triangle& t : piece.triangles) {
    look();
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  std::unordered_map<int, std::size_t> number;
  std::vector<SurfacePiece> parts;
  std::vector<int> index(piece.vertices.size(), -1);
  for (const Triangle& t : piece.triangles) {
    look();
    const auto [place, fresh] = number.try_emplace(sets.find(t[0]), parts.size());
    if (fresh) parts.emplace_back();
    SurfacePiece& part = parts[place->second];
    Triangle mine{};
    for (std::size_t k = 0; k < 3; ++k) {
      int& known = index[at(t[k])];
      if (known < 0) {
        known = static_cast<int>(part.vertices.size());
        part.vertices.push_back(piece.vertices[at(t[k])]);
      }
      mine[k] = known;
    }
    part.triangles.push_back(mine);
  }
  return parts;
}

SurfacePiece simplified(const SurfacePiece& piece, std::size_t vertices, const RunControl& control) {
  if (piece.vertices.size() <= vertices) return piece;
  const Eigen::AlignedBox3d box = boundingBox(piece);
  // A surface as large as one side of its box fills about one cell per vertex; coarsen until there are few enough.
  constexpr double kFirstSide = 0.8, kCoarser = 1.3;
  double side = kFirstSide * box.sizes().maxCoeff() / std::sqrt(static_cast<double>(vertices));
  Looks look(control);
  for (;; side *= kCoarser)
    if (std::optional<SurfacePiece> result = clustered(piece, box, side, vertices, look)) return *std::move(result);
}

std::vector<std::pair<int, int>> edgesOf(const SurfacePiece& piece) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(piece.triangles.size() * 3);
  for (const Triangle& t : piece.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(std::minmax(t[k], t[(k + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace collision_hulls
