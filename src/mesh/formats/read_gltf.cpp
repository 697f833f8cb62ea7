// glTF 2.0: the triangles of the default scene, where its nodes place them, in metres and with the axes that the file has. What may move
// surface and is not understood (skins, morph targets that are in use, compression, instancing) is refused.
//
// Several primitives are sub-meshes. Points and lines are counted and left out.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mesh/formats/gltf_document.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/scan.h"
#include "mesh/polygons.h"

namespace collision_hulls {
namespace {

using Json = GltfDocument::Json;

constexpr int kMostNodesOfChain = 1000;                   // chain of nodes
constexpr double kUnitQuaternion = 0.01;                  // how far the length of a rotation may be from 1
constexpr double kSameRow = 1e-6;                         // how far the last row of a matrix may be from 0 0 0 1
constexpr int kFirstTriangles = 4, kStrip = 5, kFan = 6;  // primitive.mode; below: points and lines

class GltfReader {
 public:
  GltfReader(const GltfDocument& document, const std::string& path, const MeshLimits& limits, const RunControl& control)
      : document_(document), path_(path), most_(limits.max_triangles), polygons_(path, limits.max_triangles, control) {}

  LoadedMesh read() {
    seen_.resize(document_.count("nodes"), false);
    for (const std::size_t node : roots()) visit(node, Eigen::Affine3d::Identity(), 0);
    return polygons_.triangles(Polygons::Vertices::kSeparate);
  }

 private:
  /// Of the default scene, which is the first if none is named; of a document without scenes, the nodes that are no children.
  std::vector<std::size_t> roots() const {
    const std::size_t scene = document_.index(document_.root(), "scene", "the document").value_or(0);
    if (document_.count("scenes") > 0)
      return document_.indices(document_.item("scenes", scene), "nodes", "scenes[" + std::to_string(scene) + "]");
    std::vector<bool> is_child(document_.count("nodes"), false);
    for (std::size_t i = 0; i < is_child.size(); ++i)
      for (const std::size_t child : document_.indices(document_.item("nodes", i), "children", "nodes[" + std::to_string(i) + "]"))
        if (child < is_child.size()) is_child[child] = true;
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
      if (!is_child[i]) roots.push_back(i);
    return roots;
  }

  Eigen::Affine3d placementOf(const Json& node, const std::string& name) const {
    Eigen::Affine3d result = Eigen::Affine3d::Identity();
    const std::vector<double> matrix = document_.numbers(node, "matrix", 16, name);
    if (!matrix.empty()) {
      result.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix.data());
      if ((Eigen::Vector4d(matrix[3], matrix[7], matrix[11], matrix[15]) - Eigen::Vector4d::UnitW()).cwiseAbs().maxCoeff() > kSameRow)
        document_.fail(name + ".matrix has a last row other than 0 0 0 1");
      return result;
    }
    const std::vector<double> shift = document_.numbers(node, "translation", 3, name), turn = document_.numbers(node, "rotation", 4, name),
                              scale = document_.numbers(node, "scale", 3, name);
    if (!shift.empty()) result.translate(Eigen::Vector3d(shift[0], shift[1], shift[2]));
    if (!turn.empty()) {
      const Eigen::Quaterniond rotation(turn[3], turn[0], turn[1], turn[2]);
      if (std::abs(rotation.norm() - 1) > kUnitQuaternion) document_.fail(name + ".rotation is not a unit quaternion");
      result.rotate(rotation.normalized());
    }
    if (!scale.empty()) result.scale(Eigen::Vector3d(scale[0], scale[1], scale[2]));
    return result;
  }

  void visit(std::size_t index, const Eigen::Affine3d& parent, int depth) {
    const std::string name = "nodes[" + std::to_string(index) + "]";
    const Json& node = document_.item("nodes", index);
    if (seen_[index]) document_.fail(name + " is placed twice; each node has one parent");
    if (depth > kMostNodesOfChain) document_.fail("has a chain of more than " + std::to_string(kMostNodesOfChain) + " nodes");
    seen_[index] = true;
    const Eigen::Affine3d placement = parent * placementOf(node, name);
    if (const std::optional<std::size_t> mesh = document_.index(node, "mesh", name)) {
      if (node.contains("skin")) document_.fail(name + " is skinned, so its shape depends on a pose; export it without its armature");
      if (node.contains("extensions") && node["extensions"].contains("EXT_mesh_gpu_instancing"))
        document_.fail(name + " is placed many times by EXT_mesh_gpu_instancing; export it as plain nodes");
      points_of_node_.clear();
      addMesh(*mesh, placement, isInUse(node));
    }
    for (const std::size_t child : document_.indices(node, "children", name)) visit(child, placement, depth + 1);
  }

  /// Whether morph targets have weights.
  static bool isInUse(const Json& object) {
    if (!object.contains("weights")) return false;
    return std::any_of(object["weights"].begin(), object["weights"].end(), [](const Json& weight) { return weight != 0; });
  }

  void addMesh(std::size_t index, const Eigen::Affine3d& placement, bool weights_of_node) {
    const Json& mesh = document_.item("meshes", index);
    const std::string name = "meshes[" + std::to_string(index) + "]";
    if (!mesh.contains("primitives") || !mesh["primitives"].is_array()) document_.fail(name + " has no primitives");
    for (const Json& primitive : mesh["primitives"]) {
      if (!primitive.is_object()) document_.fail(name + " has a primitive that is not an object");
      if (primitive.contains("targets") && (weights_of_node || isInUse(mesh)))
        document_.fail(name + " has morph targets in use; apply them before the export");
      addPrimitive(primitive, name, placement);
    }
  }

  void addPrimitive(const Json& primitive, const std::string& name, const Eigen::Affine3d& placement) {
    const std::size_t mode = document_.index(primitive, "mode", name).value_or(kFirstTriangles);
    if (mode > kFan) document_.fail(name + " has a primitive of the unknown mode " + std::to_string(mode));
    if (mode < kFirstTriangles) return polygons_.skip(1);
    if (!primitive.contains("attributes") || !primitive["attributes"].is_object())
      document_.fail(name + " has a primitive without attributes");
    const std::optional<std::size_t> positions = document_.index(primitive["attributes"], "POSITION", name);
    if (!positions) document_.fail(name + " has a primitive without positions; if it is compressed, export the mesh without compression");
    const auto [first, points] = pointsOf(*positions, placement);
    std::vector<std::uint32_t> corners;
    if (const std::optional<std::size_t> indices = document_.index(primitive, "indices", name))
      corners = document_.wholeNumbers(*indices, 3 * most_);
    else
      for (std::size_t i = 0; i < points; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    for (const std::uint32_t corner : corners)
      if (corner >= points)
        throw Error(ErrorCode::kIndexOutOfRange, path_ + ": " + name + " names vertex " + std::to_string(corner) + " of " +
                                                     std::to_string(points) + ", counted from 0; export it again");
    polygons_.beginPart();
    addTriangles(mode, corners, first, name);
  }

  struct Points {
    std::size_t first, count;
  };

  /// Where an accessor's points are; primitives of a node may share them.
  Points pointsOf(std::size_t accessor, const Eigen::Affine3d& placement) {
    const auto [known, is_new] = points_of_node_.emplace(accessor, Points{polygons_.points(), 0});
    if (is_new) known->second.count = addPoints(accessor, placement);
    return known->second;
  }

  /// Returns how many.
  std::size_t addPoints(std::size_t accessor, const Eigen::Affine3d& placement) {
    const std::vector<double> numbers = document_.accessor(accessor, 3, 3 * most_);
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
      const Eigen::Vector3d p = placement * Eigen::Vector3d(numbers[i], numbers[i + 1], numbers[i + 2]);
      polygons_.addPoint(p.x(), p.y(), p.z());
    }
    return numbers.size() / 3;
  }

  void addTriangles(std::size_t mode, const std::vector<std::uint32_t>& corners, std::size_t first, const std::string& name) {
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      for (const std::size_t k : {a, b, c}) polygons_.addCorner(static_cast<int>(first + corners[k]));
      polygons_.endPolygon();
    };
    const std::size_t n = corners.size();
    if (mode == kFirstTriangles && n % 3 != 0)
      document_.fail(name + " has triangles of " + std::to_string(n) + " corners in all, which is not a multiple of 3");
    if (mode == kFirstTriangles)
      for (std::size_t i = 0; i < n; i += 3) add(i, i + 1, i + 2);
    for (std::size_t i = 0; mode == kStrip && i + 2 < n; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
    for (std::size_t i = 0; mode == kFan && i + 2 < n; ++i) add(i + 1, i + 2, 0);
  }

  const GltfDocument& document_;
  const std::string& path_;
  const std::size_t most_;
  Polygons polygons_;
  std::vector<bool> seen_;
  std::map<std::size_t, Points> points_of_node_;  // by accessor
};

}  // namespace

LoadedMesh readGltf(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control) {
  GltfDocument document(bytes, path);
  document.readBuffers();
  return GltfReader(document, path, limits, control).read();
}

}  // namespace collision_hulls
