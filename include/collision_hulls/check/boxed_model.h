// A robot, or a scene, as a planner may hold one: boxes about links are asked first, then those about their bodies, then FCL.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <vector>

#include "collision_hulls/check/query_body.h"

namespace collision_hulls {

/// Pairs of links that are not looked at: neighbours by a joint, and what an SRDF disables.
class IgnoredPairs {
 public:
  explicit IgnoredPairs(std::size_t links) : links_(links), ignored_(links * links) {}
  void ignore(std::size_t a, std::size_t b) { ignored_[a * links_ + b] = ignored_[b * links_ + a] = true; }
  bool operator()(std::size_t a, std::size_t b) const { return ignored_[a * links_ + b]; }

 private:
  std::size_t links_;
  std::vector<bool> ignored_;
};

/// Bodies that links carry, hulls or meshes. FCL's dynamic trees serve thousands of bodies that move; of a robot's few links they take
/// most of the time that a question takes. Here each pair of links is looked at, box against box, and bodies are placed where boxes of
/// links meet. All in one frame, in metres. Not thread safe: copies of bodies are cheap, so each thread has a model of its own.
class BoxedModel {
 public:
  explicit BoxedModel(IgnoredPairs ignored);  ///< what questions leave out
  ~BoxedModel();
  BoxedModel(BoxedModel&&) noexcept;

  /// `origin`: of the body in the link's frame. Empty bodies are left out.
  void add(std::size_t link, const QueryBody& body, const Eigen::Isometry3d& origin = Eigen::Isometry3d::Identity());

  /// To be called once all bodies are there, and before each question about another state: a pose for each link.
  void place(const std::vector<Eigen::Isometry3d>& links);

  bool collides();    ///< two of its own links
  double distance();  ///< [m] between two of its own links; 0 in contact, infinite where all are ignored

  /// The same of a link of this one and a link of the other, which may have many: a tree of its boxes is kept while it stays in its place.
  /// Left out is what this one ignores; indices of the other's links are among its.
  bool collides(BoxedModel& scene);
  double distance(BoxedModel& scene);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
