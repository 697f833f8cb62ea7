// Scenes as MoveIt publishes them. Poses are led back to the root link through the frames that the message itself tells of; one that it
// does not is an error, as a guess would put an obstacle in the wrong place. Built only where moveit_msgs is, which Debian does not
// package.
#include "planning_scene.h"

#include "collision_hulls/error.h"
#include "octomap_message.h"
#include "scene/reading.h"

namespace collision_hulls {
namespace {

using shape_msgs::SolidPrimitive;

Eigen::Vector3d toVector(const geometry_msgs::Point& p) {
  return {p.x, p.y, p.z};
}

/// A quaternion that was not set turns nothing.
Eigen::Quaterniond toTurn(const geometry_msgs::Quaternion& q) {
  const bool is_set = q.x != 0 || q.y != 0 || q.z != 0 || q.w != 0;  // so is nan
  return is_set ? checkedQuaternion(q.x, q.y, q.z, q.w) : Eigen::Quaterniond::Identity();
}

Eigen::Isometry3d toTransform(const geometry_msgs::Pose& pose) {
  return Eigen::Translation3d(toVector(pose.position)) * toTurn(pose.orientation);
}

Eigen::Isometry3d toTransform(const geometry_msgs::Transform& transform) {
  const geometry_msgs::Vector3& t = transform.translation;
  return Eigen::Translation3d(t.x, t.y, t.z) * toTurn(transform.rotation);
}

[[noreturn]] void fail(const std::string& reason) {
  throw Error(ErrorCode::kBadScene, "the planning scene " + reason);
}

/// A frame's name without the slash that ROS once put before it.
std::string bare(const std::string& frame) {
  return frame.substr(!frame.empty() && frame.front() == '/');
}

/// Where frames are in the root link's.
class Frames {
 public:
  Frames(const moveit_msgs::PlanningScene& message, const std::string& root_link) : message_(message), root_(root_link) {}

  Eigen::Isometry3d inRoot(const std::string& frame) const { return inRoot(bare(frame), 0); }

 private:
  /// `steps`: that led here; more than there are transforms lead round and round.
  Eigen::Isometry3d inRoot(const std::string& frame, std::size_t steps) const {
    if (frame.empty() || frame == root_) return Eigen::Isometry3d::Identity();
    const sensor_msgs::MultiDOFJointState& floating = message_.robot_state.multi_dof_joint_state;
    if (frame == bare(floating.header.frame_id) && floating.transforms.size() == 1) return toTransform(floating.transforms[0]).inverse();
    for (const geometry_msgs::TransformStamped& known : message_.fixed_frame_transforms) {
      if (steps > message_.fixed_frame_transforms.size()) break;
      const std::string parent = bare(known.header.frame_id), child = bare(known.child_frame_id);
      if (child == frame && parent != frame) return inRoot(parent, steps + 1) * toTransform(known.transform);
      if (parent == frame && child == root_) return toTransform(known.transform).inverse();
    }
    fail("has poses in the frame '" + frame + "', which it does not relate to the root link's, '" + root_ +
         "'; add it to fixed_frame_transforms, or give poses in '" + root_ + "'");
  }

  const moveit_msgs::PlanningScene& message_;
  const std::string root_;
};

TriangleMesh toMesh(const shape_msgs::Mesh& message) {
  TriangleMesh mesh;
  for (const geometry_msgs::Point& p : message.vertices) mesh.vertices.push_back(toVector(p));
  for (const shape_msgs::MeshTriangle& t : message.triangles)
    mesh.triangles.push_back(
        {static_cast<int>(t.vertex_indices[0]), static_cast<int>(t.vertex_indices[1]), static_cast<int>(t.vertex_indices[2])});
  return mesh;
}

void setShape(SceneBody& body, const SolidPrimitive& primitive) {
  std::vector<double> sizes(primitive.dimensions.begin(), primitive.dimensions.end());
  std::string kind;
  switch (primitive.type) {
    case SolidPrimitive::BOX: kind = "box"; break;
    case SolidPrimitive::SPHERE: kind = "sphere"; break;
    case SolidPrimitive::CYLINDER: kind = "cylinder"; break;
    case SolidPrimitive::CONE: kind = "cone"; break;
    default:
      fail("has a primitive of the unknown type " + std::to_string(primitive.type) + " in '" + body.name +
           "'; use a box, sphere, cylinder or cone");
  }
  if (sizes.size() != sizesOf(kind)) {
    fail("has a " + kind + " of " + std::to_string(sizes.size()) + " dimensions in '" + body.name + "'; it takes " +
         std::to_string(sizesOf(kind)));
  }
  if (sizes.size() == 2) std::swap(sizes[0], sizes[1]);  // height and radius
  setShape(body, kind, sizes);
}

/// Adds an object's shapes one after the other.
class ObjectAdder {
 public:
  ObjectAdder(const moveit_msgs::CollisionObject& object, const Eigen::Isometry3d& frame, SceneBuilder& scene)
      : object_(object), pose_(frame * toTransform(object.pose)), scene_(scene) {
    shapes_ = object.primitives.size() + object.meshes.size() + object.planes.size();
  }

  void addAll() {
    add(object_.primitives, object_.primitive_poses, [](const SolidPrimitive& shape, SceneBody& body) { setShape(body, shape); });
    add(object_.meshes, object_.mesh_poses, [](const shape_msgs::Mesh& shape, SceneBody& body) { body.shape = toMesh(shape); });
    add(object_.planes, object_.plane_poses, [](const shape_msgs::Plane& shape, SceneBody& body) {
      setShape(body, "plane", {shape.coef[0], shape.coef[1], shape.coef[2], shape.coef[3]});
    });
  }

 private:
  template <class Shapes, class Set>
  void add(const Shapes& shapes, const std::vector<geometry_msgs::Pose>& poses, const Set& set) {
    if (poses.size() > shapes.size())
      fail("has " + std::to_string(poses.size()) + " poses for " + std::to_string(shapes.size()) + " shapes in '" + object_.id +
           "'; give one pose for each shape");
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      SceneBody body;
      body.name = shapes_ == 1 ? object_.id : object_.id + "/" + std::to_string(++added_);
      body.pose = i < poses.size() ? pose_ * toTransform(poses[i]) : pose_;
      set(shapes[i], body);
      scene_.add(std::move(body));
    }
  }

  const moveit_msgs::CollisionObject& object_;
  const Eigen::Isometry3d pose_;
  SceneBuilder& scene_;
  std::size_t shapes_ = 0, added_ = 0;
};

}  // namespace

Scene toScene(const moveit_msgs::PlanningScene& message, const std::string& root_link, const RunControl& control) {
  if (message.is_diff) fail("is a difference to another one, not a whole scene; ask for service:/get_planning_scene");
  const Frames frames(message, root_link);
  Scene scene;
  SceneBuilder builder(scene);
  scene.name = message.name;
  for (const moveit_msgs::CollisionObject& object : message.world.collision_objects)
    ObjectAdder(object, frames.inRoot(object.header.frame_id), builder).addAll();
  const octomap_msgs::OctomapWithPose& map = message.world.octomap;
  if (!map.octomap.data.empty())
    addOctomap(scene, "octomap", toOctomap(map.octomap), frames.inRoot(map.header.frame_id) * toTransform(map.origin), control);
  return scene;
}

}  // namespace collision_hulls
