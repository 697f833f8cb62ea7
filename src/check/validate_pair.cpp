// Every verdict is our own: a sphere's distances are computed exactly beside FCL's, an answer between hulls is accepted with the
// proof that FCL's nearest points give, or else computed, and an answer between meshes (exact to rounding, wherever it was
// measured) is computed again where it would speak against the hulls.
#include "check/validate_pair.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include "check/unit_frame.h"
#include "check/validate_exact.h"
#include "collision_hulls/check/solid.h"
#include "collision_hulls/geometry/triangle_bvh.h"

namespace collision_hulls {

namespace {

constexpr double kLeastRadius = 0.001, kLargestRadius = 0.25;  // of spheres, as shares of the element's size
constexpr double kThinnest = 1e-12;                            // height over length of a triangle that has an area
constexpr double kTimeout = 1e6;                               // [us]

/// The triangles that have an area to rounding, or the others.
TriangleMesh selected(const TriangleMesh& mesh, bool with_area) {
  TriangleMesh result{mesh.vertices, {}};
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3d u = mesh.corner(t, 1) - mesh.corner(t, 0), v = mesh.corner(t, 2) - mesh.corner(t, 0);
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    if ((u.cross(v).norm() > kThinnest * longest) == with_area) result.triangles.push_back(mesh.triangles[static_cast<std::size_t>(t)]);
  }
  return result;
}

class PairCheck {
 public:
  PairCheck(const ValidationPair& pair, const std::vector<ProbeShape>& boxes, const std::vector<Neighbour>& neighbours);
  void query(std::size_t number, Random& random);
  PairResult result;

 private:
  void pointOnOriginal(const Eigen::Vector3d& p);
  void pointInHull(const Eigen::Vector3d& p);
  void probe(const Probe& probe);

  std::vector<std::pair<double, std::size_t>> hullsByBox(const Eigen::AlignedBox3d& box) const;
  double toHulls(const Probe& probe);
  double toHull(const Probe& probe, std::size_t hull, const FclAnswer& answer);
  double toOriginal(const Probe& probe);
  double toSurface(const Probe& probe, const FclAnswer& answer);
  bool holdsAComponent(const Probe& probe) const;
  double settled(const Probe& probe, FclAnswer answer, double ours, const char* against);
  void judge(const Probe& probe, double original, double hulls);
  double toSolid(const Eigen::Vector3d& p, double original, double hulls) const;
  void remark(const Probe& probe, const std::string& text);

  const std::string name_;
  const UnitFrame frame_;
  const TriangleMesh original_;
  const TriangleMesh with_area_, without_area_;  // its triangles: those that FCL is asked about, and the others
  const std::vector<ConvexHull> hulls_;
  const RepairedMesh repaired_;
  const Solid solid_;
  const TriangleBvh bvh_, bvh_without_area_;
  const FclMesh fcl_original_;
  const PoseSampler sampler_;
  const double tolerance_;  // of a verdict
  const double allowed_;    // the certified protrusion, and what the tolerance and welding add to it
  const std::vector<ProbeShape>& boxes_;
  std::vector<ProbeShape> neighbours_;
  std::vector<FclHull> fcl_hulls_;
  std::vector<Eigen::AlignedBox3d> hull_boxes_;
  std::vector<Eigen::Vector3d> component_points_;  // a vertex of each
};

PairCheck::PairCheck(const ValidationPair& pair, const std::vector<ProbeShape>& boxes, const std::vector<Neighbour>& neighbours)
    : name_(pair.name),
      frame_(pair),
      original_(frame_.units(pair.original)),
      with_area_(selected(original_, true)),
      without_area_(selected(original_, false)),
      hulls_(frame_.units(pair.hulls)),
      repaired_(repair(original_)),
      solid_(repaired_),
      bvh_(with_area_),
      bvh_without_area_(without_area_),
      fcl_original_(with_area_),
      sampler_(original_, hulls_),
      tolerance_(kFclTolerance + frame_.rounding()),
      allowed_(frame_.units(pair.protrusion) + tolerance_ + repaired_.counts.weld_distance),
      boxes_(boxes) {
  for (const Neighbour& neighbour : neighbours) neighbours_.emplace_back("hull of " + neighbour.name, frame_.units(*neighbour.hull));
  for (const ConvexHull& hull : hulls_) {
    fcl_hulls_.emplace_back(hull);
    hull_boxes_.push_back(boundingBox(hull));
  }
  component_points_ = repaired_.loose;
  for (std::size_t t = 0, seen = 0; t < repaired_.component.size(); ++t) {
    if (static_cast<std::size_t>(repaired_.component[t]) < seen) continue;
    component_points_.push_back(repaired_.mesh.corner(static_cast<int>(t), 0));
    ++seen;
  }
}

/// Of ten queries three are spheres, two boxes, one a neighbour's hull (the first time where it is, then anywhere), four points.
void PairCheck::query(std::size_t number, Random& random) {
  ++result.counts.queries;
  const std::size_t kind = number % 10, round = number / 10;
  if (kind < 3) {
    const double radius = random.logUniform(kLeastRadius, kLargestRadius);
    probe(sphere(sampler_.sphereCentre(random, radius), radius));
  } else if (kind == 5 && round < neighbours_.size()) {
    probe(placed(neighbours_[round], sampler_.nudge(random)));
  } else if (kind < 6) {
    const ProbeShape& shape =
        kind < 5 || neighbours_.empty() ? boxes_[random.below(boxes_.size())] : neighbours_[round % neighbours_.size()];
    probe(placed(shape, sampler_.pose(random, shape.hull)));
  } else if (kind < 8 || hulls_.empty()) {
    pointOnOriginal(sampler_.onOriginal(random));
  } else {
    pointInHull(sampler_.inHull(random));
  }
}

void PairCheck::pointOnOriginal(const Eigen::Vector3d& p) {
  double hulls = kFurthest;
  for (const auto& [lower, hull] : hullsByBox(Eigen::AlignedBox3d(p)))
    if (lower < hulls) hulls = std::min(hulls, pointDistance(hulls_[hull], p));
  judge(sphere(p, 0), 0, hulls);
}

void PairCheck::pointInHull(const Eigen::Vector3d& p) {
  judge(sphere(p, 0), std::min(bvh_.nearest(p).distance, bvh_without_area_.nearest(p).distance), 0);
}

void PairCheck::probe(const Probe& probe) {
  double original = toOriginal(probe);
  const double hulls = toHulls(probe);
  const bool speaks_against = (original == 0 && hulls > tolerance_) || original - hulls > allowed_;
  if (speaks_against && probe.shape) {
    FclAnswer again;
    again.distance = original;
    original = settled(probe, again, distanceToBody(original_, probe.body), "original");
  }
  judge(probe, original, hulls);
}

/// Hulls in the order of the distances of their boxes, which never exceed their own.
std::vector<std::pair<double, std::size_t>> PairCheck::hullsByBox(const Eigen::AlignedBox3d& box) const {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < hull_boxes_.size(); ++i) order.emplace_back(hull_boxes_[i].exteriorDistance(box), i);
  std::sort(order.begin(), order.end());
  return order;
}

double PairCheck::toHulls(const Probe& probe) {
  const auto start = std::chrono::steady_clock::now();
  const auto order = hullsByBox(probe.box);
  double microseconds = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  double least = kFurthest;
  for (const auto& [lower, hull] : order) {
    if (lower >= least) break;
    const FclAnswer answer =
        probe.shape ? fclDistance(fcl_hulls_[hull], probe.shape->convex, probe.pose) : fclDistance(fcl_hulls_[hull], probe.centre);
    microseconds += answer.microseconds;
    least = std::min(least, toHull(probe, hull, answer));
  }
  if (!fcl_original_.empty()) result.hull_us.push_back(microseconds);
  return least;
}

double PairCheck::toHull(const Probe& probe, std::size_t hull, const FclAnswer& answer) {
  if (!probe.shape) return settled(probe, answer, std::max(0.0, pointDistance(hulls_[hull], probe.centre) - probe.radius), "hulls");
  if (proved(answer, hulls_[hull], probe.body, frame_.rounding())) return answer.distance;
  return settled(probe, answer, bodyDistance(hulls_[hull], probe.body), "hulls");
}

/// FCL's part and what it cannot be asked about.
double PairCheck::toOriginal(const Probe& probe) {
  const double without_area = probe.shape ? distanceToBody(without_area_, probe.body)
                                          : std::max(0.0, bvh_without_area_.nearest(probe.centre).distance - probe.radius);
  if (fcl_original_.empty()) return without_area;
  const FclAnswer answer =
      probe.shape ? fclDistance(fcl_original_, probe.shape->mesh, probe.pose) : fclDistance(fcl_original_, probe.centre);
  result.mesh_us.push_back(answer.microseconds);
  return std::min(without_area, toSurface(probe, answer));
}

double PairCheck::toSurface(const Probe& probe, const FclAnswer& answer) {
  const double centre = bvh_.nearest(probe.centre).distance;
  if (!probe.shape) return settled(probe, answer, std::max(0.0, centre - probe.radius), "original");
  if (answer.status == FclAnswer::Status::kDistance) {
    if (holdsAComponent(probe)) return 0;  // as a surface among surfaces FCL sees it apart
    const bool possible = answer.distance <= centre + kFclTolerance && answer.distance >= centre - probe.radius - kFclTolerance;
    if (answer.distance > 0 && possible) return answer.distance;
    if (answer.distance == 0 && distanceToBody(with_area_, probe.body, kFclTolerance) < kFclTolerance) return 0;
  }
  return settled(probe, answer, distanceToBody(with_area_, probe.body), "original");
}

bool PairCheck::holdsAComponent(const Probe& probe) const {
  return std::any_of(component_points_.begin(), component_points_.end(),
                     [&](const Eigen::Vector3d& p) { return probe.box.contains(p) && planeDistance(probe.body, p) <= 0; });
}

/// Our own distance, after FCL's answer was compared with it and counted.
double PairCheck::settled(const Probe& probe, FclAnswer answer, double ours, const char* against) {
  if (!probe.shape) answer.distance = std::max(0.0, answer.distance - probe.radius);
  if (answer.microseconds > kTimeout) ++result.counts.timeouts;
  std::ostringstream text;
  if (answer.status == FclAnswer::Status::kException) {
    ++result.counts.exceptions;
    text << "exception of FCL (" << answer.error << ")";
  } else if (answer.status == FclAnswer::Status::kNan) {
    ++result.counts.nan;
    text << "FCL answered NaN";
  } else if (std::abs(answer.distance - ours) > kFclTolerance) {
    ++result.counts.disagreements;
    text << "disagreement, FCL " << frame_.metres(answer.distance) << " m";
  } else {
    return ours;
  }
  text << ", ours " << frame_.metres(ours) << " m, counted, to the " << against;
  remark(probe, text.str());
  return ours;
}

/// The distance to the solid: 0 for a probe that touches no surface and is inside. Looked up only where the verdict or the
/// largest underestimate depends on it.
double PairCheck::toSolid(const Eigen::Vector3d& p, double original, double hulls) const {
  const double matters = std::min(allowed_, frame_.units(result.counts.max_underestimate));
  return original - hulls > matters && solid_.contains(p) ? 0 : original;
}

void PairCheck::judge(const Probe& probe, double original, double hulls) {
  std::ostringstream text;
  if (original == 0 && hulls > tolerance_) {
    ++result.counts.missed;
    text << "missed: original hit, hulls " << frame_.metres(hulls) << " m away";
  }
  const double solid = toSolid(probe.centre, original, hulls);
  result.counts.max_underestimate = std::max(result.counts.max_underestimate, frame_.metres(solid - hulls));
  if (solid - hulls > allowed_) {
    if (hulls == 0) ++result.counts.phantom;
    text << (hulls == 0 ? "phantom: hulls hit" : "underestimate: hulls ")
         << (hulls == 0 ? "" : std::to_string(frame_.metres(hulls)) + " m away") << ", original " << frame_.metres(solid)
         << " m away, protrusion at most " << frame_.metres(allowed_) << " m";
  }
  if (!text.str().empty()) remark(probe, text.str());
}

void PairCheck::remark(const Probe& probe, const std::string& text) {
  if (result.counts.remarks.size() >= kMostRemarks) return;
  std::ostringstream line;
  const Eigen::Vector3d at = frame_.metres(probe.centre);
  line << name_ << ": ";
  if (probe.shape)
    line << probe.shape->name;
  else if (probe.radius > 0)
    line << "sphere of radius " << frame_.metres(probe.radius) << " m";
  else
    line << "point";
  line << " at (" << at.x() << " " << at.y() << " " << at.z() << ") m: " << text;
  result.counts.remarks.push_back(line.str());
}

}  // namespace

std::string fault(const ValidationPair& pair) {
  Eigen::AlignedBox3d box;
  for (const Triangle& t : pair.original.triangles) {
    for (int i : t) {
      if (i < 0 || i >= static_cast<int>(pair.original.vertices.size()))
        throw Error(ErrorCode::kIndexOutOfRange, pair.name + ": a triangle names vertex " + std::to_string(i) + " of " +
                                                     std::to_string(pair.original.vertices.size()) + "; mend the mesh");
      const Eigen::Vector3d& v = pair.original.vertices[static_cast<std::size_t>(i)];
      if (!v.allFinite()) return "a vertex of the original is not finite";
      box.extend(v);
    }
  }
  for (const ConvexHull& hull : pair.hulls) {
    if (hull.triangles.empty() || hull.faces.empty()) return "a hull has no faces";
    for (const Eigen::Vector3d& v : hull.vertices) {
      if (!v.allFinite()) return "a vertex of a hull is not finite";
      box.extend(v);
    }
    for (const HalfSpace& face : hull.faces)
      if (!face.normal.allFinite() || !std::isfinite(face.offset)) return "a face of a hull is not finite";
  }
  if (!box.isEmpty() && !std::isfinite(box.diagonal().squaredNorm())) return "its coordinates are too large to be squared";
  if (!std::isfinite(pair.protrusion) || pair.protrusion < 0)
    return "its protrusion of " + std::to_string(pair.protrusion) + " m is no bound";
  return "";
}

PairResult validatePair(const ValidationPair& pair, std::size_t index, const std::vector<ProbeShape>& boxes,
                        const std::vector<Neighbour>& neighbours, const ValidationOptions& options, const RunControl& control) {
  PairCheck check(pair, boxes, neighbours);
  for (std::size_t number = 0; number < static_cast<std::size_t>(options.queries_per_pair); ++number) {
    control.check();
    Random random(options.seed, index, number);
    check.query(number, random);
  }
  return check.result;
}

}  // namespace collision_hulls
