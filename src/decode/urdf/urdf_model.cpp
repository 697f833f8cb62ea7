// The only file that sees urdfdom: turns its model into plain values and collects its complaints.
#include "decode/urdf/urdf_model.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <new>
#include <stdexcept>

#include "collision_hulls/robot/kinematics.h"
#include "geometry/pi.h"

namespace collision_hulls {
namespace {

// Enough of urdfdom's complaints to say what is wrong; a broken file can have any number of them.
constexpr std::size_t kMostComplaints = 2000;

// Keeps what urdfdom logs, which would go to stderr.
class LogCapture : public console_bridge::OutputHandler {
 public:
  void start() {
    errors_.clear();
    console_bridge::useOutputHandler(this);
  }

  std::string stop() {
    console_bridge::restorePreviousOutputHandler();
    return errors_;
  }

  void log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/, int /*line*/) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && errors_.size() < kMostComplaints)
      errors_ += (errors_.empty() ? "" : "; ") + text.substr(0, text.find_last_not_of(". ") + 1);
  }

 private:
  std::string errors_;
};

struct ParseResult {
  urdf::ModelInterfaceSharedPtr model;
  std::string errors;
};

// The log handler belongs to the whole process, which reads one description at a time. It lives as long as the process does, because
// console_bridge keeps a pointer to a handler that was replaced.
ParseResult parse(const std::string& text) {
  static LogCapture* const capture = new LogCapture;
  ParseResult result;
  capture->start();
  try {
    result.model = urdf::parseURDF(text);
  } catch (const std::bad_alloc&) {
    capture->stop();
    throw;
  } catch (const std::exception& error) {
    result.errors = capture->stop();
    result.errors += (result.errors.empty() ? "" : "; ") + std::string(error.what());
    return result;
  }
  result.errors = capture->stop();
  return result;
}

Eigen::Vector3d toEigen(const urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

Eigen::Isometry3d toEigen(const urdf::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z).toRotationMatrix();
  result.translation() = toEigen(pose.position);
  return result;
}

void setShape(const urdf::Geometry& geometry, GeometryElement& element) {
  if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(&geometry)) {
    element.kind = GeometryElement::Kind::kMesh;
    element.uri = mesh->filename;
    element.scale = toEigen(mesh->scale);
  } else if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry)) {
    element.kind = GeometryElement::Kind::kBox;
    element.size = toEigen(box->dim);
  } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry)) {
    element.kind = GeometryElement::Kind::kSphere;
    element.size.x() = sphere->radius;
  } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry)) {
    element.kind = GeometryElement::Kind::kCylinder;
    element.size = {cylinder->radius, cylinder->length, 0};
  } else {
    throw std::runtime_error("a geometry is neither a mesh nor a box, sphere or cylinder");
  }
}

template <class Elements>  // urdf::Visual or urdf::Collision
std::vector<GeometryElement> toElements(const Elements& from) {
  std::vector<GeometryElement> elements;
  for (const auto& source : from) {
    GeometryElement element;
    setShape(*source->geometry, element);
    element.origin = toEigen(source->origin);
    element.name = source->name;
    elements.push_back(element);
  }
  return elements;
}

JointDescription::Kind kindOf(const urdf::Joint& joint) {
  using Kind = JointDescription::Kind;
  switch (joint.type) {
    case urdf::Joint::REVOLUTE: return Kind::kRevolute;
    case urdf::Joint::CONTINUOUS: return Kind::kContinuous;
    case urdf::Joint::PRISMATIC: return Kind::kPrismatic;
    case urdf::Joint::FLOATING: return Kind::kFloating;
    case urdf::Joint::PLANAR: return Kind::kPlanar;
    default: return Kind::kFixed;
  }
}

JointDescription toJoint(const urdf::Joint& joint) {
  JointDescription result;
  result.name = joint.name;
  result.kind = kindOf(joint);
  result.parent = joint.parent_link_name;
  result.child = joint.child_link_name;
  result.origin = toEigen(joint.parent_to_joint_origin_transform);
  result.axis = toEigen(joint.axis).stableNormalized();
  constexpr double kNoLimit = 1e4;  // [rad] converters write such numbers where there is none
  const bool turns = result.kind == JointDescription::Kind::kRevolute;
  if (turns && joint.limits && joint.limits->upper - joint.limits->lower > kNoLimit) result.kind = JointDescription::Kind::kContinuous;
  if (result.kind == JointDescription::Kind::kContinuous) {
    result.lower = -kPi;
    result.upper = kPi;
  } else if (joint.limits && joint.limits->lower <= joint.limits->upper) {
    result.lower = joint.limits->lower;
    result.upper = joint.limits->upper;
  }
  if (!joint.mimic) return result;
  result.mimic = joint.mimic->joint_name;
  result.mimic_multiplier = joint.mimic->multiplier;
  result.mimic_offset = joint.mimic->offset;
  return result;
}

// From the root along each link's own parent joint, so that joints which share a child are not followed twice.
std::vector<JointDescription> jointsFromRoot(const urdf::ModelInterface& model) {
  std::vector<JointDescription> joints;
  std::vector<urdf::LinkConstSharedPtr> open{model.getRoot()};
  while (!open.empty()) {
    const urdf::LinkConstSharedPtr link = open.back();
    open.pop_back();
    for (const urdf::JointSharedPtr& joint : link->child_joints) {
      const urdf::LinkConstSharedPtr child = model.getLink(joint->child_link_name);
      if (child->parent_joint != joint) continue;
      joints.push_back(toJoint(*joint));
      open.push_back(child);
    }
  }
  return joints;
}

using Poses = std::map<std::string, Eigen::Isometry3d>;

/// Where joints stand when all that mimic no other are at rest. What mimics nothing that is there, or itself, is at rest, too.
class RestValues {
 public:
  explicit RestValues(const std::vector<JointDescription>& joints) {
    for (const JointDescription& joint : joints) by_name_[joint.name] = &joint;
  }

  /// Follows the masters up to one that is known; a loop, as a chain may be long.
  double of(const JointDescription& joint) {
    std::vector<const JointDescription*> way{&joint};
    while (known_.emplace(way.back(), restValue(*way.back())).second) {
      const auto master = by_name_.find(way.back()->mimic);
      if (master == by_name_.end()) break;
      way.push_back(master->second);
    }
    double value = known_.at(way.back());
    for (way.pop_back(); !way.empty(); way.pop_back())
      known_[way.back()] = value = way.back()->mimic_multiplier * value + way.back()->mimic_offset;
    return value;
  }

 private:
  std::map<std::string, const JointDescription*> by_name_;
  std::map<const JointDescription*, double> known_;
};

Poses restPoses(const std::string& root, const std::vector<JointDescription>& joints) {
  RestValues values(joints);
  Poses poses{{root, Eigen::Isometry3d::Identity()}};
  for (const JointDescription& joint : joints) poses[joint.child] = poses[joint.parent] * joint.origin * motion(joint, values.of(joint));
  return poses;
}

LinkDescription toLink(const urdf::Link& link, const Poses& poses) {
  LinkDescription result;
  result.name = link.name;
  result.visuals = toElements(link.visual_array);
  result.collisions = toElements(link.collision_array);
  result.pose = poses.at(link.name);
  if (link.parent_joint) result.parent = link.parent_joint->parent_link_name;
  return result;
}

}  // namespace

UrdfModel readUrdfModel(const std::string& urdf_text) {
  const ParseResult parsed = parse(urdf_text);
  if (!parsed.model) throw std::runtime_error(parsed.errors.empty() ? "no reason is given" : parsed.errors);
  UrdfModel model{parsed.model->getName(), {}, jointsFromRoot(*parsed.model), parsed.errors};
  const Poses poses = restPoses(parsed.model->getRoot()->name, model.joints);
  for (const auto& [name, link] : parsed.model->links_) model.links.push_back(toLink(*link, poses));
  return model;
}

}  // namespace collision_hulls
