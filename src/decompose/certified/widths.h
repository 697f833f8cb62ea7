// The extent of a point set along 13 directions. Tells how large a union is, and how near its parts
// are, without building its hull. The *mean width* is the mean of the 13 extents, a stand-in for
// size that hardly depends on rotation.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace collision_hulls {

class Widths {
 public:
  static constexpr int kDirections = 13;  // axes, and diagonals of a cube's faces and body
  using Array = Eigen::Array<double, kDirections, 1>;

  void extend(const Eigen::Vector3d& p) {
    const Array along = (directions() * p).array();
    low_ = low_.min(along), high_ = high_.max(along);
  }
  Widths merged(const Widths& other) const {
    Widths both;
    both.low_ = low_.min(other.low_), both.high_ = high_.max(other.high_);
    return both;
  }
  bool contains(const Widths& other) const { return (low_ <= other.low_).all() && (high_ >= other.high_).all(); }
  double gap(const Widths& other) const {  ///< a lower bound on the distance between the two sets' hulls
    return std::max(0.0, (low_.max(other.low_) - high_.min(other.high_)).maxCoeff());
  }
  double mean() const { return (high_ - low_).mean(); }  ///< nearly independent of rotation
  double middle(int direction) const { return (low_[direction] + high_[direction]) / 2; }

 private:
  using Directions = Eigen::Matrix<double, kDirections, 3>;
  static const Directions& directions() {
    static const Directions unit = [] {
      Directions d;
      d << 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1, -1, 0, 1, 0, 1, 1, 0, -1, 0, 1, 1, 0, 1, -1, 1, 1, 1, 1, 1, -1, 1, -1, 1, 1, -1, -1;
      d.rowwise().normalize();
      return d;
    }();
    return unit;
  }

  Array low_ = Array::Constant(std::numeric_limits<double>::infinity());
  Array high_ = Array::Constant(-std::numeric_limits<double>::infinity());
};

}  // namespace collision_hulls
