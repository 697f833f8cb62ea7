// rosrun collision_hulls collision_hulls_node: see node.h and doc/ros.md.
//
// Handles its signals itself: ROS's own handler shuts the log down first, which would swallow what becomes of the running job, and a
// shutdown waits for the service call in progress, which only Node::stop() cuts short.
#include <ros/ros.h>
#include <signal.h>

#include "node.h"

namespace {

volatile sig_atomic_t interrupted = 0;

/// The first signal ends the node in order, a second one as ever.
void handleSignals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

/// roscpp waits for a master for ever, and for nothing else. False if a signal came first.
bool waitForMaster() {
  if (!ros::master::check()) ROS_WARN("waiting for a master at %s: start roscore, or set ROS_MASTER_URI", ros::master::getURI().c_str());
  while (!interrupted && !ros::master::check()) ros::WallDuration(0.1).sleep();
  return !interrupted;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "collision_hulls", ros::init_options::NoSigintHandler);
  handleSignals();
  if (!waitForMaster()) return 0;
  ros::AsyncSpinner spinner(4);
  {
    collision_hulls::Node node;
    spinner.start();
    while (!interrupted && !ros::isShuttingDown()) ros::WallDuration(0.02).sleep();
    ros::master::setRetryTimeout(ros::WallDuration(2));  // a job that would tell a lost master does not wait for it
    node.stop();
    spinner.stop();
  }  // the job has ended
  ros::shutdown();
  return 0;
}
