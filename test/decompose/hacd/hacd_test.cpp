#include "collision_hulls/decompose/hacd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "decompose/hacd/dual_graph.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

constexpr double kShare = 0.03;  // epsilon over D in the paper's figures

std::vector<std::vector<int>> partition(const TriangleMesh& mesh, double share = kShare) {
  return hacdPartition(mesh, share * diagonal(mesh));
}

std::vector<ConvexHull> hulls(const TriangleMesh& mesh) {
  std::vector<ConvexHull> result;
  for (const std::vector<int>& cluster : partition(mesh)) {
    std::vector<Eigen::Vector3d> points;
    for (int t : cluster)
      for (int k = 0; k < 3; ++k) points.push_back(mesh.corner(t, k));
    result.push_back(convexHull(points));
  }
  return result;
}

/// The largest distance from the surface of those points of the hulls that lie in open space according to `outside`.
template <class Outside>
double sampledProtrusion(const TriangleMesh& mesh, const Outside& outside) {
  const TriangleBvh bvh(mesh);
  double most = 0;
  for (const ConvexHull& hull : hulls(mesh)) {
    const TriangleMesh faces = test_shapes::subdivided(surface(hull), 12);
    for (const Eigen::Vector3d& p : faces.vertices)
      if (outside(p)) most = std::max(most, bvh.nearest(p).distance);
  }
  return most;
}

TEST(Equations, AspectRatioIsOneForADisk) {
  constexpr double kRadius = 3;
  EXPECT_DOUBLE_EQ(aspectRatio(2 * test_shapes::kPi * kRadius, test_shapes::kPi * kRadius * kRadius), 1);
  EXPECT_DOUBLE_EQ(aspectRatio(4, 1), 4 / test_shapes::kPi);
  EXPECT_EQ(aspectRatio(0, 1), 0);
  EXPECT_TRUE(std::isinf(aspectRatio(1, 0)));
}

TEST(Equations, CostAndWeight) {
  EXPECT_DOUBLE_EQ(decimationCost(2, 4, 0.1, 3), 0.8);
  EXPECT_DOUBLE_EQ(shapeWeight(0.03, 2), 0.0015);
}

TEST(HacdPartition, EmptyMesh) {
  EXPECT_TRUE(hacdPartition({}, 1).empty());
}

TEST(HacdPartition, RefusesWhatItCannotUse) {
  const auto code = [](const TriangleMesh& mesh, double epsilon, const auto& act) {
    try {
      act(mesh, epsilon);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  TriangleMesh mesh = test_shapes::lBracket();
  for (const auto act : {+[](const TriangleMesh&m, double epsilon) { hacdPartition(m, epsilon); },
                         +[](const TriangleMesh&m, double epsilon) { hacdSegmentation(m, epsilon); }}) {
    for (const double epsilon : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 0.99e-6 * diagonal(mesh)})
      EXPECT_EQ(code(mesh, epsilon, act), ErrorCode::kBadOption) << epsilon;
    TriangleMesh wrong = mesh;
    wrong.triangles[0][1] = 1000;
    EXPECT_EQ(code(wrong, 0.1, act), ErrorCode::kIndexOutOfRange);
  }
}

TEST(HacdPartition, SingleTriangle) {
  EXPECT_EQ(partition(test_shapes::singleTriangle()), (std::vector<std::vector<int>>{{0}}));
}

TEST(HacdPartition, TriangleWithoutAreaDoesNoHarm) {
  TriangleMesh mesh = test_shapes::sheet();
  mesh.triangles.push_back({0, 1, 1});
  std::size_t count = 0;
  for (const auto& cluster : partition(mesh)) count += cluster.size();
  EXPECT_EQ(count, 3u);
}

TEST(HacdPartition, ConvexSurfacesAreOneCluster) {
  EXPECT_EQ(partition(test_shapes::sphere(1, 8)).size(), 1u);
  EXPECT_EQ(partition(test_shapes::box(1, 2, 3, 4)).size(), 1u);
  EXPECT_EQ(partition(test_shapes::sheet(1, 2, 6)).size(), 1u);
}

TEST(HacdPartition, FourSpheresAreFourClusters) {
  EXPECT_EQ(partition(test_shapes::fourSpheres()).size(), 4u);
}

TEST(HacdPartition, EveryTriangleIsInOneCluster) {
  const TriangleMesh mesh = test_shapes::flange();
  std::set<int> seen;
  std::size_t count = 0;
  for (const auto& cluster : partition(mesh)) {
    count += cluster.size();
    seen.insert(cluster.begin(), cluster.end());
  }
  EXPECT_EQ(count, mesh.triangles.size());
  EXPECT_EQ(seen.size(), mesh.triangles.size());
}

TEST(HacdPartition, EndsWhenNoEdgeGivesAConcavityBelowEpsilon) {
  const TriangleMesh mesh = test_shapes::torus(1, 0.3, 20, 10);
  const double epsilon = kShare * diagonal(mesh);
  const auto clusters = hacdPartition(mesh, epsilon);
  std::vector<int> cluster_of(mesh.triangles.size());
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    EXPECT_LE(concavity(mesh, clusters[k]), epsilon * (1 + 1e-9));
    for (int t : clusters[k]) cluster_of[static_cast<std::size_t>(t)] = static_cast<int>(k);
  }
  std::set<std::pair<int, int>> neighbours;
  for (const DualEdge& edge : dualGraph(mesh)) {
    const int a = cluster_of[static_cast<std::size_t>(edge.v)], b = cluster_of[static_cast<std::size_t>(edge.w)];
    if (a != b) neighbours.emplace(std::min(a, b), std::max(a, b));
  }
  EXPECT_FALSE(neighbours.empty());
  for (const auto& [a, b] : neighbours) {
    std::vector<int> both = clusters[static_cast<std::size_t>(a)];
    both.insert(both.end(), clusters[static_cast<std::size_t>(b)].begin(), clusters[static_cast<std::size_t>(b)].end());
    EXPECT_GT(concavity(mesh, both), epsilon);
  }
}

/// The decimation as in the paper: every cost is computed from scratch before every collapse.
std::vector<std::vector<int>> eagerPartition(const TriangleMesh& mesh, double epsilon) {
  const double d = diagonal(mesh), alpha = shapeWeight(epsilon, d);
  std::vector<std::vector<int>> clusters;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) clusters.push_back({static_cast<int>(t)});
  const std::vector<DualEdge> dual = dualGraph(mesh);
  for (;;) {
    double least = std::numeric_limits<double>::infinity();
    std::vector<int> best;
    std::size_t from = 0, into = 0;
    std::vector<std::size_t> of(mesh.triangles.size());
    for (std::size_t k = 0; k < clusters.size(); ++k)
      for (int t : clusters[k]) of[static_cast<std::size_t>(t)] = k;
    for (const DualEdge& edge : dual) {
      const std::size_t a = of[static_cast<std::size_t>(edge.v)], b = of[static_cast<std::size_t>(edge.w)];
      if (a == b) continue;
      std::vector<int> both = clusters[a];
      both.insert(both.end(), clusters[b].begin(), clusters[b].end());
      const double c = concavity(mesh, both);
      if (c > epsilon) continue;
      double perimeter = 0, area_sum = 0;
      std::set<int> members(both.begin(), both.end());
      for (int t : both) {
        for (int k = 0; k < 3; ++k) perimeter += (mesh.corner(t, k) - mesh.corner(t, (k + 1) % 3)).norm();
        area_sum += (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)).norm() / 2;
      }
      for (const DualEdge& inner : dual)
        if (members.count(inner.v) && members.count(inner.w)) perimeter -= 2 * inner.border;
      const double cost = decimationCost(c, d, alpha, aspectRatio(std::max(0.0, perimeter), area_sum));
      if (cost < least) least = cost, best = both, into = a, from = b;
    }
    if (best.empty()) break;
    clusters[into] = best;
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(from));
  }
  for (auto& cluster : clusters) std::sort(cluster.begin(), cluster.end());
  std::sort(clusters.begin(), clusters.end());
  return clusters;
}

TEST(HacdPartition, LazyEvaluationChangesNothing) {
  // Vertices are moved slightly so that no two costs are equal.
  for (TriangleMesh mesh : {test_shapes::lBracket(), test_shapes::uChannel(), test_shapes::openBox(), test_shapes::torus(1, 0.4, 7, 5)}) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      mesh.vertices[i] += 0.01 * Eigen::Vector3d(std::sin(1.0 + 7.0 * i), std::sin(2.0 + 11.0 * i), std::sin(3.0 + 13.0 * i));
    EXPECT_EQ(partition(mesh), eagerPartition(mesh, kShare * diagonal(mesh)));
  }
}

TEST(HacdSegmentation, CutAtEpsilonIsThePartition) {
  for (const TriangleMesh& mesh : {test_shapes::torus(1, 0.3, 20, 10), test_shapes::openBox(), test_shapes::fourSpheres()}) {
    const double epsilon = kShare * diagonal(mesh);
    const Segmentation segmentation = hacdSegmentation(mesh, epsilon);
    EXPECT_EQ(segmentation.clusters, hacdPartition(mesh, epsilon));
    EXPECT_EQ(clustersAt(segmentation, epsilon), segmentation.clusters.size());
  }
}

TEST(HacdSegmentation, EndsWithAClusterForEachConnectedPiece) {
  const auto atTheEnd = [](const TriangleMesh& mesh) {
    return clustersAt(hacdSegmentation(mesh, kShare * diagonal(mesh)), std::numeric_limits<double>::infinity());
  };
  EXPECT_EQ(atTheEnd(test_shapes::torus(1, 0.3, 12, 8)), 1u);
  EXPECT_EQ(atTheEnd(test_shapes::openBox()), 1u);
  TriangleMesh two = test_shapes::box(1, 1, 1), other = test_shapes::box(1, 1, 1);
  for (Eigen::Vector3d& v : other.vertices) v.x() += 5;
  for (const Triangle& t : other.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  EXPECT_EQ(atTheEnd(two), 2u);
}

TEST(HacdSegmentation, MergesAreTheConcavitiesOfTheHierarchysClusters) {
  const TriangleMesh mesh = test_shapes::torus(1, 0.3, 16, 8);
  const Segmentation segmentation = hacdSegmentation(mesh, kShare * diagonal(mesh));
  EXPECT_EQ(segmentation.merges.size() + 1, mesh.triangles.size());
  EXPECT_TRUE(std::is_sorted(segmentation.merges.begin(), segmentation.merges.end()));
  std::vector<int> all(mesh.triangles.size());
  for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
  EXPECT_NEAR(segmentation.merges.back(), concavity(mesh, all), 1e-6 * diagonal(mesh));
}

TEST(PapersWeakness, LBracketIsTwoHullsWithinEpsilon) {
  const TriangleMesh mesh = test_shapes::lBracket();
  EXPECT_EQ(hulls(mesh).size(), 2u);
  const auto outside = [](const Eigen::Vector3d& p) { return p.x() > 0.1 + 1e-6 && p.y() > 0.1 + 1e-6; };
  EXPECT_LT(sampledProtrusion(mesh, outside), 0.03 * diagonal(mesh));
}

TEST(PapersWeakness, UChannelsGapIsFilled) {
  // The end faces are flat bands without concavity, but their hulls span the gap: up to half its width from the surface.
  const TriangleMesh mesh = test_shapes::uChannel(1, 1, 0.1, 2);
  EXPECT_EQ(hulls(mesh).size(), 4u);
  const auto outside = [](const Eigen::Vector3d& p) { return p.x() > 0.1 && p.x() < 0.9 && p.y() > 0.1; };
  EXPECT_GT(sampledProtrusion(mesh, outside), 0.35);
  EXPECT_GT(sampledProtrusion(mesh, outside), 3 * kShare * diagonal(mesh));
}

TEST(PapersWeakness, ASmallerEpsilonDoesNotHelp) {
  for (const TriangleMesh& mesh : {test_shapes::uChannel(), test_shapes::openBox()}) EXPECT_EQ(partition(mesh, 0.001), partition(mesh));
}

TEST(PapersWeakness, OpenBoxIsFilled) {
  const TriangleMesh mesh = test_shapes::openBox();
  EXPECT_EQ(hulls(mesh).size(), 6u);
  const auto outside = [](const Eigen::Vector3d& p) {
    return p.x() > 0.05 && p.x() < 0.95 && p.y() > 0.05 && p.y() < 0.95 && p.z() > 0.05;
  };
  EXPECT_GT(sampledProtrusion(mesh, outside), 3 * kShare * diagonal(mesh));
}

TEST(HacdPartition, DoesNotDependOnScaleOrPosition) {
  const TriangleMesh mesh = test_shapes::flange(5);
  TriangleMesh far = mesh;
  for (Eigen::Vector3d& v : far.vertices) v = 1e-3 * v + Eigen::Vector3d(1, -2, 0.5);
  EXPECT_NEAR(static_cast<double>(partition(mesh).size()), static_cast<double>(partition(far).size()), 3);
}

TEST(HacdPartition, SameInputGivesSameResult) {
  const TriangleMesh mesh = test_shapes::torus();
  EXPECT_EQ(partition(mesh), partition(mesh));
}

TEST(HacdPartition, ProgressRisesFromZeroToOne) {
  RunControl control;
  double last = 0;
  bool rising = true;
  control.progress = [&](double fraction) {
    rising = rising && fraction >= last && fraction <= 1;
    last = fraction;
  };
  const TriangleMesh mesh = test_shapes::sphere(1, 5);
  hacdPartition(mesh, kShare * diagonal(mesh), control);
  EXPECT_TRUE(rising);
  EXPECT_EQ(last, 1);
  last = 0;
  hacdSegmentation(mesh, kShare * diagonal(mesh), control);
  EXPECT_TRUE(rising);
  EXPECT_EQ(last, 1);
}

TEST(HacdPartition, CanBeCancelledHalfway) {
  RunControl control;
  control.progress = [&](double fraction) {
    if (fraction > 0.5) control.cancel();
  };
  const TriangleMesh mesh = test_shapes::sphere(1, 10);
  try {
    hacdPartition(mesh, kShare * diagonal(mesh), control);
    FAIL() << "was not cancelled";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

}  // namespace
}  // namespace collision_hulls
