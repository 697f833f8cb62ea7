// What the stages find out about one mesh, whichever links use it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/decompose/segments.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/measure/solid.h"
#include "collision_hulls/report/report.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// [m] The longest links of robots, booms of large manipulators and gantries, are about 10 m. In millimetres read as metres, every link
/// above 20 mm is larger than this limit.
constexpr double kLargestLink = 20;

/// A result for one mesh. Where a stage failed, what the stages before it found out remains.
struct MeshResult {
  MeshFacts mesh;
  HullFacts model;
  Status status = Status::kOk;
  std::string reason, error, untried;  ///< see ElementReport
  StageSeconds seconds;
  bool cached = false;
  TriangleMesh original;
  std::vector<ConvexHull> hulls;
  std::vector<GeometryElement> primitives;   ///< see ElementResult
  std::vector<ConvexHull> unneeded;          ///< see ElementResult
  std::shared_ptr<const Segments> segments;  ///< see ElementResult
  std::shared_ptr<const HullTree> coarser;   ///< see ElementResult
  std::shared_ptr<const Solid> solid;        ///< of `original`; null if the hulls are from the cache
};

/// One for each use of a mesh; uses of the same mesh, with the same hulls, share theirs.
using MeshResults = std::vector<std::shared_ptr<const MeshResult>>;

/// Marks a result as failed and drops its hulls. `error` is the name of an ErrorCode.
void fail(MeshResult& result, const std::string& error, const std::string& reason);

/// The same for the exception being handled; rethrows kCancelled.
void fail(MeshResult& result);

}  // namespace collision_hulls
