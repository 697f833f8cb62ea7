// The meshes themselves, as planners ask them: what a model is measured against.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "scene/assembly.h"

namespace collision_hulls {

/// The parts of an assembly with the elements' original meshes. Immutable, thread safe.
class Originals {
 public:
  Originals(const FitProblem& problem, const Assembly& assembly);

  /// Surfaces alone, as FCL and MoveIt have it.
  bool touch(std::size_t a, std::size_t b, const Places& places) const;

  /// [m] The distance between two parts, or `limit` where it is no less. 0 also where one lies within the other.
  double distanceBelow(double limit, std::size_t a, std::size_t b, const Places& places) const;

  /// Contact is asked for first, since it takes FCL a hundredth of a distance's time.
  bool clear(const PartPair& pair, const Places& places) const {
    return !touch(pair.a, pair.b, places) && distanceBelow(pair.clearance, pair.a, pair.b, places) >= pair.clearance;
  }

  struct Body {
    QueryBody body;
    Eigen::Isometry3d origin;             // in the part's frame
    const Solid* solid = nullptr;         // what lies inside; null for a convex body or a surface
    const ConvexHull* convex = nullptr;   // of a convex body
    std::vector<Eigen::Vector3d> points;  // one of each component
  };
  const std::vector<Body>& bodies(std::size_t part) const { return of_part_[part]; }

 private:
  std::vector<std::vector<Body>> of_part_;
};

}  // namespace collision_hulls
