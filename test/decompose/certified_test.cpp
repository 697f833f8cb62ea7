#include "collision_hulls/decompose/certified.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_hulls/check/measures.h"
#include "collision_hulls/decompose/fit_cover.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using test_shapes::RandomPoints;

constexpr double kGap = 0.001;  // of the tolerance: between the bounds of a protrusion

DecomposeOptions within(double tolerance, Effort effort = Effort::kQuick, int max_vertices = 64) {
  DecomposeOptions options;
  options.method = Method::kCertified;
  options.tolerance = tolerance;
  options.effort = effort;
  options.max_vertices = max_vertices;
  return options;
}

double sizeOf(const RepairedMesh& mesh) {
  Eigen::AlignedBox3d box = boundingBox(mesh.mesh);
  for (const Eigen::Vector3d& p : mesh.loose) box.extend(p);
  return box.diagonal().norm() + box.center().norm();
}

/// The surface as triangles of which loose points are some.
TriangleMesh surfaceOf(const RepairedMesh& mesh) {
  TriangleMesh all = mesh.mesh;
  for (const Eigen::Vector3d& p : mesh.loose) {
    const int i = static_cast<int>(all.vertices.size());
    all.vertices.push_back(p);
    all.triangles.push_back({i, i, i});
  }
  return all;
}

/// As decompose.h and fit_cover.h promise: the hulls cover, as they are up to rounding and as they are written without any doubt.
FittedHulls expectCovers(const RepairedMesh& mesh, const std::vector<ConvexHull>& hulls, int max_vertices = 0) {
  const TriangleMesh all = surfaceOf(mesh);
  EXPECT_LE(uncovered(all, hulls), 1e-12 * sizeOf(mesh));
  const FittedHulls fitted = fitCover(hulls, all, 0, max_vertices);
  EXPECT_EQ(uncovered(all, fitted.hulls), 0);
  EXPECT_EQ(fitted.completed, 0u);
  return fitted;
}

Decomposition checked(const TriangleMesh& mesh, const DecomposeOptions& options) {
  const RepairedMesh repaired = repair(mesh);
  Decomposition result = certified(repaired, options);
  const FittedHulls fitted = expectCovers(repaired, result.hulls, options.max_vertices);
  EXPECT_LE(protrusion(fitted.hulls, Solid(repaired), kGap * options.tolerance).bound, options.tolerance);
  for (const ConvexHull& hull : result.hulls)
    EXPECT_TRUE(options.max_vertices == 0 || hull.vertices.size() <= static_cast<std::size_t>(options.max_vertices));
  EXPECT_FALSE(result.capped);
  return result;
}

std::size_t count(const TriangleMesh& mesh, double share, Effort effort = Effort::kQuick) {
  return checked(mesh, within(share * diagonal(mesh), effort)).hulls.size();
}

TriangleMesh rotated(const TriangleMesh& mesh, const Eigen::Matrix3d& rotation) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  return transformed(mesh, pose);
}

/// A quarter of a ring, with its bore, as a closed surface.
TriangleMesh bentTube(int around = 12, int across = 10, double ring = 1, double outer = 0.3, double inner = 0.22) {
  const auto at = [&](double tube, int i, int j) {
    const double a = test_shapes::kPi / 2 * i / around, b = 2 * test_shapes::kPi * (j % across) / across;
    const double r = ring + tube * std::cos(b);
    return Eigen::Vector3d(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
  };
  test_shapes::MeshBuilder builder;
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < around; ++i) {
      builder.quad(at(outer, i, j), at(outer, i + 1, j), at(outer, i + 1, j + 1), at(outer, i, j + 1));
      builder.quad(at(inner, i, j), at(inner, i, j + 1), at(inner, i + 1, j + 1), at(inner, i + 1, j));
    }
    builder.quad(at(inner, 0, j), at(outer, 0, j), at(outer, 0, j + 1), at(inner, 0, j + 1));
    builder.quad(at(outer, around, j), at(inner, around, j), at(inner, around, j + 1), at(outer, around, j + 1));
  }
  return builder.mesh();
}

/// A square frame and a wall on it: an L with a hole.
TriangleMesh bracketWithHole() {
  const std::vector<Eigen::Vector2d> outer{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, hole{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
  const auto at = [](const Eigen::Vector2d& p, double z) { return Eigen::Vector3d(p.x(), p.y(), z); };
  test_shapes::MeshBuilder builder;
  const double t = 0.1;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    builder.quad(at(outer[i], t), at(outer[j], t), at(hole[j], t), at(hole[i], t));
    builder.quad(at(outer[j], 0), at(outer[i], 0), at(hole[i], 0), at(hole[j], 0));
    builder.quad(at(outer[i], 0), at(outer[j], 0), at(outer[j], t), at(outer[i], t));
    builder.quad(at(hole[j], 0), at(hole[i], 0), at(hole[i], t), at(hole[j], t));
  }
  return test_shapes::merged({builder.mesh(), test_shapes::moved(test_shapes::box(1, t, 0.6), {0, 0, t})});
}

void expectEqual(const std::vector<ConvexHull>& a, const std::vector<ConvexHull>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t h = 0; h < a.size(); ++h) {
    EXPECT_EQ(a[h].vertices, b[h].vertices);
    EXPECT_EQ(a[h].triangles, b[h].triangles);
  }
}

// Degenerate input.

TEST(Certified, SingleTriangleAndFlatMesh) {
  const TriangleMesh l_shape{{{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}, {0.1, 0.1, 0}, {0.1, 1, 0}, {0, 1, 0}},
                             {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 5}}, {{3, 4, 5}}}};
  for (Effort effort : {Effort::kQuick, Effort::kBest}) {
    EXPECT_EQ(count(test_shapes::singleTriangle(), 0.01, effort), 1u);
    EXPECT_EQ(count(test_shapes::sheet(1, 2, 3), 0.01, effort), 1u);
  }
  EXPECT_EQ(count(l_shape, 0.05), 2u);
}

TEST(Certified, LoosePointsOnly) {
  RepairedMesh mesh;
  mesh.loose = {{0, 0, 0}, {0.01, 0, 0}, {5, 0, 0}, {5, 0.01, 0}, {0, 0, 7}};
  for (Effort effort : {Effort::kQuick, Effort::kBest}) {
    const Decomposition result = certified(mesh, within(0.1, effort));
    EXPECT_EQ(result.hulls.size(), 3u);
    expectCovers(mesh, result.hulls);
  }
  mesh.loose = {{1, 2, 3}};
  expectCovers(mesh, certified(mesh, within(0.1)).hulls);
}

TEST(Certified, OpenAndOverlappingSurfaces) {
  RandomPoints random(11);
  count(test_shapes::boxWithWindow(), 0.03);
  count(random.soup(4), 0.03);
  const TriangleMesh box = test_shapes::box(1, 1, 1);
  EXPECT_EQ(count(test_shapes::merged({box, box}), 0.02), 1u);
  EXPECT_EQ(count(test_shapes::merged({box, test_shapes::moved(box, {0.5, 0, 0})}), 0.02), 1u);
}

// Closed-form counts.

TEST(Certified, ConvexInputIsOneHull) {
  RandomPoints random(3);
  for (Effort effort : {Effort::kQuick, Effort::kBest}) {
    EXPECT_EQ(count(test_shapes::box(1, 2, 3), 0.01, effort), 1u);
    EXPECT_EQ(count(test_shapes::box(1, 1, 0.001, 2), 0.01, effort), 1u);
    EXPECT_EQ(count(surface(convexHull(random.cloud(30))), 0.01, effort), 1u);
    EXPECT_EQ(count(test_shapes::sphere(1, 4), 0.05, effort), 1u);
  }
}

TEST(Certified, WallsAreOneHullEach) {
  for (Effort effort : {Effort::kQuick, Effort::kBest}) {
    SCOPED_TRACE(name(effort));
    for (double share : {0.01, 0.02}) {
      EXPECT_EQ(count(test_shapes::lBracket(), share, effort), 2u) << share;
      EXPECT_EQ(count(test_shapes::uChannel(), share, effort), 3u) << share;
    }
    EXPECT_EQ(count(test_shapes::openBox(), 0.01, effort), 5u);
  }
  EXPECT_EQ(count(test_shapes::openBox(1, 1, 1, 0.05, 2), 0.02, Effort::kBest), 5u);
}

TEST(Certified, PartsThatAreFarApartAreOneHullEach) {
  EXPECT_EQ(count(test_shapes::fourSpheres(), 0.02), 4u);
}

TEST(Certified, FarFromTheOriginIsTheSame) {
  const TriangleMesh mesh = test_shapes::uChannel();
  EXPECT_EQ(count(test_shapes::moved(mesh, {1000, -2000, 500}), 0.02), 3u);
}

TEST(Certified, APocketBehindANarrowNeckIsNotFilled) {
  const TriangleMesh mesh = test_shapes::flask();
  EXPECT_GT(checked(mesh, within(0.5)).hulls.size(), 1u);
  EXPECT_EQ(checked(mesh, within(1.1)).hulls.size(), 1u);
}

TEST(Certified, FilledHullsHoldTheInside) {
  const TriangleMesh mesh = test_shapes::flask();
  const Solid solid(repair(mesh));
  DecomposeOptions options = within(0.05 * diagonal(mesh));
  EXPECT_LT(coveredShare(checked(mesh, options).hulls, solid), 1) << "else there is nothing to fill";
  options.fill = true;
  for (Effort effort : {Effort::kQuick, Effort::kBest}) {
    options.effort = effort;
    EXPECT_EQ(coveredShare(checked(mesh, options).hulls, solid), 1);
  }
}

// The promise.

TEST(Certified, CoversWithinTheTolerance) {
  for (const TriangleMesh& mesh :
       {test_shapes::torus(1, 0.3, 8, 6), bentTube(4, 6), bracketWithHole(), test_shapes::flange(3, 0.4, 1, 0.12, 0.15, 2, 1)})
    for (double share : {0.05, 0.02, 0.01})
      for (int max_vertices : {0, 64}) {
        SCOPED_TRACE(testing::Message() << mesh.triangles.size() << " triangles, " << share << ", " << max_vertices);
        checked(mesh, within(share * diagonal(mesh), Effort::kQuick, max_vertices));
      }
}

TEST(Certified, FewVerticesStillCoverWithinTheTolerance) {
  for (int max_vertices : {8, 16}) {
    const TriangleMesh mesh = bentTube();
    checked(mesh, within(0.04 * diagonal(mesh), Effort::kQuick, max_vertices));
  }
}

TEST(Certified, BestNeedsNoMoreHullsThanQuick) {
  for (const TriangleMesh& mesh : {test_shapes::torus(1, 0.3, 12, 8), bentTube(8, 8), bracketWithHole()}) {
    SCOPED_TRACE(testing::Message() << mesh.triangles.size() << " triangles");
    EXPECT_LE(count(mesh, 0.03, Effort::kBest), count(mesh, 0.03, Effort::kQuick));
  }
}

TEST(Certified, MoreToleranceNeedsNoMoreHulls) {
  const TriangleMesh mesh = bracketWithHole();
  EXPECT_LE(count(mesh, 0.05), count(mesh, 0.01));
}

TEST(Certified, RotationChangesTheCountLittle) {
  RandomPoints random(5);
  const TriangleMesh mesh = bracketWithHole();
  const double still = static_cast<double>(count(mesh, 0.04));
  for (int i = 0; i < 2; ++i) {
    const TriangleMesh turned_mesh = rotated(mesh, random.rotation());
    const double turned = static_cast<double>(checked(turned_mesh, within(0.04 * diagonal(mesh))).hulls.size());
    EXPECT_LE(std::abs(turned - still), std::max(1.0, 0.25 * still));
  }
}

// How it runs.

TEST(Certified, SameInputSameBytesWhateverTheThreads) {
  const RepairedMesh mesh = repair(bentTube(8, 8));
  for (Effort effort : {Effort::kQuick, Effort::kBest}) {
    const DecomposeOptions options = within(0.1, effort);
    const Decomposition first = certified(mesh, options);
    for (std::size_t threads : {1, 2}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      expectEqual(certified(mesh, options).hulls, first.hulls);
    }
  }
}

TEST(Certified, MaxHullsCapsAndSaysSo) {
  const TriangleMesh mesh = test_shapes::openBox();
  const RepairedMesh repaired = repair(mesh);
  DecomposeOptions options = within(0.01 * diagonal(mesh));
  for (int cap : {2, 5}) {
    options.max_hulls = cap;
    const Decomposition result = certified(repaired, options);
    EXPECT_LE(result.hulls.size(), static_cast<std::size_t>(cap));
    EXPECT_EQ(result.capped, cap < 5);
    expectCovers(repaired, result.hulls, 64);
  }
}

TEST(Certified, CancelledAtAnyShare) {
  const RepairedMesh mesh = repair(test_shapes::torus(1, 0.3, 16, 8));
  for (double share : {0.0, 0.3, 0.8}) {
    RunControl control;
    control.progress = [&](double done) {
      if (done >= share) control.cancel();
    };
    try {
      certified(mesh, within(0.1, Effort::kBest), control);
      FAIL() << share;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kCancelled);
    }
  }
}

// The tree of hulls.

TEST(HullTree, RefusesWhatItCannotUse) {
  const auto code = [](const RepairedMesh& mesh, double tolerance) {
    try {
      hullTree(mesh, within(tolerance));
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  EXPECT_EQ(code({}, 1), ErrorCode::kEmptyMesh);
  const RepairedMesh box = repair(test_shapes::box(1, 1, 1));
  for (double tolerance : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(code(box, tolerance), ErrorCode::kBadOption);
}

/// Children before parents, each with one parent, bounds that never fall on the way up, the root last.
void expectSound(const HullTree& tree) {
  const int size = static_cast<int>(tree.nodes.size());
  for (int i = 0; i < size; ++i) {
    const HullNode& node = tree.nodes[static_cast<std::size_t>(i)];
    EXPECT_EQ(node.parent < 0, i == size - 1);
    EXPECT_TRUE(node.parent < 0 || (node.parent > i && node.parent < size));
    EXPECT_EQ(node.left < 0, node.right < 0);
    EXPECT_TRUE(node.left < 0 || node.left != node.right);
    for (int child : {node.left, node.right}) {
      if (child < 0) continue;
      ASSERT_LT(child, i);
      const HullNode& below = tree.nodes[static_cast<std::size_t>(child)];
      EXPECT_EQ(below.parent, i);
      EXPECT_LE(below.protrusion, node.protrusion);
      for (const Eigen::Vector3d& v : below.hull.vertices) EXPECT_LE(planeDistance(node.hull, v), 1e-9);
    }
  }
}

double furthest(const HullTree& tree, const std::vector<int>& cut) {
  double most = 0;
  for (int id : cut) most = std::max(most, tree.nodes[static_cast<std::size_t>(id)].protrusion);
  return most;
}

class HullTreeOfBentTube : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    mesh_ = new RepairedMesh(repair(bentTube()));
    tree_ = new HullTree(hullTree(*mesh_, within(kTolerance)));
  }
  static void TearDownTestSuite() {
    delete mesh_;
    delete tree_;
  }
  static constexpr double kTolerance = 0.05;
  static const RepairedMesh* mesh_;
  static const HullTree* tree_;
};
const RepairedMesh* HullTreeOfBentTube::mesh_ = nullptr;
const HullTree* HullTreeOfBentTube::tree_ = nullptr;

TEST_F(HullTreeOfBentTube, IsSound) {
  EXPECT_GT(tree_->nodes.size(), 10u);
  EXPECT_EQ(tree_->tolerance, kTolerance);
  expectSound(*tree_);
  for (const Eigen::Vector3d& v : mesh_->mesh.vertices) EXPECT_LE(planeDistance(tree_->nodes.back().hull, v), 1e-9);
}

TEST_F(HullTreeOfBentTube, BoundsAreProven) {
  const Solid solid(*mesh_);
  for (const HullNode& node : tree_->nodes) {
    const double found = protrusion({node.hull}, solid, kGap * kTolerance).found;
    EXPECT_LE(found, node.protrusion);
    EXPECT_TRUE(node.left >= 0 || node.protrusion <= 1.02 * kTolerance) << node.protrusion;
  }
}

TEST_F(HullTreeOfBentTube, CutsCover) {
  for (double tolerance : {0.0, 0.05, 0.1, 0.2, 0.5, 10.0}) {
    const std::vector<int> cut = tree_->cutAt(tolerance);
    EXPECT_TRUE(tree_->isCut(cut));
    EXPECT_TRUE(tolerance < 0.1 || furthest(*tree_, cut) <= tolerance);
    expectCovers(*mesh_, tree_->hullsOf(cut));
  }
  EXPECT_EQ(tree_->cutAt(10).size(), 1u);
}

TEST_F(HullTreeOfBentTube, CutToSoMany) {
  const std::size_t leaves = (tree_->nodes.size() + 1) / 2;
  double last = std::numeric_limits<double>::infinity();
  for (std::size_t most = 1; most <= leaves + 1; ++most) {
    const std::vector<int> cut = tree_->cutTo(static_cast<int>(most));
    EXPECT_TRUE(tree_->isCut(cut));
    EXPECT_EQ(cut.size(), std::min(most, leaves));
    EXPECT_LE(furthest(*tree_, cut), last);
    last = furthest(*tree_, cut);
  }
}

TEST_F(HullTreeOfBentTube, RandomCutsCover) {
  RandomPoints random(17);
  for (int i = 0; i < 100; ++i) {
    std::vector<int> cut, open{static_cast<int>(tree_->nodes.size()) - 1};
    while (!open.empty()) {
      const int id = open.back();
      open.pop_back();
      const HullNode& node = tree_->nodes[static_cast<std::size_t>(id)];
      if (node.left < 0 || random.number(0, 1) < 0.3)
        cut.push_back(id);
      else
        open.insert(open.end(), {node.left, node.right});
    }
    std::sort(cut.begin(), cut.end());
    EXPECT_TRUE(tree_->isCut(cut));
    EXPECT_LE(uncovered(mesh_->mesh, tree_->hullsOf(cut)), 1e-12 * sizeOf(*mesh_)) << "cut " << i;
    const std::size_t left_out = static_cast<std::size_t>(random.index(cut.size()));
    cut.erase(cut.begin() + static_cast<std::ptrdiff_t>(left_out));
    EXPECT_FALSE(tree_->isCut(cut));
  }
}

TEST_F(HullTreeOfBentTube, IsTheSameAgain) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const HullTree again = hullTree(*mesh_, within(kTolerance));
  ASSERT_EQ(again.nodes.size(), tree_->nodes.size());
  for (std::size_t i = 0; i < again.nodes.size(); ++i) {
    EXPECT_EQ(again.nodes[i].hull.vertices, tree_->nodes[i].hull.vertices);
    EXPECT_EQ(again.nodes[i].protrusion, tree_->nodes[i].protrusion);
    EXPECT_EQ(again.nodes[i].parent, tree_->nodes[i].parent);
  }
}

TEST(HullTree, OfDegenerateInput) {
  RepairedMesh points;
  points.loose = {{0, 0, 0}, {0.01, 0, 0}, {5, 0, 0}, {0, 0, 7}};
  const HullTree tree = hullTree(points, within(0.1));
  expectSound(tree);
  EXPECT_EQ(tree.nodes.size(), 5u);
  expectCovers(points, {tree.nodes.back().hull});
  const HullTree flat = hullTree(repair(test_shapes::sheet()), within(0.01));
  EXPECT_EQ(flat.nodes.size(), 1u);
  EXPECT_EQ(flat.cutAt(0), std::vector<int>{0});
  EXPECT_TRUE(HullTree{}.cutAt(1).empty());
  EXPECT_TRUE(HullTree{}.cutTo(1).empty());
}

TEST(HullTree, FarPartsAreMergedAtLast) {
  const RepairedMesh mesh = repair(test_shapes::fourSpheres(2));
  const HullTree tree = hullTree(mesh, within(0.1));
  expectSound(tree);
  EXPECT_EQ(tree.cutTo(4).size(), 4u);
  const double found = protrusion({tree.nodes.back().hull}, Solid(mesh), 0.01).found;
  EXPECT_GE(tree.nodes.back().protrusion, found);
  EXPECT_LE(tree.nodes.back().protrusion, 1.05 * found);
}

}  // namespace
}  // namespace collision_hulls
