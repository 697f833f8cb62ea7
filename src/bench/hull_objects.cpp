// A small OBJ reader: what counts here is which points each object has, and a general mesh reader may merge vertices and objects.
#include "bench/hull_objects.h"

#include <cstdlib>
#include <set>
#include <sstream>

#include "base/read_file.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "mesh/formats/number.h"
#include "storage/sha256.h"

namespace collision_hulls {
namespace {

class Reader {
 public:
  explicit Reader(std::string path) : path_(std::move(path)) {}

  std::vector<std::vector<Eigen::Vector3d>> read() {
    std::istringstream in(readFile(path_, "file of hulls", MeshLimits().max_bytes));
    for (std::string line; std::getline(in, line);) {
      ++line_;
      take(line);
    }
    finishObject();
    return std::move(any_face_ ? of_faces_ : of_vertices_);
  }

 private:
  void take(const std::string& line) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "o") finishObject();
    if (key == "v") addVertex(words);
    if (key == "f") addFace(words);
  }

  void addVertex(std::istringstream& words) {
    Eigen::Vector3d v;
    for (int k = 0; k < 3; ++k) {
      std::string word;
      words >> word;
      double number = 0;
      if (!parseNumber(word, &number)) fail("'" + word + "' is not a coordinate");
      v[k] = toSingle(number);
    }
    if (!v.allFinite()) fail("a coordinate is not finite");
    vertices_.push_back(v);
  }

  void addFace(std::istringstream& words) {
    for (std::string corner; words >> corner;) {
      const long index = std::strtol(corner.c_str(), nullptr, 10);
      const long count = static_cast<long>(vertices_.size()), vertex = index < 0 ? count + index : index - 1;
      if (index == 0 || vertex < 0 || vertex >= count) fail("face corner '" + corner + "' refers to no vertex above it");
      used_.insert(static_cast<std::size_t>(vertex));
    }
    any_face_ = true;
  }

  void finishObject() {
    std::vector<Eigen::Vector3d> used, standing(vertices_.begin() + static_cast<std::ptrdiff_t>(first_), vertices_.end());
    for (const std::size_t vertex : used_) used.push_back(vertices_[vertex]);
    if (!used.empty()) of_faces_.push_back(std::move(used));
    if (!standing.empty()) of_vertices_.push_back(std::move(standing));
    used_.clear();
    first_ = vertices_.size();
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorCode::kNotAMesh, "hulls '" + path_ + "', line " + std::to_string(line_) + ": " + what);
  }

  std::string path_;
  int line_ = 0;
  std::vector<Eigen::Vector3d> vertices_;
  std::size_t first_ = 0;       // vertex of the object
  std::set<std::size_t> used_;  // by its faces
  bool any_face_ = false;
  std::vector<std::vector<Eigen::Vector3d>> of_faces_, of_vertices_;
};

}  // namespace

std::vector<std::vector<Eigen::Vector3d>> readHullObjects(const std::string& path) {
  return Reader(path).read();
}

std::string hashOf(const std::vector<std::vector<Eigen::Vector3d>>& objects) {
  std::string bytes;
  for (const std::vector<Eigen::Vector3d>& points : objects) {
    bytes += std::to_string(points.size()) + ":";
    for (const Eigen::Vector3d& p : points) bytes.append(reinterpret_cast<const char*>(p.data()), 3 * sizeof(double));
  }
  return sha256(bytes);
}

}  // namespace collision_hulls
