// What a run gives, and what it says on its way: the words that its entry points share.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/decompose/segments.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/report/report.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// The geometry of one mesh of one link; its row in the report says how well the hulls fit.
/// Coordinates after the row's scale, in the element's own frame (before its `<origin>`).
struct ElementResult {
  std::string link;
  GeometryElement source;
  /// Of the element's frame in the robot's zero configuration.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  TriangleMesh original;          ///< as read and scaled
  std::vector<ConvexHull> hulls;  ///< as written; empty if the row's status is failed
  /// In its frame; replace the files of the last hulls, which enclose them.
  std::vector<GeometryElement> primitives;
  std::vector<ConvexHull> unneeded;  ///< finer hulls that a scene did not need
  /// The clusters of `original` and their hierarchy, in its frame; null unless the options ask for
  /// them.
  std::shared_ptr<const Segments> segments;
  /// What fewer hulls would be, where they are a cut of a hull tree: a tree whose leaves are
  /// `hulls`, in their order, with a proved bound for each node. Null otherwise.
  std::shared_ptr<const HullTree> coarser;
};

/// A `<collision>` element of the new description that stays as it was: a primitive, or a mesh of a
/// link that is kept.
struct KeptElement {
  GeometryElement element;
  TriangleMesh surface;  ///< of a mesh, as read and scaled; empty where it cannot be read
  /// Of the element's frame in the robot's zero configuration.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

/// One collision model of the robot; a ModelReport has its rows.
struct ModelResult {
  std::vector<ElementResult> elements;  ///< links[i] of its report is the row of elements[i]
  std::vector<KeptElement> kept;        ///< for the page alone: empty without Options::html
  /// Rewritten description, URIs as the output package will hold them; empty for a single mesh.
  std::string urdf;
};

struct RobotResult : ModelResult {
  Report report;
  std::vector<ModelResult> models;  ///< the others, those of report.models
  std::string robot_name;           ///< or the mesh's stem
  bool single_mesh = false;
  /// Folder or package that the URIs of each `urdf` refer to: writeOutput() takes no other. Empty:
  /// any, as for a single mesh.
  std::string place;
  /// Surface of the scene that it was fitted to, in the root link's frame; empty: none.
  TriangleMesh scene;
  /// Further files of the output package: path in it, content.
  std::map<std::string, std::string> extra_files;
  /// Hulls of earlier outputs that the description keeps: path in the package, content.
  std::map<std::string, std::string> kept_files;
};

/// What a run is doing, for bars and feedback.
struct Step {
  /// "read", "decompose", "validate"; for a scene, "fit" and "certify" come before "validate". Of
  /// addConsumerFiles(): "pairs"
  std::string stage;
  std::string item;  ///< link of the mesh finished last; empty where the stage has none
  std::size_t done = 0, total = 0, hulls = 0;  ///< meshes finished, all meshes, hulls so far
  double fraction = 0;  ///< share of the whole run done, in [0, 1], never decreasing; 1 at the end
  double seconds_left = -1;    ///< a rough estimate; negative where there is none yet
  std::size_t primitives = 0;  ///< so far, which do not count among the hulls
};
/// Called at the start of each stage, for each finished mesh, and at most every 0.2 s in between;
/// one call at a time, from any thread.
using StepCallback = std::function<void(const Step&)>;

}  // namespace collision_hulls
