// The methods' common interface: a repaired mesh in, convex hulls that cover it out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

enum class Method {
  kCertified,   ///< ours: fewest hulls whose protrusion provably stays within the tolerance, see certified.h
  kHacd,        ///< Mamou & Ghorbel 2009, see hacd.h
  kAcd,         ///< Lien & Amato 2007, see acd.h
  kSingleHull,  ///< the convex hull of everything
  kBoundingBox  ///< the smallest oriented box found
};
const char* name(Method method);  ///< "certified", "hacd", "acd", "single_hull", "bounding_box"
std::optional<Method> methodNamed(const std::string& name);
const std::vector<Method>& allMethods();

/// How long certified looks for fewer hulls; both keep within the tolerance.
enum class Effort {
  kQuick,  ///< cut, merge, and a short search
  kBest    ///< several cuts, and a long search
};
const char* name(Effort effort);  ///< "quick", "best"
std::optional<Effort> effortNamed(const std::string& name);

struct DecomposeOptions {
  Method method = Method::kCertified;
  double tolerance = 0;    ///< [m] > 0: protrusion that the caller accepts (hacd, acd: the papers' concavity epsilon)
  int max_hulls = 0;       ///< most hulls per mesh; 0: no cap
  int max_vertices = 64;   ///< most vertices per hull, at least 8; 0: no cap. Reduced outward only
  std::uint64_t seed = 1;  ///< of whatever is random
  Effort effort = Effort::kQuick;
  bool fill = false;  ///< certified: cover the inside of closed meshes as well, not their surface alone
};

void check(const DecomposeOptions& options);  ///< throws kBadOption

struct Decomposition {
  std::vector<ConvexHull> hulls;  ///< they cover mesh and loose segments up to rounding; in a fixed order
  bool capped = false;            ///< a cap (hulls or vertices) made the result coarser than the tolerance alone would
};

/// Decomposes a mesh. Deterministic: same input and options, same bytes, whatever else runs. Thread safe.
/// Throws kBadOption, kEmptyMesh, kCancelled.
Decomposition decompose(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control = {});

}  // namespace collision_hulls
