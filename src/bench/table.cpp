// The columns of benchmark.csv. Their names and order are read by the chart scripts and by users' own tools.
#include "bench/table.h"

#include "storage/csv.h"

namespace collision_hulls {

std::string benchmarkHeader() {
  return "mesh,triangles,method,tolerance,status,hulls,hull_vertices,uncovered,protrusion,protrusion_found,volume_ratio,"
         "cpu_seconds,wall_seconds,peak_mb,hash,diagonal,seed,effort,requested,message,least_hulls\n";
}

std::string toCsv(const BenchmarkRow& row) {
  return csvLine({row.mesh,
                  csvCount(row.triangles),
                  row.method,
                  csvNumber(row.tolerance),
                  row.status,
                  csvCount(row.hulls),
                  csvCount(row.hull_vertices),
                  csvNumber(row.uncovered),
                  csvNumber(row.protrusion),
                  csvNumber(row.protrusion_found),
                  csvNumber(row.volume_ratio),
                  csvNumber(row.cpu_seconds),
                  csvNumber(row.wall_seconds),
                  csvNumber(row.peak_mb),
                  row.hash,
                  csvNumber(row.diagonal),
                  std::to_string(row.seed),
                  row.effort,
                  row.requested,
                  row.message,
                  csvCount(row.least_hulls)});
}

}  // namespace collision_hulls
