// Our readers against Assimp's, by which rviz reads: on well-formed files both must find the same triangles, in the same order. Assimp
// rounds some numbers to a neighbour of the nearest one.
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <sstream>

#include "base/at.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "mesh/polygons.h"
#include "mesh/reading.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

Eigen::Affine3d toEigen(const aiMatrix4x4& m) {
  Eigen::Affine3d result;
  result.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1;
  return result;
}

using Corners = std::vector<Eigen::Vector3d>;  // three for each triangle

Corners cornersOf(const TriangleMesh& mesh) {
  Corners corners;
  for (const Triangle& t : mesh.triangles)
    for (const int v : t) corners.push_back(mesh.vertices[at(v)]);
  return corners;
}

/// The triangles of Assimp's polygons.
class AssimpReader {
 public:
  explicit AssimpReader(const aiScene& scene) : scene_(scene), sink_(&loaded_, name_, 1 << 30, control_) {
    // Collada's unit and its up-axis, of which rviz ignores the latter.
    const Eigen::Vector3d unit = toEigen(scene.mRootNode->mTransformation).linear().colwise().norm();
    addNode(*scene.mRootNode, Eigen::Affine3d(Eigen::Scaling(unit)));
  }
  Corners corners() const { return cornersOf(loaded_.mesh); }

 private:
  void addNode(const aiNode& node, const Eigen::Affine3d& to_root) {
    for (unsigned m = 0; m < node.mNumMeshes; ++m) addMesh(*scene_.mMeshes[node.mMeshes[m]], to_root);
    for (unsigned i = 0; i < node.mNumChildren; ++i) addNode(*node.mChildren[i], to_root * toEigen(node.mChildren[i]->mTransformation));
  }

  void addMesh(const aiMesh& mesh, const Eigen::Affine3d& to_root) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      std::vector<int> polygon;
      for (unsigned k = 0; k < mesh.mFaces[f].mNumIndices; ++k) {
        const aiVector3D& v = mesh.mVertices[mesh.mFaces[f].mIndices[k]];
        polygon.push_back(static_cast<int>(loaded_.mesh.vertices.size()));
        loaded_.mesh.vertices.emplace_back(to_root * Eigen::Vector3d(v.x, v.y, v.z));
      }
      sink_.add(polygon);
    }
  }

  const aiScene& scene_;
  const std::string name_ = "by Assimp";
  const RunControl control_;
  LoadedMesh loaded_;
  PolygonSink sink_;
};

Corners byAssimp(const std::string& bytes, const std::string& name) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, lowerExtension(name).c_str() + 1);
  EXPECT_NE(scene, nullptr) << importer.GetErrorString();
  return scene == nullptr ? Corners() : AssimpReader(*scene).corners();
}

void expectTheSame(const std::string& bytes, const std::string& name) {
  SCOPED_TRACE(name);
  const Corners ours = cornersOf(test_files::readHere(bytes, name).mesh), theirs = byAssimp(bytes, name);
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double unit = std::max(std::abs(ours[i][k]) * std::numeric_limits<float>::epsilon(), 1e-40);
      ASSERT_NEAR(ours[i][k], theirs[i][k], 2 * unit) << "corner " << i;
    }
}

/// The same triangles in any order, each from any of its corners: Assimp reads strips and fans from another one, and turns points by nodes
/// in single precision.
void expectTheSameSet(const std::string& bytes, const std::string& name) {
  const Corners ours = cornersOf(test_files::readHere(bytes, name).mesh);
  Corners theirs = byAssimp(bytes, name);
  ASSERT_EQ(ours.size(), theirs.size());
  double largest = 0;
  for (const Eigen::Vector3d& p : ours) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  for (std::size_t i = 0; i < ours.size(); i += 3) {
    const auto matches = [&](std::size_t t) {
      for (std::size_t turn = 0; turn < 3; ++turn) {
        double far = 0;
        for (std::size_t k = 0; k < 3; ++k) far = std::max(far, (ours[i + k] - theirs[t + (k + turn) % 3]).cwiseAbs().maxCoeff());
        if (far < 1e-6 * largest) return true;
      }
      return false;
    };
    std::size_t t = 0;
    while (t < theirs.size() && !matches(t)) t += 3;
    ASSERT_LT(t, theirs.size()) << "Assimp lacks triangle " << i / 3;
    theirs.erase(theirs.begin() + static_cast<std::ptrdiff_t>(t), theirs.begin() + static_cast<std::ptrdiff_t>(t) + 3);
  }
}

/// A random number as programs write it.
std::string number(std::mt19937* random) {
  static const char* const kFormats[] = {"%.6f", "%g", "%.9g", "%e", "%.0f", "%.15g"};
  char text[400];
  const double value = std::uniform_real_distribution<double>(-1, 1)(*random) * std::pow(10, static_cast<int>((*random)() % 5) - 2);
  std::snprintf(text, sizeof text, kFormats[(*random)() % std::size(kFormats)], value);
  return text;
}

struct RandomMesh {
  std::vector<std::string> vertices;  // "x y z"
  std::vector<std::vector<int>> polygons;

  RandomMesh(std::mt19937* random, std::size_t most_corners) {
    for (std::size_t i = 0; i < 12; ++i) vertices.push_back(number(random) + " " + number(random) + " " + number(random));
    for (int i = 0; i < 20; ++i) {
      std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
      std::shuffle(all.begin(), all.end(), *random);
      all.resize(3 + (*random)() % (most_corners - 2));
      polygons.push_back(all);
    }
  }
};

std::string obj(const RandomMesh& mesh) {
  std::ostringstream text;
  text << "# made up\no part\n";
  for (const std::string& v : mesh.vertices) text << "v  " << v << "\n";
  text << "vt 0 0\nvn 0 0 1\nusemtl a\n";
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    if (f == 7) text << "g other\nusemtl b\n";
    text << "f";
    for (const int k : mesh.polygons[f]) text << " " << (f % 3 == 0 ? k - 12 : k + 1) << (f % 2 == 0 ? "" : f % 5 == 0 ? "/1/1" : "//1");
    text << (f % 4 == 0 ? "\r\n" : "\n");
  }
  return text.str();
}

std::string off(const RandomMesh& mesh) {
  std::ostringstream text;
  text << "OFF\n" << mesh.vertices.size() << " " << mesh.polygons.size() << " 0\n";
  for (const std::string& v : mesh.vertices) text << v << "\n";
  for (const std::vector<int>& polygon : mesh.polygons) {
    text << polygon.size();
    for (const int k : polygon) text << " " << k;
    text << "\n";
  }
  return text.str();
}

std::string ply(const RandomMesh& mesh) {
  const std::string body = off(mesh);
  return "ply\nformat ascii 1.0\nelement vertex 12\nproperty float x\nproperty float y\nproperty float z\nelement face 20\n"
         "property list uchar int vertex_indices\nend_header\n" +
         body.substr(body.find(" 0\n") + 3);
}

std::string stl(const RandomMesh& mesh) {
  std::ostringstream text;
  text << "solid made up\n";
  for (const std::vector<int>& polygon : mesh.polygons) {
    text << "facet normal 0 0 1\n outer loop\n";
    for (int k = 0; k < 3; ++k) text << "  vertex " << mesh.vertices[at(polygon[at(k)])] << "\n";
    text << " endloop\nendfacet\n";
  }
  return text.str() + "endsolid made up\n";
}

/// Triangles, a strip and a fan of the same points, in nodes that are turned, scaled and moved.
std::string gltf(std::mt19937* random) {
  const auto some = [&](std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i ? ", " : "") + number(random);
    return "[" + text + "]";
  };
  std::string bytes;
  for (int i = 0; i < 36; ++i) {
    const auto value = std::stof(number(random));
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  for (int i = 0; i < 12; ++i) bytes += static_cast<char>((*random)() % 12);
  const std::string nodes =
      R"([{"children": [1, 2], "translation": )" + some(3) + R"(}, {"mesh": 0, "rotation": [0.6, 0, 0, 0.8], "scale": )" + some(3) +
      R"(}, {"mesh": 0, "matrix": [0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 3, 0, 1, 2, 3, 1]}, {}])";  // two roots, below which Assimp puts one of
                                                                                              // its own
  std::string json = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 3]}], "nodes": )" + nodes +
                     R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1},
    {"attributes": {"POSITION": 0}, "mode": 5}, {"attributes": {"POSITION": 0}, "indices": 1, "mode": 6}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 12, "type": "VEC3", "min": [-1e9, -1e9, -1e9], "max": [1e9, 1e9, 1e9]},
    {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 144}, {"buffer": 0, "byteOffset": 144, "byteLength": 12}], "buffers": [{"byteLength": 156}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  return test_files::glb(json, bytes);
}

TEST(AgainstAssimp, RandomMeshes) {
  std::mt19937 random(11);
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const RandomMesh mesh(&random, 9);
    expectTheSame(obj(mesh), "random.obj");
    expectTheSame(off(mesh), "random.off");
    expectTheSame(ply(mesh), "random.ply");
    expectTheSame(stl(mesh), "random.stl");
    expectTheSameSet(gltf(&random), "random.glb");
  }
}

TEST(AgainstAssimp, RealMeshes) {
  std::size_t read = 0;
  for (const char* folder : {"robots", "meshes"}) {
    if (!fs::exists(fs::path(SHARED_DATA) / folder)) GTEST_SKIP() << "no meshes at " << SHARED_DATA;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(SHARED_DATA) / folder)) {
      const std::string path = entry.path().string();
      if (!isMeshFile(path)) continue;
      std::ifstream file(path, std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), {}};
      try {
        expectTheSame(bytes, path);
        ++read;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kTooFarFromOrigin) << error.what();
      }
    }
  }
  EXPECT_GT(read, 100u);
}

}  // namespace
}  // namespace collision_hulls
