// Hulls as programs write them: an OBJ file with an object for each.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace collision_hulls {

/// The points of each object (`o`) of an OBJ file, in its order: the vertices that the object's faces use or, in a file without any face,
/// those that stand in it. Objects without points are left out; what stands before the first `o` is an object. Coordinates become the
/// nearest single-precision numbers, as in the programs that load such files.
/// Throws kFileNotFound, and kNotAMesh with the line for a number or index that is none.
std::vector<std::vector<Eigen::Vector3d>> readHullObjects(const std::string& path);

/// The SHA-256 of the objects' coordinates, one after the other.
std::string hashOf(const std::vector<std::vector<Eigen::Vector3d>>& objects);

}  // namespace collision_hulls
