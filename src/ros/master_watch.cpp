// A lookup that fails may mean that the master went away in between: only the second in a row counts.
#include "master_watch.h"

#include <ros/master.h>
#include <ros/node_handle.h>
#include <ros/param.h>
#include <ros/this_node.h>
#include <ros/time.h>

namespace collision_hulls {
namespace {

constexpr double kPeriod = 1;  // [s]

/// roscpp registers this service before all else: a master that was restarted meanwhile may know what came later.
bool masterKnowsThisNode() {
  XmlRpc::XmlRpcValue request, response, uri;
  request[0] = ros::this_node::getName();
  request[1] = ros::this_node::getName() + "/get_loggers";
  return ros::master::execute("lookupService", request, response, uri, false);
}

}  // namespace

MasterWatch::MasterWatch() {
  std::string description;
  XmlRpc::XmlRpcValue value;
  const ros::NodeHandle node;  // searches where Node does: ros::param would find the node's own result first
  if (node.searchParam("robot_description", description) && node.getParam(description, value)) parameters_[description] = value;
  const std::string own = ros::this_node::getName();
  if (!ros::param::get(own, value) || value.getType() != XmlRpc::XmlRpcValue::TypeStruct) return;
  for (const auto& [name, parameter] : value)
    if (name != "robot_description" && name != "view") parameters_[own + "/" + name] = parameter;  // those two are results
}

bool MasterWatch::forgotten() {
  const double now = ros::SteadyTime::now().toSec();
  if (now < next_) return times_ > 1;
  next_ = now + kPeriod;
  times_ = ros::master::check() && !masterKnowsThisNode() ? times_ + 1 : 0;
  return times_ > 1;
}

void MasterWatch::restore() const {
  for (const auto& [name, value] : parameters_)
    if (!ros::param::has(name)) ros::param::set(name, value);
}

}  // namespace collision_hulls
