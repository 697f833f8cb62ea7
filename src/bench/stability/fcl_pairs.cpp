// Generates pairs with seeded random numbers, and computes the true signed distance by brute force: separating axes from faces and from
// pairs of edges, O(n^2) support queries.
#include "bench/stability/fcl_pairs.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "check/validate_exact.h"
#include "geometry/box_hull.h"
#include "geometry/hull_support.h"
#include "geometry/random_stream.h"

namespace collision_hulls {

namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr int kVertices = 14;
constexpr double kLeastGap = 1e-9, kLargestGap = 1e-2;  // [m]
constexpr double kMillimetre = 1e-3;                    // in metres

ConvexHull roundBody(double size, Random& random) {
  const Eigen::Vector3d radii = size / 2 * Eigen::Vector3d(1, random.uniform(0.4, 1), random.uniform(0.4, 1));
  const Eigen::Quaterniond turn = random.rotation();
  Points points;
  for (int i = 0; i < kVertices; ++i) points.push_back(turn * radii.cwiseProduct(random.direction()));
  return convexHull(points);
}

ConvexHull plate(Random& random) {
  Points points;
  for (int i = 0; i < kVertices; ++i) {
    const Eigen::Vector3d p = random.direction();
    points.emplace_back(p.x() / 2, p.y() / 2, 0);
  }
  return convexHull(points);
}

/// The support function: how far a body extends in a direction.
double reach(const ConvexHull& body, const Eigen::Vector3d& direction) {
  double furthest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& v : body.vertices) furthest = std::max(furthest, direction.dot(v));
  return furthest;
}

const Eigen::Vector3d& lowest(const ConvexHull& body, const Eigen::Vector3d& direction) {
  return *std::min_element(body.vertices.begin(), body.vertices.end(),
                           [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return direction.dot(a) < direction.dot(b); });
}

Eigen::Vector3d middleOfFace(const ConvexHull& body, const HalfSpace& face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (const Eigen::Vector3d& v : body.vertices)
    if (face.distance(v) > -1e-9 * std::abs(face.offset)) sum += v, ++count;
  return sum / count;
}

/// Places the second body, rotated at random, with its lowest corner `gap` above the middle of a face of the first.
void placeOverFace(double gap, Random& random, BodyPair& pair) {
  const HalfSpace& face = pair.first.faces[random.below(pair.first.faces.size())];
  const Eigen::Quaterniond turn = random.rotation();
  const Eigen::Vector3d corner = turn * lowest(pair.second, turn.conjugate() * face.normal);
  pair.pose = Eigen::Translation3d(middleOfFace(pair.first, face) + gap * face.normal - corner) * turn;
}

/// Places the second body, rotated at random, `gap` from the first along some direction, so the bodies are at least `gap` apart.
void placeApart(double gap, Random& random, BodyPair& pair) {
  const Eigen::Quaterniond turn = random.rotation();
  const Eigen::Vector3d way = random.direction();
  const double between = reach(pair.first, way) + reach(pair.second, turn.conjugate() * -way) + gap;
  pair.pose = Eigen::Translation3d(between * way) * turn;
}

void placeWithin(double offset, Random& random, BodyPair& pair) {
  const Eigen::Quaterniond turn = random.rotation();
  pair.pose = Eigen::Translation3d(offset * random.direction()) * turn;
}

void placeInMiddle(Random& random, BodyPair& pair) {
  pair.pose = Eigen::Translation3d(meanOfVertices(pair.first)) * random.rotation();
}

/// Two boxes, one standing on the other, with parallel edges.
BodyPair stacked(Random& random) {
  const Eigen::Vector3d a(1, random.uniform(0.2, 1), random.uniform(0.2, 1)), b(0.5, random.uniform(0.2, 1), random.uniform(0.2, 1));
  BodyPair pair{hullOfBox(a), hullOfBox(b)};
  pair.pose.translation() = Eigen::Vector3d(random.uniform(-0.4, 0.4), random.uniform(-0.1, 0.1), (a.z() + b.z()) / 2);
  return pair;
}

/// The least overlap over all directions that may separate the bodies.
double penetration(const ConvexHull& a, const ConvexHull& b) {
  double least = std::numeric_limits<double>::infinity();
  const auto tryAxis = [&](const Eigen::Vector3d& axis) { least = std::min(least, reach(a, axis) + reach(b, -axis)); };
  for (const HalfSpace& face : a.faces) tryAxis(face.normal);
  for (const HalfSpace& face : b.faces) tryAxis(-face.normal);
  const auto edges = [](const ConvexHull& body) {
    Points result;
    for (const Triangle& t : body.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] < t[(k + 1) % 3])
          result.push_back(body.vertices[static_cast<std::size_t>(t[(k + 1) % 3])] - body.vertices[static_cast<std::size_t>(t[k])]);
    return result;
  };
  const Points ours = edges(a), theirs = edges(b);
  constexpr double kParallel = 1e-9;  // sine of the angle
  for (const Eigen::Vector3d& u : ours)
    for (const Eigen::Vector3d& v : theirs) {
      const Eigen::Vector3d axis = u.cross(v);
      if (axis.norm() <= kParallel * u.norm() * v.norm()) continue;
      tryAxis(axis.normalized());
      tryAxis(-axis.normalized());
    }
  return least;
}

BodyPair pairOf(PairKind kind, bool other_time, Random& random) {
  BodyPair pair;
  const auto gap = [&] { return random.logUniform(kLeastGap, kLargestGap); };
  const auto bodies = [&](double first, double second) {
    pair.first = roundBody(first, random);
    pair.second = roundBody(second, random);
  };
  switch (kind) {
    case PairKind::kFar: bodies(1, 1), placeApart(random.uniform(1, 3), random, pair); break;
    case PairKind::kNear: bodies(1, 1), placeOverFace(gap(), random, pair); break;
    case PairKind::kTouching:
      if (other_time) return stacked(random);
      bodies(1, 1), placeOverFace(0, random, pair);
      break;
    case PairKind::kDeep: bodies(1, 1), placeWithin(0.3, random, pair); break;
    case PairKind::kContained: bodies(1, 0.1), placeInMiddle(random, pair); break;
    case PairKind::kFlat: pair.first = plate(random), pair.second = roundBody(1, random), placeApart(kLargestGap, random, pair); break;
    case PairKind::kNeedle:
      pair.first = pair.second = hullOfBox({1, 1e-3, 1e-3});
      placeApart(kLargestGap, random, pair);
      break;
    case PairKind::kMillimetre:
      bodies(kMillimetre, kMillimetre);
      other_time ? placeWithin(0.3 * kMillimetre, random, pair) : placeOverFace(kMillimetre * gap(), random, pair);
      break;
    case PairKind::kIdentical: pair.first = pair.second = roundBody(1, random); break;
    case PairKind::kUnequal: bodies(10, 0.01), placeOverFace(gap(), random, pair); break;
  }
  return pair;
}

}  // namespace

const char* name(PairKind kind) {
  switch (kind) {
    case PairKind::kFar: return "far";
    case PairKind::kNear: return "near";
    case PairKind::kTouching: return "touching";
    case PairKind::kDeep: return "deep";
    case PairKind::kContained: return "contained";
    case PairKind::kFlat: return "flat";
    case PairKind::kNeedle: return "needle";
    case PairKind::kMillimetre: return "millimetre";
    case PairKind::kIdentical: return "identical";
    case PairKind::kUnequal: return "1cm_10m";
  }
  return "unknown";
}

const std::vector<PairKind>& allPairKinds() {
  static const std::vector<PairKind> kinds{PairKind::kFar,       PairKind::kNear,   PairKind::kTouching, PairKind::kDeep,
                                           PairKind::kContained, PairKind::kFlat,   PairKind::kNeedle,   PairKind::kMillimetre,
                                           PairKind::kIdentical, PairKind::kUnequal};
  return kinds;
}

BodyPair bodyPair(PairKind kind, std::uint64_t seed, std::uint64_t number) {
  Random random(seed, static_cast<std::uint64_t>(kind), number);
  BodyPair pair = pairOf(kind, number % 2 == 1, random);
  pair.size = std::max(boundingBox(pair.first).sizes().maxCoeff(), boundingBox(pair.second).sizes().maxCoeff());
  return pair;
}

double signedDistance(const BodyPair& pair) {
  const ConvexHull second = transformed(pair.second, pair.pose);
  const double apart = bodyDistance(pair.first, second);
  return apart > 0 ? apart : -penetration(pair.first, second);
}

}  // namespace collision_hulls
