// Reading and writing mesh files. Formats are parsed in another process, which links Assimp; the
// libraries do not.
//
// For example:
//
//     const LoadedMesh part = readMesh("part.dae");  // [m], as rviz shows it
//     const ConvexHull hull = convexHull(part.mesh.vertices);
//     std::ofstream("part.stl", std::ios::binary) << encodeHull(hull, MeshFormat::kStl, "part");
#pragma once

#include <array>
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
  std::uintmax_t max_bytes = std::uintmax_t{1} << 30;  ///< largest file, with its buffers [bytes]
  std::size_t max_triangles = 20'000'000;              ///< most triangles in a file
  /// What the process that reads a file may use, beside 40 bytes of memory for each byte of the
  /// file and 1 s for each of its megabytes.
  std::uintmax_t reader_memory = std::uintmax_t{512} << 20;  ///< address space [bytes]
  double reader_seconds = 4;                                 ///< computing time [s], > 0
};

/// The contents of a mesh file.
struct LoadedMesh {
  /// metres; node transforms and Collada's unit are applied as in rviz, Collada's up-axis is
  /// ignored
  TriangleMesh mesh;
  /// sub-meshes that contributed triangles (each instance in the node tree counts)
  int submeshes = 0;
  std::size_t skipped_primitives = 0;  ///< lines and points, left out because they have no surface
  /// [m] half a unit in the last place of the largest number that the single-precision reader
  /// rounded; decimal text errs by up to 1.25 times this
  double resolution = 0;
};

/// [m] How far a point of the surface may lie from where the file has it: each of its three
/// coordinates errs by up to 1.25 times the LoadedMesh::resolution.
inline double readingError(double resolution) {
  constexpr double kDiagonal = 1.7320508075688772;  // of a cube
  return 1.25 * kDiagonal * resolution;
}

/// The extensions that readMesh supports, in lower case with the dot (file names may use any
/// case): .stl .dae .obj .off .ply .glb .gltf
const std::vector<std::string>& meshExtensions();

/// Whether a file's name has one of the extensions that readMesh supports.
bool isMeshFile(const std::string& path);

/// Reads a mesh file. As in rviz, Collada's `<unit>` scales, its `<up_axis>` is ignored, and node
/// transforms apply. Units: Collada's are converted to metres; numbers in other formats are metres.
/// Polygons are triangulated without loss, in two ways if their surface is in doubt (see
/// doc/limits.md); materials and textures are ignored; vertices that no triangle uses are dropped.
/// A truncated or inconsistent file is an error, never half a mesh, and so is one with anything
/// that may carry surface and is not understood. Buffers of a .gltf file may be in other files, in
/// its folder or below. Throws kFileNotFound, kOutsideRoots (such a buffer lies elsewhere),
/// kUnsupportedFormat, kNotAMesh, kEmptyMesh, kTooLarge, kNonFiniteCoordinate, kIndexOutOfRange,
/// kTooFarFromOrigin (single precision cannot resolve a thousandth of the mesh's diagonal),
/// kReaderFailed, kOutOfMemory, kOutOfTime, kCancelled, and kBadOption for limits without a
/// positive, finite time.
///
/// Except for binary STL, bytes are decoded in another process, `collision_hulls_reader`, which is
/// started as needed and can do nothing else. A file that crashes it is kReaderFailed, and one that
/// exceeds its limits kOutOfMemory or kOutOfTime; a cancelled run ends it at once.
LoadedMesh readMesh(const std::string& path, const MeshLimits& limits = {},
                    const RunControl& control = {});

/// The same from the content of a mesh file. `name` stands in messages; its extension says how the
/// bytes are read. Buffers in other files are refused, with kNotAMesh. Throws what readMesh()
/// throws, except kFileNotFound and kOutsideRoots.
LoadedMesh parseMesh(const std::string& bytes, const std::string& name,
                     const MeshLimits& limits = {}, const RunControl& control = {});

/// What keeps a hostile mesh file from doing harm on this machine, in words: "a process of its own,
/// with limits, seccomp, Landlock". Throws kReaderFailed if no mesh can be read.
std::string readerProtection();

enum class MeshFormat { kStl, kObj, kDae };

/// The extension of a format, with the dot.
const char* extension(MeshFormat format);
std::optional<MeshFormat> meshFormatNamed(const std::string& name);  ///< "stl", "obj", "dae"

/// The contents of a mesh file with one hull: binary STL, OBJ, or Collada. Coordinates are written
/// as single-precision numbers, exactly: a hull with single-precision vertices is read back
/// unchanged (but Assimp reads Collada's numbers below 1e-6 m with an error of a few units in the
/// last place). The same hull gives the same bytes. STL has no name. In names, blanks and
/// characters that XML reserves become '_'.
std::string encodeHull(const ConvexHull& hull, MeshFormat format, const std::string& object_name);

/// One OBJ file with an object (`o <name>_<m>`, m from 0) per hull; coordinates as in encodeHull().
std::string encodeHullsObj(const std::vector<ConvexHull>& hulls, const std::string& name);

using Rgb = std::array<std::uint8_t, 3>;  ///< red, green and blue

/// A mesh in coloured parts, sets of its triangles, as binary PLY. Vertices have their part's
/// colour and are written once for each part; faces have its number, `int part`. Coordinates are
/// single precision. The same mesh gives the same bytes. Throws what check() of
/// a mesh throws, and kIndexOutOfRange for a triangle that is not there or a part without a colour.
std::string encodePly(const TriangleMesh& mesh, const std::vector<std::vector<int>>& parts,
                      const std::vector<Rgb>& colours);

}  // namespace collision_hulls
