// Tests src/consumers/pairs_without_check.cpp through the files that name the pairs.
#include <map>
#include <utility>

#include "collision_hulls/error.h"
#include "collision_hulls/scene/srdf.h"
#include "consumers/fixture.h"

namespace collision_hulls {
namespace {

using PairsWithoutCheck = Consumers;

// All links are fixed to each other: 245,000 pairs of names of some 900 bytes.
TEST_F(PairsWithoutCheck, PairsThatNoMemoryHolds) {
  std::string text = "<robot name=\"star\"><link name=\"base\">" + cube() + "</link>";
  for (int i = 0; i < 700; ++i) {
    const std::string number = std::to_string(i), link = std::string(900, 'l') + number;
    text += "<link name=\"" + link + "\"><collision><geometry><sphere radius=\"1\"/></geometry></collision></link><joint name=\"j" +
            number + "\" type=\"fixed\"><parent link=\"base\"/><child link=\"" + link + "\"/></joint>";
  }
  RobotResult result = decomposed(text + "</robot>");
  try {
    addConsumerFiles({Consumer::kMoveit}, folder_ / "three_c", result);
    FAIL() << "all pairs were written";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kTooLarge);
    EXPECT_NE(std::string(e.what()).find("join links that are fixed"), std::string::npos) << e.what();
  }
}

/// Of each pair of links, as --for moveit has it.
using Reasons = std::map<std::pair<std::string, std::string>, std::string>;

Reasons reasonsIn(const std::string& srdf, const std::string& urdf) {
  Reasons reasons;
  for (const DisabledPair& pair : parseDisabledPairs(srdf, parseRobotDescription(urdf)).pairs)
    reasons[{pair.link1, pair.link2}] = pair.reason;
  return reasons;
}

TEST_F(PairsWithoutCheck, MoveitSkipsNeighboursAndWhatIsProvedApart) {
  const std::string urdf = threeLinks(cube());
  Reasons reasons = reasonsIn(fileOf(Consumer::kMoveit, urdf, "config/three.srdf"), urdf);
  EXPECT_EQ((reasons[{"a", "b"}]), "Adjacent");
  EXPECT_EQ((reasons[{"b", "c"}]), "Adjacent");
  EXPECT_EQ((reasons[{"a", "c"}]), "Never");  // turned by 1 rad at most, the last is 0.77 m away
}

TEST_F(PairsWithoutCheck, MoveitChecksWhatMayMeetOrIsNotKnown) {
  std::string near = threeLinks(cube());
  for (std::size_t at = near.find("\"-1\" upper=\"1\""); at != std::string::npos; at = near.find("\"-1\" upper=\"1\""))
    near.replace(at, 14, "\"-3.1\" upper=\"3.1\"");
  EXPECT_EQ(fileOf(Consumer::kMoveit, near, "config/three.srdf").find("Never"), std::string::npos);
  const std::string lost = threeLinks("<collision>" + fixtures::meshTag("/nowhere/lost.stl") + "</collision>");
  EXPECT_EQ(fileOf(Consumer::kMoveit, lost, "config/three.srdf").find("Never"), std::string::npos);
}

TEST_F(PairsWithoutCheck, MoveitSkipsWhatTouchesAtRestInTheOriginal) {
  const std::string far = "<collision><origin xyz=\"0.95 0 0\"/>" + fixtures::meshTag(mesh_) + "</collision>";
  std::string urdf = threeLinks(far);
  EXPECT_NE((reasonsIn(fileOf(Consumer::kMoveit, urdf, "config/three.srdf"), urdf)[{"a", "c"}]), "Default") << "0.9 m behind b";
  urdf.replace(urdf.find("lower=\"-1\"", urdf.find("\"bc\"")), 20, "lower=\"3.1\" upper=\"3.2\"");
  RobotResult result = decomposed(urdf);
  addConsumerFiles({Consumer::kMoveit}, folder_ / "three_c", result);
  EXPECT_EQ((reasonsIn(result.extra_files["config/three.srdf"], urdf)[{"a", "c"}]), "Default") << "rest is where the limits allow it";
  ASSERT_FALSE(result.report.notes.empty());
  EXPECT_NE(result.report.notes.back().find("by the files of --for: 'a' and 'c'; delete"), std::string::npos) << result.report.notes.back();
}

TEST_F(PairsWithoutCheck, MoveitSkipsAKeptBoxThatTouchesAtRest) {
  const auto reason = [&](const std::string& x) {
    const std::string urdf =
        threeLinks("<collision><origin xyz=\"" + x + " 0 0\"/><geometry><box size=\"0.1 0.1 0.1\"/></geometry></collision>");
    return reasonsIn(fileOf(Consumer::kMoveit, urdf, "config/three.srdf"), urdf)[{"a", "c"}];
  };
  EXPECT_EQ(reason("-1"), "Default");
  EXPECT_NE(reason("-0.5"), "Default");
}

TEST_F(PairsWithoutCheck, MoveitChecksWhatTouchesAtRestByItsHullsAlone) {
  // Two cubes on either side of a's, and one body for both.
  const TriangleMesh cube = test_shapes::box(0.1, 0.1, 0.1);
  const TriangleMesh two = test_shapes::merged({test_shapes::moved(cube, {-1, 0.5, 0}), test_shapes::moved(cube, {-1, -0.5, 0})});
  const std::string urdf =
      threeLinks("<collision>" + fixtures::meshTag(fixtures::write(folder_ / "two.obj", fixtures::obj(two))) + "</collision>");
  options_.method = Method::kSingleHull;
  EXPECT_EQ((reasonsIn(fileOf(Consumer::kMoveit, urdf, "config/three.srdf"), urdf).count({"a", "c"})), 0u);
  options_.method = Method::kCertified;
  options_.shapes = Shapes::kBox;
  EXPECT_EQ((reasonsIn(fileOf(Consumer::kMoveit, urdf, "config/three.srdf"), urdf).count({"a", "c"})), 0u)
      << "the box stands in place of the hull";
}

TEST_F(PairsWithoutCheck, MujocoLeavesOutThePairsThatMoveitDoes) {
  const std::string xml = fileOf(Consumer::kMujoco, threeLinks(cube()), "mjcf/three.xml");
  EXPECT_NE(xml.find("  <contact>\n    <exclude body1=\"a\" body2=\"b\"/>\n    <exclude body1=\"a\" body2=\"c\"/>\n"
                     "    <exclude body1=\"b\" body2=\"c\"/>\n  </contact>\n"),
            std::string::npos)
      << xml;
}

// A proof of many pairs takes seconds: it is said before it begins, and only where pairs are named.
TEST_F(PairsWithoutCheck, AreAStepOfTheRun) {
  RobotResult result = decomposed(threeLinks(cube()));
  std::vector<std::string> stages;
  const auto note = [&](const Step& step) {
    stages.push_back(step.stage);
    EXPECT_EQ(step.done, 3u);
    EXPECT_EQ(step.hulls, 3u);
    EXPECT_EQ(step.fraction, 1) << "all else is done";
  };
  addConsumerFiles({Consumer::kGazebo}, folder_ / "three_c", result, {}, note);
  EXPECT_TRUE(stages.empty());
  addConsumerFiles({Consumer::kMoveit}, folder_ / "three_c", result, {}, note);
  EXPECT_EQ(stages, std::vector<std::string>{"pairs"});
}

}  // namespace
}  // namespace collision_hulls
