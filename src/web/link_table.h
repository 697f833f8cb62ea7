// The table of a report's rows, as HTML.
#pragma once

#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/report/report.h"

namespace collision_hulls {

/// A row for each mesh, failed ones first, then degraded ones, each with its reason below it. Every row is a <tbody>, for sorting: its
/// data-row is the index in `model.links`, and a cell's data-value what it is sorted by.
std::string linkTable(const ModelReport& model, const RunControl& control = {});

}  // namespace collision_hulls
