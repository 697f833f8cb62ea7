// The tree of hulls built by certified: well-formed, proven, and covering wherever it is cut.
#include "collision_hulls/decompose/hull_tree.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "counted_looks.h"
#include "decompose/certified/certified_cases.h"

namespace collision_hulls {
namespace {

using test_shapes::bentTube;
using test_shapes::expectCovers;
using test_shapes::kGap;
using test_shapes::RandomPoints;
using test_shapes::sizeOf;
using test_shapes::within;

TEST(HullTree, RejectsUnusableInput) {
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

TEST(HullTree, IgnoresTheMethod) {
  const RepairedMesh mesh = repair(test_shapes::box(1, 1, 1));
  DecomposeOptions options = within(0.1);
  options.fill = true;
  options.effort = Effort::kBest;
  const std::size_t nodes = hullTree(mesh, options).nodes.size();
  for (const Method method : {Method::kHacd, Method::kSingleHull, static_cast<Method>(99)}) {
    options.method = method;
    EXPECT_EQ(hullTree(mesh, options).nodes.size(), nodes);
    EXPECT_EQ(certified(mesh, options).hulls.size(), 1u);
    options.tolerance = 0;
    EXPECT_THROW(hullTree(mesh, options), Error);
    options.tolerance = 0.1;
  }
}

/// Children precede parents, each has one parent, bounds never decrease on the way up, and the root comes last.
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

TEST_F(HullTreeOfBentTube, IsWellFormed) {
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

TEST_F(HullTreeOfBentTube, CutsToAGivenNumber) {
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

TEST_F(HullTreeOfBentTube, RefusesCutsOfAnother) {
  for (const int node : {-1, static_cast<int>(tree_->nodes.size())}) {
    try {
      tree_->hullsOf({0, node});
      ADD_FAILURE() << node;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kIndexOutOfRange);
    }
  }
}

TEST(HullTree, ProgressEndsAtOne) {
  const TriangleMesh mesh = test_shapes::lBracket();
  RunControl control;
  double last = 0;
  control.progress = [&](double fraction) { last = fraction; };
  hullTree(repair(mesh), within(0.01 * diagonal(mesh)), control);
  EXPECT_EQ(last, 1);
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

TEST_F(HullTreeOfBentTube, IsDeterministic) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const HullTree again = hullTree(*mesh_, within(kTolerance));
  ASSERT_EQ(again.nodes.size(), tree_->nodes.size());
  for (std::size_t i = 0; i < again.nodes.size(); ++i) {
    EXPECT_EQ(again.nodes[i].hull.vertices, tree_->nodes[i].hull.vertices);
    EXPECT_EQ(again.nodes[i].protrusion, tree_->nodes[i].protrusion);
    EXPECT_EQ(again.nodes[i].parent, tree_->nodes[i].parent);
  }
}

TEST(HullTree, DegenerateInput) {
  RepairedMesh points;
  points.loose = test_shapes::loosePoints({{0, 0, 0}, {0.01, 0, 0}, {5, 0, 0}, {0, 0, 7}});
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

TEST(HullTree, BoundsWithATinyGapEnd) {
  const RepairedMesh mesh = repair(test_shapes::lBracket(0.2, 0.03, 0.1));
  const CountedLooks looks(10'000);  // where it is told to end
  const HullTree tree = hullTree(mesh, within(2e-6), looks.control());
  expectSound(tree);
  EXPECT_GE(tree.nodes.back().protrusion, protrusion({tree.nodes.back().hull}, Solid(mesh), 0.001).found);
}

TEST(HullTree, DistantPartsAreMergedInTheEnd) {
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
