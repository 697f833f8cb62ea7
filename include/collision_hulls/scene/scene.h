// A robot's surroundings: static bodies, read from the usual scene formats.
//
// For example:
//
//     Scene scene = readScene("cell.yaml", defaultPackageFinder());
//     SceneBody crate{"crate", boxShape({0.4, 0.3, 0.2})};  // [m]
//     crate.pose.translation() = Eigen::Vector3d(0.6, 0, 0.1);
//     addBody(scene, crate);
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <unordered_set>
#include <variant>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// A static body. Boxes, spheres, cylinders and cones are convex hulls; round ones become
/// circumscribed polyhedra that protrude by at most kRoundness of the radius. Meshes are surfaces
/// without an interior, as planners treat them.
struct SceneBody {
  static constexpr double kRoundness = 5e-3;

  std::string name;  ///< unique in its scene
  std::variant<ConvexHull, TriangleMesh> shape;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of the shape's frame in the scene's
};

/// Static bodies in the frame of the robot's root link. Lengths in metres.
struct Scene {
  std::string name;
  std::vector<SceneBody> bodies;
  /// what it was read from beside its own file: meshes and included files
  std::vector<std::string> files = {};
};

// Shapes centred at their frame's origin, as URDF, SDF and MoveIt place them; sizes in metres. They
// throw kBadScene for a size that is not positive and finite, or is above 1e6.
ConvexHull boxShape(const Eigen::Vector3d& sides);
ConvexHull sphereShape(double radius);
ConvexHull cylinderShape(double radius, double length);  ///< along z
ConvexHull coneShape(double radius, double length);      ///< along z, the tip at +length / 2

struct PlacedShape {
  ConvexHull shape;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};
constexpr double kPlaneSide = 20, kPlaneDepth = 0.1;  // [m]

/// A slab that stands in for the unbounded plane a x + b y + c z + d = 0: kPlaneSide square and
/// kPlaneDepth thick. Its upper face lies in the plane, centred at the plane's point nearest to the
/// origin; the normal (a, b, c) points out of the slab. Throws kBadScene for a normal of zero
/// length, a plane more than 1e6 m from the origin, and numbers that are not finite.
PlacedShape planeShape(const Eigen::Vector3d& normal, double d);

/// How many numbers setShape() takes for "box" (3), "sphere" (1), "cylinder" and "cone" (2), and
/// "plane" (4); 0 for any other kind.
std::size_t sizesOf(const std::string& kind);

/// Gives a body a shape of that kind. For a plane, also moves the body's pose to the slab. Throws
/// as the functions above, and kBadScene for another kind or another number of sizes.
void setShape(SceneBody& body, const std::string& kind, const std::vector<double>& sizes);

/// Appends a body. Throws kTooLarge beyond 100,000 bodies; kBadScene for a name that is empty,
/// taken, longer than 1000 bytes or with a control character, a pose that is not finite or more
/// than 1e6 m out, a hull without vertices or with one that is not finite or more than 2e6 m out,
/// or a mesh that has no triangles, an index out of range, or a vertex that is not finite or more
/// than 1e6 m out. Takes time in the number of bodies: for many, use a SceneBuilder.
void addBody(Scene& scene, SceneBody body);

/// Appends many bodies to a scene, which nobody else changes meanwhile and which must outlive this.
class SceneBuilder {
 public:
  explicit SceneBuilder(Scene& scene);
  /// As addBody(), in time that hardly depends on the number of bodies.
  void add(SceneBody body);

 private:
  Scene& scene_;
  std::unordered_set<std::string> names_;
};

/// Reads a scene; the extension of `file` selects the format:
///
///   .scene            MoveIt's text format, with object poses (since MoveIt 1.1) or without. An
///                     object of several shapes becomes the bodies "object/1", "object/2", ...;
///                     colours and subframes are ignored
///   .urdf .xacro      collision elements, or the visual elements of links without any; joints are
///                     at zero, or at the limit nearest to it. Bodies are named after their links:
///                     "link", or "link/1", "link/2", ...
///   .sdf .world       the collisions of all models, nested or not, static or not, where their
///                     poses put them, or where a saved world's `<state>` does; relative_to may
///                     name links, joints, frames and models of the same scope, and those inside
///                     such a model ("a::b"). Bodies are named "model::link::collision".
///                     `<include>` accepts model:// (searched for in GAZEBO_MODEL_PATH,
///                     GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH, SDF_PATH, the folders above
///                     the file, ~/.gazebo/models, and as a package name), package://, or a path;
///                     each to a file or a model's folder
///   .stl .dae .obj .off .ply .glb .gltf
///                     one mesh, in the scene's frame
///   .bt .ot           OctoMap maps; see octomap.h
///   .yaml .yml        our own format:
///
///     name: cell                                # default: the file's name
///     bodies:                                   # m and rad; without a pose: at the origin
///     - {name: table, box: [1.2, 0.8, 0.04], pose: {xyz: [0.6, 0, -0.02], rpy: [0, 0, 0]}}
///     - {name: ball, sphere: 0.1}               # radius
///     - {name: can, cylinder: [0.03, 0.12]}     # radius, length along z
///     - {name: tip, cone: [0.05, 0.1]}          # the same, tip up
///     - {name: floor, plane: [0, 0, 1, 0]}      # a, b, c, d: see planeShape()
///     - {name: part, mesh: package://cell/meshes/part.stl, scale: [1, 1, 1]}
///     - {name: lid, mesh: lid.stl}              # a path relative to this file's folder
///     - {name: room, scene: room.world, pose: {xyz: [1, 0, 0]}}     # another file, moved
///
/// `scene` adds all bodies of another file of any of these formats, named "room/..."; scenes nest
/// at most 20 deep, and are at most 1,000 in all.
///
/// A pose may have `quaternion: [x, y, z, w]` instead of rpy. In every format, planes become
/// planeShape()'s slabs.
///
/// An empty scene must be explicit: YAML with `bodies: []`. Any other file without a body is an
/// error. Throws kFileNotFound, kUnsupportedFormat, kPackageNotFound and kTooLarge; kBadScene for
/// text that violates the format, invalid sizes and poses, duplicate names, and a scene without
/// bodies; the errors of reading a mesh, naming the body; for URDF, those of
/// readRobotDescription(), which takes `package_path`. XML and YAML are parsed in another process,
/// as meshes are: also throws kReaderFailed, kOutOfMemory, kOutOfTime, kCancelled.
Scene readScene(const std::string& file, const PackageFinder& find_package,
                const MeshLimits& limits = {}, const RunControl& control = {},
                const std::vector<std::string>& package_path = {});

}  // namespace collision_hulls
