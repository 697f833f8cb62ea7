// Notices that the master was restarted.
#pragma once

#include <XmlRpcValue.h>

#include <map>
#include <string>

namespace collision_hulls {

/// A master that was restarted knows neither this node nor its parameters, and roscpp never tells it again. Asks at most once a second.
class MasterWatch {
 public:
  /// Remembers the node's private parameters and the robot description.
  MasterWatch();

  /// Whether there is a master that does not know this node; false while there is none.
  bool forgotten();

  /// Gives the master the parameters that it lacks, so that this node can be started again.
  void restore() const;

 private:
  std::map<std::string, XmlRpc::XmlRpcValue> parameters_;  // by name
  double next_ = 0;                                        // [s] when to ask again, by the steady clock
  int times_ = 0;                                          // that the answer was no, in a row
};

}  // namespace collision_hulls
