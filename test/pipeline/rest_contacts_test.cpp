// Links whose hulls touch at rest though their meshes do not: which pairs are told, and how.
#include "pipeline/contacts/rest_contacts.h"

#include <gtest/gtest.h>

#include <thread>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "counted_looks.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using test_shapes::box;
using test_shapes::moved;

/// A channel whose mouth its hull fills, and pins that may stand in it. Its walls are 10 mm from a pin of 20 mm at the origin.
class RestContacts : public ::testing::Test {
 protected:
  RestContacts() {
    const TriangleMesh channel =
        test_shapes::merged({moved(box(0.1, 0.06, 0.01), {-0.05, -0.03, -0.03}), moved(box(0.1, 0.06, 0.01), {-0.05, -0.03, 0.02}),
                             moved(box(0.01, 0.06, 0.06), {-0.06, -0.03, -0.03})});
    fixtures::write(folder_ / "channel.obj", fixtures::obj(channel));
    fixtures::write(folder_ / "pin.obj", fixtures::obj(moved(box(0.02, 0.02, 0.02), {-0.01, -0.01, -0.01})));
    options_.method = Method::kSingleHull;
    options_.jobs = 2;
  }

  static std::string link(const std::string& name, const std::string& mesh) {
    return "<link name='" + name + "'>" + (mesh.empty() ? "" : "<collision>" + fixtures::meshTag(mesh) + "</collision>") + "</link>";
  }
  static std::string joint(const std::string& parent, const std::string& child, const std::string& place, const std::string& lower = "-1") {
    return "<joint name='to_" + child + "' type='prismatic'><parent link='" + parent + "'/><child link='" + child + "'/><origin xyz='" +
           place + "'/><axis xyz='0 0 1'/><limit lower='" + lower + "' upper='1' effort='1' velocity='1'/></joint>";
  }
  /// A channel, a link without geometry, and a pin that hangs on it.
  static std::string channelAndPin(const std::string& place, const std::string& lower = "-1") {
    return link("channel", "channel.obj") + link("carriage", "") + link("pin", "pin.obj") + joint("channel", "carriage", "0 0 0") +
           joint("carriage", "pin", place, lower);
  }

  /// The notes on such links.
  std::vector<std::string> notes(const std::string& links) {
    const std::string file = fixtures::write(folder_ / "arm.urdf", fixtures::robot("arm", links));
    std::vector<std::string> found;
    for (const std::string& note :
         decomposeRobot(readRobotDescription(file), defaultPackageFinder(file), options_, folder_ / "out").report.notes)
      if (note.find("touch") != std::string::npos) found.push_back(note);
    return found;
  }

  fixtures::TempFolder folder_;
  Options options_;
};

TEST_F(RestContacts, APinInAMouthThatAHullFillsIsNotedWithTheGap) {
  const std::vector<std::string> found = notes(channelAndPin("0 0 0"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0],
            "hulls of 'channel' and 'pin' touch with all joints at rest, where their meshes are 10 mm apart: choose another method for "
            "these links, or disable the pair");
  options_.method = Method::kCertified;
  EXPECT_TRUE(notes(channelAndPin("0 0 0")).empty()) << "the mouth is open";
}

TEST_F(RestContacts, WhatIsWrittenIsNamed) {
  const auto start = [&](const std::string& links) {
    const std::vector<std::string> found = notes(links);
    return found.empty() ? "" : found[0].substr(0, found[0].find(" touch"));
  };
  options_.tolerance = lengthOf(0.03);
  options_.method = Method::kCertified;
  options_.shapes = Shapes::kSpheres;
  EXPECT_EQ(start(channelAndPin("0 0 0")), "spheres of 'channel' and 'pin'");
  options_.shapes = Shapes::kCylinder;
  EXPECT_EQ(start(channelAndPin("0 0 0")), "primitives of 'channel' and 'pin'");
  LinkRule rule;
  rule.pattern = "pin";
  rule.settings.shapes = Shapes::kHulls;
  options_.rules = {rule};
  EXPECT_EQ(start(channelAndPin("0 0 0")), "bodies of 'channel' and 'pin'");
}

TEST_F(RestContacts, TheRemedyIsForTheCause) {
  const auto remedy = [&] {
    const std::vector<std::string> found = notes(channelAndPin("0 0 0"));
    return found.empty() ? "" : found[0].substr(found[0].rfind(": ") + 2);
  };
  options_.method = Method::kCertified;
  options_.tolerance = lengthOf(0.03);
  EXPECT_EQ(remedy(), "lower the tolerance of these links, or disable the pair");
  options_.padding = 0.006;
  EXPECT_EQ(remedy(), "lower the padding or the tolerance of these links, or disable the pair");
  options_.padding = 0;
  options_.shapes = Shapes::kCylinder;
  EXPECT_EQ(remedy(), "take hulls for these links, or disable the pair");
  options_.shapes = Shapes::kHulls;
  options_.tolerance = lengthOf(0.002);
  options_.max_hulls = 1;
  EXPECT_EQ(remedy(), "allow these links more hulls, or disable the pair");
}

TEST_F(RestContacts, OthersAreListed) {
  std::string links = channelAndPin("0 0 0");
  for (const std::string name : {"b", "c", "d", "e", "f", "g"}) links += link(name, "pin.obj") + joint("carriage", name, "-0.02 0 0");
  for (const std::string name : {"x", "y"}) links += link(name, "channel.obj") + joint("carriage", name, "0 0.5 0");
  links += link("last", "pin.obj") + joint("carriage", "last", "-0.03 0.5 0.009");
  const std::vector<std::string> found = notes(links);
  ASSERT_EQ(found.size(), 1u) << "pins that lie in each other collide, and so do channels";
  EXPECT_EQ(found[0].find("hulls of 'channel' and 'pin' (and those of 'channel' and 'b', of 'channel' and 'c', of 'channel' and 'd', of "
                          "'channel' and 'e', of 'channel' and 'f', and of 3 more pairs) touch"),
            0u)
      << found[0];
  EXPECT_NE(found[0].find("the meshes of the first are 10 mm apart"), std::string::npos) << found[0];
  EXPECT_NE(found[0].find("disable the pairs"), std::string::npos) << found[0];
}

TEST_F(RestContacts, MeshesThatTouchAndHullsThatDoNotAreNotNoted) {
  EXPECT_TRUE(notes(channelAndPin("0 0 0.0100001")).empty()) << "in the wall";
  EXPECT_TRUE(notes(channelAndPin("0 0 0.009999")).empty()) << "flush with it";
  EXPECT_EQ(notes(channelAndPin("0 0 0.0099")).size(), 1u);
  EXPECT_TRUE(notes(channelAndPin("0.0601 0 0")).empty()) << "before the mouth";
  EXPECT_EQ(notes(channelAndPin("0.0599 0 0")).size(), 1u);
}

TEST_F(RestContacts, JoinedLinksMayTouch) {
  EXPECT_TRUE(notes(link("channel", "channel.obj") + link("pin", "pin.obj") + joint("channel", "pin", "0 0 0")).empty());
  EXPECT_TRUE(notes(fixtures::link("channel", "<collision>" + fixtures::meshTag("channel.obj") + "</collision>") +
                    fixtures::link("pin", "<collision><origin xyz='0 0 -0.5'/>" + fixtures::meshTag("pin.obj") + "</collision>", "channel"))
                  .empty())
      << "fixed";
}

TEST_F(RestContacts, RestIsWithinTheLimits) {
  EXPECT_EQ(notes(channelAndPin("0 0 -0.3", "0.3")).size(), 1u);
  EXPECT_TRUE(notes(channelAndPin("0 0 0", "0.3")).empty());
}

TEST_F(RestContacts, WithoutValidationNobodyLooks) {
  options_.validate = false;
  EXPECT_TRUE(notes(channelAndPin("0 0 0")).empty());
}

TEST_F(RestContacts, EachModelHasItsNote) {
  options_.models = {{"coarse", lengthOf(0.1)}, {"fine", lengthOf(0.001)}};
  options_.method = Method::kCertified;
  const std::vector<std::string> found = notes(channelAndPin("0 0 0"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].find("model 'coarse': hulls of 'channel' and 'pin' touch"), 0u) << found[0];
}

/// What the stages would have found, without them.
struct Made {
  void add(const std::string& link, const TriangleMesh& mesh, const ConvexHull& hull, double protrusion) {
    MeshUse use;
    use.link = link;
    uses.push_back(use);
    MeshResult result;
    result.original = mesh;
    result.hulls = {hull};
    result.model.protrusion = protrusion;
    results.push_back(std::make_shared<const MeshResult>(result));
  }
  std::vector<RestContact> contacts(const RunControl& control = {}) const { return restContacts(robot, uses, results, 0, control); }

  RobotDescription robot;
  std::vector<MeshUse> uses;
  MeshResults results;
};

/// Links without geometry are between those that are given.
RobotDescription robotOf(std::size_t links) {
  std::string text = "<link name='root'/>";
  for (std::size_t i = 0; i < links; ++i) {
    const std::string name = std::to_string(i);
    for (const auto& [parent, child] : {std::pair<std::string, std::string>("root", "to" + name), {"to" + name, "link" + name}})
      text += "<link name='" + child + "'/><joint name='j" + child + "' type='continuous'><parent link='" + parent + "'/><child link='" +
              child + "'/></joint>";
  }
  return parseRobotDescription(fixtures::robot("r", text));
}

TEST(RestContactsOfHulls, APrimitiveCountsInPlaceOfTheHullAroundIt) {
  const auto made = [](double radius) {
    Made made;
    made.robot = robotOf(2);
    const TriangleMesh left = moved(box(0.1, 0.1, 0.1), {-0.2, -0.05, -0.05}), right = moved(box(0.1, 0.1, 0.1), {0.1, -0.05, -0.05});
    made.add("link0", left, convexHull(left.vertices), 0);
    made.add("link1", right, convexHull(moved(box(0.4, 0.1, 0.1), {-0.2, -0.05, -0.05}).vertices), 0.3);
    MeshResult round = *made.results[1];
    GeometryElement ball;
    ball.kind = GeometryElement::Kind::kSphere;
    ball.size = {radius, 0, 0};
    ball.origin.translation() = Eigen::Vector3d(0.1, 0, 0);
    round.primitives = {ball};
    made.results[1] = std::make_shared<const MeshResult>(round);
    return made;
  };
  EXPECT_TRUE(made(0.19).contacts().empty());
  const std::vector<RestContact> found = made(0.21).contacts();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].apart, 0.2, 1e-6);
  EXPECT_FALSE(found[0].at_least);
}

TEST(RestContactsOfHulls, OfAMeshInsideAnotherTheLeastDistanceIsKnown) {
  Made made;
  made.robot = robotOf(2);
  const TriangleMesh housing = moved(box(0.2, 0.2, 0.2), {-0.1, -0.1, -0.1}), motor = moved(box(0.1, 0.1, 0.1), {-0.05, -0.05, -0.05});
  made.add("link0", housing, convexHull(housing.vertices), 0.002);
  made.add("link1", motor, convexHull(motor.vertices), 0);
  const std::vector<RestContact> found = made.contacts();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].apart, 0.003, 1e-9);
  EXPECT_TRUE(found[0].at_least);
  EXPECT_EQ(notesOnRestContacts(made.robot, made.uses, made.results, 0),
            std::vector<std::string>{"hulls of 'link0' and 'link1' touch with all joints at rest, where their meshes are at least 3 mm "
                                     "apart, one inside the other: disable the pair"});
}

TEST(RestContactsOfHulls, BoxesThatDoNotMeetCostNothing) {
  const TriangleMesh ball = test_shapes::sphere(0.01, 4);
  const ConvexHull hull = convexHull(ball.vertices);
  const auto row = [&](std::size_t links, double apart) {
    Made made;
    made.robot = robotOf(links);
    for (std::size_t i = 0; i < links; ++i) {
      made.add("link" + std::to_string(i), ball, hull, 0);
      made.uses.back().source.origin.translation().x() = apart * static_cast<double>(i);
    }
    return made;
  };
  const Made clear = row(40, 0.03), near = row(10, 0.005);
  EXPECT_LE(looksOf([&](const RunControl& control) { clear.contacts(control); }), 41u) << "one for each mesh, none for its triangles";
  const auto work = [&](const RunControl& control) { near.contacts(control); };
  EXPECT_GT(looksOf(work), 9 * ball.triangles.size()) << "FCL builds trees";
  EXPECT_LE(looksAfterCancel(100, work), 1 + std::thread::hardware_concurrency()) << "a look for each thread";
}

TEST(RestContactsOfHulls, JointsAtFaultAreNoted) {
  Made made;
  made.robot = robotOf(1);
  made.robot.joints[0].mimic = "lost";
  const std::vector<std::string> notes = notesOnRestContacts(made.robot, made.uses, made.results, 0);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("mimics 'lost'"), std::string::npos) << notes[0];
}

}  // namespace
}  // namespace collision_hulls
