// collision_hulls_bag_reader: reads the joint states of a bag for the node, which starts it, in a process that can do nothing else.
//
// rosbag opens a file by its name, which a confined process cannot. But it has the one file that it is to read, already open: so here
// fopen64(), which rosbag calls, gives that one, whatever the name. Bags are set up before that, as they look for plugins on the disk.
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/JointState.h>
#include <stdio.h>

#include <stdexcept>

#include "collision_hulls/error.h"
#include "ros/bags/recorded_state.h"
#include "sandbox/serve.h"

namespace {

int g_given_file = -1;  // of the worker

}  // namespace

extern "C" {
std::FILE* fopen64(const char* name, const char* mode);
}

std::FILE* fopen64(const char* name, const char* mode) {
  return g_given_file >= 0 ? fdopen(g_given_file, "rb") : std::fopen(name, mode);
}

namespace collision_hulls {
namespace {

std::vector<RecordedState> statesIn(rosbag::Bag& bag, const std::string& topic) {
  bag.open("given", rosbag::bagmode::Read);
  rosbag::View view(bag, [&](const rosbag::ConnectionInfo* connection) {
    return connection->datatype == kJointStateType && (topic.empty() || connection->topic == topic);
  });
  std::vector<RecordedState> states;
  for (const rosbag::MessageInstance& message : view) {
    const sensor_msgs::JointStateConstPtr state = message.instantiate<sensor_msgs::JointState>();
    if (!state) throw std::runtime_error("topic " + message.getTopic() + " has another version of " + kJointStateType);
    states.push_back({state->name, state->position});
  }
  return states;
}

std::string answer(rosbag::Bag& bag, const Question& question) {
  std::string name, topic;
  fromBytes(question.head, name, topic);
  g_given_file = question.file;
  try {
    return toBytes(statesIn(bag, topic));
  } catch (const std::exception& error) {
    throw Error(ErrorCode::kBadConfigurations, "'" + name + "' cannot be read: " + error.what() + "; 'rosbag reindex' may mend it");
  }
}

}  // namespace
}  // namespace collision_hulls

int main() {
  rosbag::Bag bag;
  return collision_hulls::serve([&bag](const collision_hulls::Question& question) { return collision_hulls::answer(bag, question); });
}
