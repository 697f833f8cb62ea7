// A report in a sentence or two, as its page begins.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/report/report.h"

namespace collision_hulls {

/// What came of a model, with the numbers of the report and nothing that it did not measure. One sentence each, as plain text; the first
/// has the totals. `report` holds what all models share.
std::vector<std::string> summary(const ModelReport& model, const Report& report);

/// Sentences on what asks for attention: failed and degraded meshes, missed and false collisions. Empty if nothing does.
std::vector<std::string> warnings(const ModelReport& model, const Report& report);

}  // namespace collision_hulls
