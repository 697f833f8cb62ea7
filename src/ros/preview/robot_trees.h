// The hull trees of a robot's meshes, held for cuts that take milliseconds. Knows no ROS.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/pipeline/result.h"
#include "pipeline/mesh_result.h"
#include "pipeline/mesh_uses.h"
#include "pipeline/run.h"

namespace collision_hulls {

/// The tolerance of the leaves where nobody gives another: 2mm,1%, or a finer one where the tolerance is.
inline Length previewTree(const Length& tolerance) {
  return {std::min(0.002, tolerance.limit), std::min(0.01, tolerance.share)};
}

/// What a link becomes: an element and its row for each of its meshes, as in a RobotResult, but for the original mesh of a cut.
struct LinkResult {
  std::vector<ElementResult> elements;
  std::vector<ElementReport> rows;
};

/// Reads meshes and holds them, with the trees that their last few builds asked for, until the robot or their file is another. Thread safe;
/// one build() at a time.
class RobotTrees {
 public:
  RobotTrees();
  ~RobotTrees();

  /// Reads the meshes of the links that the options choose, builds their trees or takes them from the cache, and certifies the hulls, which
  /// are those of decomposeRobot() with these options. `options` must have a tree. A mesh that fails is a row. What was done before a
  /// cancel is held. Throws kBadOption, kCancelled.
  RobotResult build(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                    const RunControl& control = {}, const StepCallback& step = {});

  /// A link's hulls as cuts of the trees, without reading or searching anything. Nothing where a tree that the options need is not held,
  /// where hulls are padded, and for shapes other than hulls: build() it. `protrusion` is proved for the hulls as they are here;
  /// decomposeRobot() rounds them outward, by micrometres. Throws kCancelled.
  std::optional<LinkResult> cut(const LinkDescription& link, const LinkOptions& options, const RunControl& control = {}) const;

  /// Why cut() has nothing for these options.
  std::string whyNoCut(const LinkDescription& link, const LinkOptions& options) const;

  /// [m] The tolerances, ascending, at which the number of a link's hulls changes, from the finest of its trees on. Empty as cut(). Throws
  /// kCancelled.
  std::vector<double> steps(const LinkDescription& link, const LinkOptions& options, const RunControl& control = {}) const;

 private:
  struct Tree;
  struct Mesh;
  struct Held;

  void buildTask(std::size_t task, Run& run);
  std::shared_ptr<Mesh> meshFor(const MeshTask& task, const Run& run);
  void dropUnused();
  MeshResult resultOf(Mesh& mesh, const LinkOptions& options, const RunControl& preparing, const RunControl& certifying);
  void beginBuild(Mesh& mesh);
  std::shared_ptr<const HullTree> hold(Mesh& mesh, const LinkOptions& options, const RunControl& control);
  std::shared_ptr<Tree> treeOf(const Mesh& mesh, const LinkOptions& options) const;
  std::shared_ptr<Tree> lastTreeOf(const Mesh& mesh) const;
  std::vector<Held> heldOf(const LinkDescription& link, const LinkOptions& options) const;
  static void cutThrough(Held& held, const LinkOptions& options);

  mutable std::mutex mutex_;
  std::string robot_;                                    // its text
  std::map<std::string, std::shared_ptr<Mesh>> meshes_;  // by content and scale
  std::map<std::string, std::shared_ptr<Mesh>> by_use_;  // by URI and scale
};

}  // namespace collision_hulls
