// A robot or a scene as a planner may hold it: compares boxes around links first, then boxes around
// their bodies, and queries FCL last.
//
// For example:
//
//     BoxedModel robot, scene;
//     for (const ConvexHull& hull : hulls) robot.add(0, QueryBody(hull));
//     scene.add(1, QueryBody(mesh));
//     robot.place({pose, Eigen::Isometry3d::Identity()});  // of links 0 and 1
//     scene.place({pose, Eigen::Isometry3d::Identity()});
//     const bool free = !robot.collides(scene);
//     const double gap = robot.distance(scene, 0.1);  // [m], 0.1 if further apart
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "collision_hulls/error.h"
#include "collision_hulls/query/query_body.h"

namespace collision_hulls {

/// Pairs of links to ignore: neighbours at a joint, and those disabled by an SRDF.
class IgnoredPairs {
 public:
  /// Starts empty, with room for pairs of links below `links`. Memory grows with `links` times the
  /// number of links that are the lower one in a pair, one bit for each.
  explicit IgnoredPairs(std::size_t links = 0) : above_(links) {}

  /// Throws kIndexOutOfRange.
  void ignore(std::size_t a, std::size_t b) {
    const std::size_t links = above_.size();
    if (a >= links || b >= links)
      throw Error(ErrorCode::kIndexOutOfRange, "cannot ignore the pair of links " +
                                                   std::to_string(a) + " and " + std::to_string(b) +
                                                   ": there is room for " + std::to_string(links) +
                                                   " links only; make room for more");
    std::vector<bool>& of_lower = above_[std::min(a, b)];
    of_lower.resize(links);
    of_lower[std::max(a, b)] = true;
  }
  bool operator()(std::size_t a, std::size_t b) const {
    const std::size_t low = std::min(a, b), high = std::max(a, b);
    return low < above_.size() && high < above_[low].size() && above_[low][high];
  }

 private:
  std::vector<std::vector<bool>> above_;  // by the lower link: the higher ones
};

/// Bodies (hulls or meshes) carried by links. FCL's dynamic trees are made for thousands of moving
/// bodies; for a robot's few links they take most of a query's time. Here the boxes of all links
/// are compared instead; where two of them meet, their bodies are compared, box against box in the
/// frame of one of the links. In metres. Queries, too, are for one thread at a time: copies of
/// bodies are cheap, so give each thread its own models. Distances to bodies made of a QueryShape
/// are FCL's, with the errors described in query_body.h; add hulls where distances matter.
class BoxedModel {
 public:
  explicit BoxedModel(IgnoredPairs ignored = IgnoredPairs());  ///< pairs that queries leave out
  ~BoxedModel();
  BoxedModel(BoxedModel&&) noexcept;

  /// `origin`: the body's pose in the link's frame. Empty bodies are left out; a model without
  /// bodies touches nothing. Throws kNonFiniteCoordinate.
  void add(std::size_t link, const QueryBody& body,
           const Eigen::Isometry3d& origin = Eigen::Isometry3d::Identity());

  /// Call this once all bodies are added, and before querying another state: a pose for each link,
  /// by index. Throws kIndexOutOfRange if a link has no pose, kNonFiniteCoordinate.
  void place(const std::vector<Eigen::Isometry3d>& links);

  // Queries throw kInternal if bodies were added but not placed, and where FCL throws.

  bool collides();  ///< between two of its own links
  /// [m] Between two of its own links; 0 in contact, and `limit` if they are no closer than that.
  /// The smaller the limit, the faster.
  double distance(double limit = std::numeric_limits<double>::infinity());

  /// The same between a link of this model and a link of the other, which may have thousands of
  /// links: these are grouped at the first query after place(). This model's ignored pairs are left
  /// out, so the two models must number their links consecutively, e.g. the robot's first and then
  /// the scene's.
  bool collides(BoxedModel& scene);
  double distance(BoxedModel& scene, double limit = std::numeric_limits<double>::infinity());

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
