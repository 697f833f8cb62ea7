// Keeps what is drawn, topic by topic, and publishes it: on a change, and again when rviz may have been too early to keep it.
//
// Publishing again is bounded, since the original of a large robot takes tens of megabytes: kRepeats after each event, to subscribers only.
// An event is a subscriber that connects or a frame that appears, never a clock.
#include "view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "annotations.h"
#include "collision_hulls/pipeline/progress_text.h"

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

visualization_msgs::Marker deleted(const visualization_msgs::Marker& shown) {
  visualization_msgs::Marker marker;
  marker.header = shown.header;
  marker.ns = shown.ns;
  marker.id = shown.id;
  marker.action = visualization_msgs::Marker::DELETE;
  return marker;
}

/// tf2 frames have no leading slash; older publishers write one.
std::string frameName(const std::string& name) {
  return name.substr(std::min(name.find_first_not_of('/'), name.size()));
}

std::string rootOf(const RobotDescription& robot) {
  for (const LinkDescription& link : robot.links)
    if (link.parent.empty()) return link.name;
  return "";
}

}  // namespace

StepCallback ViewedRun::shown(StepCallback step) const {
  return [&view = view_, step = std::move(step)](const Step& now) {
    view.progress(now);
    if (step) step(now);
  };
}

View::View(const ros::NodeHandle& node) : node_(node) {
  opacity_ = std::clamp(node_.param("opacity", kOpacity), 0.0, 1.0);
  const char* const names[kTopics] = {"hulls",    "original", "protrusion", "labels",   "unneeded",
                                      "segments", "scene",    "chosen",     "progress", "markers"};
  const auto connected = [this](const ros::SingleSubscriberPublisher&) { subscribed(); };
  for (std::size_t i = 0; i < kTopics; ++i)
    displays_[i].publisher = node_.advertise<visualization_msgs::MarkerArray>(names[i], 1, connected, {}, ros::VoidConstPtr(), true);
  for (std::size_t i = 0; i < kTopics; ++i) put(static_cast<Topic>(i), {});  // what an earlier node of this name left in rviz goes
  timer_ = node_.createWallTimer(ros::WallDuration(kTick), [this](const ros::WallTimerEvent&) { repeat(); });
  transforms_ = node_.subscribe("/tf", 100, &View::transformed, this);
  static_transforms_ = node_.subscribe("/tf_static", 100, &View::transformed, this);
}

void View::begin(const RobotDescription& robot, Source source, const PackageFinder& find_package) {
  const MeshFile file = [&](const std::string& uri) { return resolveUri(uri, robot.path, find_package); };
  Drawing original = drawOriginal(robot, source, file);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    robot_ = robot;
    root_ = rootOf(robot);
    if (!has_result_) put(std::move(original));
  }
  const RobotBounds bounds = robotBounds(robot, source, file);
  const std::lock_guard<std::mutex> lock(mutex_);
  bounds_ = bounds;
  announceBounds(robot.name);
}

void View::progress(const Step& step) {
  const std::lock_guard<std::mutex> lock(mutex_);
  putProgress(progressLine(step));
}

void View::show(const RobotResult& result, const Scene* scene) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Drawing drawing = drawResult(result, robot_, scene, opacity_);
  if (scene && !scene->bodies.empty() && drawing.scene.empty())
    ROS_WARN("the scene '%s' is not shown: it has more than %zu triangles", scene->name.c_str(), kMostSceneTriangles);
  has_result_ = true;
  put(std::move(drawing));
}

void View::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  putProgress("");
}

void View::put(Topic topic, MarkerList markers) {
  Display& display = displays_[topic];
  for (const visualization_msgs::Marker& marker : markers) drawn_.insert(marker.header.frame_id);
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

void View::replace(const std::vector<ShownLink>& links, bool chosen) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::set<std::string> names;
  Drawing all;
  for (const ShownLink& link : links) {
    names.insert(link.link.name);
    const Drawing drawing = drawLink(link, bounds_.radius, opacity_);
    for (const auto list : {&Drawing::hulls, &Drawing::protrusion, &Drawing::chosen})
      (all.*list).insert((all.*list).end(), (drawing.*list).begin(), (drawing.*list).end());
  }
  replace(kHulls, names, all.hulls);
  put(kChosen, chosen ? std::move(all.chosen) : MarkerList());
  replace(kProtrusion, names, all.protrusion);
  all.hulls.insert(all.hulls.end(), all.protrusion.begin(), all.protrusion.end());
  replace(kAll, names, all.hulls);
}

/// Publishes the difference alone: a large robot's markers take longer than a slider may.
void View::replace(Topic topic, const std::set<std::string>& links, const MarkerList& markers) {
  std::set<std::pair<std::string, int>> kept;
  for (const visualization_msgs::Marker& marker : markers) kept.insert({marker.ns, marker.id}), drawn_.insert(marker.header.frame_id);
  Display& display = displays_[topic];
  MarkerList& shown = display.markers.markers;
  visualization_msgs::MarkerArray change;
  const auto is_replaced = [&](const visualization_msgs::Marker& marker) {
    const std::size_t slash = marker.ns.find('/');
    const std::string kind = marker.ns.substr(0, slash);
    if ((kind != "hulls" && kind != "primitives" && kind != "worst") || links.count(marker.ns.substr(slash + 1)) == 0) return false;
    if (kept.count({marker.ns, marker.id}) == 0) change.markers.push_back(deleted(marker));
    return true;
  };
  shown.erase(std::remove_if(shown.begin(), shown.end(), is_replaced), shown.end());
  shown.insert(shown.end(), markers.begin(), markers.end());
  change.markers.insert(change.markers.end(), markers.begin(), markers.end());
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
      if (seen_.insert(frame).second && drawn_.count(frame)) is_news = true;
    }
  }
  if (is_news) repeatSoon();
}

void View::repeatSoon() {
  repeats_ = 0;
  due_ = ros::WallTime::now() + ros::WallDuration(kRepeats[0]);
}

void View::repeat() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (due_.isZero() || ros::WallTime::now() < due_) return;
  for (const Display& display : displays_) {
    if (display.publisher.getNumSubscribers() > 0 && !display.markers.markers.empty()) display.publisher.publish(display.markers);
  }
  due_ = ++repeats_ == std::size(kRepeats) ? ros::WallTime() : ros::WallTime::now() + ros::WallDuration(kRepeats[repeats_]);
}

}  // namespace collision_hulls
