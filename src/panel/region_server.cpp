// One thread sends what has changed; the marker server has another for what rviz answers. The server exists only once there is something to
// show: it needs a master, which there is by then.
#include "panel/region_server.h"

#include <interactive_markers/interactive_marker_server.h>
#include <ros/serialization.h>

#include <QMetaType>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace collision_hulls {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerFeedback;

struct SentMarker {
  std::string region;
  RegionHandle handle;
  InteractiveMarker marker;
};

bool isEqual(const InteractiveMarker& a, const InteractiveMarker& b) {
  const ros::SerializedMessage x = ros::serialization::serializeMessage(a), y = ros::serialization::serializeMessage(b);
  return x.num_bytes == y.num_bytes && std::equal(x.buf.get(), x.buf.get() + x.num_bytes, y.buf.get());
}

/// But for where they are.
bool isAlike(InteractiveMarker a, const InteractiveMarker& b) {
  a.pose = b.pose;
  return isEqual(a, b);
}

/// By their names.
std::map<std::string, SentMarker> markersOf(const std::vector<ShownRegion>& regions) {
  std::map<std::string, SentMarker> markers;
  for (const ShownRegion& shown : regions) {
    for (const RegionHandle& handle : handlesOf(shown.shape)) {
      if (handle.axis >= 0 && !shown.has_handles) continue;
      InteractiveMarker marker = toMarker(shown, handle);
      const std::string name = marker.name;
      markers[name] = {shown.region, handle, std::move(marker)};
    }
  }
  return markers;
}

}  // namespace

class RegionServer::Session {
 public:
  Session(RegionServer& owner, std::string topic) : owner_(owner), topic_(std::move(topic)), sender_([this] { send(); }) {}

  ~Session() {
    post([this] { ended_ = true; });
    sender_.join();
  }

  void show(const std::vector<ShownRegion>& regions) {
    post([&] { wanted_ = regions; });
  }

 private:
  template <typename Change>
  void post(const Change& change) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      change();
      is_news_ = true;
    }
    news_.notify_all();
  }

  void send() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      news_.wait(lock, [this] { return is_news_; });
      if (ended_) break;
      is_news_ = false;
      const std::map<std::string, SentMarker> wanted = markersOf(wanted_);
      const std::string held = held_, released = std::exchange(released_, "");
      lock.unlock();
      update(wanted, held, released);
      lock.lock();
    }
    lock.unlock();
    server_.reset();  // its end waits for its thread, which may wait for the mutex
  }

  void update(const std::map<std::string, SentMarker>& wanted, const std::string& held, const std::string& released) {
    if (!server_ && wanted.empty()) return;
    if (!server_) server_.emplace(topic_, "", true);
    for (auto sent = sent_.begin(); sent != sent_.end();) {
      const bool is_gone = wanted.count(sent->first) == 0;
      if (is_gone) server_->erase(sent->first);
      sent = is_gone ? sent_.erase(sent) : std::next(sent);
    }
    for (const auto& [name, marker] : wanted) {
      if (name == held && sent_.count(name) > 0) continue;
      put(name, marker, name == released);
    }
    server_->applyChanges();
  }

  /// `anew`: rviz has moved it meanwhile.
  void put(const std::string& name, const SentMarker& marker, bool anew) {
    const auto sent = sent_.find(name);
    if (sent != sent_.end() && !anew && isEqual(sent->second.marker, marker.marker)) return;
    if (sent != sent_.end() && isAlike(sent->second.marker, marker.marker)) {
      server_->setPose(name, marker.marker.pose);
    } else {
      const auto take = [this, region = marker.region, handle = marker.handle](
                            const visualization_msgs::InteractiveMarkerFeedbackConstPtr& feedback) { hear(region, handle, *feedback); };
      server_->insert(marker.marker, take);
    }
    sent_[name] = marker;
  }

  /// The server's thread.
  void hear(const std::string& region, const RegionHandle& handle, const InteractiveMarkerFeedback& feedback) {
    if (feedback.event_type == InteractiveMarkerFeedback::MOUSE_UP) {
      post([&] { released_ = std::exchange(held_, ""); });
    } else if (feedback.event_type == InteractiveMarkerFeedback::POSE_UPDATE) {
      bool goes_on = false;
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        goes_on = held_ == feedback.marker_name;
        held_ = feedback.marker_name;
      }
      Q_EMIT owner_.dragged({region, handle, toPose(feedback.pose), goes_on});
    }
  }

  RegionServer& owner_;
  const std::string topic_;
  std::optional<interactive_markers::InteractiveMarkerServer> server_;  // and the following: the sender's
  std::map<std::string, SentMarker> sent_;

  std::mutex mutex_;  // of what follows
  std::condition_variable news_;
  std::vector<ShownRegion> wanted_;
  std::string held_, released_;  // names of markers
  bool is_news_ = false, ended_ = false;
  std::thread sender_;  // last: it begins when all else is there
};

RegionServer::RegionServer(QObject* parent) : QObject(parent) {
  qRegisterMetaType<RegionDrag>("collision_hulls::RegionDrag");
}

RegionServer::~RegionServer() = default;

void RegionServer::setTopic(const std::string& topic) {
  session_.reset();
  if (!topic.empty()) session_ = std::make_unique<Session>(*this, topic);
}

void RegionServer::show(const std::vector<ShownRegion>& regions) {
  if (session_) session_->show(regions);
}

}  // namespace collision_hulls
