// What a page's script draws: a description in JSON, and the geometry as bytes.
#pragma once

#include <string>

#include "web/report_page.h"

namespace collision_hulls {

/// For src/web/page/data.js, which says what each field means to it.
struct ViewData {
  std::string json;
  std::string geometry;  ///< meshes one after another (toPageBytes), where the JSON says
};

/// Meshes with equal hulls are there once, however many links use them.
ViewData viewData(const PageContent& content, const RunControl& control = {});

}  // namespace collision_hulls
