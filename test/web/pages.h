// Reports and their contents, made by hand.
#pragma once

#include <string>
#include <vector>

#include "shapes.h"
#include "web/report_page.h"

namespace collision_hulls {
namespace pages {

inline ElementReport row(const std::string& link, Status status = Status::kOk) {
  ElementReport row;
  row.link = link;
  row.uri = "package://robot/meshes/" + link + ".stl";
  row.sha256 = link;
  row.status = status;
  row.triangles = 1234;
  if (status != Status::kFailed) {
    row.hulls = 2;
    row.hull_vertices = 16;
    row.protrusion = 0.0098;
    row.protrusion_found = 0.0095;
  }
  row.tolerance = 0.01;
  return row;
}

/// Two boxes for each link, in the place of a larger one.
struct Sample {
  explicit Sample(const std::vector<ElementReport>& rows = {row("arm"), row("hand")}) {
    report.links = rows;
    report.input_path = "robot.urdf";
    report.validation.queries = 400;
    report.validation.mesh_query_us = 27;
    report.validation.hull_query_us = 1;
    for (const double x : {0.0, 2.0}) hulls.push_back(convexHull(test_shapes::moved(test_shapes::box(1, 1, 1), {x, 0, 0}).vertices));
  }

  PageContent content() const {
    PageContent content{"robot", report, {PageModel{report, {}, {}}}, false, scene};
    for (const ElementReport& row : report.links)
      content.models[0].elements.push_back({original, row.hulls > 0 ? hulls : none, Eigen::Isometry3d::Identity(), primitives});
    return content;
  }

  Report report;
  TriangleMesh original = test_shapes::box(3, 1, 1), scene;
  std::vector<ConvexHull> hulls, none;
  std::vector<GeometryElement> primitives;  // of each link
};

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace pages
}  // namespace collision_hulls
