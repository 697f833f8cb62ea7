#include "verify/joint_differences.h"

#include <gtest/gtest.h>

#include "collision_hulls/verify/verify.h"
#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

constexpr const char* kLimits = "<limit lower='-1' upper='2' effort='1' velocity='1'/>";

/// Links base, a and b; joint j moves a, and k moves b.
RobotDescription arm(const std::string& j_type, const std::string& j_more, const std::string& k_more = "") {
  const auto joint = [](const std::string& name, const std::string& child, const std::string& type, const std::string& more) {
    return "<link name='" + child + "'><visual><geometry><box size='1 1 1'/></geometry></visual><collision><geometry><box size='1 1 1'/>" +
           "</geometry></collision></link><joint name='" + name + "' type='" + type + "'><parent link='base'/><child link='" + child +
           "'/>" + more + "</joint>";
  };
  return parseRobotDescription("<robot name='r'><link name='base'/>" + joint("k", "b", "continuous", k_more) +
                               joint("j", "a", j_type, j_more) + "</robot>");
}

TEST(JointDifferences, AreNamedByWhatDiffersFirst) {
  const RobotDescription original = arm("revolute", kLimits);
  EXPECT_TRUE(jointDifferences(original, original).empty());
  EXPECT_TRUE(
      jointDifferences(original, arm("revolute", "<axis xyz='1 0 0'/><limit lower='-1.0000001' upper='2' effort='5' velocity='3'/>"))
          .empty());
  const auto only = [&](const RobotDescription& result) {
    const std::vector<std::string> differences = jointDifferences(original, result);
    return differences.size() == 1 ? differences[0] : std::to_string(differences.size()) + " differences";
  };
  EXPECT_EQ(only(arm("prismatic", kLimits)), "'j', which is prismatic there and is revolute in ORIGINAL");
  EXPECT_EQ(only(arm("fixed", "")), "'j', which is fixed there and is revolute in ORIGINAL");
  EXPECT_EQ(only(arm("revolute", std::string("<axis xyz='0 -1 0'/>") + kLimits)),
            "'j', which has the axis '0 -1 0' there and has the axis '1 0 0' in ORIGINAL");
  EXPECT_EQ(only(arm("revolute", "<limit lower='-1' upper='1.5' effort='1' velocity='1'/>")),
            "'j', which goes from -1 to 1.5 there and goes from -1 to 2 in ORIGINAL");
  EXPECT_EQ(only(arm("revolute", std::string(kLimits) + "<mimic joint='k' multiplier='2'/>")),
            "'j', which follows 'k' (times 2, plus 0) there and follows no joint in ORIGINAL");
  EXPECT_EQ(jointDifferences(original, arm("fixed", "", "<axis xyz='0 0 1'/>")).size(), 2u);
}

TEST(JointDifferences, LinksOfOneSideAloneHaveNone) {
  EXPECT_TRUE(jointDifferences(arm("fixed", ""), parseRobotDescription("<robot name='r'><link name='a'/></robot>")).empty());
}

TEST(JointDifferences, AreNotedByVerify) {
  const Description original{arm("revolute", kLimits), PackageFinder()}, result{arm("prismatic", kLimits), PackageFinder()};
  VerifyOptions options;
  options.configurations = 1;
  EXPECT_TRUE(verify(original, original, options).notes.empty());
  const Verification seen = verify(original, result, options);
  ASSERT_EQ(seen.notes.size(), 1u);
  EXPECT_EQ(
      seen.notes[0],
      "1 joint moves otherwise in RESULT: 'j', which is prismatic there and is revolute in ORIGINAL; links are moved by ORIGINAL's joints");
}

TEST(JointDifferences, ARobotWhoseJointsLeadNowhereIsMeasuredWithoutQueries) {
  const Description lost{arm("revolute", std::string(kLimits) + "<mimic joint='nope'/>"), PackageFinder()};
  const Verification seen = verify(lost, lost, {});
  EXPECT_EQ(seen.configurations, 0u);
  EXPECT_EQ(seen.queries, 0u);
  ASSERT_EQ(seen.links.size(), 2u);
  EXPECT_EQ(seen.links[0].status, LinkStatus::kOk);
  ASSERT_EQ(seen.notes.size(), 1u);
  EXPECT_EQ(seen.notes[0], "no configuration was tried: joint 'j' mimics 'nope', which the robot does not have; correct its <mimic>");
}

}  // namespace
}  // namespace collision_hulls
