// Sums and verdicts over the rows of a report.
#include "collision_hulls/report/report.h"

#include <algorithm>

#include "collision_hulls/report/totals.h"

namespace collision_hulls {

const char* version() {
  return COLLISION_HULLS_VERSION;
}

const char* name(Status status) {
  switch (status) {
    case Status::kOk: return "ok";
    case Status::kDegraded: return "degraded";
    case Status::kFailed: return "failed";
  }
  return "unknown";
}

bool anyFailed(const Report& report) {
  return std::any_of(report.links.begin(), report.links.end(), [](const ElementReport& row) { return row.status == Status::kFailed; });
}

bool allFailed(const Report& report) {
  return !report.links.empty() &&
         std::all_of(report.links.begin(), report.links.end(), [](const ElementReport& row) { return row.status == Status::kFailed; });
}

Totals totals(const Report& report) {
  Totals sum;
  const std::string* link = nullptr;  // rows of a link stand together
  for (const ElementReport& row : report.links) {
    if (!link || *link != row.link) ++sum.links;
    link = &row.link;
    ++sum.meshes;
    sum.triangles += row.triangles;
    sum.hulls += row.hulls;
    sum.hull_vertices += row.hull_vertices;
    sum.failed += row.status == Status::kFailed;
    sum.degraded += row.status == Status::kDegraded;
  }
  return sum;
}

}  // namespace collision_hulls
