// What happens to meshes between a designer and a user: perturbations, which leave the shape alone, and defects.
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
  kRotation,        ///< amount: degrees about some axis through the box's middle
  kJitter,          ///< amount: how far each coordinate may move, in D
  kScale,           ///< amount: factor
  kFar,             ///< amount: how far from where it was, in D
  kRetessellation,  ///< amount: pieces of each triangle, 4
  kShuffle,         ///< other orders of vertices, triangles, and a triangle's corners
  kUnwelded,        ///< three vertices of its own for each triangle
  kDuplicate,       ///< amount: share of the triangles that are there twice
  kFlipped,         ///< amount: share of the triangles that face the other way
  kZeroArea,        ///< amount: share of the triangles that have one without area at one of their edges
  kSliver,          ///< amount: height over length of slivers cut off one triangle in ten
  kDecimation,      ///< amount: share of the vertices that is left; the shape changes somewhat, as with all that follow
  kHole,            ///< amount: share of the triangles that is missing, in one place
  kFin,             ///< amount: height, in D, of triangles that stand on one edge in twenty, which so has three
  kSelfCrossing,    ///< amount: how far off, in D, a copy of the mesh lies
  kNested,          ///< amount: size of a copy about the same middle
  kManyComponents,  ///< amount: how many small tetrahedra lie on the surface
  kOneTriangle,     ///< the largest triangle alone
  kNan              ///< one coordinate is not a number: to be refused
};
const char* name(TroubleKind kind);  ///< "none", "rotation", "jitter", ... "zero_area", ... "one_triangle", "nan"
std::optional<TroubleKind> troubleNamed(const std::string& name);

struct Trouble {
  TroubleKind kind = TroubleKind::kNone;
  double amount = 0;
};

/// All kinds in the order above, each with its usual amounts; kNone first.
const std::vector<Trouble>& usualTroubles();
/// Some of them: a moderate amount of each kind.
const std::vector<Trouble>& fewTroubles();

/// Whether the surface stays what it was, up to motion, scale and jitter, so that a result should stay as well.
bool keepsShape(TroubleKind kind);

/// Whether another seed gives another mesh.
bool isRandom(TroubleKind kind);

/// How much longer lengths are than before.
double lengthFactor(const Trouble& trouble);

/// The mesh in trouble. `mesh` has triangles, which name vertices that there are. The same seed gives the same mesh everywhere.
TriangleMesh troubled(const TriangleMesh& mesh, const Trouble& trouble, std::uint64_t seed);

}  // namespace collision_hulls
