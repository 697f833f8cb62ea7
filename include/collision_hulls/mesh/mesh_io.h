// Meshes from and to files. The only room that sees Assimp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

struct MeshLimits {
  std::uintmax_t max_bytes = std::uintmax_t{1} << 30;  ///< largest file [bytes]
  std::size_t max_triangles = 20'000'000;              ///< most triangles in a file
};

/// What a file held.
struct LoadedMesh {
  TriangleMesh mesh;                   ///< metres; node transforms and Collada unit applied as rviz shows them; its up-axis turns nothing
  int submeshes = 0;                   ///< sub-meshes that gave triangles (a node's instance counts once each)
  std::size_t skipped_primitives = 0;  ///< lines and points, which have no surface, left out
  double resolution = 0;  ///< [m] half a unit in the last place of the largest number that the single-precision reader rounded; decimal
                          ///< text errs by up to 1.25 of it
};

/// The extensions that readMesh takes, lower case with the dot: .stl .dae .obj .off .ply (any case in a file's name).
const std::vector<std::string>& meshExtensions();

/// Whether a file is named as one that readMesh takes.
bool isMeshFile(const std::string& path);

/// Reads a mesh file. Collada's `<unit>` scales, its `<up_axis>` has no effect, and node transforms apply, as in rviz. Polygons are
/// triangulated without loss; materials and textures are not looked for; vertices that no triangle uses are left out. A file
/// that is cut off or contradicts itself is an error, never half a mesh. Units: Collada's are converted to metres, the other formats'
/// numbers are taken as metres. Throws kFileNotFound, kUnsupportedFormat, kNotAMesh, kEmptyMesh, kTooLarge, kNonFiniteCoordinate,
/// kIndexOutOfRange, kTooFarFromOrigin (single precision resolves less than a thousandth of the mesh's diagonal), kCancelled. Thread safe.
LoadedMesh readMesh(const std::string& path, const MeshLimits& limits = {}, const RunControl& control = {});

enum class MeshFormat { kStl, kObj, kDae };

/// The extension of a format, with the dot.
const char* extension(MeshFormat format);
std::optional<MeshFormat> meshFormatNamed(const std::string& name);  ///< "stl", "obj", "dae"

/// The text of a mesh file that holds one hull: binary STL, OBJ, or Collada. Coordinates are written as single-precision numbers
/// (exactly, so a hull whose vertices are single-precision numbers is read back unchanged; Assimp reads a text's numbers below
/// 1e-6 m with an error of a few units in their last place). The same hull gives the same bytes. Blanks in names become '_', and so
/// does what XML reserves.
std::string encodeHull(const ConvexHull& hull, MeshFormat format, const std::string& object_name);

/// One OBJ with an object (`o <name>_<m>`) per hull; coordinates as in encodeHull.
std::string encodeHullsObj(const std::vector<ConvexHull>& hulls, const std::string& name);

}  // namespace collision_hulls
