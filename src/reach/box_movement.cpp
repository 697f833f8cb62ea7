// Works joint by joint from the body back to the root, with the points of the body carried along at the middle of the box: each joint's
// bound needs the points in that joint's frame. Linear in points times joints.
#include "reach/box_movement.h"

#include <algorithm>
#include <cmath>

#include "geometry/pi.h"

namespace collision_hulls {
namespace {

Eigen::RowVectorXd chordsOf(const BoxedJoint& at, const PointMatrix& points) {
  if (!at.joint->turns) return Eigen::RowVectorXd::Constant(points.cols(), at.way);
  const double chord = 2 * std::sin(std::min(at.way, kPi) / 2);
  return chord * points.colwise().cross(at.joint->axis).colwise().norm();
}

/// How far one joint alone moves points along a direction given in its frame.
Eigen::RowVectorXd alongOf(const BoxedJoint& at, const PointMatrix& points, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d& axis = at.joint->axis;
  if (!at.joint->turns) return Eigen::RowVectorXd::Constant(points.cols(), at.way * std::abs(axis.dot(direction)));
  // (axis x p) . n = (n x axis) . p; moving p straight to the axis moves it along n by (n's component along the axis - n) . p.
  const Eigen::Vector3d tangent = direction.cross(axis), inward = axis.dot(direction) * axis - direction;
  return std::sin(std::min(at.way, kPi / 2)) * (tangent.transpose() * points).cwiseAbs() +
         (1 - std::cos(std::min(at.way, kPi))) * (inward.transpose() * points).cwiseMax(0);
}

}  // namespace

BoxedBody::BoxedBody(const PointMatrix& points, std::vector<BoxedJoint> joints) : points_(points) {
  for (auto at = joints.rbegin(); at != joints.rend(); ++at) {
    const Eigen::Isometry3d turn = motion(*at->joint, at->middle);
    PointMatrix in_joint = (turn.linear() * points_).colwise() + turn.translation();
    points_ = (at->joint->origin.linear() * in_joint).colwise() + at->joint->origin.translation();
    Eigen::RowVectorXd chords = chordsOf(*at, in_joint);
    steps_.push_back({*at, std::move(in_joint), std::move(chords)});
  }
  std::reverse(steps_.begin(), steps_.end());
}

template <class MovesOf>
double BoxedBody::sum(std::vector<double>& of_variables, const MovesOf& moves_of) const {
  Eigen::RowVectorXd total = Eigen::RowVectorXd::Zero(points_.cols());
  for (const Step& step : steps_) {
    const Eigen::RowVectorXd moves = moves_of(step);
    total += moves;
    of_variables[step.at.variable] += moves.maxCoeff();
  }
  return total.maxCoeff();
}

double BoxedBody::movement(std::vector<double>& of_variables) const {
  return sum(of_variables, [](const Step& step) { return step.chords; });
}

double BoxedBody::movementAlong(const Eigen::Vector3d& direction, std::vector<double>& of_variables) const {
  Eigen::Matrix3d before = Eigen::Matrix3d::Identity();  // orientation of the joint's frame
  double turned = 0;                                     // [rad] that the joints before it turn, at most
  return sum(of_variables, [&](const Step& step) -> Eigen::RowVectorXd {
    before = before * step.at.joint->origin.linear();
    const Eigen::RowVectorXd along = alongOf(step.at, step.points, before.transpose() * direction);
    const double aside = 2 * std::sin(std::min(turned, kPi) / 2);
    before = before * motion(*step.at.joint, step.at.middle).linear();
    if (step.at.joint->turns) turned += step.at.way;
    return (along + aside * step.chords).cwiseMin(step.chords);
  });
}

}  // namespace collision_hulls
