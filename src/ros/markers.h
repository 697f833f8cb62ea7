// What rviz draws, as plain markers: pure functions from results to messages. View publishes them.
#pragma once

#include "collision_hulls/pipeline/result.h"
#include "collision_hulls/scene/scene.h"
#include "pen.h"
#include "robot_bounds.h"

namespace collision_hulls {

constexpr std::size_t kMostSceneTriangles = 1'000'000;  ///< a scene of more is not drawn: rviz could not cope with it

/// Everything drawn of a robot, one list per display. Markers are in their link's frame and locked to it, except those of the scene, which
/// are in the root link's frame. The namespace is `<kind>/<link>`; ids count from 0 within a namespace.
struct Drawing {
  MarkerList hulls;       ///< hulls/: a TRIANGLE_LIST per hull; primitives/: boxes, spheres and cylinders
  MarkerList original;    ///< original/: a mesh as it was read, or a primitive; grey
  MarkerList protrusion;  ///< worst/: sphere and arrow at the place of largest protrusion, and its size as text
  MarkerList labels;      ///< labels/: "forearm: 5 hulls, 4.8 mm", with a line to the link
  MarkerList unneeded;    ///< unneeded/: grey, finer hulls that a scene did not need
  MarkerList segments;    ///< segments/: a TRIANGLE_LIST per mesh, coloured by cluster
  MarkerList chosen;      ///< chosen/: the edges of hulls that stand out
  MarkerList scene;       ///< scene: one TRIANGLE_LIST of all bodies
};

/// The original alone, before anything is computed: each mesh as a MESH_RESOURCE, which rviz reads itself, and the primitives.
Drawing drawOriginal(const RobotDescription& robot, Source source, const MeshFile& file);

/// A result, the description that it was made from (for the primitives among the originals), and the scene that it was fitted to (null:
/// none). `opacity` is that of the hulls, in [0, 1].
Drawing drawResult(const RobotResult& result, const RobotDescription& original, const Scene* scene, double opacity);

/// A link on its own: its results, and as collisions of `link` the primitives that are shown.
struct ShownLink {
  LinkDescription link;
  double hue = 0;  ///< see linkHue()
  std::vector<ElementResult> elements;
  std::vector<ElementReport> rows;  ///< of the elements
};

/// Its hulls, primitives and protrusion as in drawResult(), and in `chosen` the edges of its hulls: chosen/<link>, a LINE_LIST. `radius`
/// [m]: of the robot.
Drawing drawLink(const ShownLink& shown, double radius, double opacity);

}  // namespace collision_hulls
