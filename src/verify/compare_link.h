// One link of two descriptions: cover and protrusion.
#pragma once

#include <memory>

#include "collision_hulls/primitives/spheres.h"
#include "verify/cover_search.h"

namespace collision_hulls {

/// A link with geometry on both sides, ready to be asked. Immutable, thread safe.
class LinkPair {
 public:
  /// Keeps references. Both sides must be sound and hold something.
  LinkPair(const LinkBodies& original, const LinkBodies& result, const RunControl& control = {});

  const LinkBodies& original() const { return original_; }
  const LinkBodies& result() const { return result_; }
  const TriangleMesh& surface() const { return surface_; }  ///< of the original; round primitives as polyhedra inside them
  const Solid& solid() const { return *solid_; }            ///< of that surface
  const BodySet& bodies() const { return bodies_; }         ///< of the result

  /// Fills what the link's row says of geometry; its diagonal must be there. `gate`: [m] a protrusion of which it matters whether it is
  /// exceeded, so that a bound just beyond it is worth a closer look.
  void measure(LinkVerification& row, double gate = 0, const RunControl& control = {}) const;

 private:
  Largest uncovered(double gap, const RunControl& control) const;
  Largest protrusion(double gap, double gate, const RunControl& control) const;
  Largest sphereProtrusion(const std::vector<Sphere>& spheres, double gap, const RunControl& control) const;
  Largest hullProtrusion(const LinkBodies& bodies, double gap, double gate, const RunControl& control) const;
  double uncoveredShare() const;

  const LinkBodies &original_, &result_;
  BodySet bodies_;
  TriangleMesh surface_;
  double surface_error_ = 0;  // [m] of the polyhedra in it
  std::unique_ptr<const Solid> solid_;
};

}  // namespace collision_hulls
