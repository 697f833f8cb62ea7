// A robot, or a scene, as a planner may hold one: boxes about links are asked first, then those about their bodies, then FCL.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "collision_hulls/check/query_body.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

/// Pairs of links that are not looked at: neighbours by a joint, and what an SRDF disables.
class IgnoredPairs {
 public:
  /// None yet. Links below this number may be in pairs.
  explicit IgnoredPairs(std::size_t links = 0) : links_(links), ignored_(links * links) {}

  /// Throws kIndexOutOfRange.
  void ignore(std::size_t a, std::size_t b) {
    if (a >= links_ || b >= links_)
      throw Error(ErrorCode::kIndexOutOfRange, "a pair of links " + std::to_string(a) + " and " + std::to_string(b) +
                                                   " is to be ignored where there are " + std::to_string(links_) + "; make room for more");
    ignored_[a * links_ + b] = ignored_[b * links_ + a] = true;
  }
  bool operator()(std::size_t a, std::size_t b) const { return a < links_ && b < links_ && ignored_[a * links_ + b]; }

 private:
  std::size_t links_;
  std::vector<bool> ignored_;
};

/// Bodies that links carry, hulls or meshes. FCL's dynamic trees serve thousands of bodies that move; of a robot's few links they take
/// most of the time that a question takes. Here boxes of all links are compared, and bodies looked at, box against box in the frame of one
/// of the two links, where those meet. In metres. Not thread safe: copies of bodies are cheap, so each thread has a model of its own.
/// Distances to bodies that are made of a QueryShape are those of FCL, which query_body.h tells of: where they matter, add hulls.
class BoxedModel {
 public:
  explicit BoxedModel(IgnoredPairs ignored = IgnoredPairs());  ///< what its questions leave out
  ~BoxedModel();
  BoxedModel(BoxedModel&&) noexcept;

  /// `origin`: of the body in the link's frame. Empty bodies are left out. Throws kNonFiniteCoordinate.
  void add(std::size_t link, const QueryBody& body, const Eigen::Isometry3d& origin = Eigen::Isometry3d::Identity());

  /// To be called once all bodies are there, and before each question about another state: a pose for each link, by its index. Throws
  /// kIndexOutOfRange where links have no pose, kNonFiniteCoordinate.
  void place(const std::vector<Eigen::Isometry3d>& links);

  // Questions throw kInternal where bodies were added that are not placed.

  bool collides();  ///< two of its own links
  /// [m] Between two of its own links; 0 in contact, and `limit` where they are no closer, which is quicker the less it is.
  double distance(double limit = std::numeric_limits<double>::infinity());

  /// The same of a link of this one and a link of the other, which may have thousands: they are grouped when the first question is asked
  /// after it was placed. What this one ignores is left out, so both count their links together, such as the scene's on from the robot's.
  bool collides(BoxedModel& scene);
  double distance(BoxedModel& scene, double limit = std::numeric_limits<double>::infinity());

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
