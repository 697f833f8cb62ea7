// One thread calls the services, which may block; another handles what the topics and actions bring, from a queue of its own. Both only
// emit signals, which Qt queues for the GUI's thread.
#include "panel/node_client.h"

#include <actionlib/client/action_client.h>
#include <collision_hulls/BuildAction.h>
#include <collision_hulls/DecomposeAction.h>
#include <collision_hulls/FitSceneAction.h>
#include <collision_hulls/NodeState.h>
#include <collision_hulls/Preview.h>
#include <collision_hulls/ValidateAction.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <QMetaType>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <utility>

#include "collision_hulls/error.h"
#include "ros/preview/settings.h"

namespace collision_hulls {
namespace {

constexpr std::chrono::milliseconds kLook{500};  // between looks at whether the node is there
constexpr std::chrono::milliseconds kEnd{100};   // for a call in progress to end by itself
constexpr double kServerWait = 5;                // [s] for an action server to notice us

LinkRow toRow(const LinkPreview& message) {
  LinkRow row;
  row.link = message.settings.link;
  row.options = toOptions(message.settings);
  row.facts.status = message.status;
  row.facts.reason = message.reason;
  row.facts.proved = message.proved;
  row.facts.triangles = message.triangles;
  row.facts.hulls = message.hulls;
  row.facts.primitives = message.primitives;
  row.facts.vertices = message.hull_vertices;
  row.facts.tolerance = message.tolerance;
  row.facts.protrusion = message.protrusion;
  row.facts.found = message.protrusion_found;
  row.facts.worst = {message.worst.x, message.worst.y, message.worst.z};
  const Eigen::Vector3d low(message.low.x, message.low.y, message.low.z), high(message.high.x, message.high.y, message.high.z);
  if (low != high) row.facts.around = Eigen::AlignedBox3d(low, high);
  row.facts.steps = message.steps;
  return row;
}

std::vector<LinkRow> toRows(const std::vector<LinkPreview>& messages) {
  std::vector<LinkRow> rows;
  for (const LinkPreview& message : messages) rows.push_back(toRow(message));
  return rows;
}

BuildGoal toGoal(const NodeJob& job) {
  BuildGoal goal;
  goal.config = job.configuration;
  goal.only = job.only;
  return goal;
}

}  // namespace

/// The conversation with one node; its end ends the call in progress.
class NodeClient::Session {
 public:
  Session(NodeClient& client, const std::string& name) : client_(client), name_(node_.resolveName(name)) {
    node_.setCallbackQueue(&queue_);
    state_ = node_.subscribe<NodeState>(name_ + "/state", 10, [this](const NodeStateConstPtr& state) { take(*state); });
    build_.emplace(node_, name_ + "/build_action", &queue_);
    decompose_.emplace(node_, name_ + "/decompose_action", &queue_);
    fit_.emplace(node_, name_ + "/fit_scene_action", &queue_);
    validate_.emplace(node_, name_ + "/validate_action", &queue_);
    spinner_.start();
    caller_ = std::async(std::launch::async, [this] { call(); });
  }

  ~Session() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ended_ = true;
    }
    news_.notify_all();
    while (caller_.wait_for(kEnd) != std::future_status::ready) {  // a node that was stopped never answers
      const std::lock_guard<std::mutex> lock(mutex_);
      service_.shutdown();
    }
    state_.shutdown();
    spinner_.stop();
    stopped_.clear();
    goals_.clear();
  }

  void preview(const std::vector<LinkRow>& links) {
    PreviewRequest request;
    for (const LinkRow& row : links) request.links.push_back(toMessage(row.link, row.options));
    request.show = true;
    post([&] { preview_ = request; });
  }

  void begin(const NodeJob& job) {
    post([&] { job_ = job; });
  }

  /// A job that waits is dropped.
  void cancel() {
    std::optional<NodeJob> dropped;
    post([&] {
      dropped = std::exchange(job_, std::nullopt);
      cancel_ = true;
    });
    if (dropped) Q_EMIT client_.finished(dropped->kind, false, false, "cancelled");
  }

 private:
  template <typename Change>
  void post(const Change& change) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      change();
    }
    news_.notify_all();
  }

  void take(const NodeState& state) {
    Q_EMIT client_.working(QString::fromStdString(state.job), state.fraction, QString::fromStdString(state.text));
    post([&] {
      if (changes_ != state.changes) all_wanted_ = true;
      changes_ = state.changes;
    });
  }

  /// The calling thread: whatever is wanted, one after the other.
  void call() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!ended_) {
      const auto is_wanted = [this] { return ended_ || preview_ || job_ || cancel_ || (all_wanted_ && is_there_); };
      if (!is_there_ || !news_.wait_for(lock, kLook, is_wanted)) look(lock);
      if (ended_) return;
      if (std::exchange(cancel_, false)) without(lock, [this] { cancelGoals(); });
      if (const auto request = std::exchange(preview_, std::nullopt)) without(lock, [&] { ask(*request); });
      if (const auto job = std::exchange(job_, std::nullopt)) without(lock, [&] { send(*job); });
      if (is_there_ && std::exchange(all_wanted_, false)) without(lock, [this] { ask({}); });
      if (!is_there_) news_.wait_for(lock, kLook, [this] { return ended_; });
    }
  }

  template <typename Work>
  static void without(std::unique_lock<std::mutex>& lock, const Work& work) {
    lock.unlock();
    try {
      work();
    } catch (const std::exception& error) {
      ROS_ERROR("Hulls panel: %s", error.what());
    }
    lock.lock();
  }

  /// Whether the node is there, and what to do if it is not.
  void look(std::unique_lock<std::mutex>& lock) {
    bool is_there = false;
    QString advice;
    without(lock, [&] {
      is_there = ros::master::check() && ros::service::exists(name_ + "/preview", false);
      if (!is_there) advice = adviceFor(QString::fromStdString(name_));
    });
    if (is_there != is_there_ || !has_looked_) Q_EMIT client_.connected(is_there, advice);
    if (is_there && !is_there_) all_wanted_ = true;
    is_there_ = is_there;
    has_looked_ = true;
  }

  static QString adviceFor(const QString& name) {
    if (!ros::master::check()) return "There is no ROS master: start one with roscore, then this panel goes on by itself.";
    return "There is no node " + name +
           ". Start one:\nroslaunch collision_hulls decompose.launch robot:=ROBOT.urdf\nor enter another node's name above.";
  }

  /// Calls ~preview; `request` without links asks for all.
  void ask(PreviewRequest request) {
    if (!service_.isValid()) {
      ros::ServiceClient service = node_.serviceClient<Preview>(name_ + "/preview", true);
      post([&] { service_ = ended_ ? ros::ServiceClient() : service; });
    }
    PreviewResponse response;
    const ros::SteadyTime begin = ros::SteadyTime::now();
    if (!service_.call(request, response)) {
      post([this] {
        service_.shutdown();
        service_ = {};
        is_there_ = has_looked_ = false;
      });
      return;
    }
    const double milliseconds = (ros::SteadyTime::now() - begin).toSec() * 1000;
    if (!response.success) {
      Q_EMIT client_.failed(QString::fromStdString(response.message));
    } else if (request.links.empty()) {
      Q_EMIT client_.known(QString::fromStdString(response.robot), toRows(response.links), QString::fromStdString(response.config));
    } else {
      Q_EMIT client_.previewed(toRows(response.links), milliseconds);
    }
  }

  void send(const NodeJob& job) {
    switch (job.kind) {
      case NodeJob::kBuild: sendGoal(*build_, toGoal(job), job.kind); break;
      case NodeJob::kWrite: {
        DecomposeGoal goal;
        goal.config = job.configuration;
        goal.brief = true;
        sendGoal(*decompose_, goal, job.kind);
        break;
      }
      case NodeJob::kFit: {
        FitSceneGoal goal;
        goal.config = job.configuration;
        goal.scene = job.scene;
        goal.clearance = job.clearance;
        goal.brief = true;
        sendGoal(*fit_, goal, job.kind);
        break;
      }
      case NodeJob::kValidate: sendGoal(*validate_, ValidateGoal(), job.kind); break;
    }
  }

  template <typename Client, typename Goal>
  void sendGoal(Client& client, const Goal& goal, NodeJob::Kind kind) {
    const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(kServerWait);
    while (!hasEnded() && ros::SteadyTime::now() < end && !client.waitForActionServerToStart(ros::Duration(0.1))) {
    }
    if (!client.isServerConnected()) {
      Q_EMIT client_.finished(kind, false, false, "The node does not take jobs: it may have been stopped. Start it, then try again.");
      return;
    }
    using Handle = typename Client::GoalHandle;
    const std::lock_guard<std::mutex> lock(goals_mutex_);
    auto handle = std::make_shared<Handle>();
    const auto transition = [this, kind](const Handle& changed) { follow(changed, kind); };
    *handle = client.sendGoal(goal, transition);
    stopped_ = {[handle] { handle->cancel(); }};
    goals_ = {handle};
  }

  template <typename Handle>
  void follow(Handle handle, NodeJob::Kind kind) {
    if (handle.getCommState() != actionlib::CommState::DONE) return;
    const auto result = handle.getResult();
    const bool refused = handle.getTerminalState() == actionlib::TerminalState::REJECTED;
    const std::string text = result ? result->message : handle.getTerminalState().getText();
    Q_EMIT client_.finished(kind, result && result->success, refused, QString::fromStdString(text));
  }

  bool hasEnded() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ended_;
  }

  void cancelGoals() {
    const std::lock_guard<std::mutex> lock(goals_mutex_);
    for (const auto& stop : stopped_) stop();
  }

  NodeClient& client_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  const std::string name_;
  ros::Subscriber state_;
  std::optional<actionlib::ActionClient<BuildAction>> build_;
  std::optional<actionlib::ActionClient<DecomposeAction>> decompose_;
  std::optional<actionlib::ActionClient<FitSceneAction>> fit_;
  std::optional<actionlib::ActionClient<ValidateAction>> validate_;
  ros::AsyncSpinner spinner_{1, &queue_};

  std::mutex goals_mutex_;
  std::vector<std::function<void()>> stopped_;  // what cancels the last goal
  std::vector<std::shared_ptr<void>> goals_;    // a handle that is gone gets no news

  std::mutex mutex_;            // of what follows
  ros::ServiceClient service_;  // set by the calling thread alone
  std::condition_variable news_;
  std::optional<PreviewRequest> preview_;  // the latest
  std::optional<NodeJob> job_;
  bool cancel_ = false, all_wanted_ = false, is_there_ = false, has_looked_ = false, ended_ = false;
  std::uint32_t changes_ = 0;
  std::future<void> caller_;
};

NodeClient::NodeClient(QObject* parent) : QObject(parent) {
  qRegisterMetaType<std::vector<LinkRow>>("std::vector<collision_hulls::LinkRow>");
}

NodeClient::~NodeClient() = default;

void NodeClient::setNode(const QString& name) {
  session_.reset();
  std::string error;
  const std::string text = name.trimmed().toStdString();
  if (text.empty() || !ros::names::validate(text, error)) {
    Q_EMIT connected(false, "'" + name + "' is not the name of a node: enter one such as collision_hulls or /left/collision_hulls.");
    return;
  }
  session_ = std::make_unique<Session>(*this, text);
}

void NodeClient::preview(const std::vector<LinkRow>& links) {
  if (session_ && !links.empty()) session_->preview(links);
}

void NodeClient::begin(const NodeJob& job) {
  if (session_) session_->begin(job);
}

void NodeClient::cancel() {
  if (session_) session_->cancel();
}

}  // namespace collision_hulls
