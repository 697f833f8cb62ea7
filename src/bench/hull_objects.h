// Hulls as programs write them: an OBJ file with one object per hull.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace collision_hulls {

/// The points of each object (`o`) of an OBJ file, in file order: the vertices that the object's faces use or, in a file without any faces,
/// the vertices listed in the object. Objects without points are skipped; anything before the first `o` is an object, too. Coordinates are
/// rounded to single precision, as in the programs that load such files. Throws kFileNotFound; kNotAMesh, naming the line, for an invalid
/// number or index.
std::vector<std::vector<Eigen::Vector3d>> readHullObjects(const std::string& path);

/// The SHA-256 hash of the objects' coordinates, in order.
std::string hashOf(const std::vector<std::vector<Eigen::Vector3d>>& objects);

}  // namespace collision_hulls
