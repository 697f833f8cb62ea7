#include "pipeline/page.h"

#include <gtest/gtest.h>

#include "web/pages.h"

namespace collision_hulls {
namespace {

using pages::count;
using pages::row;

TEST(PageOf, AResult) {
  RobotResult result;
  result.robot_name = "My Arm";
  result.report.links = {row("a"), row("b")};
  result.elements.resize(1);
  result.elements[0].hulls = {convexHull(test_shapes::box(1, 1, 1).vertices)};
  const std::string page = pageOf(result);
  EXPECT_EQ(count(page, "<h1>My Arm</h1>"), 1u);
  EXPECT_EQ(count(page, "<tbody data-row="), 2u) << "a row without an element, too";
}

TEST(PageOf, EveryModelOfAResult) {
  RobotResult result;
  result.report.links = {row("a")};
  result.report.models.resize(1);
  result.report.models[0].links = {row("a")};
  result.models.resize(1);
  EXPECT_EQ(count(pageOf(result), "<tbody data-row=\"0\""), 2u);
}

}  // namespace
}  // namespace collision_hulls
