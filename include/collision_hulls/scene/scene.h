// What stands around a robot: static bodies, read from the formats in which scenes are kept.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// A static body. Boxes, spheres, cylinders and cones are convex hulls; round ones of a polyhedron that circumscribes them, no more than
/// kRoundness of their radius further out. Meshes are surfaces without an inside, as planners take them.
struct SceneBody {
  static constexpr double kRoundness = 5e-3;

  std::string name;  ///< unique in its scene
  std::variant<ConvexHull, TriangleMesh> shape;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of the shape's frame in the scene's
};

/// The scene's frame is that of the robot's root link. Lengths in metres.
struct Scene {
  std::string name;
  std::vector<SceneBody> bodies;
};

// Shapes about their frame's origin, as URDF, SDF and MoveIt place them; sizes in metres. They throw kBadScene for a size that is not
// positive and finite, or is above 1e6.
ConvexHull boxShape(const Eigen::Vector3d& sides);
ConvexHull sphereShape(double radius);
ConvexHull cylinderShape(double radius, double length);  ///< along z
ConvexHull coneShape(double radius, double length);      ///< along z, the tip at +length / 2

struct PlacedShape {
  ConvexHull shape;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};
constexpr double kPlaneSide = 20, kPlaneDepth = 0.1;  // [m]

/// What stands for a plane a x + b y + c z + d = 0, which bodies here cannot: a slab, kPlaneSide square and kPlaneDepth thick. Its upper
/// face is the plane, about the point that is nearest to the origin; (a, b, c) points out of it. Throws kBadScene for a normal of no
/// length.
PlacedShape planeShape(const Eigen::Vector3d& normal, double d);

/// Numbers that setShape() takes for "box" (3), "sphere" (1), "cylinder", "cone" (2) and "plane" (4); 0 for any other kind.
std::size_t sizesOf(const std::string& kind);

/// Gives a body the shape of such a kind. A plane's slab moves the body's frame within it. Throws as
/// the functions above.
void setShape(SceneBody& body, const std::string& kind, const std::vector<double>& sizes);

/// Appends a body. Throws kBadScene for a name that is empty or taken, a pose that is not finite, or a mesh with a vertex that is not
/// finite or an index out of range, without triangles, or further than 1e6 m out.
void addBody(Scene& scene, SceneBody body);

/// Reads a scene; `file` says what it is by its extension:
///
///   .scene            MoveIt's text, with poses of objects (since MoveIt 1.1) or without. An object of several shapes gives bodies named
///                     "object/1", "object/2", ...; colours and subframes are not looked at
///   .urdf .xacro      collision elements, or visual ones of links that have none, joints at zero or the limit that is nearest to it; named
///                     as the link, or "link/1", "link/2", ...
///   .sdf .world       the collisions of all models, also nested and within a world, static or not, where their poses put them, or where a
///                     saved world's `<state>` says that they were; relative_to names links, joints, frames and models beside it, and those
///                     within such a model ("a::b"). Named "model::link::collision". `<include>` takes model:// (looked for in
///                     GAZEBO_MODEL_PATH, GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH, SDF_PATH, the folders that enclose the file, as
///                     a package's name, and in ~/.gazebo/models), package://, or a path, of a file or a model's folder
///   .stl .dae .obj .off .ply    one mesh, where it is
///   .bt .ot           OctoMap's maps; see octomap.h
///   .yaml .yml        ours:
///
///     name: cell                                   # may be missing
///     bodies:
///     - {name: table, box: [1.2, 0.8, 0.04], pose: {xyz: [0.6, 0, -0.02], rpy: [0, 0, 0]}}    # m, rad; no pose: at the origin
///     - {name: ball, sphere: 0.1}                                                            # radius
///     - {name: can, cylinder: [0.03, 0.12]}                                                  # radius, length along z
///     - {name: tip, cone: [0.05, 0.1]}                                                       # the same, the tip up
///     - {name: floor, plane: [0, 0, 1, 0]}                                                   # a, b, c, d: see planeShape()
///     - {name: part, mesh: package://cell/meshes/part.stl, scale: [1, 1, 1]}                 # or a path from the file's folder
///
/// A pose may have `quaternion: [x, y, z, w]` in place of rpy. A plane of any format is planeShape()'s slab.
///
/// An empty scene has to be meant: YAML with `bodies: []`. Any other file without a body is an error.
/// Throws kFileNotFound, kUnsupportedFormat, kPackageNotFound, kTooLarge; kBadScene for what the format does not allow, sizes and
/// poses that are none, names that stand twice, and no body; a mesh's errors, naming the body; for URDF those of readRobotDescription().
Scene readScene(const std::string& file, const PackageFinder& find_package);

}  // namespace collision_hulls
