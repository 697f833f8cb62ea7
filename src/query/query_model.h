// A robot or a scene as in MoveIt: bodies of links in FCL's dynamic AABB tree, queried as a whole.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "collision_hulls/query/boxed_model.h"
#include "collision_hulls/query/query_body.h"

namespace collision_hulls {

/// Bodies carried by links, see query_body.h. FCL is queried in the settings of fcl_bodies.cpp. Queries on two models compare all bodies of
/// one with all bodies of the other. Not thread safe. Queries throw kInternal where FCL throws.
class QueryModel {
 public:
  QueryModel();
  ~QueryModel();
  QueryModel(QueryModel&&) noexcept;

  /// `origin`: the body's pose in the link's frame.
  void add(std::size_t link, const QueryBody& body, const Eigen::Isometry3d& origin = Eigen::Isometry3d::Identity());
  void add(std::size_t link, const TriangleMesh& mesh) { add(link, QueryBody(mesh)); }
  void add(std::size_t link, const ConvexHull& hull) { add(link, QueryBody(hull)); }

  /// Call this once all bodies are added, and before querying another state: a pose for each link.
  void place(const std::vector<Eigen::Isometry3d>& links);

  bool collides(const QueryModel& other) const;
  bool collides(const QueryModel& other, const IgnoredPairs& ignored) const;  ///< pairs of a link of this model and a link of the other
  bool collides(const IgnoredPairs& ignored) const;                           ///< two of its own links
  std::vector<std::pair<std::size_t, std::size_t>> touching(const IgnoredPairs& ignored) const;  ///< pairs of its own links

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
