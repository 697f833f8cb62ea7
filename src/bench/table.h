// The rows of a benchmark.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace collision_hulls {

/// One mesh, decomposed by one method at one tolerance. Anything not measured is empty. Lengths in metres.
struct BenchmarkRow {
  std::string mesh;
  std::optional<std::size_t> triangles;  ///< as read
  std::string method;                    ///< of this package, or the name of a peer
  std::optional<double> tolerance;
  std::string status = "ok";  ///< ok, timeout, crash, error
  std::optional<std::size_t> hulls, hull_vertices;
  std::optional<double> uncovered, protrusion, protrusion_found;
  std::optional<double> volume_ratio;  ///< of the hulls' union to the solid; empty if the mesh encloses nothing
  std::optional<double> cpu_seconds, wall_seconds, peak_mb;
  std::string hash;  ///< SHA-256 of the hulls' vertices
  std::optional<double> diagonal;
  std::uint64_t seed = 1;
  std::string effort;                      ///< of methods that have efforts
  std::string requested;                   ///< the tolerance as requested: "1%"
  std::string message;                     ///< why there is no result, or what is odd about it
  std::optional<std::size_t> least_hulls;  ///< proved: nothing within the tolerance covers the mesh with fewer; see leastHulls()
  std::string hulls_file;                  ///< where the hulls are kept; empty if they are not; not a column
};

/// The column names and a row, each as a line of benchmark.csv (RFC 4180).
std::string benchmarkHeader();
std::string toCsv(const BenchmarkRow& row);

}  // namespace collision_hulls
