// Lien & Amato's divide and conquer with a priority queue on concavity: the most concave part is cut next, at its deepest notch. A part
// whose plane divides nothing is cut in the middle instead, and if that fails too, kept.
#include "collision_hulls/decompose/acd.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "decompose/acd/notches.h"
#include "decompose/certified/rough_hull.h"
#include "decompose/cluster_hulls.h"
#include "decompose/finest_tolerance.h"
#include "decompose/surface_piece.h"
#include "mesh/loose_segments.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kMostParts = 2000;
constexpr std::size_t kManyPoints = 100'000;  // of a part whose hull is not built exactly before it is known to stay
constexpr double kOnPlane = 1e-9;             // in extents of the whole mesh

struct Part {
  SurfacePiece piece;
  ConvexHull hull;
  Notch notch;
  bool two_sided = false;
};

/// The hull of a part that may be cut: of many points a rough one, as an exact one takes long.
ConvexHull hullToCut(const SurfacePiece& piece, const RunControl& control) {
  return piece.vertices.size() > kManyPoints ? roughHull(piece.vertices, Corners::kNeeded, control) : convexHull(piece.vertices, control);
}

/// Parts in the order to cut them: highest concavity first, then oldest first.
struct Waiting {
  double concavity;
  std::size_t part;
  bool operator<(const Waiting& o) const { return concavity != o.concavity ? concavity < o.concavity : part > o.part; }
};

/// The triangles of the sheets, or all the others.
SurfacePiece trianglesOf(const RepairedMesh& mesh, bool sheets) {
  SurfacePiece piece;
  piece.vertices = mesh.mesh.vertices;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
    if ((mesh.sheet[t] != 0) == sheets) piece.triangles.push_back(mesh.mesh.triangles[t]);
  return piece;
}

bool within(const ConvexHull& hull, const SurfacePiece& piece) {
  return std::all_of(piece.vertices.begin(), piece.vertices.end(), [&](const Eigen::Vector3d& v) { return planeDistance(hull, v) <= 0; });
}

/// What a cut leaves on one side: its components, with each component inside another's hull joined to that one. Why: if a wall is cut at
/// all of its edges its two skins become separate components, and the outer skin alone is convex, whatever it encloses.
std::vector<SurfacePiece> separated(const SurfacePiece& side, const RunControl& control) {
  std::vector<SurfacePiece> parts;
  std::vector<ConvexHull> hulls;
  for (SurfacePiece& piece : components(side, control)) {
    ConvexHull hull = hullToCut(piece, control);
    for (std::size_t i = 0; i < parts.size();) {
      control.check();
      if (!within(hulls[i], piece) && !within(hull, parts[i])) {
        ++i;
        continue;
      }
      append(piece, parts[i]);
      hull = hullToCut(piece, control);
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
      hulls.erase(hulls.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;  // the hull has grown: start again
    }
    parts.push_back(std::move(piece));
    hulls.push_back(std::move(hull));
  }
  return parts;
}

class Resolving {
 public:
  Resolving(const RepairedMesh& mesh, double epsilon, const RunControl& control)
      : epsilon_(epsilon), on_plane_(kOnPlane * boundingBox(mesh.mesh).sizes().maxCoeff()), control_(control), undone_(area(mesh.mesh)) {
    whole_ = undone_;
    for (bool sheets : {false, true})
      for (SurfacePiece& piece : components(trianglesOf(mesh, sheets), control)) add(std::move(piece), sheets);
  }

  std::vector<ConvexHull> run() {
    while (!waiting_.empty() && parts_.size() - resolved_ < kMostParts) {
      const std::size_t next = waiting_.top().part;
      waiting_.pop();
      resolve(next);
    }
    std::vector<ConvexHull> hulls;
    for (Part& part : parts_)
      if (!part.hull.vertices.empty()) hulls.push_back(std::move(part.hull));
    return hulls;
  }

 private:
  void add(SurfacePiece piece, bool two_sided) {
    control_.check();
    Part part;
    part.hull = hullToCut(piece, control_);
    part.notch = deepestNotch(piece, part.hull, two_sided, control_);
    part.two_sided = two_sided;
    if (part.notch.concavity > epsilon_) {
      waiting_.push({part.notch.concavity, parts_.size()});
      part.piece = std::move(piece);
    } else {
      finish(piece, part);
    }
    parts_.push_back(std::move(part));
  }

  /// Replaces a part by the pieces on either side of the plane through its deepest notch; keeps it if no plane divides it.
  void resolve(std::size_t index) {
    const Part part = std::exchange(parts_[index], {});
    for (const HalfSpace& plane : {planeThrough(part.notch), middlePlane(part.piece)}) {
      const auto [beneath, above] = split(part.piece, plane, on_plane_, control_);
      if (beneath.triangles.empty() || above.triangles.empty()) continue;
      ++resolved_;
      for (const SurfacePiece* side : {&beneath, &above})
        for (SurfacePiece& piece : separated(*side, control_)) add(std::move(piece), part.two_sided);
      return;
    }
    parts_[index].hull = part.hull;
    finish(part.piece, parts_[index]);
  }

  static HalfSpace planeThrough(const Notch& notch) { return {notch.bisector, notch.bisector.dot(notch.point)}; }

  /// For a part that is not cut any more. Its hull becomes exact.
  void finish(const SurfacePiece& piece, Part& part) {
    if (piece.vertices.size() > kManyPoints) part.hull = convexHull(piece.vertices, control_);
    undone_ = std::max(0.0, undone_ - area(piece));
    if (whole_ > 0) control_.report(1 - undone_ / whole_);
  }

  double epsilon_, on_plane_;
  const RunControl& control_;
  double undone_, whole_ = 0;
  std::vector<Part> parts_;  // parts that were replaced are empty
  std::size_t resolved_ = 0;
  std::priority_queue<Waiting> waiting_;
};

}  // namespace

std::vector<ConvexHull> acdHulls(const RepairedMesh& mesh, double epsilon, const RunControl& control) {
  expectUsable(epsilon, mesh.mesh, "epsilon");
  if (mesh.mesh.triangles.empty()) return {convexHull(withLoose(mesh).vertices, control)};
  std::vector<ConvexHull> hulls = Resolving(mesh, epsilon, control).run();
  addLoose(hulls, mesh.loose, control);
  control.report(1);
  return hulls;
}

}  // namespace collision_hulls
