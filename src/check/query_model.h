// A robot, or a scene, as MoveIt holds one: bodies of links in FCL's dynamic tree of boxes, asked as a whole.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "collision_hulls/check/boxed_model.h"
#include "collision_hulls/check/query_body.h"

namespace collision_hulls {

/// Bodies that links carry, see query_body.h. FCL is asked in the settings of fcl_queries.h. Queries of two models are between all bodies
/// of one and all of the other; not thread safe.
class QueryModel {
 public:
  QueryModel();
  ~QueryModel();
  QueryModel(QueryModel&&) noexcept;

  /// `origin`: of the body in the link's frame.
  void add(std::size_t link, const QueryBody& body, const Eigen::Isometry3d& origin = Eigen::Isometry3d::Identity());
  void add(std::size_t link, const TriangleMesh& mesh) { add(link, QueryBody(mesh)); }
  void add(std::size_t link, const ConvexHull& hull) { add(link, QueryBody(hull)); }

  /// To be called once all bodies are there, and before each query of another state: a pose for each link.
  void place(const std::vector<Eigen::Isometry3d>& links);

  bool collides(const QueryModel& other) const;
  bool collides(const QueryModel& other, const IgnoredPairs& ignored) const;  ///< pairs of a link of one and a link of the other
  bool collides(const IgnoredPairs& ignored) const;                           ///< of two of its own links
  std::vector<std::pair<std::size_t, std::size_t>> touching(const IgnoredPairs& ignored) const;  ///< pairs of its own links

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
