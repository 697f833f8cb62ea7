// A robot in its scene, as parts: links and scene bodies, the pieces they consist of, and their poses in a sample.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "collision_hulls/fit/fit.h"
#include "collision_hulls/scene/configurations.h"
#include "fit/detail_tree.h"
#include "query/box_groups.h"

namespace collision_hulls {

/// A body of a part at every level of detail.
struct Piece {
  std::size_t part = 0;
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  ///< in the part's frame
  std::shared_ptr<const DetailTree> tree;
};

/// For each piece, the nodes of its tree that represent it.
using Cuts = std::vector<std::vector<int>>;

/// The corners of a body's shape, in its own frame.
template <class Body>
const std::vector<Eigen::Vector3d>& verticesOf(const Body& body) {
  return std::visit([](const auto& shape) -> const std::vector<Eigen::Vector3d>& { return shape.vertices; }, body.shape);
}

/// A pose for each part, in the scene's frame. There may be tens of thousands of bodies, which do not move: their poses stay in the scene.
class Places {
 public:
  Places(std::vector<Eigen::Isometry3d> links, const std::vector<SceneBody>& bodies) : links_(std::move(links)), bodies_(&bodies) {}

  const std::vector<Eigen::Isometry3d>& links() const { return links_; }
  std::vector<Eigen::Isometry3d> all() const;
  const Eigen::Isometry3d& operator[](std::size_t part) const {
    return part < links_.size() ? links_[part] : (*bodies_)[part - links_.size()].pose;
  }

 private:
  std::vector<Eigen::Isometry3d> links_;
  const std::vector<SceneBody>* bodies_;
};

/// Parts are the robot's links, in order, followed by the scene's bodies. The first pieces are the problem's elements. Immutable, thread
/// safe; keeps a reference to the problem.
class Assembly {
 public:
  /// Throws kCancelled.
  Assembly(const FitProblem& problem, std::uint64_t seed, const RunControl& control = {});

  std::size_t links() const { return problem_.robot.links.size(); }
  std::size_t parts() const { return links() + problem_.scene.bodies.size(); }
  bool isLink(std::size_t part) const { return part < links(); }
  const std::string& name(std::size_t part) const;

  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<int>& piecesOf(std::size_t part) const { return of_part_[part]; }
  /// Around the scene's bodies, in its frame.
  const BoxGroups& bodyBoxes() const { return body_boxes_; }
  Cuts roots() const;
  Cuts cheapest(const Cuts& cuts) const;      ///< with primitives in place of the elements' hulls
  std::size_t hulls(const Cuts& cuts) const;  ///< of the elements

  const Kinematics& kinematics() const { return kinematics_; }
  /// All joints at rest, held or not.
  Configuration rest() const { return problem_.rest_unheld.empty() ? kinematics_.rest() : problem_.rest_unheld; }
  /// A given configuration, or a sample within the joint limits: from the low-discrepancy sequence, and from kIndependentFrom on
  /// independent.
  Configuration sample(std::size_t index) const;
  static constexpr std::size_t kIndependentFrom = std::size_t{1} << 40;
  Places places(const Configuration& configuration) const;
  Places places(std::size_t sample) const { return places(this->sample(sample)); }

 private:
  const FitProblem& problem_;
  Kinematics kinematics_;
  ConfigurationSequence even_, independent_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<int>> of_part_;
  BoxGroups body_boxes_;
};

using PartIndices = std::pair<std::size_t, std::size_t>;  // of two parts, the smaller one first

/// Two parts to check against each other, a < b, and the distance [m] from which on the original counts as clear.
struct PartPair {
  std::size_t a = 0, b = 0;
  double clearance = 0;
  std::size_t unclear = 0;  ///< surveyed samples in which its originals are apart, but not clear
  double seconds = 0;       ///< that the survey of it took
};

}  // namespace collision_hulls
