// Sums over a report's rows, for the JSON and the table.
#pragma once

#include <cstddef>

#include "collision_hulls/report/report.h"

namespace collision_hulls {

struct Totals {
  std::size_t links = 0;  ///< links with at least one mesh
  std::size_t meshes = 0, triangles = 0, hulls = 0, primitives = 0, least_hulls = 0,
              hull_vertices = 0, failed = 0, degraded = 0;
  std::size_t kept = 0, removed = 0;  ///< links, which do not count among the others
};

Totals totals(const ModelReport& report);

}  // namespace collision_hulls
