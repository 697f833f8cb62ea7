// The common interface of all methods: a repaired mesh in, a covering set of convex hulls out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/region.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

enum class Method {
  /// ours: few hulls whose protrusion provably stays within the tolerance, see certified.h
  kCertified,
  kHacd,        ///< Mamou & Ghorbel 2009, see hacd.h
  kAcd,         ///< Lien & Amato 2007, see acd.h
  kSingleHull,  ///< the convex hull of the whole mesh
  kBoundingBox  ///< the smallest oriented box found
};
const char* name(Method method);  ///< "certified", "hacd", "acd", "single_hull", "bounding_box"
std::optional<Method> methodNamed(const std::string& name);
const std::vector<Method>& allMethods();

/// How hard certified looks for fewer hulls; either way it stays within the tolerance.
enum class Effort {
  kInstant,  ///< split and merge once: for previews
  kQuick,    ///< up to three ways of splitting, merge, and a short search
  kBest      ///< several ways of splitting, and a long search
};
const char* name(Effort effort);  ///< "instant", "quick", "best"
std::optional<Effort> effortNamed(const std::string& name);
const std::vector<Effort>& allEfforts();
/// Whether the effort is a choice that only method certified offers: all but kQuick are.
bool needsCertified(Effort effort);

struct DecomposeOptions {
  Method method = Method::kCertified;
  /// [m] > 0, and has to be set: acceptable protrusion (hacd, acd: the papers' concavity epsilon).
  /// None is too large here; checkTolerance() in report/options.h refuses more than 1 m, which are
  /// mostly millimetres by mistake
  double tolerance = 0;
  int max_hulls = 0;  ///< most hulls per mesh; 0: no limit
  /// most vertices per hull, at least 8; 0: no limit. Reduction is outward only
  int max_vertices = 64;
  std::uint64_t seed = 1;  ///< seeds everything random
  Effort effort = Effort::kQuick;
  bool fill = false;  ///< certified: also cover the inside of closed meshes, not only their surface
  /// certified: where the hulls protrude less, in the mesh's frame; other methods ignore them
  std::vector<Region> regions;
  /// [m] >= 0: certifiedHulls() makes the hulls hold everything within this distance of the
  /// surface
  double padding = 0;
};

/// Throws kBadOption for a value outside its range, for an effort or a filling that the method does
/// not have, and as check() of its regions. How fine a tolerance may be depends on the mesh;
/// decompose() checks that.
void check(const DecomposeOptions& options);

struct Decomposition {
  /// cover the mesh and its loose segments up to rounding; in a fixed order
  std::vector<ConvexHull> hulls;
  /// a limit (on hulls or vertices) made the result coarser than the tolerance alone would
  bool capped = false;
  /// the tolerance asks for more pieces than a mesh is divided into: the hulls are those of a
  /// larger one (certified)
  bool too_fine = false;
  /// what the control's deadline cut short or left out, for people; empty: nothing
  std::string untried;
};

/// Decomposes a mesh. Deterministic: the same input and options give the same bytes, whatever else
/// is running. Throws kBadOption as check(), and for a tolerance below a millionth of the mesh's
/// diagonal (unless the method ignores it), kEmptyMesh, kCancelled.
Decomposition decompose(const RepairedMesh& mesh, const DecomposeOptions& options,
                        const RunControl& control = {});

}  // namespace collision_hulls
