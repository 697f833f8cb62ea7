// The number of hulls at which the search for fewer may end.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/measure/solid.h"

namespace collision_hulls {

/// A number of hulls that is proved to be needed. The proof takes time, so it is sought once, when
/// the search first asks; it is then as good as the cover that the search had.
class LowerBound {
 public:
  /// Finds the number with the help of a cover, whose hulls lie in the frame of the mesh.
  using Finder = std::function<std::size_t(const std::vector<ConvexHull>& cover, const RunControl& control)>;

  explicit LowerBound(Finder find) : find_(std::move(find)) {}

  std::size_t operator()(const std::vector<ConvexHull>& cover, const RunControl& control) {
    if (!known_) known_ = find_(cover, control);
    return *known_;
  }

  const std::optional<std::size_t>& known() const { return known_; }  ///< nullopt: nobody asked, or time ended first

 private:
  Finder find_;
  std::optional<std::size_t> known_;
};

/// As in certified.h, where the mesh's solid is known, with a lower bound from outside: of the mesh
/// as it was read, and for the whole tolerance.
Decomposition certified(const RepairedMesh& mesh, const Solid& solid, const DecomposeOptions& options, LowerBound& least,
                        const RunControl& control);

}  // namespace collision_hulls
