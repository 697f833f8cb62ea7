// The inputs of a benchmark: mesh files, folders of them, and robots.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

struct BenchmarkMesh {
  std::string name;  ///< unique: the file's name, or its path below the input folder; for a robot's mesh, prefixed with the robot's name
  std::string file;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// The subject of queries: a robot, or a single mesh that moves freely.
struct QuerySubject {
  std::string name;
  RobotDescription robot;  ///< without links: a single mesh
  struct Part {
    std::size_t link = 0, mesh = 0;                            ///< indices
    Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  ///< of the mesh in the link's frame
  };
  std::vector<Part> parts;  ///< the robot's meshes, without its boxes, spheres and cylinders
};

struct BenchmarkInputs {
  std::vector<BenchmarkMesh> meshes;
  std::vector<QuerySubject> subjects;
};

/// The meshes of `inputs`, in order. A folder contributes the meshes in and below it, sorted; a folder that is a ROS package with robot
/// descriptions contributes those robots instead. A robot contributes each mesh of its links once (of a link's collision elements or, if it
/// has none, of its visual elements). Throws the readers' errors, and kFileNotFound for an input without meshes.
BenchmarkInputs benchmarkInputs(const std::vector<std::string>& inputs);

/// Only the meshes of the inputs.
std::vector<BenchmarkMesh> benchmarkMeshes(const std::vector<std::string>& inputs);

}  // namespace collision_hulls
