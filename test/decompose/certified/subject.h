// Test subjects for the parts of the certified method: a mesh, its solid, and an oracle for both.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "collision_hulls/measure/measures.h"
#include "decompose/certified/protrusion_oracle.h"
#include "decompose/certified/splitting.h"
#include "decompose/certified/surface_groups.h"
#include "mesh/loose_segments.h"
#include "solids.h"

namespace collision_hulls {
namespace test_shapes {

struct Subject {
  Subject(const TriangleMesh& original, double tolerance)
      : mesh(repair(original)), solid(mesh), oracle(solid, boundingBox(mesh), tolerance, control) {}

  std::vector<Leaf> leaves(const SplitOptions& options = {}) {
    return splitIntoLeaves(mesh, oracle, options, [](double) {});
  }
  double protrusionOf(const std::vector<ConvexHull>& hulls) const { return protrusion(hulls, solid, 0.001 * oracle.tolerance()).bound; }

  RepairedMesh mesh;
  RunControl control;
  Solid solid;
  ProtrusionOracle oracle;
};

/// A leaf as given, whether or not its hull fits.
inline Leaf leafOf(const TriangleMesh& mesh) {
  return {{mesh, {}}, roughHull(mesh.vertices)};
}

/// The elements of all groups, with repetitions.
inline std::vector<int> elementsIn(const Cover& cover) {
  std::vector<int> all;
  for (const Group& g : cover) all.insert(all.end(), g.elements.begin(), g.elements.end());
  std::sort(all.begin(), all.end());
  return all;
}

inline std::vector<int> upTo(std::size_t count) {
  std::vector<int> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<int>(i);
  return all;
}

inline Cover singlesOf(const SurfaceGroups& groups, std::size_t count) {
  Cover cover;
  for (std::size_t i = 0; i < count; ++i) cover.push_back(groups.single(static_cast<int>(i)));
  return cover;
}

inline std::vector<ConvexHull> exactHulls(const Cover& cover, const SurfaceGroups& groups) {
  std::vector<ConvexHull> hulls;
  for (const Group& g : cover) hulls.push_back(groups.exactHull(g));
  return hulls;
}

inline std::vector<std::vector<int>> elementSets(const Cover& cover) {
  std::vector<std::vector<int>> sets;
  for (const Group& g : cover) sets.push_back(g.elements);
  return sets;
}

}  // namespace test_shapes
}  // namespace collision_hulls
