// Wraps FCL's narrow phase. For its settings, and why bodies are enlarged, see fcl_bodies.cpp. apart() is the separating-axis test for
// oriented boxes (Gottschalk et al. 1996).
#include "collision_hulls/query/query_body.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/looks.h"
#include "query/fcl_bodies.h"

namespace collision_hulls {
namespace {

std::vector<Triangle> withArea(const TriangleMesh& mesh, const RunControl& control) {
  Looks look(control);
  std::vector<Triangle> triangles;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    look();
    const Eigen::Vector3d &a = mesh.corner(i, 0), u = mesh.corner(i, 1) - a;
    if (!u.cross(mesh.corner(i, 2) - a).isZero(0)) triangles.push_back(mesh.triangles[static_cast<std::size_t>(i)]);
  }
  return triangles;
}

const fcl::CollisionGeometryd* geometry(const QueryBody& body) {
  return body.impl()->geometry.get();
}

std::shared_ptr<fcl::CollisionGeometryd> geometryOf(const QueryShape& shape) {
  const Eigen::Vector3d size = kFclEnlarged * shape.size;
  if (shape.kind == QueryShape::Kind::kSphere) return std::make_shared<fcl::Sphered>(size.x());
  if (shape.kind == QueryShape::Kind::kCylinder) return std::make_shared<fcl::Cylinderd>(size.x(), size.y());
  return std::make_shared<fcl::Boxd>(size);
}

/// Half the sides of the shape's box in its own frame.
Eigen::Vector3d halfSides(const QueryShape& shape) {
  const Eigen::Vector3d& size = shape.size;
  if (shape.kind == QueryShape::Kind::kSphere) return Eigen::Vector3d::Constant(size.x());
  if (shape.kind == QueryShape::Kind::kCylinder) return {size.x(), size.x(), size.y() / 2};
  return size / 2;
}

}  // namespace

QueryBody::QueryBody(const ConvexHull& hull) : box_(boundingBox(hull)), corners_(hull.vertices.size()) {
  if (!hull.vertices.empty()) impl_ = std::make_shared<const Impl>(Impl{fclConvex(hull)});
}

QueryBody::QueryBody(const QueryShape& shape, const Eigen::Isometry3d& origin)
    : impl_(std::make_shared<const Impl>(Impl{geometryOf(shape), origin})), box_(placed({-halfSides(shape), halfSides(shape)}, origin)) {}

QueryBody::QueryBody(const TriangleMesh& mesh, const RunControl& control) : box_(boundingBox(mesh)) {
  const std::vector<Triangle> triangles = withArea(mesh, control);
  if (triangles.empty()) return;
  impl_ = std::make_shared<const Impl>(Impl{fclTree<fcl::OBBRSSd>(mesh.vertices, fclTriangles(triangles), kFclEnlarged, control)});
}

bool touch(const QueryBody& first, const QueryBody& second, const Eigen::Isometry3d& pose) {
  if (first.empty() || second.empty()) return false;
  fcl::CollisionResultd result;
  return answered([&] {
    return fcl::collide(geometry(first), enlarged(first.impl()->origin), geometry(second), enlarged(pose * second.impl()->origin),
                        contactRequest(), result) > 0;
  });
}

double distanceBelow(double limit, const QueryBody& first, const QueryBody& second, const Eigen::Isometry3d& pose) {
  if (first.empty() || second.empty()) return limit;
  fcl::DistanceResultd result;
  result.min_distance = kFclEnlarged * limit;  // FCL skips branches that are further away
  answered([&] {
    fcl::distance(geometry(first), enlarged(first.impl()->origin), geometry(second), enlarged(pose * second.impl()->origin),
                  distanceRequest(false), result);
  });
  return std::clamp(result.min_distance / kFclEnlarged, 0.0, limit);
}

Eigen::AlignedBox3d placed(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d middle = pose * box.center(), half = pose.linear().cwiseAbs() * (0.5 * box.sizes());
  return {middle - half, middle + half};
}

// Two boxes are disjoint if and only if a face normal of one, or the cross product of an edge of each, separates them.
bool apart(const Eigen::AlignedBox3d& first, const Eigen::AlignedBox3d& second, const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d a = 0.5 * first.sizes(), b = 0.5 * second.sizes(), way = pose * second.center() - first.center();
  const Eigen::Matrix3d turn = pose.linear(), reach = turn.cwiseAbs();
  if ((way.cwiseAbs() - a - reach * b).maxCoeff() > 0) return true;
  if (((turn.transpose() * way).cwiseAbs() - b - reach.transpose() * a).maxCoeff() > 0) return true;
  // Nearly parallel edges give no usable axis; poses may be accurate to single precision only.
  const double rounding = 1e-6 * (a.sum() + b.sum());
  for (int i = 0; i < 3; ++i) {
    const int u = (i + 1) % 3, v = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int s = (j + 1) % 3, t = (j + 2) % 3;
      const double half = a[u] * reach(v, j) + a[v] * reach(u, j) + b[s] * reach(i, t) + b[t] * reach(i, s);
      if (std::abs(way[v] * turn(u, j) - way[u] * turn(v, j)) > half + rounding) return true;
    }
  }
  return false;
}

}  // namespace collision_hulls
