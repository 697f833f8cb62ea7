// What the node knows of each link: ~preview, which cuts hull trees, and ~state.
#pragma once

#include <collision_hulls/LinkPreview.h>
#include <collision_hulls/NodeState.h>
#include <collision_hulls/Preview.h>
#include <ros/ros.h>

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision_hulls/config/link_decisions.h"
#include "robot_trees.h"
#include "ros/view.h"

namespace collision_hulls {

/// Serves ~preview from the links' last results and from hull trees, and publishes ~state (latched). A service, not a topic pair: a caller
/// knows which answer belongs to its question, and a slider that waits for each answer never floods the node. Thread safe.
class LinkPreviews {
 public:
  /// `node`: the private name space. Nothing comes in before open().
  LinkPreviews(const ros::NodeHandle& node, View& view);
  void open();

  RobotTrees& trees() { return trees_; }

  /// Whether the links of another robot, or of none, are known.
  bool isNews(const RobotDescription& robot) const;

  /// What a run made: the results of its links take the place of earlier ones. Those of other links stay if the robot is the same.
  void take(const RobotDescription& robot, const LinkDecisions& decisions, const RobotResult& result);

  /// The results of these links as messages; empty: of all. Throws kCancelled.
  std::vector<LinkPreview> messages(const std::vector<std::string>& links, const RunControl& control) const;

  /// The last results of these links, empty: of all, and the robot that has them. Throws kBadOption for a link that it does not have, or
  /// that is named twice.
  std::map<std::string, LinkResult> results(const std::vector<std::string>& links) const;
  RobotDescription robot() const;

  /// Draws the last results of these links, with their edges; empty: of all, without. Throws kCancelled.
  void show(const std::vector<std::string>& links, const RunControl& control);

  /// For the way out: cancels the call in progress and those to come.
  void stop() { stopping_.cancel(); }

  /// The state while the node works on a job, and when it ends (empty).
  void working(const std::string& job);
  void progress(const Step& step);

 private:
  /// A link's last result.
  struct Known {
    LinkOptions options;
    LinkResult result;
    bool proved = false;
  };

  bool serve(PreviewRequest& request, PreviewResponse& response);
  std::vector<LinkPreview> messagesLocked(const std::vector<std::string>& links, const RunControl& control) const;
  void cutAll(const PreviewRequest& request, PreviewResponse& response);
  std::optional<Known> cut(const LinkChoice& settings) const;
  LinkPreview unbuilt(const LinkChoice& settings) const;
  LinkOptions withTree(LinkOptions options) const;
  const LinkDescription& described(const std::string& link) const;
  std::set<std::string> chosen(const std::string& field, const std::vector<std::string>& links) const;
  ShownLink shown(const std::string& link, const Known& known) const;
  LinkPreview message(const std::string& link, const Known& known, const RunControl& control) const;
  void publish();

  View& view_;
  RobotTrees trees_;
  RunControl stopping_;  // of calls of ~preview
  mutable std::mutex mutex_;
  RobotDescription robot_;
  std::map<std::string, std::size_t> places_;  // of its links, by name
  std::map<std::string, Known> known_;
  std::optional<Length> tree_;     // of the last build
  std::optional<Options> config_;  // of the last run on all links, with the regions of the last one
  NodeState state_;
  ros::NodeHandle node_;
  ros::Publisher publisher_;
  ros::ServiceServer service_;  // last, so that no call comes to what is half gone
};

/// A job, for as long as the node works on it.
class StatedJob {
 public:
  StatedJob(LinkPreviews& preview, const std::string& job) : preview_(preview) { preview_.working(job); }
  ~StatedJob() { preview_.working(""); }
  StatedJob(const StatedJob&) = delete;
  StatedJob& operator=(const StatedJob&) = delete;

  /// `step`, which may be empty, with the state published as well.
  StepCallback stated(StepCallback step) const;

 private:
  LinkPreviews& preview_;
};

}  // namespace collision_hulls
