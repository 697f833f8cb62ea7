// Joint states to configurations: listens to a topic for some seconds, or reads a bag, and collects what the messages say of the joints.
// A damaged bag can crash rosbag or make it allocate without end, so another program reads it (bags/bag_reader.cpp).
#include "joint_states.h"

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <sstream>
#include <vector>

#include "bags/recorded_state.h"
#include "base/read_file.h"
#include "collision_hulls/error.h"
#include "sandbox/reader_program.h"
#include "topic_type.h"
#include "waiting.h"

namespace collision_hulls {
namespace {

const std::string kBag = ".bag", kType = kJointStateType;
constexpr double kUsualSeconds = 10, kMostSeconds = 3600;
constexpr std::uint32_t kQueue = 10'000;  // messages

using JointStates = std::vector<RecordedState>;

/// A source split before its last word; the second part is empty if there is one word.
std::pair<std::string, std::string> parts(const std::string& source) {
  const std::size_t space = source.rfind(' ');
  if (space == std::string::npos) return {source, ""};
  return {source.substr(0, space), source.substr(space + 1)};
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// A bag's file and the topic in it, if one is named; the file is empty if the source is no bag.
std::pair<std::string, std::string> bagAndTopic(const std::string& source) {
  if (endsWith(source, kBag)) return {source, ""};
  const auto [file, topic] = parts(source);
  return endsWith(file, kBag) ? std::pair(file, topic) : std::pair(std::string(), std::string());
}

/// What messages of a source say, one after another.
class Collection {
 public:
  Collection(const std::string& source, const Kinematics& kinematics, const ConfigurationOptions& options)
      : source_(source), collector_(kinematics, options) {}

  void add(const std::vector<std::string>& names, const std::vector<double>& positions, const RunControl& control) {
    ++messages_;
    if (names.empty() && positions.empty()) return;  // it says nothing of any joint
    collector_.add(names, positions, "'" + source_ + "', message " + std::to_string(messages_), control);
  }

  ConfigurationSet take(const std::string& or_else) {
    if (messages_ == 0)
      throw Error(ErrorCode::kBadConfigurations,
                  "'" + source_ + "' has no message of " + kType + "; give a source that has some" + or_else);
    ConfigurationSet set = collector_.take();
    if (set.configurations.empty())
      throw Error(ErrorCode::kBadConfigurations, "'" + source_ + "' has no message of " + kType + " with positions, of " +
                                                     std::to_string(messages_) + " in all; give a source that has some" + or_else);
    return set;
  }

 private:
  const std::string source_;
  ConfigurationCollector collector_;
  std::size_t messages_ = 0;
};

/// Of a bag with many other topics little is kept: its index, one chunk at a time, and the joint states.
ReadingLimits limitsFor(std::uint64_t bag_bytes) {
  ReadingLimits limits;
  limits.worker.memory = (std::uint64_t{1} << 30) + bag_bytes;
  limits.answer = limits.worker.memory / 4;
  limits.worker.cpu_seconds = 10 + bag_bytes / 10'000'000;
  limits.clock_seconds = 10 * static_cast<double>(limits.worker.cpu_seconds);
  return limits;
}

JointStates fromBag(const std::string& file, const std::string& topic, const RunControl& control) {
  static auto* const reader = new ReaderProgram("collision_hulls_bag_reader", "COLLISION_HULLS_BAG_READER");  // threads may outlive main()
  const OpenFile bag(file);
  bag.expectAllowed();
  bag.expectRegular("bag");
  const std::string head = toBytes(file, topic);
  const std::string answer = reader->ask({head, {}, bag.number()}, limitsFor(static_cast<std::uint64_t>(bag.status().st_size)),
                                         "'" + file + "'", "give a bag with fewer messages, as 'rosbag filter' makes it", control);
  return madeOfAnswer("'" + file + "'", "record it again", [&] {
    JointStates states;
    fromBytes(answer, states);
    return states;
  });
}

double secondsOf(const std::string& word, const std::string& source) {
  if (word.empty()) return kUsualSeconds;
  std::istringstream in(word);
  double seconds = 0;
  if (in >> seconds && in.eof() && seconds > 0 && seconds <= kMostSeconds) return seconds;
  throw Error(ErrorCode::kBadOption, "configurations '" + source +
                                         "' is not understood: give 'topic:NAME SECONDS', with up to 3600 seconds to "
                                         "listen");
}

void expectJointStates(const std::string& topic) {
  const std::optional<std::string> type = typeOfTopic(topic);
  if (!type)
    throw Error(ErrorCode::kBadOption,
                "configurations '" + topic + "' has no publisher; start its node, or give the full name (see 'rostopic list')");
  if (*type != kType) throw Error(ErrorCode::kBadOption, "configurations '" + topic + "' is a " + *type + "; give a topic of " + kType);
}

/// Until time is over, or a message is wrong or one too many.
void listen(const std::string& topic, double seconds, Collection& collection, const RunControl& control) {
  expectJointStates(topic);
  std::exception_ptr failure;
  ros::CallbackQueue queue;  // of its own: the node's threads may all be busy
  ros::NodeHandle node;
  node.setCallbackQueue(&queue);
  const boost::function<void(const sensor_msgs::JointStateConstPtr&)> keep = [&](const auto& state) {
    try {
      if (!failure) collection.add(state->name, state->position, control);
    } catch (...) {
      failure = std::current_exception();
    }
  };
  const ros::Subscriber subscriber = node.subscribe<sensor_msgs::JointState>(topic, kQueue, keep);
  const auto take = [&] {
    queue.callAvailable();
    return failure != nullptr;
  };
  waitFor(take, seconds, control);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

bool areJointStates(const std::string& source) {
  return source.compare(0, kTopicPrefix.size(), kTopicPrefix) == 0 || !bagAndTopic(source).first.empty();
}

ConfigurationSet readJointStates(const std::string& source, const std::function<std::string(const std::string&)>& path,
                                 const Kinematics& kinematics, const ConfigurationOptions& options, const RunControl& control) {
  Collection collection(source, kinematics, options);
  const auto [file, bag_topic] = bagAndTopic(source);
  if (!file.empty()) {
    for (const RecordedState& state : fromBag(path(file), bag_topic, control)) collection.add(state.names, state.positions, control);
    return collection.take("");
  }
  const auto [topic, seconds] = parts(source.substr(kTopicPrefix.size()));
  listen(topic, secondsOf(seconds, source), collection, control);
  return collection.take(", or more seconds");
}

}  // namespace collision_hulls
