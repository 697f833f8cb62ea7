// A table, a shelf of four boards with back and sides, and things on them, all scaled by the subject's reach.
#include "bench/queries/query_scene.h"

#include <cmath>

#include "geometry/box_hull.h"
#include "geometry/pi.h"
#include "geometry/random_stream.h"

namespace collision_hulls {
namespace {

constexpr std::uint64_t kThings = 1, kPoses = 2;  // streams of random numbers

ConvexHull cylinder(const Eigen::Vector3d& foot, double radius, double height) {
  constexpr int kSides = 24;
  std::vector<Eigen::Vector3d> rims;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * kPi * i / kSides;
    const Eigen::Vector3d out(radius * std::cos(angle), radius * std::sin(angle), 0);
    rims.push_back(foot + out);
    rims.push_back(foot + out + Eigen::Vector3d(0, 0, height));
  }
  return convexHull(rims);
}

/// Puts things on a surface, boxes and cylinders in turn.
void addThings(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double z, double size, int count, Random& random,
               std::vector<ConvexHull>& scene) {
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d foot(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()), z);
    const double half = random.uniform(0.2, 0.5) * size, height = random.uniform(0.4, 1.5) * size;
    if (i % 2) scene.push_back(cylinder(foot, half, height));
    if (i % 2 == 0) scene.push_back(hullOfBox(foot - Eigen::Vector3d(half, half, 0), foot + Eigen::Vector3d(half, 0.7 * half, height)));
  }
}

}  // namespace

std::vector<ConvexHull> clutteredScene(const Surroundings& reach, std::uint64_t seed) {
  Random random(seed, kThings, 0);
  const double r = reach.radius, board = 0.03 * r, size = 0.12 * r, wide = 0.6 * r;
  const double top = reach.low + 0.4 * (reach.high - reach.low);
  std::vector<ConvexHull> scene;
  scene.push_back(hullOfBox({0.3 * r, -wide, top - board}, {1.1 * r, wide, top}));
  addThings({0.35 * r, -wide}, {1.05 * r, wide}, top, size, 20, random, scene);

  const double front = -0.5 * r, back = -0.9 * r, storey = 0.3 * r;
  constexpr int kBoards = 4;
  for (int i = 0; i < kBoards; ++i) {
    const double z = top + (i - 1) * storey;
    scene.push_back(hullOfBox({back, -wide, z - board}, {front, wide, z}));
    if (i + 1 < kBoards) addThings({back, -wide}, {front, wide}, z, size, 6, random, scene);
  }
  const double low = top - storey - board, high = top + (kBoards - 2) * storey;
  scene.push_back(hullOfBox({back - board, -wide, low}, {back, wide, high}));
  for (const double side : {-wide, wide}) scene.push_back(hullOfBox({back, side - board / 2, low}, {front, side + board / 2, high}));
  return scene;
}

std::vector<Eigen::Isometry3d> freePoses(const Surroundings& reach, std::size_t count, std::uint64_t seed) {
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, kPoses, i);
    const Eigen::Vector3d place(random.uniform(-reach.radius, reach.radius), random.uniform(-reach.radius, reach.radius),
                                random.uniform(reach.low, reach.high));
    poses.push_back(Eigen::Translation3d(place) * random.rotation());
  }
  return poses;
}

}  // namespace collision_hulls
