// Runs one of FCL's queries as a user would write it, or as the validator does, and compares the answer with the true signed distance.
#include "bench/stability/fcl_trials.h"

#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "query/fcl_bodies.h"
#include "query/fcl_queries.h"

namespace collision_hulls {

namespace {

using Query = FclSetting::Query;
using Bodies = FclSetting::Bodies;
using Solver = FclSetting::Solver;
using Geometry = std::shared_ptr<const fcl::CollisionGeometryd>;

Geometry convexOf(const ConvexHull& hull) {
  return fclConvex(hull, 1);
}

Geometry bvhOf(const ConvexHull& hull) {
  return fclTree<fcl::OBBRSSd>(hull.vertices, fclTriangles(hull.triangles), 1);
}

fcl::GJKSolverType solverType(Solver solver) {
  return solver == Solver::kIndep ? fcl::GST_INDEP : fcl::GST_LIBCCD;
}

double distanceBy(const FclSetting& setting, const BodyPair& pair) {
  const Geometry first = setting.bodies == Bodies::kConvexConvex ? convexOf(pair.first) : bvhOf(pair.first);
  const Geometry second = setting.bodies == Bodies::kBvhBvh ? bvhOf(pair.second) : convexOf(pair.second);
  const double tolerance = setting.tolerance > 0 ? setting.tolerance : fcl::DistanceRequestd().distance_tolerance;
  const fcl::DistanceRequestd request(false, setting.query == Query::kSignedDistance, 0, 0, tolerance, solverType(setting.solver));
  fcl::DistanceResultd result;
  fcl::distance(first.get(), fcl::Transform3d::Identity(), second.get(), pair.pose, request, result);
  return result.min_distance;
}

bool collideBy(const FclSetting& setting, const BodyPair& pair) {
  const Geometry first = setting.bodies == Bodies::kConvexConvex ? convexOf(pair.first) : bvhOf(pair.first);
  const Geometry second = setting.bodies == Bodies::kBvhBvh ? bvhOf(pair.second) : convexOf(pair.second);
  fcl::CollisionRequestd request;
  request.gjk_solver_type = solverType(setting.solver);
  if (setting.tolerance > 0) request.gjk_tolerance = setting.tolerance;
  fcl::CollisionResultd result;
  fcl::collide(first.get(), fcl::Transform3d::Identity(), second.get(), pair.pose, request, result);
  return result.isCollision();
}

ConvexHull enlarged(ConvexHull hull, double factor) {
  for (Eigen::Vector3d& v : hull.vertices) v *= factor;
  return hull;
}

/// Scales so that the larger body is about one unit in size, as UnitFrame does with elements and probes.
FclAnswer askAsValidator(const FclSetting& setting, const BodyPair& pair, double& unit) {
  int exponent = 0;
  std::frexp(pair.size, &exponent);
  unit = std::ldexp(1.0, exponent);
  const ConvexHull first = enlarged(pair.first, 1 / unit), second = enlarged(pair.second, 1 / unit);
  Eigen::Isometry3d pose = pair.pose;
  pose.translation() /= unit;
  if (setting.bodies == Bodies::kBvhBvh) return fclDistance(FclMesh(surface(first)), FclMesh(surface(second)), pose);
  return fclDistance(FclHull(first), FclHull(second), pose);
}

FclTrial failed(FclTrial::Outcome outcome) {
  FclTrial trial;
  trial.outcome = outcome;
  return trial;
}

FclTrial judged(double error, const BodyPair& pair) {
  FclTrial trial;
  trial.error = error / pair.size;
  trial.outcome = trial.error <= kFclTolerance ? FclTrial::Outcome::kExact : FclTrial::Outcome::kOff;
  return trial;
}

FclTrial judgedDistance(double answer, double truth, const BodyPair& pair) {
  if (std::isnan(answer)) return failed(FclTrial::Outcome::kNan);
  if (truth <= 0 && answer == -1) return failed(FclTrial::Outcome::kMinusOne);
  return judged(std::abs(std::max(0.0, answer) - std::max(0.0, truth)), pair);
}

FclTrial asked(const FclSetting& setting, const BodyPair& pair, double truth) {
  switch (setting.query) {
    case Query::kCollide: {
      const bool right = collideBy(setting, pair) == (truth <= 0);
      return judged(right ? 0 : std::abs(truth), pair);
    }
    case Query::kSignedDistance: {
      const double answer = distanceBy(setting, pair);
      return std::isnan(answer) ? failed(FclTrial::Outcome::kNan) : judged(std::abs(answer - truth), pair);
    }
    case Query::kDistance: return judgedDistance(distanceBy(setting, pair), truth, pair);
    case Query::kValidator: break;
  }
  double unit = 1;
  const FclAnswer answer = askAsValidator(setting, pair, unit);
  if (answer.status == FclAnswer::Status::kException) return failed(FclTrial::Outcome::kException);
  if (answer.status == FclAnswer::Status::kNan) return failed(FclTrial::Outcome::kNan);
  return judgedDistance(answer.distance * unit, truth, pair);
}

}  // namespace

std::string queryName(const FclSetting& setting) {
  const char* const query = setting.query == Query::kDistance         ? "distance"
                            : setting.query == Query::kSignedDistance ? "signed distance"
                            : setting.query == Query::kCollide        ? "collide"
                                                                      : "validator";
  const char* const bodies = setting.bodies == Bodies::kConvexConvex ? " Convex-Convex"
                             : setting.bodies == Bodies::kBvhConvex  ? " BVH-Convex"
                                                                     : " BVH-BVH";
  return std::string(query) + bodies;
}

const char* name(FclSetting::Solver solver) {
  switch (solver) {
    case Solver::kLibccd: return "libccd";
    case Solver::kIndep: return "indep";
    case Solver::kNone: return "none";
  }
  return "unknown";
}

const std::vector<FclSetting>& fclSettings() {
  static const std::vector<FclSetting> settings{{Query::kValidator, Bodies::kConvexConvex, Solver::kLibccd, 1e-9},
                                                {Query::kValidator, Bodies::kBvhBvh, Solver::kNone, 0},
                                                {Query::kDistance, Bodies::kConvexConvex, Solver::kLibccd, 1e-6},
                                                {Query::kDistance, Bodies::kConvexConvex, Solver::kLibccd, 1e-9},
                                                {Query::kDistance, Bodies::kConvexConvex, Solver::kIndep, 1e-6},
                                                {Query::kDistance, Bodies::kBvhConvex, Solver::kLibccd, 1e-6},
                                                {Query::kDistance, Bodies::kBvhConvex, Solver::kLibccd, 1e-9},
                                                {Query::kDistance, Bodies::kBvhConvex, Solver::kIndep, 1e-6},
                                                {Query::kDistance, Bodies::kBvhBvh, Solver::kNone, 0},
                                                {Query::kSignedDistance, Bodies::kConvexConvex, Solver::kLibccd, 1e-6},
                                                {Query::kSignedDistance, Bodies::kConvexConvex, Solver::kLibccd, 1e-9},
                                                {Query::kSignedDistance, Bodies::kConvexConvex, Solver::kIndep, 1e-6},
                                                {Query::kCollide, Bodies::kConvexConvex, Solver::kLibccd, 1e-6},
                                                {Query::kCollide, Bodies::kConvexConvex, Solver::kIndep, 1e-6},
                                                {Query::kCollide, Bodies::kBvhConvex, Solver::kLibccd, 1e-6},
                                                {Query::kCollide, Bodies::kBvhConvex, Solver::kIndep, 1e-6},
                                                {Query::kCollide, Bodies::kBvhBvh, Solver::kNone, 0}};
  return settings;
}

const char* name(FclTrial::Outcome outcome) {
  switch (outcome) {
    case FclTrial::Outcome::kExact: return "exact";
    case FclTrial::Outcome::kMinusOne: return "minus_one";
    case FclTrial::Outcome::kOff: return "off";
    case FclTrial::Outcome::kNan: return "nan";
    case FclTrial::Outcome::kException: return "exception";
  }
  return "unknown";
}

FclTrial tryFcl(const FclSetting& setting, const BodyPair& pair) {
  const double truth = signedDistance(pair);
  try {
    return asked(setting, pair, truth);
  } catch (const std::exception&) {
    return failed(FclTrial::Outcome::kException);
  }
}

}  // namespace collision_hulls
