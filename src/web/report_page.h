// report.html: a report that people look at, in one file that needs nothing else.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/report/report.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// What a page draws of a row. All is in the element's frame; anything may be empty.
struct PageElement {
  const TriangleMesh& original;
  const std::vector<ConvexHull>& hulls;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of that frame, in the frame of the robot at rest
  const std::vector<GeometryElement>& primitives;          ///< stand in the place of the last hulls, one for each
  /// A tree whose leaves are the hulls, in their order, with a proved bound for each node; null: the page merges them.
  const HullTree* tree = nullptr;
};

/// What else a model holds: a <collision> element that stays as it is. A primitive, or the surface of a mesh in its own frame.
struct PageBody {
  const GeometryElement& element;
  const TriangleMesh& surface;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

/// One of the robot's collision models.
struct PageModel {
  const ModelReport& report;
  std::vector<PageElement> elements;  ///< one for each row
  std::vector<PageBody> kept;         ///< the others
};

struct PageContent {
  std::string title;  ///< the robot's name, or the mesh's
  const Report& report;
  std::vector<PageModel> models;  ///< the first is the report's own
  bool single_mesh = false;       ///< there is no robot
  const TriangleMesh& scene;      ///< surface of what the model was fitted to, in the same frame; empty: none
};

/// The page. `three_js`: the text of that library, see threeJs(); empty: the page draws by itself. Whatever names, paths and messages hold
/// is shown, never run. The same content gives the same bytes. Throws kCancelled.
std::string reportPage(const PageContent& content, const std::string& three_js, const RunControl& control = {});

}  // namespace collision_hulls
