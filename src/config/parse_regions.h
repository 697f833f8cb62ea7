// The regions of a configuration.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/report/options.h"
#include "config/config_item.h"

namespace collision_hulls {

/// Reads the list. Whether its expressions match is known only to LinkDecisions. Throws the document's error, and kCancelled.
std::vector<RegionRule> readRegions(const ConfigItem& list, const RunControl& control);

/// What readRegions() reads back, as an entry of the list.
std::string yaml(const RegionRule& rule);

}  // namespace collision_hulls
