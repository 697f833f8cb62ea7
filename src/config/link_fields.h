// The settings of a link, once: whoever reads, writes or applies them goes through this list.
#pragma once

#include "collision_hulls/report/options.h"

namespace collision_hulls {

/// Calls visit(name, option, setting) for each, with pointers to the members of LinkOptions and LinkSettings.
template <typename Visit>
void forEachLinkField(const Visit& visit) {
  visit("action", &LinkOptions::action, &LinkSettings::action);
  visit("tolerance", &LinkOptions::tolerance, &LinkSettings::tolerance);
  visit("method", &LinkOptions::method, &LinkSettings::method);
  visit("effort", &LinkOptions::effort, &LinkSettings::effort);
  visit("fill", &LinkOptions::fill, &LinkSettings::fill);
  visit("max_hulls", &LinkOptions::max_hulls, &LinkSettings::max_hulls);
  visit("max_vertices", &LinkOptions::max_vertices, &LinkSettings::max_vertices);
  visit("source", &LinkOptions::source, &LinkSettings::source);
  visit("padding", &LinkOptions::padding, &LinkSettings::padding);
  visit("close_openings", &LinkOptions::close_openings, &LinkSettings::close_openings);
  visit("shapes", &LinkOptions::shapes, &LinkSettings::shapes);
}

}  // namespace collision_hulls
