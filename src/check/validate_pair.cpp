// FCL's answers never decide alone. Distances of spheres are also computed exactly. An answer between hulls is accepted if FCL's nearest
// points prove it, and computed otherwise. An answer between meshes (exact up to rounding wherever it was measured) is computed again if it
// would count against the hulls.
#include "check/validate_pair.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include "base/decimal.h"
#include "base/parallel.h"
#include "check/validate_exact.h"

namespace collision_hulls {

namespace {

constexpr double kLeastRadius = 0.001, kLargestRadius = 0.25;  // of spheres, as shares of the element's size
constexpr std::size_t kQueriesAtOnce = 20;
constexpr double kTimeout = 1e6;  // [us]

class PairCheck {
 public:
  explicit PairCheck(const PairModel& model) : model_(model) {}
  void query(std::size_t number, Random& random);
  PairResult result;

 private:
  void pointOnOriginal(const Eigen::Vector3d& p);
  void pointInHull(const Eigen::Vector3d& p);
  void probe(const Probe& probe);

  std::vector<std::pair<double, std::size_t>> hullsByBox(const Eigen::AlignedBox3d& box) const;
  double toHulls(const Probe& probe);
  FclAnswer fclToHull(const Probe& probe, std::size_t hull) const;
  void countTimeOf(const FclAnswer& answer);
  double toHull(const Probe& probe, std::size_t hull, const FclAnswer& answer);
  double toPoint(std::size_t hull, const Eigen::Vector3d& p) const;
  double toOriginal(const Probe& probe);
  double toSurface(const Probe& probe, const FclAnswer& answer);
  bool touches(const Probe& probe) const;
  bool holdsAComponent(const Probe& probe) const;
  double settled(const Probe& probe, FclAnswer answer, double ours, const char* against);
  void judge(const Probe& probe, double original, double hulls);
  double toSolid(const Probe& probe, double original, double hulls) const;
  bool meetsTheInside(const Probe& probe, double hulls) const;
  void remark(const Probe& probe, const std::string& text);

  const PairModel& model_;
};

/// Of ten queries three are spheres, two boxes, one is a neighbour's hull (at first where it is, later anywhere), four are points.
void PairCheck::query(std::size_t number, Random& random) {
  ++result.counts.queries;
  const std::size_t kind = number % 10, round = number / 10;
  if (kind < 3) {
    const double radius = random.logUniform(kLeastRadius, kLargestRadius);
    probe(sphere(model_.sampler.sphereCentre(random, radius), radius));
  } else if (kind == 5 && round < model_.neighbours.size()) {
    probe(placed(model_.neighbours[round], model_.sampler.nudge(random)));
  } else if (kind < 6) {
    const ProbeShape& shape = kind < 5 || model_.neighbours.empty() ? model_.boxes[random.below(model_.boxes.size())]
                                                                    : model_.neighbours[round % model_.neighbours.size()];
    probe(placed(shape, model_.sampler.pose(random, shape.hull)));
  } else if (kind < 8 || model_.hulls.empty()) {
    pointOnOriginal(model_.sampler.onOriginal(random));
  } else {
    pointInHull(model_.sampler.inHull(random));
  }
}

void PairCheck::pointOnOriginal(const Eigen::Vector3d& p) {
  double hulls = kFurthest;
  for (const auto& [lower, hull] : hullsByBox(Eigen::AlignedBox3d(p)))
    if (lower < hulls) hulls = std::min(hulls, toPoint(hull, p));
  judge(sphere(p, 0), 0, hulls);
}

void PairCheck::pointInHull(const Eigen::Vector3d& p) {
  judge(sphere(p, 0), std::min(model_.bvh->nearest(p).distance, model_.bvh_without_area->nearest(p).distance), 0);
}

void PairCheck::probe(const Probe& probe) {
  double original = toOriginal(probe);
  const double hulls = toHulls(probe);
  const bool speaks_against = (original == 0 && hulls > model_.tolerance) || original - hulls > model_.allowed;
  if (speaks_against && probe.shape) {
    FclAnswer again;
    again.distance = original;
    original = settled(probe, again, distanceToBody(model_.original, probe.body), "original");
  }
  judge(probe, original, hulls);
}

/// Hulls, by the distances of their boxes; these never exceed the hulls' distances.
std::vector<std::pair<double, std::size_t>> PairCheck::hullsByBox(const Eigen::AlignedBox3d& box) const {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < model_.hull_boxes.size(); ++i) order.emplace_back(model_.hull_boxes[i].exteriorDistance(box), i);
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
    const FclAnswer answer = fclToHull(probe, hull);
    microseconds += answer.microseconds;
    least = std::min(least, toHull(probe, hull, answer));
  }
  if (!model_.fcl_original->empty()) result.hull_us.push_back(microseconds);
  return least;
}

/// A sphere's distances are those of its centre, less its radius.
FclAnswer PairCheck::fclToHull(const Probe& probe, std::size_t hull) const {
  const Sphere* const sphere = model_.sphereAt(hull);
  if (!sphere)
    return probe.shape ? fclDistance(model_.fcl_hulls[hull], probe.shape->convex, probe.pose)
                       : fclDistance(model_.fcl_hulls[hull], probe.centre);
  FclAnswer answer;
  if (probe.shape)
    answer = fclDistance(probe.shape->convex, Eigen::Vector3d(probe.pose.inverse() * sphere->centre));
  else
    answer.distance = (sphere->centre - probe.centre).norm();
  answer.distance = std::max(0.0, answer.distance - sphere->radius);
  return answer;
}

double PairCheck::toPoint(std::size_t hull, const Eigen::Vector3d& p) const {
  const Sphere* const sphere = model_.sphereAt(hull);
  return sphere ? std::max(0.0, (p - sphere->centre).norm() - sphere->radius) : pointDistance(model_.hulls[hull], p);
}

/// Whatever FCL answered, and whether it was needed.
void PairCheck::countTimeOf(const FclAnswer& answer) {
  if (answer.microseconds > kTimeout) ++result.counts.timeouts;
}

double PairCheck::toHull(const Probe& probe, std::size_t hull, const FclAnswer& answer) {
  countTimeOf(answer);
  if (!probe.shape) return settled(probe, answer, std::max(0.0, toPoint(hull, probe.centre) - probe.radius), "hulls");
  if (const Sphere* const sphere = model_.sphereAt(hull))
    return settled(probe, answer, std::max(0.0, pointDistance(probe.body, sphere->centre) - sphere->radius), "hulls");
  if (proved(answer, model_.hulls[hull], probe.body, model_.frame.rounding())) return answer.distance;
  return settled(probe, answer, bodyDistance(model_.hulls[hull], probe.body), "hulls");
}

/// The lesser of FCL's distance and that of the triangles FCL cannot handle.
double PairCheck::toOriginal(const Probe& probe) {
  const double without_area = probe.shape ? distanceToBody(model_.without_area, probe.body)
                                          : std::max(0.0, model_.bvh_without_area->nearest(probe.centre).distance - probe.radius);
  if (model_.fcl_original->empty()) return without_area;
  const FclAnswer answer =
      probe.shape ? fclDistance(*model_.fcl_original, probe.shape->mesh, probe.pose) : fclDistance(*model_.fcl_original, probe.centre);
  result.mesh_us.push_back(answer.microseconds);
  countTimeOf(answer);
  return std::min(without_area, toSurface(probe, answer));
}

double PairCheck::toSurface(const Probe& probe, const FclAnswer& answer) {
  const double centre = model_.bvh->nearest(probe.centre).distance;
  if (!probe.shape) return settled(probe, answer, std::max(0.0, centre - probe.radius), "original");
  if (answer.status == FclAnswer::Status::kDistance) {
    if (holdsAComponent(probe)) return 0;  // FCL, comparing surfaces, sees them apart
    const bool possible = answer.distance <= centre + kFclTolerance && answer.distance >= centre - probe.radius - kFclTolerance;
    if (answer.distance > 0 && possible) return answer.distance;
    if (answer.distance == 0 && touches(probe)) return 0;
  }
  return settled(probe, answer, distanceToBody(model_.withArea(), probe.body), "original");
}

/// Whether the original comes within FCL's tolerance of a polyhedron.
bool PairCheck::touches(const Probe& probe) const {
  // One look is mostly enough.
  if (distanceToBody(model_.nearestWithArea(probe.centre), probe.body, kFclTolerance) < kFclTolerance) return true;
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kFclTolerance);
  const TriangleMesh near = model_.withAreaNear({probe.box.min() - margin, probe.box.max() + margin});
  return distanceToBody(near, probe.body, kFclTolerance) < kFclTolerance;
}

bool PairCheck::holdsAComponent(const Probe& probe) const {
  return std::any_of(model_.component_points.begin(), model_.component_points.end(),
                     [&](const Eigen::Vector3d& p) { return probe.box.contains(p) && planeDistance(probe.body, p) <= 0; });
}

/// Compares FCL's answer with our own distance, counts any fault, and returns our own.
double PairCheck::settled(const Probe& probe, FclAnswer answer, double ours, const char* against) {
  if (!probe.shape) answer.distance = std::max(0.0, answer.distance - probe.radius);
  std::ostringstream text;
  if (answer.status == FclAnswer::Status::kException) {
    ++result.counts.exceptions;
    text << "FCL threw an exception (" << answer.error << ")";
  } else if (answer.status == FclAnswer::Status::kNan) {
    ++result.counts.nan;
    text << "FCL answered NaN";
  } else if (std::abs(answer.distance - ours) > kFclTolerance) {
    ++result.counts.disagreements;
    text << "disagreement: FCL says " << model_.frame.metres(answer.distance) << " m";
  } else {
    return ours;
  }
  text << "; our own distance to the " << against << ", " << model_.frame.metres(ours) << " m, was used";
  remark(probe, text.str());
  return ours;
}

/// The distance to the solid: 0 for a probe that is inside without touching the surface. Computed only if the verdict or the largest
/// underestimate depends on it.
double PairCheck::toSolid(const Probe& probe, double original, double hulls) const {
  const double matters = std::min(model_.allowed, model_.frame.units(result.counts.max_underestimate));
  if (original - hulls <= matters) return original;
  if (model_.inSolid(probe.centre)) return 0;
  return model_.hasOpenings() && meetsTheInside(probe, hulls) ? hulls : original;
}

/// A probe may reach the inside through an opening without touching the surface. Whether some point of the hulls at the hulls' distance
/// from the probe lies inside.
bool PairCheck::meetsTheInside(const Probe& probe, double hulls) const {
  const auto inside = [&](const Eigen::Vector3d& p) { return model_.inSolid(p); };
  for (const auto& [lower, hull] : hullsByBox(probe.box)) {
    if (lower > hulls) break;
    const ConvexHull& body = model_.hulls[hull];
    if (const Sphere* const sphere = model_.sphereAt(hull)) {
      const Eigen::Vector3d towards = probe.shape ? nearestPoint(probe.body, sphere->centre) : probe.centre;
      const Eigen::Vector3d away = towards - sphere->centre;
      if (inside(sphere->centre + away * std::min(1.0, sphere->radius / away.norm()))) return true;
    } else if (probe.shape) {
      const std::vector<Eigen::Vector3d> common = hulls == 0 ? commonPoints(body, probe.body) : std::vector<Eigen::Vector3d>();
      if (std::any_of(common.begin(), common.end(), inside)) return true;
    } else {
      const Eigen::Vector3d near = nearestPoint(body, probe.centre);
      if ((near - probe.centre).norm() <= probe.radius + hulls + kFclTolerance && inside(near)) return true;
    }
  }
  return false;
}

void PairCheck::judge(const Probe& probe, double original, double hulls) {
  std::ostringstream text;
  if (original == 0 && hulls > model_.tolerance) {
    ++result.counts.missed;
    text << "missed: the original is hit, the hulls are " << model_.frame.metres(hulls) << " m away";
  }
  const double solid = toSolid(probe, original, hulls);
  result.counts.max_underestimate = std::max(result.counts.max_underestimate, model_.frame.metres(solid - hulls));
  if (solid - hulls > model_.allowed) {
    if (hulls == 0) ++result.counts.phantom;
    if (hulls == 0)
      text << "false collision: the hulls are hit";
    else
      text << "underestimate: the hulls are " << model_.frame.metres(hulls) << " m away";
    text << ", the original is " << model_.frame.metres(solid) << " m away, but the protrusion is at most "
         << model_.frame.metres(model_.allowed) << " m";
  }
  if (!text.str().empty()) remark(probe, text.str());
}

void PairCheck::remark(const Probe& probe, const std::string& text) {
  if (result.counts.remarks.size() >= kMostRemarks) return;
  std::ostringstream line;
  const Eigen::Vector3d at = model_.frame.metres(probe.centre);
  line << model_.name << ": ";
  if (probe.shape)
    line << probe.shape->name;
  else if (probe.radius > 0)
    line << "sphere of radius " << model_.frame.metres(probe.radius) << " m";
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
        throw Error(ErrorCode::kIndexOutOfRange, pair.name + ": a triangle names vertex " + std::to_string(i) + ", but there are " +
                                                     std::to_string(pair.original.vertices.size()) + ", counted from 0; repair the mesh");
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
  if (!box.isEmpty() && !std::isfinite(box.diagonal().squaredNorm())) return "its coordinates are too large to square";
  if (pair.spheres.size() > pair.hulls.size()) return "there is no hull for each of its spheres";
  for (const Sphere& sphere : pair.spheres)
    if (!sphere.centre.allFinite() || !std::isfinite(sphere.radius)) return "a sphere is not finite";
  if (!std::isfinite(pair.protrusion) || pair.protrusion < 0)
    return "its protrusion of " + fixedDecimal(pair.protrusion) + " m is not a valid bound";
  return "";
}

std::vector<PairResult> validatePair(ValidationPair& pair, std::size_t index, const std::vector<ProbeShape>& boxes,
                                     const std::vector<Neighbour>& neighbours, const ValidationOptions& options,
                                     const RunControl& control) {
  const PairModel model(pair, boxes, neighbours, control);
  const auto queries = static_cast<std::size_t>(options.queries_per_pair);
  std::vector<PairResult> results((queries + kQueriesAtOnce - 1) / kQueriesAtOnce);
  forEach(results.size(), [&](std::size_t i) {
    PairCheck check(model);
    for (std::size_t number = i * kQueriesAtOnce; number < std::min(queries, (i + 1) * kQueriesAtOnce); ++number) {
      control.check();
      Random random(options.seed, index, number);
      check.query(number, random);
    }
    results[i] = std::move(check.result);
  });
  return results;
}

}  // namespace collision_hulls
