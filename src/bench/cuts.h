// Random cuts through the hull tree of a mesh: does each cover the mesh, and keep the bound that the tree states?
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/benchmark.h"

namespace collision_hulls {

/// The job `cuts`: "file", "scale", "tolerance" (of the leaves, as text: "1%"), "seed", "cuts" (how many) -> "leaves", and one entry of
/// "cuts" per cut, for its hulls as they are written, against the mesh as it was read:
///   kind         how the cut was drawn: tolerance (between the leaves' and the root's protrusion), hulls (their number), nodes (opened at
///                random)
///   hulls        how many
///   bound        [m] the largest protrusion of its nodes, as the tree states it, plus what margin and rounding add when hulls are written
///   uncovered    [m]
///   protrusion   [m] certified
nlohmann::json measureCuts(const nlohmann::json& job);

/// A cut through the tree of a mesh, as above; a single row without figures if there is no tree.
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

/// Measures `cuts` cuts of each mesh, in a process per mesh. `leaves` is the tolerance of the trees' leaves. Of the options, only program,
/// folder and seed are used.
void runCuts(const std::vector<BenchmarkMesh>& meshes, const BenchmarkOptions& options, const Length& leaves, int cuts,
             const std::function<void(const CutRow&)>& row);

}  // namespace collision_hulls
