// What a benchmark runs on: mesh files, folders of them, and robots.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

struct BenchmarkMesh {
  std::string name;  ///< no two alike: the file's name, or its path below the folder, with the robot's name before it
  std::string file;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// What moves as one in a query: a robot, or a single mesh that flies freely.
struct QuerySubject {
  std::string name;
  RobotDescription robot;  ///< without links: a single mesh
  struct Part {
    std::size_t link = 0, mesh = 0;                            ///< indices
    Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  ///< of the mesh in the link's frame
  };
  std::vector<Part> parts;  ///< the robot's meshes; its boxes, spheres and cylinders are left out
};

struct BenchmarkInputs {
  std::vector<BenchmarkMesh> meshes;
  std::vector<QuerySubject> subjects;
};

/// The meshes that `inputs` mean, in order. A folder gives those in it and below, sorted; a folder in it that is a ROS package with robot
/// descriptions gives these. A robot gives each mesh of its links once (collision elements of a link that has any, else visual ones).
/// Throws the readers' errors, and kFileNotFound for an input without meshes.
BenchmarkInputs benchmarkInputs(const std::vector<std::string>& inputs);

/// Their meshes alone.
std::vector<BenchmarkMesh> benchmarkMeshes(const std::vector<std::string>& inputs);

}  // namespace collision_hulls
