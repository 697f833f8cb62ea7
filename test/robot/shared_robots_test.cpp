// Real robots, where they are at hand.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "base/run_program.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/robot_tests.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

std::vector<std::string> sharedRobots() {
  std::vector<std::string> found;
  std::error_code missing;
  for (const auto& package : fs::directory_iterator(SHARED_DATA "/robots", missing)) {
    for (const std::string& file : robotDescriptionsIn(package.path().string())) found.push_back(file);
  }
  return found;
}

class SharedRobots : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { robot_ = readRobotDescription(GetParam()); }

  // Two elements for each mesh of the source, at its origin.
  std::map<std::string, LinkCollisions> twoForEach(Source from) const {
    std::map<std::string, LinkCollisions> links;
    for (const LinkDescription& link : robot_.links) {
      const SourceElements source = sourceElements(link, from);
      LinkCollisions& written = links[link.name];
      written.keep_primitives = !source.visual;
      for (GeometryElement element : source.elements) {
        if (element.kind != GeometryElement::Kind::kMesh) continue;
        element.uri = "package://out/x.stl";
        for (int i = 0; i < 2; ++i) written.elements.push_back({link.name, element});
      }
    }
    return links;
  }

  RobotDescription robot_;
};

TEST_P(SharedRobots, EveryMeshIsFoundWithoutRos) {
  const ScopedVariable path("ROS_PACKAGE_PATH", ""), prefix("CMAKE_PREFIX_PATH", "");
  const PackageFinder finder = defaultPackageFinder(robot_.path);
  std::size_t meshes = 0;
  for (const LinkDescription& link : robot_.links) {
    for (const auto* elements : {&link.visuals, &link.collisions}) {
      for (const GeometryElement& element : *elements) {
        if (element.kind != GeometryElement::Kind::kMesh) continue;
        EXPECT_NO_THROW(resolveUri(element.uri, robot_.path, finder)) << element.uri;
        ++meshes;
      }
    }
  }
  EXPECT_GE(meshes, 10u);
}

TEST_P(SharedRobots, RewritingDiffersInCollisionsAlone) {
  for (const Source source : {Source::kAuto, Source::kVisual, Source::kCollision}) {
    const std::string result = rewriteCollisions(robot_, twoForEach(source));
    EXPECT_NE(result, robot_.text);
    EXPECT_EQ(withoutCollisions(result), withoutCollisions(robot_.text));
  }
}

TEST_P(SharedRobots, NewElementsStandWhereTheOldOnesDid) {
  const RobotDescription after = parseRobotDescription(rewriteCollisions(robot_, twoForEach(Source::kAuto)));
  std::set<std::string> names;
  for (std::size_t i = 0; i < robot_.links.size(); ++i) {
    const SourceElements source = sourceElements(robot_.links[i], Source::kAuto);
    std::vector<Eigen::Isometry3d> expected, found;
    for (const GeometryElement& element : source.elements) {
      if (element.kind == GeometryElement::Kind::kMesh) expected.insert(expected.end(), 2, element.origin);
    }
    for (const GeometryElement& element : after.links[i].collisions) {
      if (element.kind != GeometryElement::Kind::kMesh) continue;
      found.push_back(element.origin);
      EXPECT_TRUE(names.insert(element.name).second) << element.name;
    }
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k].matrix(), expected[k].matrix()) << robot_.links[i].name;
  }
}

TEST_P(SharedRobots, CheckUrdfAcceptsTheResult) {
  const TemporaryFolder folder;
  const std::string file = folder.write("out.urdf", rewriteCollisions(robot_, twoForEach(Source::kAuto)));
  const auto check = runProgram({"check_urdf", file});
  if (!check) GTEST_SKIP() << "check_urdf is not installed";
  EXPECT_EQ(check->status, 0) << check->errors;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SharedRobots);
INSTANTIATE_TEST_SUITE_P(Files, SharedRobots, testing::ValuesIn(sharedRobots()),
                         [](const auto& robot) { return fs::path(robot.param).stem().string(); });

}  // namespace
}  // namespace collision_hulls
