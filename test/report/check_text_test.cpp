#include "report/check_text.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(CheckText, NumbersAndNone) {
  Validation found;
  found.queries = 1;
  found.phantom = 1;
  found.max_underestimate = 0.00321;
  EXPECT_EQ(checkText(found, "hulls"),
            "1 query compared hulls and meshes: no collision missed, 1 false collision beyond the protrusion; distances at most 3.21 mm "
            "too short");
  EXPECT_EQ(verdictText(2, 0, "clearance"), "2 collisions missed, no false collision beyond the clearance");
}

TEST(CheckText, InTheNumbersOfTheTextAround) {
  const CountText rough = [](std::size_t number, const std::string& noun, const std::string& plural) {
    return (number > 1000 ? "many " : "few ") + (plural.empty() ? noun + "s" : plural);
  };
  Validation found;
  found.queries = 5000;
  found.missed = 3;
  EXPECT_EQ(checkText(found, "bodies", rough).rfind("many queries compared bodies and meshes: few collisions missed, no false", 0), 0u);
}

TEST(CheckText, NumbersOfBodies) {
  EXPECT_EQ(countedBodies(0, 0), "0 hulls");
  EXPECT_EQ(countedBodies(1, 2), "1 hull and 2 primitives");
  EXPECT_EQ(countedBodies(0, 1), "1 primitive");
  EXPECT_EQ(bodiesInColumn(3, 0), "3");
  EXPECT_EQ(bodiesInColumn(3, 1), "3 hulls and 1 primitive");
  EXPECT_EQ(bodiesInColumn(0, 2), "2 primitives");
}

TEST(CheckText, KindsOfBodies) {
  ModelReport model;
  model.links.resize(2);
  model.links[0].hulls = 3;
  EXPECT_EQ(kindOfBodies(model), "hulls");
  model.links[1].primitives = 1;
  EXPECT_EQ(kindOfBodies(model), "bodies");
  model.links[0].hulls = 0;
  EXPECT_EQ(kindOfBodies(model), "primitives");
}

}  // namespace
}  // namespace collision_hulls
