// Reading, sampling and interpolating configurations of a small arm with one joint of each kind.
// Also tests src/scene/configuration_files.cpp.
#include "collision_hulls/scene/configurations.h"

#include <array>
#include <cmath>
#include <random>

#include "counted_looks.h"
#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Joints a (revolute, -1 to 2), b (continuous), c (prismatic, 0 to 0.5), m (mimics a: 2 a + 0.1), f (fixed).
Kinematics arm() {
  const std::string limits = "<limit lower='-1' upper='2' effort='1' velocity='1'/>";
  const auto joint = [](const std::string& name, const std::string& type, int i, const std::string& more) {
    return "<link name='l" + std::to_string(i + 1) + "'/><joint name='" + name + "' type='" + type + "'><parent link='l" +
           std::to_string(i) + "'/><child link='l" + std::to_string(i + 1) + "'/><axis xyz='0 0 1'/>" + more + "</joint>";
  };
  return Kinematics(parseRobotDescription(
      "<robot name='r'><link name='l0'/>" + joint("a", "revolute", 0, limits) + joint("b", "continuous", 1, "") +
      joint("c", "prismatic", 2, "<limit lower='0' upper='0.5' effort='1' velocity='1'/>") +
      joint("m", "revolute", 3, limits + "<mimic joint='a' multiplier='2' offset='0.1'/>") + joint("f", "fixed", 4, "") + "</robot>"));
}

ConfigurationSet setOf(const std::string& name, const std::string& text, const ConfigurationOptions& options = {}) {
  const TemporaryFolder folder;
  static const Kinematics kinematics = arm();
  return readConfigurations(folder.write(name, text), kinematics, options);
}

void expectBad(ErrorCode code, const std::vector<std::string>& parts, const std::string& name, const std::string& text,
               const ConfigurationOptions& options = {}) {
  expectError(code, parts, [&] { setOf(name, text, options); });
}

TEST(ConfigurationSequence, IsEmptyForARobotWithoutJoints) {
  const ConfigurationSequence sequence(Kinematics(parseRobotDescription("<robot name='r'><link name='a'/></robot>")));
  EXPECT_TRUE(sequence(0).empty());
}

TEST(ConfigurationSequence, IsWithinLimitsAndRepeatable) {
  const Kinematics kinematics = arm();
  for (const Sampling sampling : {Sampling::kEven, Sampling::kIndependent}) {
    const ConfigurationSequence sequence(kinematics, 7, sampling), again(kinematics, 7, sampling), other(kinematics, 8, sampling);
    for (const std::uint64_t i : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{123456}, std::uint64_t{1} << 60}) {
      const Configuration configuration = sequence(i);
      ASSERT_EQ(configuration.size(), 3u);
      EXPECT_EQ(configuration, again(i));
      EXPECT_NE(configuration, other(i));
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GE(configuration[k], kinematics.variables()[k].lower);
        EXPECT_LE(configuration[k], kinematics.variables()[k].upper);
      }
    }
  }
}

/// Counts the first samples in each of 4 x 4 x 4 cells; returns the smallest and the largest count.
std::array<int, 2> fewestAndMost(Sampling sampling, int samples) {
  const Kinematics kinematics = arm();
  const ConfigurationSequence sequence(kinematics, 1, sampling);
  std::vector<int> counts(64, 0);
  for (int i = 0; i < samples; ++i) {
    const Configuration configuration = sequence(static_cast<std::uint64_t>(i));
    std::size_t cell = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const JointVariable& v = kinematics.variables()[k];
      cell = 4 * cell + static_cast<std::size_t>(std::min(3.0, 4 * (configuration[k] - v.lower) / (v.upper - v.lower)));
    }
    ++counts[cell];
  }
  const auto [fewest, most] = std::minmax_element(counts.begin(), counts.end());
  return {*fewest, *most};
}

TEST(ConfigurationSequence, FillsTheJointRanges) {
  const std::array<int, 2> even = fewestAndMost(Sampling::kEven, 6400), independent = fewestAndMost(Sampling::kIndependent, 6400);
  EXPECT_GE(even[0], 85);
  EXPECT_LE(even[1], 115);
  EXPECT_GE(independent[0], 60);
  EXPECT_GT(independent[1] - independent[0], 35) << "independent samples must vary as chance does";
}

TEST(Configurations, RejectsUnusableFiles) {
  expectBad(ErrorCode::kUnsupportedFormat, {"a.bag", ".csv"}, "a.bag", "");
  expectBad(ErrorCode::kBadConfigurations, {"a.csv", "no line"}, "a.csv", "");
  expectBad(ErrorCode::kBadConfigurations, {"a.csv", "no line"}, "a.csv", "a,b\n");
  expectBad(ErrorCode::kBadConfigurations, {"a.yaml", "no message"}, "a.yaml", "x: 1\n---\n");
  expectBad(ErrorCode::kBadConfigurations, {"no message"}, "a.yaml", "joint_names: [a]\npoints: []\n");
  const Kinematics kinematics = arm();
  expectError(ErrorCode::kFileNotFound, {"no.csv"}, [&] { readConfigurations("/nowhere/no.csv", kinematics); });
  expectError(ErrorCode::kBadOption, {"step"}, [&] { ConfigurationCollector(kinematics, {-1}); });
}

TEST(Configurations, Csv) {
  const ConfigurationSet set = setOf("a.csv", "\xEF\xBB\xBF# recorded\nTime, \"c\" ,a\r\n0.0,0.25,1\r\n\r\n0.1,0.5,-1\r\n");
  ASSERT_EQ(set.configurations.size(), 2u);
  EXPECT_EQ(set.given, 2u);
  EXPECT_EQ(set.configurations[0], (Configuration{1, 0, 0.25}));
  EXPECT_EQ(set.configurations[1], (Configuration{-1, 0, 0.5}));
  EXPECT_EQ(set.beyond_limits, 0u);
  ASSERT_EQ(set.notes.size(), 1u);
  EXPECT_NE(set.notes[0].find("at rest: 'b'"), std::string::npos);
  EXPECT_EQ(setOf("a.csv", "a;c\n1;0.5").configurations.at(0), (Configuration{1, 0, 0.5}));
}

TEST(Configurations, CsvOfRostopic) {
  const ConfigurationSet set = setOf("a.csv",
                                     "%time,field.header.seq,field.header.stamp,field.header.frame_id,field.name0,field.name1,"
                                     "field.position0,field.position1,field.velocity0\n"
                                     "1,1,1,,b,a,3,1,0\n2,2,2,,a,b,1.5,4,0\n");
  ASSERT_EQ(set.configurations.size(), 2u);
  EXPECT_EQ(set.configurations[0], (Configuration{1, 3, 0}));
  EXPECT_EQ(set.configurations[1], (Configuration{1.5, 4, 0}));
  EXPECT_EQ(set.beyond_limits, 0u) << "continuous joints have no limits";
}

TEST(Configurations, CsvErrorsNameTheFaultAndTheLine) {
  const auto expectBadCsv = [](const std::vector<std::string>& parts, const std::string& text) {
    expectBad(ErrorCode::kBadConfigurations, parts, "a.csv", text);
  };
  expectBadCsv({"line 1", "no column names a joint"}, "time\n0.1\n");
  expectBadCsv({"line 1", "no joint 'elbow'", "a, b, c, f, m"}, "elbow\n1\n");
  expectBadCsv({"line 1", "'a' appears twice"}, "a,a\n1,1\n");
  expectBadCsv({"line 1", "'0.5'", "names"}, "0.5,1\n");
  expectBadCsv({"line 3", "2 cells", "1"}, "a\n1\n1,2\n");
  expectBadCsv({"line 2", "'x'", "joint 'a'"}, "a\nx\n");
  expectBadCsv({"line 2", "'nan'"}, "a\nnan\n");
  expectBadCsv({"line 2", "''"}, "a,b\n1,\n");
  expectBadCsv({"line 1", "column 2 has no name", "remove"}, "a,\n1,\n");
  expectBadCsv({"line 1", "JointState"}, "%time,field.data\n1,2\n");
}

TEST(Configurations, BeyondLimits) {
  const std::string text = "a,c\n1,0.5000001\n3,0.2\n1,-7\n";
  const ConfigurationSet set = setOf("a.csv", text);
  EXPECT_EQ(set.beyond_limits, 2u);
  EXPECT_EQ(set.configurations[1][0], 3) << "not clamped";
  ASSERT_FALSE(set.notes.empty());
  for (const char* part : {"2 values", "line 3", "'a' at 3", "-1.0", "2.0"}) EXPECT_NE(set.notes[0].find(part), std::string::npos) << part;
  ConfigurationOptions strict;
  strict.refuse_beyond_limits = true;
  expectBad(ErrorCode::kBadConfigurations, {"line 3", "'a' at 3"}, "a.csv", text, strict);
}

TEST(Configurations, PositionsAreWithinABillionOfZero) {
  EXPECT_EQ(setOf("a.csv", "b\n1e9\n-1e9\n").configurations.size(), 2u);
  ConfigurationOptions options;
  options.max_step = 0.1;  // the way from one to the other was infinite, and what lay between not a number
  expectBad(ErrorCode::kBadConfigurations, {"line 2", "'b'", "1.7e+308", "within 1e9 of zero"}, "a.csv", "b,c\n1.7e308,0\n-1.7e308,0.5\n",
            options);
  expectBad(ErrorCode::kBadConfigurations, {"line 2", "'m'", "1.2e+09"}, "a.csv", "a\n6e8\n");
}

TEST(Configurations, MimicJointsAreCompared) {
  EXPECT_EQ(setOf("a.csv", "m,a,b,c,f\n2.1,1,0,0,9\n").notes.size(), 0u);
  const ConfigurationSet set = setOf("a.csv", "a,b,c,m\n1,0,0,2.1\n1,0,0,2.6\n0.5,0,0,1.2\n");
  ASSERT_EQ(set.notes.size(), 1u);
  for (const char* part : {"'m'", "0.5", "line 3"}) EXPECT_NE(set.notes[0].find(part), std::string::npos) << part;
}

TEST(Configurations, JointStates) {
  const ConfigurationSet set = setOf("a.yaml", R"(header:
  seq: 1
  frame_id: ''
name: [a, b]
position: [1.0, 2.0]
velocity: []
---
name:
  - c
position:
  - 0.5
---
)");
  ASSERT_EQ(set.configurations.size(), 2u);
  EXPECT_EQ(set.configurations[0], (Configuration{1, 2, 0}));
  EXPECT_EQ(set.configurations[1], (Configuration{1, 2, 0.5})) << "joints not named in a message keep their positions";
  EXPECT_TRUE(set.notes.empty());
}

TEST(Configurations, MessagesWithoutPositionsArePassedOverAndNoted) {
  const std::string efforts = "---\nname: [b]\nposition: []\neffort: [1.0]\n";
  const ConfigurationSet set = setOf("a.yaml", "name: [a, c]\nposition: [1.0, 0]\n" + efforts + "---\nname: [b]\nposition: [2]\n");
  EXPECT_EQ(set.configurations, (std::vector<Configuration>{{1, 0, 0}, {1, 2, 0}}));
  EXPECT_EQ(set.given, 2u);
  ASSERT_EQ(set.notes.size(), 1u);
  for (const char* part : {"1 message without positions is passed over, the first: ", "a.yaml', line 4, of joint 'b'"})
    EXPECT_NE(set.notes[0].find(part), std::string::npos) << set.notes[0];
  const ConfigurationSet path = setOf("a.yaml", "joint_names: [a]\npoints: [{positions: []}, {positions: [1]}, {positions: []}]\n");
  EXPECT_EQ(path.configurations, (std::vector<Configuration>{{1, 0, 0}}));
  EXPECT_NE(path.notes.at(0).find("2 messages without positions are"), std::string::npos) << path.notes[0];
  expectBad(ErrorCode::kBadConfigurations, {"a.yaml", "no message with name and position"}, "a.yaml", efforts);
}

TEST(Configurations, Trajectories) {
  const std::string trajectory = R"(joint_names: [b, a]
points:
  - {positions: [1, 2], velocities: [0, 0], time_from_start: {secs: 0, nsecs: 0}}
  - {positions: [-1, 0]}
)";
  const ConfigurationSet set = setOf("a.yaml", trajectory);
  ASSERT_EQ(set.configurations.size(), 2u);
  EXPECT_EQ(set.configurations[0], (Configuration{2, 1, 0}));
  const std::string within =
      "model_id: r\ntrajectory:\n- joint_trajectory:\n    joint_names: [a]\n    points:\n    - positions: [1]\n"
      "- joint_trajectory:\n    joint_names: [c]\n    points: [{positions: [0.5]}]\n";
  ASSERT_EQ(setOf("a.yml", within).configurations.size(), 2u);
  EXPECT_EQ(setOf("a.yml", within).configurations[1], (Configuration{1, 0, 0.5}));
}

TEST(Configurations, AJointThatIsAlmostKnownIsSuggested) {
  const Kinematics kinematics(
      parseRobotDescription("<robot name='r'><link name='a'/><link name='b'/><joint name='elbow' type='continuous'><parent link='a'/>"
                            "<child link='b'/></joint></robot>"));
  const TemporaryFolder folder;
  expectError(ErrorCode::kBadConfigurations, {"no joint 'elbwo'", "its joints are elbow; did you mean 'elbow'?"},
              [&] { readConfigurations(folder.write("a.csv", "elbwo\n1\n"), kinematics); });
}

TEST(Configurations, TransformsOfTheRobotAreIgnoredAndNoted) {
  const std::string transforms = "transforms: [{translation: {x: 1, y: 0, z: 0}, rotation: {x: 0, y: 0, z: 0, w: 1}}]";
  const std::string state =
      "joint_state: {name: [a], position: [1]}\nmulti_dof_joint_state:\n  joint_names: [world]\n  " + transforms + "\n";
  const std::string path = "- {joint_names: [a], points: [{positions: [1]}]}\n- {joint_names: [base], points: [{" + transforms + "}]}\n";
  for (const auto& [text, part] : {std::pair(state, "'world' in"), std::pair(path, "'base' in")}) {
    const ConfigurationSet set = setOf("a.yaml", text);
    ASSERT_EQ(set.configurations.size(), 1u);
    ASSERT_FALSE(set.notes.empty());
    EXPECT_NE(set.notes.back().find("transforms of joints are ignored, such as that of "), std::string::npos) << set.notes.back();
    EXPECT_NE(set.notes.back().find(part), std::string::npos) << set.notes.back();
  }
  expectBad(ErrorCode::kBadConfigurations, {"points that have positions"}, "a.yaml",
            "joint_names: [base]\npoints: [{" + transforms + "}]\n");
}

TEST(Configurations, ReadsContentOnTheLineOfTheDashes) {
  EXPECT_EQ(setOf("a.yaml", "--- {name: [a], position: [1]}\n--- {name: [a], position: [2]}\n").configurations.size(), 2u);
}

TEST(Configurations, MoveItPlans) {
  const std::string plan =
      "trajectory_start:\n  joint_state: {name: [], position: []}\ntrajectory:\n- joint_trajectory:\n    joint_names: [a]\n"
      "    points:\n    - positions: [1]\n  multi_dof_joint_trajectory:\n    joint_names: [base]\n"
      "    points: [{transforms: [], velocities: []}]\n";
  const ConfigurationSet set = setOf("a.yaml", plan);
  ASSERT_EQ(set.configurations.size(), 1u) << "an empty message must be skipped";
  EXPECT_EQ(set.configurations[0], (Configuration{1, 0, 0}));
}

TEST(Configurations, YamlErrorsNameTheFaultAndTheLine) {
  const auto expectBadYaml = [](const std::vector<std::string>& parts, const std::string& text) {
    expectBad(ErrorCode::kBadConfigurations, parts, "a.yaml", text);
  };
  expectBadYaml({"line 5", "not valid YAML"}, "name: [a]\nposition: [1]\n---\nx: [\n");
  expectBadYaml({"line 1", "1 position for 2 joints"}, "name: [a, b]\nposition: [1]\n");
  expectBadYaml({"no joint 'elbow'"}, "name: [elbow]\nposition: [1]\n");
  expectBadYaml({"'.nan'"}, "name: [a]\nposition: [.nan]\n");
  expectBadYaml({"line 2, points: 'positions' is missing"}, "joint_names: [a]\npoints: [{velocities: [1]}]\n");
  expectBadYaml({"line 1, name: expected a list"}, "name: a\nposition: 1\n");
  std::string bomb = "x0: &x0 [1, 1]\n";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "*x" + std::to_string(i - 1);
    bomb += "x" + std::to_string(i) + ": &x" + std::to_string(i) + " [" + before + ", " + before + "]\n";
  }
  expectBadYaml({"aliases repeat more than", "fewer"}, bomb);
}

TEST(Configurations, InterpolatesWithinTheLargestStep) {
  ConfigurationOptions options;
  options.max_step = 0.5;
  const ConfigurationSet set = setOf("a.csv", "a,b,c\n0,0,0\n2,0,0.5\n", options);
  ASSERT_EQ(set.configurations.size(), 5u);
  EXPECT_EQ(set.given, 2u);
  EXPECT_EQ(set.configurations[1], (Configuration{0.5, 0, 0.125}));
  EXPECT_EQ(set.configurations[4], (Configuration{2, 0, 0.5}));
}

TEST(Configurations, ANegativeStepIsNamedAsItsOption) {
  ConfigurationOptions options;
  options.max_step = -1;
  expectBad(ErrorCode::kBadOption, {"max-step is -1", "give 0"}, "a.csv", "a,b,c\n0,0,0\n", options);
}

TEST(Configurations, ContinuousJointsTakeTheShorterWay) {
  ConfigurationOptions options;
  options.max_step = 0.1;
  const ConfigurationSet set = setOf("a.csv", "b\n3\n-3\n", options);
  const double way = 2 * kPi - 6;
  ASSERT_EQ(set.configurations.size(), 1 + static_cast<std::size_t>(std::ceil(way / 0.1)));
  EXPECT_NEAR(set.configurations[1][1], 3 + way / 3, 1e-12);
  EXPECT_EQ(set.configurations.back()[1], -3);
}

TEST(Configurations, DoesNotInterpolateBetweenTrajectories) {
  ConfigurationOptions options;
  options.max_step = 0.5;
  const std::string one = "joint_names: [a]\npoints: [{positions: [0]}, {positions: [1]}]\n";
  EXPECT_EQ(setOf("a.yaml", one + "---\n" + one, options).configurations.size(), 6u);
  EXPECT_EQ(setOf("a.yaml", "name: [a]\nposition: [0]\n---\nname: [a]\nposition: [1]\n", options).configurations.size(), 3u);
}

TEST(Configurations, TooManySteps) {
  ConfigurationOptions options;
  options.max_step = 1e-12;
  expectBad(ErrorCode::kTooLarge, {"larger step"}, "a.csv", "a\n0\n1\n", options);
}

TEST(Configurations, TooManyValuesOfManyJoints) {
  std::string text = "<robot name='r'><link name='base'/>";
  for (int i = 0; i < 60; ++i) {
    const std::string number = std::to_string(i);
    text += "<link name='l" + number + "'/><joint name='j" + number + "' type='revolute'><parent link='base'/><child link='l" + number +
            "'/><axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>";
  }
  const Kinematics kinematics(parseRobotDescription(text + "</robot>"));
  ConfigurationOptions options;
  options.max_step = 1e-6;  // 1,000,001 configurations, below the limit of their own
  ConfigurationCollector collector(kinematics, options);
  collector.add({"j0"}, {0}, "row 1");
  expectError(ErrorCode::kTooLarge, {"row 2", " configurations of 60 variables", "50000000 values", "larger step"},
              [&] { collector.add({"j0"}, {1}, "row 2"); });
}

TEST(Configurations, ACsvOfVeryManyColumns) {
  expectBad(ErrorCode::kTooLarge, {"a.csv", "line 1", "100001 columns", "limit of 100000", "leave out"}, "a.csv",
            "a" + std::string(100'000, ',') + "\n0\n");
  const TemporaryFolder folder;
  const Kinematics kinematics = arm();
  const std::string file = folder.write("a.csv", "a" + std::string(99'999, ',') + "\n");
  const CountedLooks looks;
  expectError(ErrorCode::kBadConfigurations, {"column 2 has no name"}, [&] { readConfigurations(file, kinematics, {}, looks.control()); });
  EXPECT_GE(looks.count(), 2 + looksFor(100'000)) << "within a line";
}

TEST(ConfigurationCollector, IsCancelledAtEachRowAndWithinSteps) {
  const Kinematics kinematics = arm();
  ConfigurationOptions options;
  options.max_step = 1e-4;
  const auto rows = [&](const RunControl& control) {
    ConfigurationCollector collector(kinematics, options);
    for (const double position : {0, 1, 1}) collector.add({"a"}, {position}, "row", control);
  };
  EXPECT_GE(looksOf(rows), 3 + 10'000 / kLargeItemsBetweenLooks);
  EXPECT_EQ(looksAfterCancel(1, rows), 1u) << "in the first row";
  EXPECT_EQ(looksAfterCancel(10, rows), 1u) << "on the way to the second";
}

TEST(ConfigurationCollector, IsReusableAfterTake) {
  const Kinematics kinematics = arm();
  ConfigurationCollector collector(kinematics);
  collector.add({"a"}, {3}, "first");
  EXPECT_EQ(collector.take().beyond_limits, 1u);
  EXPECT_TRUE(collector.take().configurations.empty());
  collector.add({"b"}, {1}, "second");
  const ConfigurationSet set = collector.take();
  EXPECT_EQ(set.configurations.at(0), (Configuration{0, 1, 0}));
  EXPECT_EQ(set.beyond_limits, 0u);
}

}  // namespace
}  // namespace collision_hulls
