// Keeps what is drawn, topic by topic, and publishes it: on a change, and again when rviz may have been too early to keep it.
//
// Publishing again is bounded, since the original of a large robot takes tens of megabytes: kRepeats after each event, to subscribers only.
// An event is a subscriber that connects or a frame that appears, never a clock.
#include "view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "annotations.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/fit_scene.h"
#include "collision_hulls/pipeline/progress_text.h"
#include "parameters.h"

namespace collision_hulls {
namespace {

constexpr double kTick = 0.25;              // [s] between looks at whether something is due
constexpr double kRepeats[] = {0.5, 2, 8};  // [s] after an event and after each other: rviz hears of a frame at another time than we do
constexpr double kOpacity = 0.6;

visualization_msgs::Marker deleteAll() {
  visualization_msgs::Marker marker;
  marker.action = visualization_msgs::Marker::DELETEALL;
  return marker;
}

/// Takes a marker away, which rviz does as soon as it hears of it.
visualization_msgs::Marker deleted(const std::string& name, int id) {
  visualization_msgs::Marker marker;
  marker.ns = name;
  marker.id = id;
  marker.action = visualization_msgs::Marker::DELETE;
  return marker;
}

/// Leaves nothing to be seen of a marker: a triangle without area, which rviz takes in the order of arrival.
visualization_msgs::Marker blank(const std::string& name, int id, const std::string& frame) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;
  marker.ns = name;
  marker.id = id;
  marker.type = visualization_msgs::Marker::TRIANGLE_LIST;
  marker.frame_locked = true;  // as the marker was: rviz 1.14 aborts where this changes
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  marker.color.a = 1;
  marker.points.resize(3);
  return marker;
}

/// The kind and the link of "hulls/forearm".
std::pair<std::string, std::string> partsOf(const std::string& name) {
  const std::size_t slash = std::min(name.find('/'), name.size());
  return {name.substr(0, slash), name.substr(std::min(slash + 1, name.size()))};
}

/// tf2 frames have no leading slash; older publishers write one.
std::string frameName(const std::string& name) {
  return name.substr(std::min(name.find_first_not_of('/'), name.size()));
}

/// What is wrong with it is not worth an end of the node.
double opacityOf(const ros::NodeHandle& node) {
  double opacity = kOpacity;
  try {
    opacity = numberParameter(node, "opacity", kOpacity);
  } catch (const Error& error) {
    ROS_ERROR("%s", error.what());
  }
  if (opacity >= 0 && opacity <= 1) return opacity;
  ROS_ERROR("parameter %s is %g: set it to a number from 0 to 1", node.resolveName("opacity").c_str(), opacity);
  return kOpacity;
}

}  // namespace

StepCallback ViewedRun::shown(StepCallback step) const {
  return [&view = view_, step = std::move(step)](const Step& now) {
    view.progress(now);
    if (step) step(now);
  };
}

View::View(const ros::NodeHandle& node) : node_(node) {
  opacity_ = opacityOf(node);
  const char* const names[kTopics] = {"hulls",    "original", "protrusion", "labels",   "unneeded",
                                      "segments", "scene",    "chosen",     "progress", "markers"};
  const auto connected = [this](const ros::SingleSubscriberPublisher&) { subscribed(); };
  for (std::size_t i = 0; i < kTopics; ++i)
    displays_[i].publisher = node_.advertise<visualization_msgs::MarkerArray>(names[i], 1, connected, {}, ros::VoidConstPtr(), true);
  for (std::size_t i = 0; i < kTopics; ++i) put(static_cast<Topic>(i), {});  // what an earlier node of this name left in rviz goes
  timer_ = node_.createSteadyTimer(ros::WallDuration(kTick), [this](const ros::SteadyTimerEvent&) { repeat(); });
  transforms_ = node_.subscribe("/tf", 100, &View::transformed, this);
  static_transforms_ = node_.subscribe("/tf_static", 100, &View::transformed, this);
}

void View::begin(const RobotDescription& robot, const PackageFinder& find_package, const Options& options, const RunControl& control) {
  const MeshFile file = [&](const std::string& uri) { return resolveUri(uri, robot.path, find_package); };
  Drawing original = drawOriginal(robot, options.source, file);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    robot_ = robot;
    root_ = rootLink(robot);
    if (!has_result_) put(std::move(original));
  }
  const RobotBounds bounds = robotBounds(robot, options.source, {file, meshLimits(options), control});
  const std::lock_guard<std::mutex> lock(mutex_);
  bounds_ = bounds;
  announceBounds(robot.name);
}

void View::progress(const Step& step) {
  if (step.fraction >= 1) return;  // it is over at once, and rviz might show this text after that: see replace()
  const std::lock_guard<std::mutex> lock(mutex_);
  putProgress(progressLine(step));
}

void View::show(const RobotResult& result, const Scene* scene) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Drawing drawing = drawResult(result, robot_, scene, opacity_);
  if (scene && !scene->bodies.empty() && drawing.scene.empty())
    ROS_WARN("the scene '%s' is not shown in rviz: it has more than %zu triangles; simplify its meshes to see it. The fit uses all of them",
             scene->name.c_str(), kMostSceneTriangles);
  has_result_ = true;
  put(std::move(drawing));
}

void View::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  putProgress("");
}

void View::put(Topic topic, MarkerList markers) {
  Display& display = displays_[topic];
  display.used.clear();
  for (const visualization_msgs::Marker& marker : markers) {
    drawn_.insert(marker.header.frame_id);
    int& used = display.used[marker.ns];
    used = std::max(used, marker.id + 1);
  }
  display.markers.markers = std::move(markers);
  display.markers.markers.insert(display.markers.markers.begin(), deleteAll());
  display.publisher.publish(display.markers);
}

void View::put(Drawing drawing) {
  drawn_.clear();
  MarkerList all;
  for (const MarkerList* list :
       {&drawing.hulls, &drawing.original, &drawing.protrusion, &drawing.labels, &drawing.unneeded, &drawing.segments, &drawing.scene})
    all.insert(all.end(), list->begin(), list->end());
  put(kAll, std::move(all));
  put(kHulls, std::move(drawing.hulls));
  put(kOriginal, std::move(drawing.original));
  put(kProtrusion, std::move(drawing.protrusion));
  put(kLabels, std::move(drawing.labels));
  put(kUnneeded, std::move(drawing.unneeded));
  put(kSegments, std::move(drawing.segments));
  put(kScene, std::move(drawing.scene));
  put(kChosen, std::move(drawing.chosen));
  repeatSoon();
}

void View::replace(const std::vector<ShownLink>& links, Redraw redraw, const RunControl& control) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::set<std::string> names;
  Drawing all;
  for (const ShownLink& link : links) {
    control.check();
    names.insert(link.link.name);
    const Drawing drawing = drawLink(link, bounds_.radius, opacity_);
    for (const auto list : {&Drawing::hulls, &Drawing::protrusion, &Drawing::chosen})
      (all.*list).insert((all.*list).end(), (drawing.*list).begin(), (drawing.*list).end());
  }
  if (!redraw.chosen) all.chosen.clear();
  replace(kHulls, names, all.hulls, redraw.settled);
  std::set<std::string> chosen = names;
  for (const auto& [name, used] : displays_[kChosen].used) chosen.insert(partsOf(name).second);
  replace(kChosen, chosen, all.chosen, redraw.settled);
  replace(kProtrusion, names, all.protrusion, redraw.settled);
  all.hulls.insert(all.hulls.end(), all.protrusion.begin(), all.protrusion.end());
  replace(kAll, names, all.hulls, redraw.settled);
}

/// Publishes the difference alone: a large robot's markers take longer than a slider may.
///
/// rviz lets what it has to draw wait for its frame, at least until the next turn of its loop; a DELETE does not wait, and overtakes what
/// was sent shortly before. So markers that are no longer needed become blank, and are deleted once the links have settled.
void View::replace(Topic topic, const std::set<std::string>& links, const MarkerList& markers, bool settled) {
  static const std::set<std::string> kinds{"hulls", "primitives", "worst", "chosen"};
  const auto is_replaced = [&](const std::string& name) {
    const auto [kind, link] = partsOf(name);
    return kinds.count(kind) > 0 && links.count(link) > 0;
  };
  Display& display = displays_[topic];
  MarkerList& shown = display.markers.markers;
  const auto is_old = [&](const visualization_msgs::Marker& marker) { return is_replaced(marker.ns); };
  shown.erase(std::remove_if(shown.begin(), shown.end(), is_old), shown.end());
  shown.insert(shown.end(), markers.begin(), markers.end());
  visualization_msgs::MarkerArray change;
  change.markers = markers;
  std::map<std::string, int> needed;
  for (const visualization_msgs::Marker& marker : markers) {
    needed[marker.ns] = std::max(needed[marker.ns], marker.id + 1);
    drawn_.insert(marker.header.frame_id);
  }
  for (auto& [name, used] : display.used) {
    if (!is_replaced(name)) continue;
    for (int id = needed[name]; id < used; ++id)
      change.markers.push_back(settled ? deleted(name, id) : blank(name, id, partsOf(name).second));
    if (settled) used = 0;
  }
  for (const auto& [name, count] : needed) display.used[name] = std::max(display.used[name], count);
  if (!change.markers.empty() && display.publisher.getNumSubscribers() > 0) display.publisher.publish(change);
}

void View::putProgress(const std::string& text) {
  if (text == progress_text_) return;
  progress_text_ = text;
  put(kProgress, text.empty() ? MarkerList() : MarkerList{drawProgress(text, root_, bounds_)});
}

void View::announceBounds(const std::string& robot) {
  XmlRpc::XmlRpcValue value;
  value["robot"] = robot;
  value["frame"] = root_;
  for (int i = 0; i < 3; ++i) value["centre"][i] = bounds_.centre[i];
  value["radius"] = bounds_.radius;
  node_.setParam("view", value);
}

void View::subscribed() {
  const std::lock_guard<std::mutex> lock(mutex_);
  repeatSoon();
}

void View::transformed(const tf2_msgs::TFMessageConstPtr& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  bool is_news = false;
  for (const geometry_msgs::TransformStamped& transform : message->transforms) {
    for (const std::string& frame : {frameName(transform.child_frame_id), frameName(transform.header.frame_id)}) {
      if (drawn_.count(frame) && seen_.insert(frame).second) is_news = true;  // others might be numbered without end
    }
  }
  if (is_news) repeatSoon();
}

void View::repeatSoon() {
  repeats_ = 0;
  due_ = ros::SteadyTime::now() + ros::WallDuration(kRepeats[0]);
}

void View::repeat() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (due_.isZero() || ros::SteadyTime::now() < due_) return;
  for (const Display& display : displays_) {
    if (display.publisher.getNumSubscribers() > 0 && !display.markers.markers.empty()) display.publisher.publish(display.markers);
  }
  due_ = ++repeats_ == std::size(kRepeats) ? ros::SteadyTime() : ros::SteadyTime::now() + ros::WallDuration(kRepeats[repeats_]);
}

}  // namespace collision_hulls
