// The node's topics for rviz.
#pragma once

#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <array>
#include <map>
#include <mutex>
#include <set>
#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/pipeline/result.h"
#include "markers.h"

namespace collision_hulls {

/// Publishes what there is to see of a run, from its start to its result: latched MarkerArrays on ~hulls, ~original, ~protrusion, ~labels,
/// ~unneeded, ~segments, ~scene, ~chosen and ~progress, one display each, and on ~markers all but the last two. Every array first deletes
/// the markers of the one before, but for those that replace single links. Sets the parameter ~view to the robot's name, root link and
/// bounds, for the camera.
///
/// rviz drops markers whose frame it does not know (yet), and latched ones never come again. So all is published again, a few times at
/// growing intervals, after each new subscriber and after each link's first transform on /tf or /tf_static. Thread safe; needs a spinner.
class View {
 public:
  /// `node`: the private name space.
  explicit View(const ros::NodeHandle& node);

  /// A run begins: shows the original at once, unless an earlier result is shown, which stays until the next.
  void begin(const RobotDescription& robot, const PackageFinder& find_package, const Options& options, const RunControl& control);

  /// How far it is; does nothing where that would change no character of the text.
  void progress(const Step& step);

  /// Its result, with the scene that the robot was fitted to (null: none).
  void show(const RobotResult& result, const Scene* scene = nullptr);

  struct Redraw {
    bool chosen = false;   ///< their edges take the place of others'; false: nobody's edges are drawn
    bool settled = false;  ///< no other change is about to follow
  };
  /// Draws these links anew, as far as hulls and protrusion go. Subscribers get only what changes; those that come later get all, as after
  /// each new subscriber. Throws kCancelled; nothing is drawn then.
  void replace(const std::vector<ShownLink>& links, Redraw redraw, const RunControl& control);

  /// It is over, whether with a result or not.
  void end();

 private:
  enum Topic { kHulls, kOriginal, kProtrusion, kLabels, kUnneeded, kSegments, kScene, kChosen, kProgress, kAll, kTopics };
  struct Display {
    ros::Publisher publisher;
    visualization_msgs::MarkerArray markers;
    std::map<std::string, int> used;  // by namespace: one more than the largest id that subscribers may have
  };

  void put(Topic topic, MarkerList markers);  // these need the mutex to be held
  void put(Drawing drawing);
  void replace(Topic topic, const std::set<std::string>& links, const MarkerList& markers, bool settled);
  void putProgress(const std::string& text);
  void repeatSoon();

  void announceBounds(const std::string& robot);
  void subscribed();
  void transformed(const tf2_msgs::TFMessageConstPtr& message);
  void repeat();

  std::mutex mutex_;
  ros::NodeHandle node_;
  double opacity_ = 1;
  bool has_result_ = false;
  RobotDescription robot_;  // of the run
  std::string root_, progress_text_;
  RobotBounds bounds_;
  std::array<Display, kTopics> displays_;
  std::set<std::string> drawn_, seen_;              // frames: of markers, and with a transform
  std::size_t repeats_ = 0;                         // since the last event
  ros::SteadyTime due_;                             // when to publish again; zero: not until something happens
  ros::SteadyTimer timer_;                          // never stops: stopping it under the lock that its callback waits for may hang
  ros::Subscriber transforms_, static_transforms_;  // last, so that no call comes to a half-built or half-gone view
};

/// A run, for as long as it is shown as one.
class ViewedRun {
 public:
  ViewedRun(View& view, const RobotDescription& robot, const PackageFinder& find_package, const Options& options, const RunControl& control)
      : view_(view) {
    view_.begin(robot, find_package, options, control);
  }
  ~ViewedRun() { view_.end(); }
  ViewedRun(const ViewedRun&) = delete;
  ViewedRun& operator=(const ViewedRun&) = delete;

  /// `step`, which may be empty, with the progress shown as well.
  StepCallback shown(StepCallback step) const;

 private:
  View& view_;
};

}  // namespace collision_hulls
