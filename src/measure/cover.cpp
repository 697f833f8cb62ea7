// A triangle whose corners lie in one hull is covered, since hulls are convex. Any other is clipped by each hull in turn: what lies beyond
// a face is kept as a polygon; what remains inside all faces is covered and dropped. Branch and bound then finds the largest distance from
// the polygons left over. Volumes are sampled by a low-discrepancy sequence.
#include "measure/cover.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "base/looks.h"
#include "base/parallel.h"
#include "collision_hulls/measure/measures.h"
#include "measure/furthest_point.h"

namespace collision_hulls {

namespace {

// Rounding error of the distance between a plane and a point, as a share of the coordinates' size.
constexpr double kPlaneRounding = 1e-12;

// This many triangles share a selection of the hulls and faces to compare them with.
constexpr int kTrianglesAtOnce = 256;

// Pieces that the search for the largest distance halves.
constexpr int kPiecesOfTriangle = 300, kPiecesOfMesh = 400'000;

using Polygon = std::vector<Eigen::Vector3d>;

/// The hulls as a set of points, up to rounding.
class Hulls {
 public:
  Hulls(const TriangleMesh& mesh, const std::vector<ConvexHull>& set) : hulls_(set) {
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    if (!box.isEmpty()) tolerance_ = kPlaneRounding * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
    for (const ConvexHull& hull : hulls_) {
      const Eigen::AlignedBox3d box = boundingBox(hull);
      boxes_.emplace_back(box.min().array() - tolerance_, box.max().array() + tolerance_);
    }
  }

  const std::vector<ConvexHull>& hulls() const { return hulls_; }
  const std::vector<Eigen::AlignedBox3d>& boxes() const { return boxes_; }
  double tolerance() const { return tolerance_; }  ///< [m] up to which distances are rounding errors

  double convexDistance(std::size_t hull, const Eigen::Vector3d& p) const { return collision_hulls::distance(hulls_[hull], p); }

  double distance(const Eigen::Vector3d& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t h = 0; h < hulls_.size(); ++h)
      if (boxes_[h].exteriorDistance(p) < least) least = std::min(least, holds(h, p) ? 0.0 : convexDistance(h, p));
    return least <= tolerance_ ? 0 : least;
  }

 private:
  bool holds(std::size_t hull, const Eigen::Vector3d& p) const {
    if (!boxes_[hull].contains(p)) return false;
    for (const HalfSpace& face : hulls_[hull].faces)
      if (face.distance(p) > tolerance_) return false;
    return true;
  }

  const std::vector<ConvexHull>& hulls_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  double tolerance_ = 0;
};

/// The hulls near some triangles, each with only those faces that the triangles may reach beyond. These are few because consecutive
/// triangles tend to lie close together.
class NearHulls {
 public:
  NearHulls(const Hulls& set, const TriangleMesh& mesh, int begin, int end) : tolerance_(set.tolerance()) {
    Eigen::AlignedBox3d box;
    for (int t = begin; t < end; ++t) box.extend(mesh.corner(t, 0)).extend(mesh.corner(t, 1)).extend(mesh.corner(t, 2));
    const Eigen::Vector3d centre = box.center(), half = box.max() - centre;
    for (std::size_t h = 0; h < set.hulls().size(); ++h) {
      if (!set.boxes()[h].intersects(box)) continue;
      near_.push_back({set.boxes()[h], {}});
      for (const HalfSpace& face : set.hulls()[h].faces)
        if (face.distance(centre) + face.normal.cwiseAbs().dot(half) > 0) near_.back().faces.push_back(face);
    }
  }

  std::size_t size() const { return near_.size(); }

  bool holds(std::size_t hull, const TriangleMesh& mesh, int triangle) const {
    return holds(near_[hull], mesh.corner(triangle, 0)) && holds(near_[hull], mesh.corner(triangle, 1)) &&
           holds(near_[hull], mesh.corner(triangle, 2));
  }

 private:
  struct Near {
    Eigen::AlignedBox3d box;
    std::vector<HalfSpace> faces;
  };
  bool holds(const Near& hull, const Eigen::Vector3d& p) const {
    if (!hull.box.contains(p)) return false;
    for (const HalfSpace& face : hull.faces)
      if (face.distance(p) > tolerance_) return false;
    return true;
  }

  std::vector<Near> near_;
  double tolerance_;
};

/// Divides a polygon by a face: what lies beyond it goes to `outside`; the rest is returned.
Polygon split(const Polygon& polygon, const HalfSpace& face, double tolerance, Polygon& outside) {
  Polygon inside;
  outside.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = face.distance(a) - tolerance, db = face.distance(b) - tolerance;
    (da > 0 ? outside : inside).push_back(a);
    if ((da > 0) != (db > 0)) {
      const Eigen::Vector3d cut = a + (b - a) * (da / (da - db));
      inside.push_back(cut);
      outside.push_back(cut);
    }
  }
  return inside;
}

/// Adds the polygon minus the hull, as convex polygons, to `rest`.
void subtract(const Polygon& polygon, const ConvexHull& hull, double tolerance, std::vector<Polygon>& rest) {
  const std::size_t before = rest.size();
  Polygon inside = polygon, outside;
  for (const HalfSpace& face : hull.faces) {
    const auto isWithin = [&](const Eigen::Vector3d& p) { return face.distance(p) <= tolerance; };
    if (std::all_of(inside.begin(), inside.end(), isWithin)) continue;
    inside = split(inside, face, tolerance, outside);
    if (outside.size() >= 3) rest.push_back(outside);
    if (inside.size() < 3) {  // nothing in common: keep the polygon whole
      rest.resize(before);
      rest.push_back(polygon);
      return;
    }
  }
}

/// What the hulls leave of a triangle, as convex polygons.
std::vector<Polygon> leftOf(const Polygon& triangle, const Hulls& set) {
  const auto boxOf = [](const Polygon& polygon) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : polygon) box.extend(p);
    return box;
  };
  const Eigen::AlignedBox3d box = boxOf(triangle);
  std::vector<Polygon> left{triangle}, next;
  for (std::size_t h = 0; h < set.hulls().size() && !left.empty(); ++h) {
    if (!set.boxes()[h].intersects(box)) continue;
    next.clear();
    for (Polygon& polygon : left) {
      if (set.boxes()[h].intersects(boxOf(polygon)))
        subtract(polygon, set.hulls()[h], set.tolerance(), next);
      else
        next.push_back(std::move(polygon));
    }
    std::swap(left, next);
  }
  return left;
}

/// [m] The largest distance from the hulls, too large by at most 1 % unless that takes too many pieces; 0 for no more than rounding.
double largestDistance(const std::vector<Polygon>& polygons, const Hulls& set, int most_pieces, const RunControl& control = {}) {
  FurthestPoint<Hulls> furthest(set);
  for (const Polygon& polygon : polygons) furthest.add(polygon);
  furthest.search(most_pieces, 0, control);
  return furthest.bound() <= set.tolerance() ? 0 : furthest.bound();
}

/// Whether more than rounding remains of a triangle.
bool isUncovered(const Polygon& triangle, const Hulls& set) {
  return largestDistance(leftOf(triangle, set), set, kPiecesOfTriangle) > 0;
}

/// Calls `visit` with the index and the corners of each triangle that is not held by one hull alone, from any thread.
template <class Visit>
void forEachNotHeld(const TriangleMesh& mesh, const Hulls& set, const RunControl& control, Visit visit) {
  const int triangles = static_cast<int>(mesh.triangles.size()), blocks = (triangles + kTrianglesAtOnce - 1) / kTrianglesAtOnce;
  forEach(static_cast<std::size_t>(blocks), [&](std::size_t block) {
    control.check();
    const int begin = static_cast<int>(block) * kTrianglesAtOnce, end = std::min(begin + kTrianglesAtOnce, triangles);
    const NearHulls near(set, mesh, begin, end);
    std::size_t last = 0;  // neighbouring triangles tend to lie in the same hull
    for (int t = begin; t < end; ++t) {
      bool covered = last < near.size() && near.holds(last, mesh, t);
      for (std::size_t h = 0; h < near.size() && !covered; ++h)
        if (near.holds(h, mesh, t)) covered = true, last = h;
      if (!covered) visit(static_cast<std::size_t>(t), Polygon{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
    }
  });
}

}  // namespace

std::vector<int> uncoveredTriangles(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls, const RunControl& control) {
  const Hulls set(mesh, hulls);
  std::vector<char> missing(mesh.triangles.size(), 0);
  forEachNotHeld(mesh, set, control, [&](std::size_t t, const Polygon& triangle) { missing[t] = isUncovered(triangle, set); });
  std::vector<int> result;
  for (std::size_t t = 0; t < missing.size(); ++t)
    if (missing[t]) result.push_back(static_cast<int>(t));
  return result;
}

std::vector<std::vector<Eigen::Vector3d>> uncoveredPolygons(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls,
                                                            const RunControl& control) {
  const Hulls set(mesh, hulls);
  std::vector<std::vector<Polygon>> left(mesh.triangles.size());
  forEachNotHeld(mesh, set, control, [&](std::size_t t, const Polygon& triangle) { left[t] = leftOf(triangle, set); });
  std::vector<Polygon> result;
  for (std::vector<Polygon>& polygons : left) std::move(polygons.begin(), polygons.end(), std::back_inserter(result));
  return result;
}

double uncovered(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls, const RunControl& control) {
  check(mesh, control);  // no comparison with NaN finds anything uncovered
  check(hulls, control);
  const Hulls set(mesh, hulls);
  return largestDistance(uncoveredPolygons(mesh, hulls, control), set, kPiecesOfMesh, control);
}

namespace {

std::vector<Eigen::AlignedBox3d> boxesOf(const std::vector<ConvexHull>& hulls) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const ConvexHull& hull : hulls) boxes.push_back(boundingBox(hull));
  return boxes;
}

constexpr double kSamples = 20000;
constexpr std::size_t kLeastSamples = 50;     // per hull,
constexpr std::size_t kTriesPerSample = 200;  // points of its box that may miss the hull, per sample

/// A point of the R3 sequence (fractional parts of multiples of the plastic number's powers), which fills the unit cube more evenly than
/// random points.
Eigen::Vector3d spread(std::size_t i) {
  const Eigen::Vector3d u = (static_cast<double>(i) + 0.5) * Eigen::Vector3d(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
  return u - u.array().floor().matrix();
}

}  // namespace

double unionVolume(const std::vector<ConvexHull>& hulls, const RunControl& control) {
  check(hulls, control);
  if (hulls.size() == 1) return volume(hulls[0]);
  const std::vector<Eigen::AlignedBox3d> boxes = boxesOf(hulls);
  double all = 0;
  for (const ConvexHull& hull : hulls) all += volume(hull);
  // A part shared by several hulls counts for each of them with an equal share.
  std::vector<double> own(hulls.size(), 0);
  forEach(hulls.size(), [&](std::size_t h) {
    Looks look(control, kLargeItemsBetweenLooks);
    const double mine = volume(hulls[h]);
    std::vector<std::size_t> others;
    for (std::size_t o = 0; o < hulls.size(); ++o)
      if (o != h && boxes[o].intersects(boxes[h])) others.push_back(o);
    const std::size_t wanted = std::max(kLeastSamples, static_cast<std::size_t>(all > 0 ? kSamples * mine / all : 0));
    const std::size_t most = kTriesPerSample * wanted;
    std::size_t inside = 0;
    double parts = 0;
    for (std::size_t i = 0; inside < wanted && i < most; ++i) {
      look();
      const Eigen::Vector3d p = boxes[h].min() + boxes[h].sizes().cwiseProduct(spread(i));
      if (!holds(hulls[h], p)) continue;
      ++inside;
      std::size_t holders = 1;
      for (const std::size_t o : others) holders += boxes[o].contains(p) && holds(hulls[o], p);
      parts += 1 / static_cast<double>(holders);
    }
    own[h] = inside > 0 ? mine * parts / static_cast<double>(inside) : mine;
  });
  return std::accumulate(own.begin(), own.end(), 0.0);
}

double coveredShare(const std::vector<ConvexHull>& hulls, const Solid& solid, const RunControl& control) {
  check(hulls, control);
  const std::vector<Eigen::AlignedBox3d> boxes = boxesOf(hulls);
  Eigen::AlignedBox3d all;
  for (const Eigen::AlignedBox3d& box : boxes) all.extend(box);
  if (all.isEmpty()) return 1;
  std::atomic<int> inside{0}, held{0};
  forEach(static_cast<std::size_t>(kSamples), [&](std::size_t i) {
    control.check();
    const Eigen::Vector3d p = all.min() + all.sizes().cwiseProduct(spread(i));
    if (!solid.contains(p)) return;
    ++inside;
    bool is_held = false;
    for (std::size_t h = 0; h < hulls.size() && !is_held; ++h) is_held = boxes[h].contains(p) && holds(hulls[h], p);
    held += is_held;
  });
  return inside == 0 ? 1 : static_cast<double>(held) / inside;
}

}  // namespace collision_hulls
