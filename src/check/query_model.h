// A robot, or a scene, as planners hold one: bodies of links in a dynamic tree of boxes, asked as a whole.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Pairs of links that are not looked at.
class IgnoredPairs {
 public:
  explicit IgnoredPairs(std::size_t links) : links_(links), ignored_(links * links, 0) {}
  void ignore(std::size_t a, std::size_t b) { ignored_[a * links_ + b] = ignored_[b * links_ + a] = 1; }
  bool operator()(std::size_t a, std::size_t b) const { return ignored_[a * links_ + b] != 0; }

 private:
  std::size_t links_;
  std::vector<char> ignored_;
};

/// Bodies that links carry. Meshes are FCL's BVH of OBBRSS, a surface without inside, as in MoveIt; hulls are FCL's Convex. FCL is asked in
/// the settings of fcl_queries.h. Queries of two models are between all bodies of one and all of the other; not thread safe.
class QueryModel {
 public:
  QueryModel();
  ~QueryModel();
  QueryModel(QueryModel&&) noexcept;

  void add(std::size_t link, const TriangleMesh& mesh);  ///< in the link's frame; triangles without area are left out
  void add(std::size_t link, const ConvexHull& hull);

  /// To be called once all bodies are there, and before each query of another state: a pose for each link.
  void place(const std::vector<Eigen::Isometry3d>& links);

  bool collides(const QueryModel& other) const;
  double distance(const QueryModel& other) const;      ///< [m] 0 in contact
  bool collides(const IgnoredPairs& ignored) const;    ///< of two of its own links
  double distance(const IgnoredPairs& ignored) const;  ///< [m] between two of its own links; infinite where all are ignored
  std::vector<std::pair<std::size_t, std::size_t>> touching(const IgnoredPairs& ignored) const;  ///< pairs of its own links

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
