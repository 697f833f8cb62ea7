// The panel's side of ROS. No answer of a node is waited for in the GUI's thread; another name waits for the master, to which topics are
// told.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "panel/link_table.h"

namespace collision_hulls {

/// A job of the node, as the panel asks for it.
struct NodeJob {
  enum Kind { kBuild, kWrite, kFit, kValidate } kind = kBuild;
  std::vector<std::string> only;  ///< build: empty for all
  std::string configuration;
  std::string scene;        ///< fit: a file that the node can read
  double clearance = 0.01;  ///< fit [m]
};

/// Talks to one node, from threads of its own: its functions return at once, and its signals come in the GUI's thread, through the queue.
///
/// While a preview is answered only the latest further one waits; those between are never sent, so a slider cannot run ahead of the node.
class NodeClient : public QObject {
  Q_OBJECT
 public:
  explicit NodeClient(QObject* parent = nullptr);
  ~NodeClient() override;

  /// The node's name, relative to rviz's name space or absolute. What the node before was asked is forgotten.
  void setNode(const QString& name);

  /// Asks for these links' hulls and lets the node draw them.
  void preview(const std::vector<collision_hulls::LinkRow>& links);

  /// Begins a job, which the node refuses if it has another.
  void begin(const collision_hulls::NodeJob& job);

  /// Ends the job that was begun last.
  void cancel();

 Q_SIGNALS:
  /// Whether the node is there; if not, what to do about it.
  void connected(bool is_there, const QString& advice);
  /// All links as the node knows them, after each of its jobs, and the configuration of its last one; none: it knows no robot yet.
  void known(const QString& robot, const std::vector<collision_hulls::LinkRow>& rows, const QString& configuration);
  /// The answer to a preview, which took so long [ms].
  void previewed(const std::vector<collision_hulls::LinkRow>& rows, double milliseconds);
  /// What the node works on, whoever asked for it; empty: nothing.
  void working(const QString& job, double fraction, const QString& text);
  /// The job that was begun here is over. `refused`: it never began, as the node is busy.
  void finished(int kind, bool success, bool refused, const QString& message);
  /// Something went wrong with a preview.
  void failed(const QString& message);

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace collision_hulls
