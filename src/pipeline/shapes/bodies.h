// The bodies of a model in which primitives stand beside hulls.
#pragma once

#include <optional>
#include <vector>

#include "collision_hulls/primitives/covering_primitive.h"

namespace collision_hulls {

constexpr double kAroundRound = 0.01;  // of the radius: how far polyhedronAbout() a cylinder reaches beyond it

/// A body of the model, with its proof.
struct Body {
  std::optional<Primitive> primitive;
  ConvexHull hull;  // where there is no primitive
  double bound = 0, found = 0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero(), nearest = Eigen::Vector3d::Zero();
};

/// The same, with a bound that holds for polyhedronAbout() each part but spheres, which stand for themselves in queries.
Body bodyOf(const CertifiedPrimitive& made);

/// As URDF can say it: a capsule is a cylinder and two spheres; others are one part.
std::vector<Primitive> partsOf(const Primitive& primitive);

/// A polyhedron that contains it: for a cylinder in queries, for a sphere in drawings alone.
ConvexHull polyhedronAbout(const Primitive& part);

}  // namespace collision_hulls
