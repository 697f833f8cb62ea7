// What happens to meshes between designer and user: perturbations, which keep the shape, and defects.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// D is the mesh's bounding-box diagonal.
enum class TroubleKind {
  kNone,
  kRotation,        ///< amount: degrees, about a random axis through the middle of the box
  kJitter,          ///< amount: how far each coordinate may move, in D
  kScale,           ///< amount: factor
  kFar,             ///< amount: translation, in D
  kRetessellation,  ///< amount: pieces per triangle, 4
  kShuffle,         ///< vertices, triangles, and each triangle's corners in another order
  kUnwelded,        ///< each triangle has three vertices of its own
  kDuplicate,       ///< amount: share of the triangles that appear twice
  kFlipped,         ///< amount: share of the triangles that face the other way
  kZeroArea,        ///< amount: share of the triangles that get a triangle without area at one of their edges
  kSliver,          ///< amount: height over length of the slivers, which one triangle in ten gets
  kDecimation,      ///< amount: share of the vertices left; from here on the shape changes, too
  kHole,            ///< amount: share of the triangles missing, all in one place
  kFin,             ///< amount: height, in D, of extra triangles on one edge for every twenty triangles, which makes the edge non-manifold
  kSelfCrossing,    ///< amount: offset, in D, of a copy of the mesh
  kNested,          ///< amount: size of a copy with the same middle
  kManyComponents,  ///< amount: number of small tetrahedra added on the surface
  kOneTriangle,     ///< only the largest triangle
  kNan              ///< one coordinate is not a number; must be refused
};
const char* name(TroubleKind kind);  ///< "none", "rotation", "jitter", ... "zero_area", ... "one_triangle", "nan"
std::optional<TroubleKind> troubleNamed(const std::string& name);

struct Trouble {
  TroubleKind kind = TroubleKind::kNone;
  double amount = 0;
};

/// All kinds, each with its usual amounts; kNone first.
const std::vector<Trouble>& usualTroubles();
/// A third of these, with moderate amounts; kNone first.
const std::vector<Trouble>& fewTroubles();

/// Whether the surface stays the same up to motion, scale and jitter, so that the result should stay the same, too.
bool keepsShape(TroubleKind kind);

/// Whether another seed gives another mesh.
bool isRandom(TroubleKind kind);

/// The factor by which the trouble scales lengths.
double lengthFactor(const Trouble& trouble);

/// The mesh with the trouble applied. `mesh` must have triangles, with valid indices. The same seed gives the same mesh everywhere.
TriangleMesh troubled(const TriangleMesh& mesh, const Trouble& trouble, std::uint64_t seed);

}  // namespace collision_hulls
