// A ball is determined by up to four points on its border. Points are added one by one; one that is outside must be on the border of the
// ball around it and all earlier ones, so that ball is found by the same steps with one point fewer to choose. Points found on the border
// move to the front, where they exclude wrong balls early: near-linear in practice.
#include "primitives/smallest_ball.h"

#include <Eigen/QR>
#include <algorithm>

#include "base/looks.h"

namespace collision_hulls {

namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kOnBorder = 1e-12;  // of a ball's squared radius: points no further out than this are on its border

/// The smallest ball with up to four given points on its border; its centre lies in their affine span.
Ball ballThrough(const Points& border) {
  if (border.empty()) return {};
  if (border.size() == 1) return {border.front(), 0};
  const auto n = static_cast<Eigen::Index>(border.size()) - 1;
  Eigen::MatrixXd spans(3, n);
  for (Eigen::Index i = 0; i < n; ++i) spans.col(i) = border[static_cast<std::size_t>(i) + 1] - border.front();
  const Eigen::MatrixXd products = spans.transpose() * spans;
  const Eigen::VectorXd shares = (2 * products).colPivHouseholderQr().solve(products.diagonal());
  const Eigen::Vector3d to_centre = spans * shares;
  return {border.front() + to_centre, to_centre.squaredNorm()};
}

/// The smallest ball around the first `count` points that has `border` on its border.
Ball ballWith(Points& points, std::size_t count, Points& border, Looks& look, const RunControl& control) {
  Ball ball = ballThrough(border);
  if (border.size() == 4) return ball;
  for (std::size_t i = 0; i < count; ++i) {
    look();
    const Eigen::Vector3d p = points[i];
    if ((p - ball.centre).squaredNorm() <= (1 + kOnBorder) * ball.squared_radius) continue;
    control.check();  // all points before this one move
    border.push_back(p);
    ball = ballWith(points, i, border, look, control);
    border.pop_back();
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i), points.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return ball;
}

}  // namespace

Ball smallestBall(std::vector<Eigen::Vector3d> points, const RunControl& control) {
  Looks look(control);
  Points border;
  Ball ball = ballWith(points, points.size(), border, look, control);
  for (const Eigen::Vector3d& p : points) ball.squared_radius = std::max(ball.squared_radius, (p - ball.centre).squaredNorm());
  return ball;
}

}  // namespace collision_hulls
