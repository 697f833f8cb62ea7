// A Collada document, checked and resolved: what of it becomes triangles.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// The polygons of a <geometry>.
struct ColladaShape {
  std::vector<Eigen::Vector3f> points;
  std::string numbers;                  // the points' coordinates as the file spells them
  std::vector<std::vector<int>> sizes;  // of each primitive element, the corners of its polygons: three at least
  std::vector<int> corners;             // of all polygons, one after another: indices of points
  std::size_t triangles = 0;
  std::size_t skipped = 0;  // lines, points and polygons of fewer than three corners
};

/// A transform, and the same with absolute values. The latter bounds the magnitudes that single precision rounded on the way: large numbers
/// that cancel lose as much as those that stay large.
struct Placement {
  Eigen::Affine3d to_root = Eigen::Affine3d::Identity();
  Eigen::Affine3d magnitude = Eigen::Affine3d::Identity();

  Placement() = default;
  explicit Placement(const Eigen::Affine3d& m) : Placement(Placement(), m) {}
  Placement(const Placement& parent, const Eigen::Affine3d& m) : to_root(parent.to_root * m), magnitude(m) {
    magnitude.matrix() = magnitude.matrix().cwiseAbs();
    magnitude = parent.magnitude * magnitude;
  }
};

/// A <geometry> at its place in the scene.
struct ColladaInstance {
  std::size_t shape = 0;  // index of ColladaScene::shapes
  Placement placement;
};

struct ColladaScene {
  std::vector<ColladaShape> shapes;        // those that the scene instances
  std::vector<ColladaInstance> instances;  // in the order in which the tree of nodes holds them
  /// A document with these shapes and instances, and nothing else: instances of nodes are written out, and so are all transforms.
  std::string canonical;
};

/// Reads what Collada says of surfaces. Throws kNotAMesh, kIndexOutOfRange, kEmptyMesh, kTooLarge, kCancelled; the first for whatever it
/// does not understand and may carry surface.
ColladaScene readCollada(const std::string& bytes, const std::string& path, std::size_t max_triangles, const RunControl& control);

}  // namespace collision_hulls
