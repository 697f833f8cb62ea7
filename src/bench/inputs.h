// What a benchmark runs on: mesh files, folders of them, and the meshes of robots.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace collision_hulls {

struct BenchmarkMesh {
  std::string name;  ///< no two alike: the file's name, or its path below the folder, with the robot's name before it
  std::string file;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// The meshes that `inputs` mean, in order. A folder gives those in it and below, sorted; a folder in it that is a ROS package with robot
/// descriptions gives these. A robot gives each mesh of its links once (collision elements of a link that has any, else visual ones).
/// Throws the readers' errors, and kFileNotFound for an input without meshes.
std::vector<BenchmarkMesh> benchmarkMeshes(const std::vector<std::string>& inputs);

}  // namespace collision_hulls
