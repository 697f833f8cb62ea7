// rosrun collision_hulls collision_hulls_node: see node.h and doc/ros.md.
#include <ros/ros.h>

#include <csignal>

#include "node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "collision_hulls");
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  ros::AsyncSpinner spinner(4);
  {
    collision_hulls::Node node;
    spinner.start();
    // Not ros::waitForShutdown(): a shutdown waits for the service call in progress, which only stop() cuts short.
    while (!ros::isShuttingDown()) ros::WallDuration(0.02).sleep();
    node.stop();
    spinner.stop();
    ros::shutdown();  // waits for the call in progress
  }
  return 0;
}
