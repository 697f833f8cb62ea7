#include "collision_hulls/scene/srdf.h"

#include "counted_looks.h"
#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

RobotDescription robot() {
  std::string text = "<robot name='r'><link name='a'/>";
  for (const std::string link : {"b", "c", "d"}) {
    text += "<link name='" + link + "'/><joint name='to_" + link + "' type='fixed'><parent link='a'/><child link='" + link + "'/></joint>";
  }
  return parseRobotDescription(text + "</robot>");
}

DisabledPairs parse(const std::string& content) {
  return parseDisabledPairs("<robot name='r'>" + content + "</robot>", robot());
}

TEST(Srdf, WithoutPairs) {
  EXPECT_TRUE(parse("").pairs.empty());
  EXPECT_TRUE(parse("<group name='arm'><chain base_link='a' tip_link='b'/></group>").pairs.empty());
}

TEST(Srdf, ADescriptionIsNone) {
  expectError(ErrorCode::kNotAnSrdf, {"line 1", "<link>", "give its SRDF"}, [] { parse("<link name='a'/>"); });
}

TEST(Srdf, KeepsTheOrderAndDropsDuplicates) {
  const DisabledPairs read = parse(
      "<disable_collisions link1='b' link2='a' reason='Adjacent'/><disable_collisions link1='c' link2='d' reason='Never'/>"
      "<disable_collisions link1='a' link2='b' reason='Default'/><disable_collisions link1='a' link2='c'/>");
  ASSERT_EQ(read.pairs.size(), 3u);
  EXPECT_EQ(read.pairs[0].link1, "b");
  EXPECT_EQ(read.pairs[0].reason, "Adjacent");
  EXPECT_EQ(read.pairs[2].link2, "c");
  EXPECT_EQ(read.pairs[2].reason, "");
  EXPECT_TRUE(read.notes.empty());
}

TEST(Srdf, DisablesAllPairsOfALinkExceptEnabledOnes) {
  const DisabledPairs read = parse("<disable_default_collisions link='a'/><enable_collisions link1='c' link2='a'/>");
  ASSERT_EQ(read.pairs.size(), 2u);
  EXPECT_EQ(read.pairs[0].link2, "b");
  EXPECT_EQ(read.pairs[1].link2, "d");
}

TEST(Srdf, ALinkThatIsDisabledAgainOrUnknownCostsNoLookAtAllLinks) {
  constexpr std::size_t kNumber = 2000;
  RobotDescription large;
  large.name = "r";
  large.links.resize(kNumber);
  for (std::size_t i = 0; i < kNumber; ++i) large.links[i].name = "l" + std::to_string(i);
  std::string known, unknown;
  for (std::size_t i = 0; i < kNumber; ++i) {
    known += "<disable_default_collisions link='l0'/>";
    unknown += "<disable_default_collisions link='x" + std::to_string(i) + "'/>";
  }
  for (const std::string& text : {known, "<disable_default_collisions link='l0'/>" + unknown}) {
    const std::size_t looks =
        looksOf([&](const RunControl& control) { parseDisabledPairs("<robot name='r'>" + text + "</robot>", large, "", control); });
    EXPECT_LT(looks, kNumber * kNumber / kLargeItemsBetweenLooks / 4) << text.substr(0, 50);
  }
  const DisabledPairs read = parseDisabledPairs("<robot name='r'>" + known + unknown + "</robot>", large);
  EXPECT_EQ(read.pairs.size(), kNumber - 1);
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_NE(read.notes[0].find("first 'x0'"), std::string::npos) << read.notes[0];
}

TEST(Srdf, OrderOfElementsDoesNotMatter) {
  const std::string off = "<disable_default_collisions link='a'/>", on = "<enable_collisions link1='c' link2='a'/>";
  const std::string pair = "<disable_collisions link1='a' link2='c'/>";
  EXPECT_EQ(parse(on + off).pairs.size(), 2u);
  EXPECT_EQ(parse(pair + on).pairs.size(), 1u) << "<enable_collisions> is an exception from defaults only";
  EXPECT_EQ(parse(pair + off + on).pairs.size(), 3u);
}

TEST(Srdf, IgnoresLinksOfOtherRobots) {
  const DisabledPairs read = parse(
      "<disable_collisions link1='a' link2='gripper'/><disable_collisions link1='a' link2='b'/><disable_collisions link1='tool' "
      "link2='x'/>");
  EXPECT_EQ(read.pairs.size(), 1u);
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_NE(read.notes[0].find("2 pairs"), std::string::npos);
  EXPECT_NE(read.notes[0].find("'gripper'"), std::string::npos);
}

TEST(Srdf, AMisspeltLinkIsGuessed) {
  const RobotDescription arm = parseRobotDescription(
      "<robot name='r'><link name='base'/><link name='forearm'/><joint name='j' type='fixed'><parent link='base'/><child link='forearm'/>"
      "</joint></robot>");
  const auto notes = [&](const std::string& unknown) {
    return parseDisabledPairs("<robot name='r'><disable_collisions link1='base' link2='" + unknown +
                                  "'/><disable_collisions link1='base' link2='forearm'/></robot>",
                              arm)
        .notes;
  };
  EXPECT_EQ(notes("foream"), std::vector<std::string>{"SRDF: 1 pair names links that the robot does not have, first 'foream' (did you mean "
                                                      "'forearm'?); it is left out"});
  EXPECT_EQ(notes("gripper"),
            std::vector<std::string>{"SRDF: 1 pair names links that the robot does not have, first 'gripper'; it is left out"});
}

TEST(Srdf, ThatOfAnotherRobotIsRefused) {
  for (const std::string pair : {"<disable_collisions link1='a' link2='gripper'/>", "<disable_default_collisions link='gripper'/>"})
    expectError(ErrorCode::kNotAnSrdf, {"the robot 'r'", "no 'gripper'", "give the SRDF of this robot"}, [&] { parse(pair); });
  EXPECT_TRUE(parse("<enable_collisions link1='a' link2='b'/><disable_collisions link1='a' link2='x'/>").pairs.empty());
}

TEST(Srdf, AnotherNameOfTheRobotIsANote) {
  const std::string pair = "<disable_collisions link1='a' link2='b'/>";
  const DisabledPairs read = parseDisabledPairs("<robot name='s'>" + pair + "</robot>", robot());
  EXPECT_EQ(read.pairs.size(), 1u);
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_NE(read.notes[0].find("for the robot 's', and the description is of 'r'"), std::string::npos) << read.notes[0];
  EXPECT_TRUE(parseDisabledPairs("<robot>" + pair + "</robot>", robot()).notes.empty());
}

TEST(Srdf, ErrorsNameTheFaultAndTheLine) {
  const auto expectBad = [](ErrorCode code, const std::vector<std::string>& parts, const std::string& text) {
    expectError(code, parts, [&] { parseDisabledPairs(text, robot(), "a.srdf"); });
  };
  expectBad(ErrorCode::kNotXml, {"'a.srdf'"}, "<robot>");
  expectBad(ErrorCode::kNotAnSrdf, {"'a.srdf'", "line 1", "<sdf>"}, "<sdf/>");
  expectBad(ErrorCode::kNotAnSrdf, {"line 2", "no link2"}, "<robot>\n<disable_collisions link1='a'/></robot>");
  expectBad(ErrorCode::kNotAnSrdf, {"no link;"}, "<robot><disable_default_collisions/></robot>");
  expectError(ErrorCode::kFileNotFound, {"no.srdf"}, [] { readDisabledPairs("/nowhere/no.srdf", robot()); });
}

TEST(Srdf, ReadsBackWhatItWrites) {
  const std::vector<DisabledPair> pairs{{"a", "b", "Adjacent", ""}, {"c", "a", "Never", "never within 0.31 m -- proved"}};
  const TemporaryFolder folder;
  const std::string text = srdfFragment("r & \"s\"", pairs);
  RobotDescription of_that_name = robot();
  of_that_name.name = "r & \"s\"";
  const DisabledPairs read = readDisabledPairs(folder.write("a.srdf", text), of_that_name);
  EXPECT_TRUE(read.notes.empty());
  ASSERT_EQ(read.pairs.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.pairs[i].link1, pairs[i].link1);
    EXPECT_EQ(read.pairs[i].link2, pairs[i].link2);
    EXPECT_EQ(read.pairs[i].reason, pairs[i].reason);
  }
  EXPECT_NE(text.find("<disable_collisions link1=\"c\" link2=\"a\" reason=\"Never\"/>  <!-- never within 0.31 m"), std::string::npos);
}

}  // namespace
}  // namespace collision_hulls
