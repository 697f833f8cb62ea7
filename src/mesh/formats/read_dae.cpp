// Collada by Assimp: checks of what it takes on trust, its scene, and every instance of every mesh in metres.
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>

#include "collision_hulls/error.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/source_checks.h"
#include "mesh/polygons.h"

namespace collision_hulls {
namespace {

/// Shows Assimp this one file and no other: materials and textures are ignored, so missing or hostile ones do no harm.
class OneFile : public Assimp::IOSystem {
 public:
  OneFile(std::string name, const std::string& bytes) : name_(std::move(name)), bytes_(bytes) {}

  bool Exists(const char* file) const override { return name_ == file; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* /*mode*/) override {
    if (!Exists(file)) return nullptr;
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes_.data()), bytes_.size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::string name_;
  const std::string& bytes_;
};

/// The beginning of a text, made printable.
std::string excerpt(std::string text) {
  constexpr std::size_t kLength = 200;
  if (text.size() > kLength) text = text.substr(0, kLength) + "...";
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, ' ');
  return text;
}

/// Stops those readers of Assimp that report progress once the run is cancelled.
class Cancelling : public Assimp::ProgressHandler {
 public:
  explicit Cancelling(const RunControl& control) : control_(control) {}
  bool Update(float /*percentage*/) override {
    control_.check();
    return true;
  }

 private:
  const RunControl& control_;
};

const aiScene* import(Assimp::Importer* importer, const std::string& bytes, const std::string& path, const std::string& extension,
                      const RunControl& control) {
  const std::string name = "mesh" + extension;
  importer->SetIOHandler(new OneFile(name, bytes));  // owned by the importer
  importer->SetProgressHandler(new Cancelling(control));
  // Without this, Assimp turns a Collada file without geometry into a made-up skeleton mesh.
  importer->SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer->ReadFile(name, 0);
  control.check();
  if (scene == nullptr || scene->mRootNode == nullptr)
    throw Error(ErrorCode::kNotAMesh, path + ": cannot be read as " + extension.substr(1) + " (" + excerpt(importer->GetErrorString()) +
                                          "); check the file or export it again");
  return scene;
}

/// Assimp's matrix in double precision, so that chains of nodes add no rounding.
Eigen::Affine3d toEigen(const aiMatrix4x4& m) {
  Eigen::Affine3d result;
  result.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1;
  return result;
}

/// The root's transform as rviz applies it. Assimp puts a Collada file's unit there, and a rotation that makes Y the up-axis. rviz keeps
/// scale and translation but drops the rotation: up_axis has no effect, and coordinates stay as written.
Eigen::Affine3d rootTransform(const aiMatrix4x4& m, const std::string& path) {
  Eigen::Affine3d root = toEigen(m);
  const Eigen::Vector3d scale = root.linear().colwise().norm();
  if (!(scale.minCoeff() > 0) || !scale.allFinite())
    throw Error(ErrorCode::kNotAMesh, path + ": its <unit meter> is " + std::to_string(scale.minCoeff()) + "; it must be positive");
  root.linear() = scale.asDiagonal();
  return root;
}

/// A node's transform, and the same with absolute values. The latter bounds the magnitudes that single precision rounded on the way: large
/// numbers that cancel lose as much as those that stay large.
struct Placement {
  Eigen::Affine3d to_root;
  Eigen::Affine3d magnitude;

  static Eigen::Affine3d absolute(Eigen::Affine3d m) {
    m.matrix() = m.matrix().cwiseAbs();
    return m;
  }
  explicit Placement(const Eigen::Affine3d& m) : to_root(m), magnitude(absolute(m)) {}
  Placement(const Placement& parent, const Eigen::Affine3d& m) : to_root(parent.to_root * m), magnitude(parent.magnitude * absolute(m)) {}
};

/// Collects the triangles of a scene's nodes; each instance of a mesh contributes its own.
class SceneReader {
 public:
  SceneReader(const aiScene& scene, const std::string& path, std::size_t max_triangles, const RunControl& control)
      : scene_(scene), path_(path), sink_(&result_, path, max_triangles, control) {}

  LoadedMesh read() {
    visit(*scene_.mRootNode, Placement(rootTransform(scene_.mRootNode->mTransformation, path_)));
    if (result_.mesh.triangles.empty()) failNoTriangle(path_, result_.skipped_primitives);
    result_.resolution = singlePrecisionResolution(result_.mesh, largest_, path_);
    return std::move(result_);
  }

 private:
  void visit(const aiNode& node, const Placement& placement) {
    for (unsigned i = 0; i < node.mNumMeshes; ++i) addInstance(*scene_.mMeshes[node.mMeshes[i]], placement);
    for (unsigned i = 0; i < node.mNumChildren; ++i)
      visit(*node.mChildren[i], Placement(placement, toEigen(node.mChildren[i]->mTransformation)));
  }

  void addInstance(const aiMesh& source, const Placement& placement) {
    const std::size_t before = result_.mesh.triangles.size();
    number_.assign(source.mNumVertices, -1);
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
      polygon_.clear();
      if (source.mFaces[f].mNumIndices >= 3)  // the vertices of lines and points are of no use
        for (unsigned k = 0; k < source.mFaces[f].mNumIndices; ++k) polygon_.push_back(vertexNumber(source, f, k, placement));
      sink_.add(polygon_);
    }
    if (result_.mesh.triangles.size() > before) ++result_.submeshes;
  }

  /// The index in the result of corner k of face f.
  int vertexNumber(const aiMesh& source, unsigned f, unsigned k, const Placement& placement) {
    const unsigned index = source.mFaces[f].mIndices[k];
    if (index >= source.mNumVertices)
      throw Error(ErrorCode::kIndexOutOfRange, path_ + ": face " + std::to_string(f) + " names vertex " + std::to_string(index) +
                                                   ", but there are " + std::to_string(source.mNumVertices) +
                                                   ", counted from 0; export it again");
    int& number = number_[index];
    if (number < 0) number = addVertex(source.mVertices[index], index, f, placement);
    return number;
  }

  int addVertex(const aiVector3D& source, unsigned index, unsigned f, const Placement& placement) {
    const Eigen::Vector3d local(source.x, source.y, source.z);
    const Eigen::Vector3d p = placement.to_root * local;
    if (!p.allFinite()) failNotFinite(path_, index, f);
    largest_ = std::max(largest_, (placement.magnitude * local.cwiseAbs()).maxCoeff());
    result_.mesh.vertices.push_back(p);
    return static_cast<int>(result_.mesh.vertices.size()) - 1;
  }

  const aiScene& scene_;
  const std::string& path_;
  LoadedMesh result_;
  PolygonSink sink_;
  double largest_ = 0;        // [m] largest of the numbers that single precision rounded
  std::vector<int> number_;   // per vertex of the current instance: its index in the result, -1 before its first use
  std::vector<int> polygon_;  // the current face
};

}  // namespace

LoadedMesh readDae(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control) {
  checkDae(bytes, path);
  Assimp::Importer importer;
  const aiScene* scene = import(&importer, bytes, path, ".dae", control);
  return SceneReader(*scene, path, limits.max_triangles, control).read();
}

}  // namespace collision_hulls
