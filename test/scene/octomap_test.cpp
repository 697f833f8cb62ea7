// Maps built node by node, so that the expected boxes are known.
#include "collision_hulls/scene/octomap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "collision_hulls/error.h"
#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

using Boxes = std::vector<Eigen::AlignedBox3d>;

/// A binary node; per child: 0 unknown, 1 free, 2 occupied, 3 has children.
std::string node(std::initializer_list<unsigned> children) {
  unsigned bits = 0, shift = 0;
  for (const unsigned kind : children) bits |= kind << shift, shift += 2;
  return {static_cast<char>(bits & 255), static_cast<char>(bits >> 8)};
}

/// A full node.
std::string node(float log_odds, unsigned children, std::size_t beyond_value = 0) {
  std::string bytes(sizeof log_odds, '\0');
  std::memcpy(&bytes[0], &log_odds, sizeof log_odds);
  return bytes + std::string(beyond_value, 'x') + static_cast<char>(children);
}

/// Nodes from the root down to the eight smallest cells that start at the map's middle, followed by `cells`.
std::string downToTheMiddle(const std::string& cells) {
  std::string data = node({0, 0, 0, 0, 0, 0, 0, 3});
  for (int level = 14; level > 0; --level) data += node({3});
  return data + cells;
}

ErrorCode errorOf(const Octomap& map) {
  try {
    occupiedBoxes(map);
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return ErrorCode::kInternal;
}

void expectBox(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  EXPECT_TRUE(box.min().isApprox(low, 1e-12)) << box.min().transpose();
  EXPECT_TRUE(box.max().isApprox(high, 1e-12)) << box.max().transpose();
}

TEST(Octomap, RejectsDamagedMaps) {
  EXPECT_EQ(errorOf({true, "OcTree", 0, ""}), ErrorCode::kBadScene);
  EXPECT_EQ(errorOf({true, "OcTree", -0.1, ""}), ErrorCode::kBadScene);
  EXPECT_EQ(errorOf({true, "OcTree", std::numeric_limits<double>::quiet_NaN(), ""}), ErrorCode::kBadScene);
  EXPECT_EQ(errorOf({true, "OcTreeStamped", 0.1, ""}), ErrorCode::kBadScene);
  EXPECT_EQ(errorOf({true, "OcTree", 0.1, "x"}), ErrorCode::kBadScene);
  EXPECT_EQ(errorOf({false, "OcTree", 0.1, "1234"}), ErrorCode::kBadScene);
  const std::string good = node({2});
  EXPECT_EQ(errorOf({true, "OcTree", 0.1, good + "x"}), ErrorCode::kBadScene);
  EXPECT_EQ(errorOf({true, "OcTree", 0.1, std::string(2000, '\xff')}), ErrorCode::kBadScene);  // endless children
  EXPECT_EQ(errorOf({false, "OcTree", 0.1, std::string(2000, '\xff')}), ErrorCode::kBadScene);
}

TEST(Octomap, NothingOccupied) {
  EXPECT_TRUE(occupiedBoxes({true, "OcTree", 0.1, ""}).empty());
  EXPECT_TRUE(occupiedBoxes({true, "OcTree", 0.1, node({1, 0, 1})}).empty());
}

TEST(Octomap, OneCell) {
  const Boxes boxes = occupiedBoxes({true, "OcTree", 0.1, downToTheMiddle(node({0, 0, 0, 0, 2}))});
  ASSERT_EQ(boxes.size(), 1u);
  expectBox(boxes[0], {0, 0, 0.1}, {0.1, 0.1, 0.2});
}

TEST(Octomap, MergesCellsThatFormABox) {
  const Boxes plate = occupiedBoxes({true, "OcTree", 0.5, downToTheMiddle(node({2, 2, 2, 2, 1}))});
  ASSERT_EQ(plate.size(), 1u);
  expectBox(plate[0], {0, 0, 0}, {1, 1, 0.5});
  EXPECT_EQ(occupiedBoxes({true, "OcTree", 0.5, downToTheMiddle(node({2, 2, 2, 2, 2, 2, 2, 2}))}).size(), 1u);
  EXPECT_EQ(occupiedBoxes({true, "OcTree", 0.5, downToTheMiddle(node({2, 2, 2, 0, 0, 0, 0, 0}))}).size(), 2u);
  EXPECT_EQ(occupiedBoxes({true, "OcTree", 0.5, downToTheMiddle(node({2, 0, 0, 2, 0, 2, 2, 0}))}).size(), 4u);
}

TEST(Octomap, FullMapOfAHalfSpace) {
  // Children 0 to 3 are below the middle. Log-odds of 0 mean a probability of 0.5, which counts as occupied; inner nodes do not count.
  std::string data = node(3, 31);
  for (const float value : {0.0F, 1.0F, 0.5F, 3.5F, -0.5F}) data += node(value, 0);
  const Boxes boxes = occupiedBoxes({false, "OcTree", 1, data});
  ASSERT_EQ(boxes.size(), 1u);
  expectBox(boxes[0], {-32768, -32768, -32768}, {32768, 32768, 0});
}

TEST(Octomap, ANodeWithoutANumberIsDamage) {
  const auto with = [](float value) { return node(3, 1) + node(value, 0); };
  EXPECT_EQ(occupiedBoxes({false, "OcTree", 1, with(1)}).size(), 1u);
  EXPECT_EQ(errorOf({false, "OcTree", 1, with(std::nanf(""))}), ErrorCode::kBadScene);
}

/// A full tree of this many levels.
std::string fullTree(int levels) {
  if (levels == 0) return node(1.0F, 0);
  std::string bytes = node(0.0F, 255);
  for (int i = 0; i < 8; ++i) bytes += fullTree(levels - 1);
  return bytes;
}

TEST(Octomap, IsCancelled) {
  const std::string data = fullTree(5);
  RunControl control;
  EXPECT_EQ(occupiedBoxes({false, "OcTree", 1, data}, control).size(), 1u);
  control.cancel();
  try {
    occupiedBoxes({false, "OcTree", 1, data}, control);
    ADD_FAILURE() << "not cancelled";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

TEST(Octomap, IgnoresColours) {
  const std::string data = node(1, 129, 3) + node(1, 0, 3) + node(1, 0, 3);
  EXPECT_EQ(occupiedBoxes({false, "ColorOcTree", 1, data}).size(), 2u);
  EXPECT_EQ(errorOf({false, "OcTree", 1, data}), ErrorCode::kBadScene);
}

TEST(Octomap, PlacesBodiesAtThePose) {
  Scene scene;
  const Eigen::Isometry3d pose = Eigen::Translation3d(1, 0, 0) * Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitZ());
  addOctomap(scene, "map", {true, "OcTree", 0.1, downToTheMiddle(node({2, 0, 0, 0, 0, 0, 0, 2}))}, pose);
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[0].name, "map/1");
  collision_hulls::expectBox(scene.bodies[0], {0.9, 0, 0}, {1, 0.1, 0.1});
}

TEST(Octomap, File) {
  const TemporaryFolder folder;
  const std::string head = "# Octomap OcTree binary file\n# (feel free)\n#\nid OcTree\nsize 17\nres 0.1\ndata\n";
  const Scene scene = sceneOf(folder, "a.bt", head + downToTheMiddle(node({2})));
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.bodies[0].name, "octomap/1");
  EXPECT_EQ(scene.name, "a") << "as its file";
  EXPECT_EQ(sceneOf(folder, "a.ot", "# Octomap OcTree file\nid OcTree\nres 0.1\ndata\n" + node(1, 0)).bodies.size(), 1u);
  EXPECT_THROW(sceneOf(folder, "b.bt", "rubbish"), Error);
  EXPECT_THROW(sceneOf(folder, "c.bt", "# Octomap OcTree binary file\nid OcTree\nsize 1\ndata\n" + node({2})), Error);
  EXPECT_THROW(sceneOf(folder, "d.bt", "# Octomap OcTree binary file\nid OcTree\nres wide\ndata\n" + node({2})), Error);
  EXPECT_THROW(sceneOf(folder, "e.bt", head), Error);  // without geometry
}

}  // namespace
}  // namespace collision_hulls
