// Files list bodies one after the other, so a body ends where a run of triangles is closed: hulls that touch each other stay apart. What is
// not in such order is divided into components. One that is closed is convex if next to nothing of its hull lies beyond its triangles,
// which overhang() proves: O(triangles * faces). Volumes are compared first: that is cheap, and settles most components that are not
// convex.
#include "verify/convex_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "base/looks.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/mesh/repair.h"
#include "geometry/hull_support.h"
#include "mesh/loose_segments.h"

namespace collision_hulls {
namespace {

constexpr double kConvex = 3e-6;  // of the size: how far a hull may protrude from a component that counts as convex,
constexpr double kWritten =
    2.5e-7;  // of the coordinates: and what single-precision numbers in a file may add, some units in the last place
constexpr double kLeastVolume = 0.999;                   // of the hull's volume
constexpr std::size_t kMostComparisons = 2'000'000'000;  // of triangles with faces: larger components do not count as convex

/// The triangles of a mesh that belong to one component, with their own vertices.
TriangleMesh componentOf(const TriangleMesh& mesh, const std::vector<std::size_t>& triangles, const RunControl& control) {
  Looks look(control, kLargeItemsBetweenLooks);
  TriangleMesh part;
  std::map<int, int> index;
  for (const std::size_t t : triangles) {
    look();
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = mesh.triangles[t][k];
      const auto known = index.emplace(v, static_cast<int>(part.vertices.size()));
      if (known.second) part.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
      corners[k] = known.first->second;
    }
    part.triangles.push_back(corners);
  }
  return part;
}

/// [m] What single precision may add to coordinates in the box.
double writtenError(const Eigen::AlignedBox3d& box) {
  return kWritten * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

/// [m] How far from convex a component may be.
double slackOf(const ConvexHull& hull) {
  const Eigen::AlignedBox3d box = boundingBox(hull);
  return kConvex * box.sizes().maxCoeff() + writtenError(box);
}

/// The faces of the hull, the vertices and triangles of the component: what overhang() compares.
bool isConvex(const TriangleMesh& part, const ConvexHull& hull, const RunControl& control) {
  if (std::abs(signedVolume(part)) < kLeastVolume * volume(hull) || part.triangles.size() * hull.faces.size() > kMostComparisons)
    return false;
  ConvexHull compared = hull;
  compared.vertices = part.vertices;
  compared.triangles = part.triangles;
  return overhang(compared, control) <= slackOf(hull);
}

/// Tells whether a segment lies in one of some hulls, up to what single precision tells apart, and compares it with those alone whose boxes
/// it meets. Keeps references.
class HullsByPlace {
 public:
  HullsByPlace(const std::vector<ConvexHull>& hulls, const RunControl& control) : hulls_(hulls), control_(control) {
    TriangleMesh diagonals;  // a box as the triangle that has it
    for (const ConvexHull& hull : hulls) {
      control.check();
      const Eigen::AlignedBox3d box = boundingBox(hull);
      slack_.push_back(writtenError(box));
      addSegment(diagonals, {box.min().array() - slack_.back(), box.max().array() + slack_.back()});
    }
    boxes_ = std::make_unique<TriangleBvh>(diagonals, std::vector<char>(), control);
  }

  /// [m] How far the segment lies beyond the hull that holds it; nullopt: none does.
  std::optional<double> held(const Segment& segment) const {
    control_.check();
    for (const int near : boxes_->trianglesNear({segment[0].cwiseMin(segment[1]), segment[0].cwiseMax(segment[1])})) {
      control_.check();
      const auto hull = static_cast<std::size_t>(near);
      double beyond = 0;  // planes first: they are cheap, but at a sharp edge a point may be much further away than from each of them
      for (const Eigen::Vector3d& end : segment) beyond = std::max(beyond, planeDistance(hulls_[hull], end));
      if (beyond > slack_[hull]) continue;
      if (beyond > 0) beyond = std::max(distance(hulls_[hull], segment[0]), distance(hulls_[hull], segment[1]));
      if (beyond <= slack_[hull]) return beyond;
    }
    return std::nullopt;
  }

 private:
  const std::vector<ConvexHull>& hulls_;
  const RunControl& control_;
  std::vector<double> slack_;
  std::unique_ptr<const TriangleBvh> boxes_;
};

/// Sorts the components of a mesh into hulls, the rest, and what belongs to none.
void addParts(const TriangleMesh& mesh, ConvexParts& parts, std::vector<Segment>& loose, const RunControl& control) {
  const RepairedMesh repaired = repair(mesh, {0}, control);
  std::vector<std::vector<std::size_t>> components(repaired.counts.components);
  for (std::size_t t = 0; t < repaired.mesh.triangles.size(); ++t) components[static_cast<std::size_t>(repaired.component[t])].push_back(t);
  for (std::size_t c = 0; c < components.size(); ++c) {
    const TriangleMesh part = componentOf(repaired.mesh, components[c], control);
    if (repaired.interior[c] == Interior::kClosed) {
      ConvexHull hull = convexHull(part.vertices, control);
      if (isConvex(part, hull, control)) {
        parts.hulls.push_back(std::move(hull));
        continue;
      }
    }
    append(parts.rest, part);
    ++parts.rest_parts;
  }
  loose.insert(loose.end(), repaired.loose.begin(), repaired.loose.end());
}

/// Runs of triangles, in the file's order, that are closed: each edge occurs equally often in both directions. The last run need not be.
std::vector<std::vector<std::size_t>> closedRuns(const TriangleMesh& mesh, const RunControl& control) {
  Looks look(control, kLargeItemsBetweenLooks);
  using Point = std::array<double, 3>;
  std::map<std::pair<Point, Point>, int> open;  // edges by their ends, the smaller one first: how much more often they run forward
  const auto point = [&](std::size_t t, std::size_t k) {
    const Eigen::Vector3d& v = mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][k])];
    return Point{v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};  // never -0
  };
  std::vector<std::vector<std::size_t>> runs(1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    look();
    runs.back().push_back(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point from = point(t, k), to = point(t, (k + 1) % 3);
      const auto edge = open.emplace(std::minmax(from, to), 0).first;
      edge->second += from < to ? 1 : from == to ? 0 : -1;
      if (edge->second == 0) open.erase(edge);
    }
    if (open.empty() && t + 1 < mesh.triangles.size()) runs.emplace_back();
  }
  return runs;
}

}  // namespace

ConvexParts convexParts(const TriangleMesh& mesh, const RunControl& control) {
  ConvexParts parts;
  std::vector<Segment> loose;
  for (const std::vector<std::size_t>& run : closedRuns(mesh, control))
    if (!run.empty()) addParts(componentOf(mesh, run, control), parts, loose, control);
  if (loose.empty()) return parts;
  const HullsByPlace hulls(parts.hulls, control);
  for (const Segment& segment : loose) {
    if (const auto beyond = hulls.held(segment))
      parts.beyond = std::max(parts.beyond, *beyond);
    else
      addSegment(parts.rest, segment);
  }
  return parts;
}

}  // namespace collision_hulls
