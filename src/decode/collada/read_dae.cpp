// Collada. We read the document ourselves, as far as it has surface, and write that part again in the plainest form (collada.h). Assimp, by
// which rviz reads, gets this text: no trick of XML or of references lies between what was checked and what it parses. Its result is the
// mesh, if every corner lies where we find it.
#include "decode/collada/read_dae.h"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include "base/at.h"
#include "collision_hulls/error.h"
#include "decode/collada/collada.h"
#include "mesh/polygons.h"

namespace collision_hulls {
namespace {

/// How far apart Assimp's coordinates and ours may lie, in units of LoadedMesh::resolution: it computes in single precision.
constexpr double kMostUnits = 8;

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

const aiScene& import(Assimp::Importer* importer, const std::string& bytes, const std::string& path) {
  const std::string name = "mesh.dae";
  importer->SetIOHandler(new OneFile(name, bytes));  // owned by the importer
  const aiScene* scene = importer->ReadFile(name, 0);
  if (scene == nullptr || scene->mRootNode == nullptr)
    throw Error(ErrorCode::kNotAMesh,
                path + ": Assimp cannot read it (" + excerpt(importer->GetErrorString()) + "); check the file or export it again");
  return *scene;
}

/// Assimp's matrix in double precision, so that chains of nodes add no rounding.
Eigen::Affine3d toEigen(const aiMatrix4x4& m) {
  Eigen::Affine3d result;
  result.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1;
  return result;
}

/// What a document's instances add up to.
struct Totals {
  std::size_t corners = 0, triangles = 0, skipped = 0;

  explicit Totals(const ColladaScene& scene) {
    for (const ColladaInstance& instance : scene.instances) {
      corners += scene.shapes[instance.shape].corners.size();
      triangles += scene.shapes[instance.shape].triangles;
      skipped += scene.shapes[instance.shape].skipped;
    }
  }
};

/// Collects the triangles of a scene's nodes; each instance of a mesh contributes its own, and each corner of a polygon its own vertex.
class AssimpReader {
 public:
  AssimpReader(const aiScene& scene, const Totals& totals, const std::string& path, std::size_t max_triangles, const RunControl& control)
      : scene_(scene), path_(path), sink_(&result_, path, max_triangles, control) {
    result_.mesh.vertices.reserve(totals.corners);
    result_.mesh.triangles.reserve(totals.triangles);
  }

  LoadedMesh read() {
    visit(*scene_.mRootNode, Placement(toEigen(scene_.mRootNode->mTransformation)));
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
    ++result_.submeshes;
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
      const aiFace& face = source.mFaces[f];
      polygon_.clear();
      for (unsigned k = 0; k < face.mNumIndices; ++k) polygon_.push_back(addVertex(source.mVertices[face.mIndices[k]], f, placement));
      sink_.add(polygon_);
    }
  }

  int addVertex(const aiVector3D& source, unsigned f, const Placement& placement) {
    const Eigen::Vector3d local(source.x, source.y, source.z);
    const Eigen::Vector3d p = placement.to_root * local;
    const std::size_t number = result_.mesh.vertices.size();
    if (!p.allFinite()) failNotFinite(path_, number, f);
    largest_ = std::max(largest_, (placement.magnitude * local.cwiseAbs()).maxCoeff());
    result_.mesh.vertices.push_back(p);
    return static_cast<int>(number);
  }

  const aiScene& scene_;
  const std::string& path_;
  LoadedMesh result_;
  PolygonSink sink_;
  double largest_ = 0;        // [m] largest of the numbers that single precision rounded
  std::vector<int> polygon_;  // the current face
};

/// Throws kNotAMesh unless a mesh has the document's polygons, corner by corner.
void expectTheSame(const ColladaScene& scene, const Totals& totals, const LoadedMesh& result, const std::string& path) {
  bool same = result.mesh.vertices.size() == totals.corners;
  std::size_t vertex = 0;
  for (const ColladaInstance& instance : scene.instances) {
    const ColladaShape& shape = scene.shapes[instance.shape];
    for (std::size_t i = 0; same && i < shape.corners.size(); ++i) {
      const Eigen::Vector3d p = instance.placement.to_root * shape.points[at(shape.corners[i])].cast<double>();
      same = (result.mesh.vertices[vertex++] - p).cwiseAbs().maxCoeff() <= kMostUnits * result.resolution;
    }
  }
  if (!same)
    throw Error(ErrorCode::kNotAMesh,
                path + ": Assimp finds other triangles in it than we do; export the mesh again, as STL if this persists");
}

}  // namespace

LoadedMesh readDae(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control) {
  const ColladaScene scene = readCollada(bytes, path, limits.max_triangles, control);
  const Totals totals(scene);
  if (totals.triangles == 0) failNoTriangle(path, totals.skipped);
  Assimp::Importer importer;
  LoadedMesh result = AssimpReader(import(&importer, scene.canonical, path), totals, path, limits.max_triangles, control).read();
  expectTheSame(scene, totals, result, path);
  result.skipped_primitives = totals.skipped;
  return result;
}

}  // namespace collision_hulls
