// Selects the method, then applies the caps. certified applies them itself, since they affect what it may merge.
#include "collision_hulls/decompose/decompose.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/decimal.h"
#include "base/positive_length.h"
#include "collision_hulls/decompose/acd.h"
#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/decompose/hacd.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "decompose/bounding_box.h"
#include "decompose/cap_hulls.h"
#include "decompose/cluster_hulls.h"

namespace collision_hulls {

void check(const DecomposeOptions& options) {
  const auto refuse = [](const std::string& text) { throw Error(ErrorCode::kBadOption, text); };
  const bool needs_tolerance = options.method != Method::kSingleHull && options.method != Method::kBoundingBox;
  const auto expect_known = [&](const char* option, const auto& all, auto value) {
    if (std::find(all.begin(), all.end(), value) != all.end()) return;
    refuse(std::string(option) + " is " + std::to_string(static_cast<int>(value)) + ", which is none of the enumerators; use one of them");
  };
  expect_known("method", allMethods(), options.method);
  expect_known("effort", allEfforts(), options.effort);
  if (needs_tolerance) expectPositiveLength("tolerance", options.tolerance);
  if (options.max_hulls < 0) refuse("max_hulls is " + std::to_string(options.max_hulls) + "; it must be at least 1, or 0 for no limit");
  if (options.max_vertices != 0 && options.max_vertices < kLeastVertices)
    refuse("max_vertices is " + std::to_string(options.max_vertices) + "; it must be at least " + std::to_string(kLeastVertices) +
           ", or 0 for no limit");
  if (!(options.padding >= 0) || !std::isfinite(options.padding))
    refuse("padding is " + fixedDecimal(options.padding) + " m; it must be 0 or a positive length");
  if (options.fill && options.method != Method::kCertified)
    refuse(std::string("fill is set but the method is ") + name(options.method) + "; only certified can fill: drop one of the two");
  if (needsCertified(options.effort) && options.method != Method::kCertified)
    refuse(std::string("effort is ") + name(options.effort) + " but the method is " + name(options.method) +
           "; only certified has it: drop one of the two");
  for (const Region& region : options.regions) check(region);
}

namespace {

std::vector<std::vector<int>> clusters(const TriangleMesh& mesh, const DecomposeOptions& options, const RunControl& control) {
  if (mesh.triangles.empty()) return {};
  if (options.method == Method::kHacd) return hacdPartition(mesh, options.tolerance, control);
  std::vector<int> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return {all};
}

/// Caps the vertices of each hull; returns whether any hull changed.
bool capVertices(std::vector<ConvexHull>& hulls, int max_vertices, const RunControl& control) {
  bool capped = false;
  for (ConvexHull& hull : hulls) {
    control.check();
    if (!exceedsCap(hull, max_vertices)) continue;
    hull = reduceVertices(hull, max_vertices, control);
    capped = true;
  }
  return capped;
}

}  // namespace

const char* name(Method method) {
  switch (method) {
    case Method::kCertified: return "certified";
    case Method::kHacd: return "hacd";
    case Method::kAcd: return "acd";
    case Method::kSingleHull: return "single_hull";
    case Method::kBoundingBox: return "bounding_box";
  }
  return "unknown";
}

const std::vector<Method>& allMethods() {
  static const std::vector<Method> methods{Method::kCertified, Method::kHacd, Method::kAcd, Method::kSingleHull, Method::kBoundingBox};
  return methods;
}

std::optional<Method> methodNamed(const std::string& text) {
  for (Method method : allMethods())
    if (text == name(method)) return method;
  return std::nullopt;
}

const char* name(Effort effort) {
  switch (effort) {
    case Effort::kInstant: return "instant";
    case Effort::kQuick: return "quick";
    case Effort::kBest: return "best";
  }
  return "unknown";
}

const std::vector<Effort>& allEfforts() {
  static const std::vector<Effort> efforts{Effort::kInstant, Effort::kQuick, Effort::kBest};
  return efforts;
}

bool needsCertified(Effort effort) {
  return effort != Effort::kQuick;
}

std::optional<Effort> effortNamed(const std::string& text) {
  for (Effort effort : allEfforts())
    if (text == name(effort)) return effort;
  return std::nullopt;
}

Decomposition decompose(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control) {
  check(options);
  if (mesh.mesh.triangles.empty() && mesh.loose.empty())
    throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangles; a decomposition needs at least one");
  control.check();
  if (options.method == Method::kCertified) return certified(mesh, options, control);
  Decomposition result;
  result.hulls = options.method == Method::kAcd ? acdHulls(mesh, options.tolerance, control)
                                                : clusterHulls(mesh, clusters(mesh.mesh, options, control), control);
  if (options.method == Method::kBoundingBox) result.hulls = {orientedBox(result.hulls.front(), control)};
  if (options.max_hulls > 0 && result.hulls.size() > static_cast<std::size_t>(options.max_hulls)) {
    result.hulls = capHulls(result.hulls, options.max_hulls, control);
    result.capped = true;
  }
  if (capVertices(result.hulls, options.max_vertices, control)) result.capped = true;
  control.report(1);
  return result;
}

}  // namespace collision_hulls
