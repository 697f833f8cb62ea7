// Where a mesh is decomposed: results hardly depend on how it lies.
#pragma once

#include <Eigen/Geometry>
#include <utility>

#include "collision_hulls/decompose/decompose.h"
#include "geometry/own_axes.h"
#include "mesh/loose_segments.h"

namespace collision_hulls {

/// The frame to work in: about the origin, where coordinates are finest, and along axes that turn with the mesh.
class Place {
 public:
  explicit Place(const RepairedMesh& mesh) : axes_(steadyAxes(mesh.mesh)), middle_(axes_.transpose() * middleOf(mesh)) {}

  RepairedMesh brought(RepairedMesh mesh) const {
    for (Eigen::Vector3d& v : mesh.mesh.vertices) v = axes_ * (v - middle_);
    for (Segment& segment : mesh.loose)
      for (Eigen::Vector3d& p : segment) p = axes_ * (p - middle_);
    return mesh;
  }

  DecomposeOptions brought(DecomposeOptions options) const {
    Eigen::Isometry3d there = Eigen::Isometry3d::Identity();
    there.linear() = axes_;
    there.translation() = -axes_ * middle_;
    for (Region& region : options.regions) region = transformed(region, there);
    return options;
  }

  ConvexHull takenBack(const ConvexHull& hull) const {
    Eigen::Isometry3d back = Eigen::Isometry3d::Identity();
    back.linear() = axes_.transpose();
    back.translation() = middle_;
    return transformed(hull, back);
  }

 private:
  /// The middle of the box along the axes, in their frame.
  Eigen::Vector3d middleOf(const RepairedMesh& mesh) const {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : mesh.mesh.vertices) box.extend(Eigen::Vector3d(axes_ * v));
    for (const Segment& segment : mesh.loose)
      for (const Eigen::Vector3d& p : segment) box.extend(Eigen::Vector3d(axes_ * p));
    return box.center();
  }

  const Eigen::Matrix3d axes_;  // rows
  const Eigen::Vector3d middle_;
};

}  // namespace collision_hulls
