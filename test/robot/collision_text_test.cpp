#include "robot/collision_text.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

CollisionElement mesh(const std::string& uri) {
  CollisionElement element;
  element.name = "hull_1";
  element.geometry.uri = uri;
  return element;
}

TEST(CollisionText, IsIndentedAsItsNeighbours) {
  const Layout layout = layoutBeside("\n    ", "\n  ");
  EXPECT_EQ(collisionText(mesh("a.stl"), {}, layout),
            "\n    <collision name=\"hull_1\">\n      <geometry>\n        <mesh filename=\"a.stl\"/>\n      </geometry>\n    </collision>");
}

TEST(CollisionText, KeepsLineEndsAndTabs) {
  const std::string text = collisionText(mesh("a.stl"), {}, layoutBeside("\r\n\t\t", "\r\n\t"));
  EXPECT_EQ(text.rfind("\r\n\t\t<collision", 0), 0u);
  EXPECT_NE(text.find("\r\n\t\t\t<geometry>"), std::string::npos);
}

TEST(CollisionText, OnOneLineWhereTheDescriptionIs) {
  EXPECT_EQ(collisionText(mesh("a.stl"), {}, layoutBeside("", "")).find('\n'), std::string::npos);
}

TEST(CollisionText, TakesAKnownOriginByteForByte) {
  CollisionElement element = mesh("a.stl");
  element.geometry.origin.translation() = Eigen::Vector3d(1, 0, 0);
  const Layout layout = layoutBeside("\n  ", "\n");
  EXPECT_NE(collisionText(element, {{element.geometry.origin, "<origin xyz='1.0  0 0'/>"}}, layout).find("<origin xyz='1.0  0 0'/>"),
            std::string::npos);
  EXPECT_NE(collisionText(element, {}, layout).find("<origin xyz=\"1 0 0\""), std::string::npos);
  EXPECT_EQ(collisionText(mesh("a.stl"), {}, layout).find("<origin"), std::string::npos) << "the identity";
}

TEST(CollisionText, EscapesAndScales) {
  CollisionElement element = mesh("a&b.stl");
  element.name.clear();
  element.geometry.scale = Eigen::Vector3d(1, 1, 0.5);
  const std::string text = collisionText(element, {}, layoutWithin("\n"));
  EXPECT_NE(text.find("filename=\"a&amp;b.stl\" scale=\"1 1 0.5\""), std::string::npos) << text;
  EXPECT_EQ(text.find("name=\"\""), std::string::npos);
}

}  // namespace
}  // namespace collision_hulls
