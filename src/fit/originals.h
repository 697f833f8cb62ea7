// The original meshes, checked as planners check them: the truth that a model is measured against.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "fit/assembly.h"

namespace collision_hulls {

/// The parts of an assembly with the elements' original meshes. Immutable, thread safe.
class Originals {
 public:
  /// Throws kCancelled.
  Originals(const FitProblem& problem, const Assembly& assembly, const RunControl& control);

  /// Whether surfaces touch; as in FCL and MoveIt, interiors do not count.
  bool touch(std::size_t a, std::size_t b, const Places& places) const;

  /// [m] The distance between two parts, or `limit` if it is no less. Also 0 if one lies inside the other.
  double distanceBelow(double limit, std::size_t a, std::size_t b, const Places& places) const;

  /// Whether a component of one part lies inside the other; only for parts that do not touch.
  bool contains(std::size_t outer, std::size_t inner, const Places& places) const;

  /// Boxes around the links, in the scene's frame.
  std::vector<Eigen::AlignedBox3d> boxesOfLinks(const Places& places) const;

  struct Body {
    QueryBody body;
    Eigen::Isometry3d origin;             // in the part's frame
    const Solid* solid = nullptr;         // null for a convex body or a surface
    const ConvexHull* convex = nullptr;   // null unless the body is convex
    std::vector<Eigen::Vector3d> points;  // one per component
  };
  const std::vector<Body>& bodies(std::size_t part) const { return of_part_[part]; }

 private:
  std::vector<std::vector<Body>> of_part_;
};

}  // namespace collision_hulls
