// Groups a sample of the triangles by normal. The group with the largest area gives the first axis, the largest group at right angles to it
// the second. ownAxes() uses the new axes only if clearly more of the area is axis-aligned with them than without.
//
// steadyAxes() must not ask how the mesh lies. Where several groups are as large, as around a flange, each pair makes a frame; and the axes
// of each may be named and pointed in 24 ways. Of all these it takes the one in which a moment of the surface, without any symmetry itself,
// is largest. Frames that tie are those that a symmetry of the shape leads to.
#include "geometry/own_axes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/lean.h"

namespace collision_hulls {

namespace {

constexpr double kLike = 1 - 1e-6;        // normals whose cosine is above this have the same direction
constexpr double kUpright = 0.01;         // directions whose cosine is below this are at right angles
constexpr double kMuch = 0.15;            // gain, as a share of the area, that makes turning the mesh worthwhile
constexpr std::size_t kTriangles = 5000;  // size of the sample
constexpr std::size_t kMostKinds = 300;   // directions that are distinguished
// For steadyAxes(), which must see through noise in the vertices:
constexpr double kMuchLike = 1 - 2e-4;  // as kLike
constexpr double kNotable = 0.15;       // share of the area that must be axis-aligned, else the principal axes are used
constexpr double kAsLarge = 0.98;       // of two areas, for either to come first
constexpr std::size_t kMostFrames = 24;

/// Faces with the same direction, regardless of which side is out.
struct Kind {
  Eigen::Vector3d normal;
  double area;
};

/// Area vectors (twice the area, along the normal) of at most kTriangles triangles, largest first.
std::vector<Eigen::Vector3d> areas(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> result;
  const std::size_t count = mesh.triangles.size();
  for (std::size_t i = 0; i < std::min(count, kTriangles); ++i) {
    const auto t = static_cast<int>(i * count / std::min(count, kTriangles));
    result.emplace_back((mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)));
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.squaredNorm() > b.squaredNorm(); });
  return result;
}

std::vector<Kind> kindsOf(const std::vector<Eigen::Vector3d>& areas, double least_cosine = kLike) {
  std::vector<Kind> kinds;
  for (const Eigen::Vector3d& a : areas) {
    const double area = a.norm();
    const auto is_like = [&](const Kind& k) { return std::abs(k.normal.dot(a)) > least_cosine * area; };
    const auto like = std::find_if(kinds.begin(), kinds.end(), is_like);
    if (like != kinds.end())
      like->area += area;
    else if (area > 0 && kinds.size() < kMostKinds)
      kinds.push_back({a / area, area});
  }
  return kinds;
}

/// The kind with the largest area at right angles to `axis`; null if there is none.
const Kind* largestAcross(const std::vector<Kind>& kinds, const Eigen::Vector3d& axis) {
  const Kind* best = nullptr;
  for (const Kind& kind : kinds)
    if (std::abs(kind.normal.dot(axis)) < kUpright && (!best || kind.area > best->area)) best = &kind;
  return best;
}

/// The share of the area whose normals lie along the axes (rows).
double flatShare(const std::vector<Eigen::Vector3d>& areas, const Eigen::Matrix3d& axes, double least_cosine = kLike) {
  double flat = 0, all = 0;
  for (const Eigen::Vector3d& a : areas) {
    const double area = a.norm();
    all += area;
    if ((axes * a).cwiseAbs().maxCoeff() > least_cosine * area) flat += area;
  }
  return all > 0 ? flat / all : 0;
}

Eigen::Matrix3d frameOf(const Eigen::Vector3d& first, const Eigen::Vector3d& across) {
  Eigen::Matrix3d axes;
  axes.row(0) = first;
  axes.row(1) = (across - across.dot(first) * first).normalized();
  axes.row(2) = first.cross(Eigen::Vector3d(axes.row(1)));
  return axes;
}

/// Frames along the largest kinds; several if kinds are as large.
std::vector<Eigen::Matrix3d> flatFrames(const std::vector<Kind>& kinds) {
  std::vector<Eigen::Matrix3d> frames;
  const Kind* largest = largestAcross(kinds, Eigen::Vector3d::Zero());
  for (const Kind& first : kinds) {
    const Kind* second = largestAcross(kinds, first.normal);
    if (first.area < kAsLarge * largest->area || !second) continue;
    for (const Kind& other : kinds)
      if (std::abs(other.normal.dot(first.normal)) < kUpright && other.area >= kAsLarge * second->area && frames.size() < kMostFrames)
        frames.push_back(frameOf(first.normal, other.normal));
  }
  return frames;
}

/// The surface as points with weights, about its centre of area.
struct Masses {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> weights;
  double reach = 0;  // of the furthest point

  explicit Masses(const TriangleMesh& mesh) {
    const std::size_t count = mesh.triangles.size(), used = std::min(count, kTriangles);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double all = 0;
    for (std::size_t i = 0; i < used; ++i) {
      const auto t = static_cast<int>(i * count / used);
      const Eigen::Vector3d a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
      const double area = (b - a).cross(c - a).norm();
      for (const Eigen::Vector3d& p : {Eigen::Vector3d((a + b) / 2), Eigen::Vector3d((b + c) / 2), Eigen::Vector3d((c + a) / 2)}) {
        points.push_back(p);  // exact for second moments
        weights.push_back(area);
        sum += area * p;
        all += area;
      }
    }
    for (Eigen::Vector3d& p : points) p -= sum / std::max(all, 1e-300), reach = std::max(reach, p.norm());
  }

  Eigen::Matrix3d principalAxes() const {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) covariance += weights[i] * points[i] * points[i].transpose();
    const Eigen::Matrix3d vectors = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
    return frameOf(vectors.col(2), vectors.col(1));
  }

  /// No two ways to lay a shape into a frame have the same, unless it has a symmetry.
  double moment(const Eigen::Matrix3d& axes) const {
    const Eigen::Vector3d direction = axes.transpose() * aslant() / reach;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double square = (1 + direction.dot(points[i])) * (1 + direction.dot(points[i]));
      sum += weights[i] * square * square;
    }
    return sum;
  }
};

/// The 24 rotations that map axes to axes.
std::vector<Eigen::Matrix3d> axisRotations() {
  std::vector<Eigen::Matrix3d> rotations;
  for (int first = 0; first < 6; ++first)
    for (int second = 0; second < 6; ++second)
      if (first / 2 != second / 2) {
        const auto unit = [](int i) { return Eigen::Vector3d((i % 2 ? -1 : 1) * Eigen::Vector3d::Unit(i / 2)); };
        rotations.push_back(frameOf(unit(first), unit(second)));
      }
  return rotations;
}

}  // namespace

Eigen::Matrix3d steadyAxes(const TriangleMesh& mesh) {
  const std::vector<Eigen::Vector3d> faces = areas(mesh);
  const Masses masses(mesh);
  if (!(masses.reach > 0)) return Eigen::Matrix3d::Identity();
  std::vector<Eigen::Matrix3d> frames = flatFrames(kindsOf(faces, kMuchLike));
  if (frames.empty() || flatShare(faces, frames.front(), kMuchLike) < kNotable) frames = {masses.principalAxes()};
  Eigen::Matrix3d best = frames.front();
  double most = 0;
  for (const Eigen::Matrix3d& frame : frames)
    for (const Eigen::Matrix3d& rotation : axisRotations()) {
      const Eigen::Matrix3d axes = rotation * frame;
      const double moment = masses.moment(axes);
      if (moment > most) most = moment, best = axes;
    }
  return best;
}

Eigen::Matrix3d ownAxes(const TriangleMesh& mesh) {
  const std::vector<Eigen::Vector3d> faces = areas(mesh);
  const std::vector<Kind> kinds = kindsOf(faces);
  const Kind* first = largestAcross(kinds, Eigen::Vector3d::Zero());
  const Kind* second = first ? largestAcross(kinds, first->normal) : nullptr;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (!first) return axes;
  axes = frameOf(first->normal, second ? second->normal : first->normal.unitOrthogonal());
  const Eigen::Matrix3d as_it_is = Eigen::Matrix3d::Identity();
  return flatShare(faces, axes) > flatShare(faces, as_it_is) + kMuch ? axes : as_it_is;
}

}  // namespace collision_hulls
