// Regions in the view: serves their interactive markers, and says what is dragged. Nothing here blocks the GUI's thread.
#pragma once

#include <QObject>
#include <memory>
#include <string>
#include <vector>

#include "panel/region_markers.h"

namespace collision_hulls {

/// A handle was dragged so far.
struct RegionDrag {
  std::string region;
  RegionHandle handle;
  Eigen::Isometry3d pose;  ///< in the link's frame
  bool goes_on = false;    ///< the same drag as before
};

/// Serves them on `topic`/update and `topic`/feedback, where a display of rviz's class InteractiveMarkers shows them, from threads of its
/// own; its signal comes in the GUI's thread, through the queue. rviz itself moves what is dragged: that marker is sent again once it is
/// let go.
class RegionServer : public QObject {
  Q_OBJECT
 public:
  explicit RegionServer(QObject* parent = nullptr);
  ~RegionServer() override;

  /// A ROS name, relative to rviz's name space or absolute; empty: none. What was shown before goes.
  void setTopic(const std::string& topic);

  /// All regions; nothing is sent where nothing has changed.
  void show(const std::vector<ShownRegion>& regions);

 Q_SIGNALS:
  void dragged(const collision_hulls::RegionDrag& drag);

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace collision_hulls
