// Boxes of meshes and primitives, put together where the links are when the robot is first shown.
#include "robot_bounds.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/robot/kinematics.h"

namespace collision_hulls {
namespace {

RobotBounds toBounds(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) return {Eigen::Vector3d::Zero(), 0.5, 0.5};
  constexpr double kLeast = 1e-3;  // [m], of a robot that is a point
  return {box.center(), std::max(0.5 * box.diagonal().norm(), kLeast), box.max().z()};
}

/// The box of a mesh or a primitive, in its own frame; its origin alone where the mesh cannot be read.
Eigen::AlignedBox3d readBox(const GeometryElement& element, const MeshReading& reading) {
  const Eigen::AlignedBox3d point(Eigen::Vector3d::Zero());
  if (isPrimitive(element)) return localBox(element);
  if (element.kind == GeometryElement::Kind::kNone || !element.fault.empty()) return point;
  try {
    return boundingBox(scaled(readMesh(reading.file(element.uri), reading.limits, reading.control).mesh, element.scale));
  } catch (const Error& error) {
    if (error.code() == ErrorCode::kCancelled) throw;
    return point;  // the run itself reports what is wrong with the mesh
  }
}

/// Where joint_state_publisher puts the links at first: joints at zero, or in the middle of their limits if these exclude zero.
std::vector<Eigen::Isometry3d> firstPoses(const RobotDescription& robot) {
  try {
    const Kinematics joints(robot);
    Configuration first;
    for (const JointVariable& joint : joints.variables())
      first.push_back(joint.lower <= 0 && joint.upper >= 0 ? 0 : 0.5 * (joint.lower + joint.upper));
    return joints.poses(first);
  } catch (const Error&) {  // joints that mimic nothing that moves: with all of them at zero, as they were read
    std::vector<Eigen::Isometry3d> poses;
    for (const LinkDescription& link : robot.links) poses.push_back(link.pose);
    return poses;
  }
}

}  // namespace

std::string rootLink(const RobotDescription& robot) {
  const auto root = std::find_if(robot.links.begin(), robot.links.end(), [](const LinkDescription& link) { return link.parent.empty(); });
  return root == robot.links.end() ? "" : root->name;
}

bool isPrimitive(const GeometryElement& element) {
  return element.fault.empty() && element.kind != GeometryElement::Kind::kMesh && element.kind != GeometryElement::Kind::kNone;
}

Eigen::AlignedBox3d localBox(const GeometryElement& element) {
  using Kind = GeometryElement::Kind;
  const double r = element.size.x();
  Eigen::Vector3d half = 0.5 * element.size;
  if (element.kind == Kind::kSphere) half = {r, r, r};
  if (element.kind == Kind::kCylinder) half = {r, r, 0.5 * element.size.y()};
  return {-half, half};
}

Eigen::AlignedBox3d moved(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& pose) {
  Eigen::AlignedBox3d result;
  if (box.isEmpty()) return result;
  for (int corner = 0; corner < 8; ++corner) result.extend(pose * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  return result;
}

Eigen::AlignedBox3d rootBox(const ElementResult& element) {
  return moved(boundingBox(element.original), element.pose);
}

RobotBounds robotBounds(const RobotDescription& robot, Source source, const MeshReading& reading) {
  std::map<std::pair<std::string, std::vector<double>>, Eigen::AlignedBox3d> known;  // by mesh and scale
  Eigen::AlignedBox3d box;
  const std::vector<Eigen::Isometry3d> poses = firstPoses(robot);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const LinkDescription& link = robot.links[i];
    for (const GeometryElement& element : sourceElements(link, source).elements) {
      std::vector<double> numbers(element.scale.data(), element.scale.data() + 3);
      numbers.insert(numbers.end(), element.size.data(), element.size.data() + 3);
      numbers.push_back(static_cast<double>(element.kind));
      const auto [entry, is_new] = known.try_emplace({element.uri, numbers});
      if (is_new) entry->second = readBox(element, reading);
      box.extend(moved(entry->second, poses[i] * element.origin));
    }
  }
  return toBounds(box);
}

RobotBounds robotBounds(const RobotResult& result) {
  Eigen::AlignedBox3d box;
  for (const ElementResult& element : result.elements) box.extend(rootBox(element));
  return toBounds(box);
}

}  // namespace collision_hulls
