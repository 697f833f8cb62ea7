// A cut takes the place of a link's last result only when it is shown: what others ask for, nobody sees.
//
// A result that is proved comes before a cut with the same settings, as it is the more exact of the two.
#include "link_previews.h"

#include <algorithm>
#include <utility>

#include "base/stopwatch.h"
#include "collision_hulls/config/config.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/progress_text.h"
#include "config/link_rule.h"
#include "ros/conversions.h"
#include "ros/parameters.h"
#include "ros/pen.h"
#include "settings.h"

namespace collision_hulls {
namespace {

/// The elements that a link has once it has hulls.
std::vector<GeometryElement> elementsOf(const LinkDescription& link, const LinkOptions* options) {
  if (!options || options->action == Action::kKeep) return link.collisions;
  if (options->action == Action::kRemove) return {};
  return sourceElements(link, options->source).elements;
}

/// No link chosen: all are.
bool isAmong(const std::set<std::string>& chosen, const std::string& link) {
  return chosen.empty() || chosen.count(link) > 0;
}

Status worse(Status a, Status b) {
  return a == Status::kFailed || b == Status::kOk ? a : b;
}

/// Around all bodies, in the link's frame.
void addBounds(const LinkResult& result, LinkPreview& message) {
  Eigen::AlignedBox3d box;
  for (const ElementResult& element : result.elements)
    for (const ConvexHull& hull : element.hulls)
      for (const Eigen::Vector3d& vertex : hull.vertices) box.extend(element.source.origin * vertex);
  if (box.isEmpty()) return;
  message.low = toPoint(box.min());
  message.high = toPoint(box.max());
}

/// The sums and extremes over a link's meshes.
void addRows(const LinkResult& result, LinkPreview& message) {
  Status status = result.rows.empty() ? Status::kOk : result.rows.front().status;
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    const ElementReport& row = result.rows[i];
    status = worse(status, row.status);
    if (message.reason.empty()) message.reason = inNodeWords(row.reason);
    message.triangles += static_cast<std::uint32_t>(row.triangles);
    message.hulls += static_cast<std::uint32_t>(row.hulls);
    message.primitives += static_cast<std::uint32_t>(row.primitives);
    message.hull_vertices += static_cast<std::uint32_t>(row.hull_vertices);
    message.tolerance = std::max(message.tolerance, row.tolerance);
    message.protrusion = std::max(message.protrusion, row.protrusion);
    if (row.protrusion_found <= message.protrusion_found) continue;
    message.protrusion_found = row.protrusion_found;
    message.worst = toPoint(result.elements[i].source.origin * row.worst);
  }
  message.meshes = static_cast<std::uint32_t>(result.rows.size());
  message.status = name(status);
}

/// A row that says so.
LinkResult undecomposed(const LinkDescription& link, const LinkOptions& options) {
  LinkResult result;
  result.elements.resize(1);
  result.rows.resize(1);
  result.elements.front().link = result.rows.front().link = link.name;
  result.rows.front().status = options.action == Action::kKeep ? Status::kKept : Status::kRemoved;
  return result;
}

/// A result without what only drawing the original needs.
ElementResult withoutOriginal(const ElementResult& element) {
  ElementResult copy;
  copy.link = element.link;
  copy.source = element.source;
  copy.pose = element.pose;
  copy.hulls = element.hulls;
  copy.primitives = element.primitives;
  return copy;
}

}  // namespace

StepCallback StatedJob::stated(StepCallback step) const {
  return [&preview = preview_, step = std::move(step)](const Step& now) {
    preview.progress(now);
    if (step) step(now);
  };
}

LinkPreviews::LinkPreviews(const ros::NodeHandle& node, View& view) : view_(view), node_(node) {
  publisher_ = node_.advertise<NodeState>("state", 1, true);
  publish();
}

void LinkPreviews::open() {
  service_ = node_.advertiseService("preview", &LinkPreviews::serve, this);
}

bool LinkPreviews::isNews(const RobotDescription& robot) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return robot_.text != robot.text;
}

void LinkPreviews::take(const RobotDescription& robot, const LinkDecisions& decisions, const RobotResult& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Options& options = result.report.options;
  const bool is_other = robot_.text != robot.text;
  if (is_other) known_.clear(), config_.reset();
  if (options.tree) tree_ = options.tree;
  if (!config_ || options.links.empty()) config_ = options;
  config_->region_rules = options.region_rules;
  robot_ = robot;
  places_.clear();
  for (std::size_t i = 0; i < robot_.links.size(); ++i) places_.emplace(robot_.links[i].name, i);
  std::map<std::string, Known> news;
  for (std::size_t i = 0; i < result.elements.size(); ++i) {
    const std::string& link = result.elements[i].link;
    Known& known = news[link];
    known.options = *decisions.of(link);
    known.proved = true;
    known.result.elements.push_back(withoutOriginal(result.elements[i]));
    known.result.rows.push_back(result.report.links[i]);
  }
  for (auto& [link, known] : news) known_[link] = std::move(known);
  state_.robot = robot.name;
  ++state_.changes;
  publish();
}

std::vector<LinkPreview> LinkPreviews::messages(const std::vector<std::string>& links, const RunControl& control) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return messagesLocked(links, control);
}

/// While the mutex is held.
std::vector<LinkPreview> LinkPreviews::messagesLocked(const std::vector<std::string>& links, const RunControl& control) const {
  const std::set<std::string> wanted(links.begin(), links.end());
  std::vector<LinkPreview> messages;
  for (const LinkDescription& link : robot_.links) {
    control.check();
    const auto known = known_.find(link.name);
    if (isAmong(wanted, link.name) && known != known_.end()) messages.push_back(message(link.name, known->second, control));
  }
  return messages;
}

std::map<std::string, LinkResult> LinkPreviews::results(const std::vector<std::string>& links) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::set<std::string> wanted = chosen("only", links);
  std::map<std::string, LinkResult> results;
  for (const auto& [link, known] : known_)
    if (isAmong(wanted, link)) results[link] = known.result;
  return results;
}

RobotDescription LinkPreviews::robot() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return robot_;
}

void LinkPreviews::show(const std::vector<std::string>& links, const RunControl& control) {
  const std::set<std::string> wanted(links.begin(), links.end());
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<ShownLink> drawn;
  for (const auto& [link, known] : known_)
    if (isAmong(wanted, link)) drawn.push_back(shown(link, known));
  view_.replace(drawn, {!links.empty(), true}, control);
}

void LinkPreviews::working(const std::string& job) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.job = job;
  state_.fraction = 0;
  state_.text.clear();
  publish();
}

void LinkPreviews::progress(const Step& step) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.fraction = step.fraction;
  state_.text = progressLine(step);
  publish();
}

bool LinkPreviews::serve(PreviewRequest& request, PreviewResponse& response) {
  try {
    const std::lock_guard<std::mutex> lock(mutex_);  // once, so that all of an answer is of one robot
    if (request.links.empty()) response.links = messagesLocked({}, stopping_);
    response.robot = robot_.name;
    if (request.links.empty() && config_) response.config = configText(*config_);
    Stopwatch time;
    cutAll(request, response);
    response.seconds = time.lap();
    response.success = true;
  } catch (const Error& error) {
    response.message = inNodeWords(error.what());
  }
  return true;
}

void LinkPreviews::cutAll(const PreviewRequest& request, PreviewResponse& response) {
  std::vector<std::string> links;
  for (const LinkChoice& settings : request.links) links.push_back(settings.link);
  chosen("links", links);  // refuses them before anything is cut
  std::vector<ShownLink> drawn;
  for (const LinkChoice& settings : request.links) {
    stopping_.check();
    const std::optional<Known> made = cut(settings);
    response.links.push_back(made ? message(settings.link, *made, stopping_) : unbuilt(settings));
    if (!request.show) continue;
    const auto known = known_.find(settings.link);
    if (made || known != known_.end()) drawn.push_back(shown(settings.link, made ? *made : known->second));
    if (made) known_[settings.link] = *made;
  }
  if (request.show) view_.replace(drawn, {true, false}, stopping_);
}

/// What a link becomes with these settings; nothing where that has to be built.
std::optional<LinkPreviews::Known> LinkPreviews::cut(const LinkChoice& settings) const {
  const LinkDescription& link = described(settings.link);
  Known made;
  made.options = withTree(toOptions(settings));
  const auto known = known_.find(settings.link);
  if (known != known_.end() && known->second.proved && equalSettings(made.options, known->second.options)) return known->second;
  if (made.options.action != Action::kDecompose) {
    made.result = undecomposed(link, made.options);
    made.proved = true;
    return made;
  }
  std::optional<LinkResult> result = trees_.cut(link, made.options, stopping_);
  if (!result) return std::nullopt;
  made.result = std::move(*result);
  return made;
}

LinkPreview LinkPreviews::unbuilt(const LinkChoice& settings) const {
  LinkPreview message;
  message.settings = settings;
  message.status = LinkPreview::UNBUILT;
  message.reason = trees_.whyNoCut(described(settings.link), withTree(toOptions(settings))) + ": build the link";
  return message;
}

/// With the tree that the last build had. A link with regions has none.
LinkOptions LinkPreviews::withTree(LinkOptions options) const {
  options.tree = options.method == Method::kCertified && options.regions.empty() ? tree_ : std::nullopt;
  return options;
}

const LinkDescription& LinkPreviews::described(const std::string& name) const {
  const auto place = places_.find(name);
  if (place != places_.end()) return robot_.links[place->second];
  throw Error(ErrorCode::kBadOption,
              robot_.links.empty() ? "no robot is known yet: call ~build or ~decompose first" : noSuchLink(robot_, name));
}

/// Links of a request as a set. As each is named once, a request asks for no more links than the robot has.
std::set<std::string> LinkPreviews::chosen(const std::string& field, const std::vector<std::string>& links) const {
  std::set<std::string> names;
  for (const std::string& link : links)
    if (!names.insert(described(link).name).second)
      throw Error(ErrorCode::kBadOption, field + ": link '" + link + "' is named twice; name it once");
  return names;
}

ShownLink LinkPreviews::shown(const std::string& link, const Known& known) const {
  ShownLink result{described(link), linkHue(places_.at(link)), known.result.elements, known.result.rows};
  result.link.collisions = elementsOf(result.link, &known.options);
  for (const ElementResult& element : known.result.elements) {
    for (GeometryElement primitive : element.primitives) {  // of a model that was fitted to a scene
      primitive.origin = element.source.origin * primitive.origin;
      result.link.collisions.push_back(primitive);
    }
  }
  return result;
}

LinkPreview LinkPreviews::message(const std::string& link, const Known& known, const RunControl& control) const {
  LinkPreview message;
  message.settings = toMessage(link, known.options);
  message.proved = known.proved;
  addRows(known.result, message);
  addBounds(known.result, message);
  if (known.options.action == Action::kDecompose) message.steps = trees_.steps(described(link), withTree(known.options), control);
  return message;
}

void LinkPreviews::publish() {
  publisher_.publish(state_);
}

}  // namespace collision_hulls
