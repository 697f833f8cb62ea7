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
    case Status::kKept: return "kept";
    case Status::kRemoved: return "removed";
  }
  return "unknown";
}

bool anyFailed(const Report& report) {
  const auto failed = [](const ModelReport& model) { return totals(model).failed > 0; };
  return failed(report) || std::any_of(report.models.begin(), report.models.end(), failed) || isRefuted(report);
}

bool isRefuted(const Report& report) {
  const auto refuted = [&](const ModelReport& model) { return report.options.validate && !model.validation.holds(); };
  return refuted(report) || std::any_of(report.models.begin(), report.models.end(), refuted) || (report.scene && report.scene->missed > 0);
}

bool allFailed(const Report& report) {
  const auto failed = [](const ModelReport& model) { return totals(model).failed > 0 && totals(model).failed == totals(model).meshes; };
  return failed(report) && std::all_of(report.models.begin(), report.models.end(), failed) && report.primitive_links < totals(report).links;
}

Totals totals(const ModelReport& report) {
  Totals sum;
  const std::string* link = nullptr;  // rows of a link stand together
  for (const ElementReport& row : report.links) {
    const bool is_new = !link || *link != row.link;
    link = &row.link;
    if (row.status == Status::kKept || row.status == Status::kRemoved) {
      (row.status == Status::kKept ? sum.kept : sum.removed) += is_new;
      continue;
    }
    sum.links += is_new;
    ++sum.meshes;
    sum.triangles += row.triangles;
    sum.hulls += row.hulls;
    sum.primitives += row.primitives;
    sum.least_hulls += row.least_hulls;
    sum.hull_vertices += row.hull_vertices;
    sum.failed += row.status == Status::kFailed;
    sum.degraded += row.status == Status::kDegraded;
  }
  return sum;
}

}  // namespace collision_hulls
