// Also tests src/ros/bags/bag_reader.cpp.
#include "ros/joint_states.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/String.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

/// An arm with two joints, and a folder for bags.
class JointStates : public ::testing::Test {
 protected:
  JointStates() {
    std::string name = (fs::temp_directory_path() / "joint_states_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~JointStates() override { fs::remove_all(folder_); }

  static std::string joint(const std::string& name, const std::string& parent, const std::string& child) {
    return "<link name='" + child + "'/><joint name='" + name + "' type='revolute'><parent link='" + parent + "'/><child link='" + child +
           "'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>";
  }

  static sensor_msgs::JointState state(std::vector<std::string> names, std::vector<double> positions) {
    sensor_msgs::JointState message;
    message.name = std::move(names);
    message.position = std::move(positions);
    return message;
  }

  ConfigurationSet read(const std::string& source) const {
    return readJointStates(source, [&](const std::string& file) { return (folder_ / file).string(); }, Kinematics(robot_), {});
  }

  ErrorCode errorOf(const std::string& source, std::string* message = nullptr) const {
    try {
      read(source);
    } catch (const Error& error) {
      if (message) *message = error.what();
      return error.code();
    }
    ADD_FAILURE() << "no error";
    return ErrorCode::kInternal;
  }

  /// Two topics, the second with one state; and a message of another type.
  std::string recorded() const {
    std::string file = folder_ / "run.bag";
    rosbag::Bag bag(file, rosbag::bagmode::Write);
    bag.write("/joint_states", ros::Time(1), state({"a", "b"}, {0.1, 0.2}));
    bag.write("/joint_states", ros::Time(2), state({"b"}, {0.4}));
    bag.write("/said", ros::Time(3), std_msgs::String());
    bag.write("/gripper", ros::Time(4), state({"a"}, {-0.5}));
    bag.close();
    return file;
  }

  fs::path folder_;
  RobotDescription robot_ = parseRobotDescription("<robot name='r'><link name='base'/>" + joint("a", "base", "upper") +
                                                  joint("b", "upper", "lower") + "</robot>");
};

TEST_F(JointStates, WhatIsOne) {
  for (const char* source : {"topic:/joint_states", "topic:/joint_states 5", "a.bag", "my runs/a.bag", "a.bag /joint_states"})
    EXPECT_TRUE(areJointStates(source)) << source;
  for (const char* source : {"", "a.csv", "my runs/a.yaml", "a.bag.csv"}) EXPECT_FALSE(areJointStates(source)) << source;
}

TEST_F(JointStates, WhatCannotBeRead) {
  EXPECT_EQ(errorOf((folder_ / "none.bag").string()), ErrorCode::kFileNotFound);
  const std::string rubbish = folder_ / "rubbish.bag", empty = folder_ / "empty.bag";
  std::ofstream(rubbish) << "no bag at all";
  std::string message;
  EXPECT_EQ(errorOf(rubbish, &message), ErrorCode::kBadConfigurations);
  EXPECT_NE(message.find("rubbish.bag"), std::string::npos) << message;
  rosbag::Bag(empty, rosbag::bagmode::Write).close();
  EXPECT_EQ(errorOf(empty, &message), ErrorCode::kBadConfigurations);
  EXPECT_EQ(message.find("seconds"), std::string::npos) << message;
  EXPECT_EQ(errorOf(recorded() + " /said"), ErrorCode::kBadConfigurations);
  EXPECT_EQ(errorOf("topic:/joint_states soon"), ErrorCode::kBadOption);
  EXPECT_EQ(errorOf("topic:/joint_states -1"), ErrorCode::kBadOption);
}

TEST_F(JointStates, OfABag) {
  const std::string bag = recorded();
  EXPECT_EQ(read(bag + " /joint_states").configurations, (std::vector<Configuration>{{0.1, 0.2}, {0.1, 0.4}}));
  EXPECT_EQ(read("run.bag").configurations, read(bag).configurations);
  EXPECT_EQ(read(bag).configurations, (std::vector<Configuration>{{0.1, 0.2}, {0.1, 0.4}, {-0.5, 0.4}}));
}

TEST_F(JointStates, MessagesAreNamed) {
  const std::string file = folder_ / "unknown.bag";
  rosbag::Bag bag(file, rosbag::bagmode::Write);
  bag.write("/joint_states", ros::Time(1), state({"a"}, {0}));
  bag.write("/joint_states", ros::Time(2), state({"elbow"}, {0}));
  bag.close();
  std::string message;
  EXPECT_EQ(errorOf(file, &message), ErrorCode::kBadConfigurations);
  EXPECT_NE(message.find("unknown.bag', message 2"), std::string::npos) << message;
}

TEST_F(JointStates, MessagesWithoutPositionsArePassedOver) {
  const std::string some = folder_ / "some.bag", none = folder_ / "none_at_all.bag";
  for (const std::string& file : {some, none}) {
    rosbag::Bag bag(file, rosbag::bagmode::Write);
    bag.write("/joint_states", ros::Time(1), state({"a", "b"}, {}));
    bag.write("/joint_states", ros::Time(2), state({}, {}));
    if (file == some) bag.write("/joint_states", ros::Time(3), state({"a", "b"}, {0.1, 0.2}));
    bag.close();
  }
  const ConfigurationSet set = read(some);
  EXPECT_EQ(set.configurations, (std::vector<Configuration>{{0.1, 0.2}}));
  ASSERT_EQ(set.notes.size(), 1u);
  EXPECT_NE(set.notes[0].find("some.bag', message 1, of joint 'a'"), std::string::npos) << set.notes[0];
  std::string message;
  EXPECT_EQ(errorOf(none, &message), ErrorCode::kBadConfigurations);
  EXPECT_NE(message.find("has no message of sensor_msgs/JointState with positions, of 2 in all"), std::string::npos) << message;
}

/// rosbag trusts a bag's index: an offset beyond the chunk makes it read there.
TEST_F(JointStates, DamagedIndexIsAnError) {
  std::ifstream in(recorded(), std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}}, first_time{"\1\0\0\0\0\0\0\0", 8};
  int failed = 0;
  for (std::size_t at = whole.find(first_time); at != std::string::npos; at = whole.find(first_time, at + 1)) {
    std::string damaged = whole;
    damaged.replace(at + first_time.size(), 4, "\xf0\xff\xff\x7f");
    const std::string file = folder_ / "damaged.bag";
    std::ofstream(file, std::ios::binary) << damaged;
    try {
      read(file);
    } catch (const Error& error) {
      failed += error.code() == ErrorCode::kReaderFailed;
      EXPECT_NE(std::string(error.what()).find("damaged.bag'"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(failed, 0);
}

}  // namespace
}  // namespace collision_hulls
