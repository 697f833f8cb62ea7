#include "ros/preview/validation.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

/// Two links with the same box, 3 by 1 by 1 m, of which the second one's is half as large.
class ValidationTest : public testing::Test {
 protected:
  ValidationTest() {
    const TriangleMesh box = test_shapes::box(3, 1, 1);
    fixtures::write(folder_ / "box.obj", fixtures::obj(box));
    robot_ = parseRobotDescription(
        R"(<robot name="r"><link name="base"><visual><geometry><mesh filename="box.obj"/></geometry></visual></link>
      <link name="arm"><visual><geometry><mesh filename="box.obj" scale="0.5 0.5 0.5"/></geometry></visual></link>
      <joint name="j" type="fixed"><parent link="base"/><child link="arm"/><origin xyz="9 0 0"/></joint></robot>)",
        folder_ / "r.urdf");
    for (const LinkDescription& link : robot_.links) {
      LinkResult& result = links_[link.name];
      result.elements.resize(1);
      result.rows.resize(1);
      result.elements[0].link = link.name;
      result.elements[0].source = link.visuals[0];
      result.elements[0].pose = link.pose;
      result.elements[0].hulls = {convexHull(scaled(box, link.visuals[0].scale).vertices)};
    }
  }

  Validation validate() { return validateLinks(robot_, defaultPackageFinder(robot_.path), options_, links_, {}, {}); }

  const fixtures::TempFolder folder_;
  RobotDescription robot_;
  Options options_;
  std::map<std::string, LinkResult> links_;
};

TEST_F(ValidationTest, HullsThatAreTheMeshHaveNoFault) {
  const Validation found = validate();
  EXPECT_GT(found.queries, 200u);
  EXPECT_EQ(0u, found.missed + found.phantom);
  EXPECT_NE(std::string::npos, summary(found).find("no collision missed, no false collision"));
}

TEST_F(ValidationTest, ShorterHullsMiss) {
  for (Eigen::Vector3d& vertex : links_["arm"].elements[0].hulls[0].vertices) vertex.x() /= 2;
  links_["arm"].elements[0].hulls = {convexHull(links_["arm"].elements[0].hulls[0].vertices)};
  const Validation found = validate();
  EXPECT_GT(found.missed, 0u);
  EXPECT_NE(std::string::npos, summary(found).find("arm")) << "the first remark: " << summary(found);
}

TEST_F(ValidationTest, LargerHullsThanWhatIsProvedAreFalse) {
  links_["base"].elements[0].hulls = {convexHull(test_shapes::box(5, 1, 1).vertices)};
  EXPECT_GT(validate().phantom, 0u);
  links_["base"].rows[0].protrusion = 2;
  EXPECT_EQ(0u, validate().phantom);
}

TEST_F(ValidationTest, LinksWithoutHullsAreNoneToCompare) {
  const auto said = [&]() -> std::string {
    try {
      validate();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  links_["arm"].elements[0].hulls.clear();
  links_["base"].elements[0].hulls.clear();
  EXPECT_NE(std::string::npos, said().find("no hulls are known of links 'arm', 'base' that could")) << said();
  links_.erase("arm");
  EXPECT_NE(std::string::npos, said().find("link 'base' has no hulls that could")) << said();
  links_.clear();
  EXPECT_NE(std::string::npos, said().find("call ~build or ~decompose first")) << said();
}

TEST_F(ValidationTest, AMeshThatIsGoneIsNamed) {
  std::filesystem::remove(folder_ / "box.obj");
  try {
    validate();
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("box.obj")) << error.what();
  }
}

}  // namespace
}  // namespace collision_hulls
