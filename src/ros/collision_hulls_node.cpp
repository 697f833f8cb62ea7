// rosrun collision_hulls collision_hulls_node: see node.h and doc/ros.md.
//
// Handles its signals itself: ROS's own handler shuts the log down first, which would swallow what becomes of the running job, and a
// shutdown waits for the service call in progress, which only Node::stop() cuts short.
#include <ros/ros.h>

#include <csignal>

#include "node.h"

namespace {

volatile std::sig_atomic_t interrupted = 0;

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "collision_hulls", ros::init_options::NoSigintHandler);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interrupted = 1; });
  ros::AsyncSpinner spinner(4);
  {
    collision_hulls::Node node;
    spinner.start();
    while (!interrupted && !ros::isShuttingDown()) ros::WallDuration(0.02).sleep();
    node.stop();
    spinner.stop();
  }  // the job has ended
  ros::shutdown();
  return 0;
}
