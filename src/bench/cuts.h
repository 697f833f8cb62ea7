// Random cuts through the hull tree of a mesh: whether each covers it, and keeps the bound that the tree tells.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/benchmark.h"

namespace collision_hulls {

/// The job `cuts`: "file", "scale", "tolerance" (of the leaves, as text: "1%"), "seed", "cuts" (how many) -> "leaves", and "cuts", one for
/// each, of hulls as they are written, measured against the mesh as it was read:
///   kind         tolerance (between the leaves' and the root's protrusion), hulls (a number of them), nodes (opened by chance)
///   hulls        how many
///   bound        [m] of the furthest protruding node, as the tree tells, with what margin and rounding add once hulls are written
///   uncovered    [m]
///   protrusion   [m] certified
nlohmann::json measureCuts(const nlohmann::json& job);

/// A cut through the tree of a mesh, as above; one row without figures where there is no tree.
struct CutRow {
  std::string mesh;
  std::string status = "ok";  ///< ok, timeout, crash, error
  std::string kind;
  std::optional<std::size_t> leaves, hulls;
  std::optional<double> bound, uncovered, protrusion;
  std::string message;
};

std::string cutHeader();
std::string toCsv(const CutRow& row);

/// So many cuts of each mesh, in a process of its own. `leaves` is the tolerance of the trees' leaves. Of the options the program, the
/// folder and the seed count.
void runCuts(const std::vector<BenchmarkMesh>& meshes, const BenchmarkOptions& options, const Length& leaves, int cuts,
             const std::function<void(const CutRow&)>& row);

}  // namespace collision_hulls
