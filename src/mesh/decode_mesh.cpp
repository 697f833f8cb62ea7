// Reads a mesh from bytes: checks of what Assimp trusts (source_checks.h), Assimp's scene, and every instance of every mesh in metres.
// Binary STL is read directly, at a tenth of Assimp's cost.
#include "mesh/decode_mesh.h"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "mesh/formats/source_checks.h"
#include "mesh/triangulate.h"

namespace collision_hulls {
namespace {

/// Single precision must resolve at least this share of a mesh's diagonal.
constexpr double kCoarsestResolution = 1e-3;

constexpr unsigned kFacesBetweenChecks = 1 << 16;

/// The start of a Git LFS pointer, which stands in for a file not fetched.
constexpr std::string_view kLfsPointer = "version https://git-lfs.github.com/spec/";

/// Keeps three corners per triangle within the range of int.
constexpr std::size_t kMostTriangles = std::numeric_limits<int>::max() / 3;

std::optional<Announced> checkSource(const std::string& bytes, const std::string& path, const std::string& extension,
                                     std::size_t max_triangles) {
  if (bytes.empty()) throw Error(ErrorCode::kEmptyMesh, path + ": the file is empty (0 bytes); export the mesh again");
  if (bytes.compare(0, kLfsPointer.size(), kLfsPointer) == 0)
    throw Error(ErrorCode::kNotAMesh, path + ": a Git LFS pointer, not the mesh itself; fetch the mesh with 'git lfs pull'");
  if (extension == ".stl") checkStl(bytes, path, max_triangles);
  if (extension == ".obj") checkObj(bytes, path);
  if (extension == ".off") return checkOff(bytes, path, max_triangles);
  if (extension == ".ply") return checkPly(bytes, path, max_triangles);
  if (extension == ".dae") checkDae(bytes, path);
  return std::nullopt;
}

/// Assimp's count differs from the file's if lines hold only blanks, or if a PLY has unknown elements before its vertices.
void expectAll(const Announced& announced, const aiScene& scene, const std::string& path) {
  Announced read;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    read.vertices += scene.mMeshes[i]->mNumVertices;
    for (unsigned f = 0; f < scene.mMeshes[i]->mNumFaces; ++f) read.faces += scene.mMeshes[i]->mFaces[f].mNumIndices > 0;
  }
  if (read.vertices == announced.vertices && read.faces == announced.faces) return;
  throw Error(ErrorCode::kNotAMesh, path + ": announces " + std::to_string(announced.vertices) + " vertices and " +
                                        std::to_string(announced.faces) + " faces, but Assimp finds " + std::to_string(read.vertices) +
                                        " and " + std::to_string(read.faces) +
                                        "; remove whitespace-only lines and any elements before the vertices, or export it again");
}

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

[[noreturn]] void failNotFinite(const std::string& path, std::size_t vertex, std::size_t face) {
  throw Error(ErrorCode::kNonFiniteCoordinate, path + ": vertex " + std::to_string(vertex) + " (of face " + std::to_string(face) +
                                                   ", both counted from 0) has a coordinate that is not a finite number; export it again");
}

std::string digits(double number) {
  std::ostringstream text;
  text << std::setprecision(4) << number;
  return text.str();
}

/// LoadedMesh::resolution; `largest` is the largest number [m] that single precision rounded.
double resolution(const TriangleMesh& mesh, double largest, const std::string& path) {
  if (!(largest > 0)) return 0;
  const double result =
      std::ldexp(1.0, std::max(std::ilogb(largest), std::numeric_limits<float>::min_exponent - 1) - std::numeric_limits<float>::digits);
  const double size = diagonal(mesh);
  if (size > 0 && result > kCoarsestResolution * size)
    throw Error(ErrorCode::kTooFarFromOrigin, path + ": the mesh is " + digits(size) + " m across and up to " + digits(largest) +
                                                  " m away from its origin, where single precision resolves only " + digits(result) +
                                                  " m; move the mesh to its origin");
  return result;
}

/// Reads a binary STL that passed checkStl(); the result equals Assimp's at a tenth of the cost.
LoadedMesh readBinaryStl(const std::string& bytes, const std::string& path, const RunControl& control) {
  LoadedMesh result;
  result.submeshes = 1;
  const std::size_t count = (bytes.size() - kStlHeaderBytes) / kStlFacetBytes;
  result.mesh.vertices.reserve(3 * count);
  result.mesh.triangles.reserve(count);
  float largest = 0;
  for (std::size_t f = 0; f < count; ++f) {
    if (f % kFacesBetweenChecks == 0) control.check();
    std::array<float, 9> corners;  // they follow the normal
    std::memcpy(corners.data(), bytes.data() + kStlHeaderBytes + kStlFacetBytes * f + 3 * sizeof(float), sizeof corners);
    const int first = static_cast<int>(3 * f);
    result.mesh.triangles.push_back({first, first + 1, first + 2});
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      result.mesh.vertices.emplace_back(corners[k], corners[k + 1], corners[k + 2]);
      if (!result.mesh.vertices.back().allFinite()) failNotFinite(path, 3 * f + k / 3, f);
    }
    for (const float x : corners) largest = std::max(largest, std::abs(x));
  }
  result.resolution = resolution(result.mesh, largest, path);
  return result;
}

/// Collects the triangles of a scene's nodes; each instance of a mesh contributes its own.
class SceneReader {
 public:
  SceneReader(const aiScene& scene, const std::string& path, std::size_t max_triangles, const RunControl& control)
      : scene_(scene), path_(path), max_triangles_(std::min(max_triangles, kMostTriangles)), control_(control) {}

  LoadedMesh read() {
    visit(*scene_.mRootNode, Placement(rootTransform(scene_.mRootNode->mTransformation, path_)));
    if (result_.mesh.triangles.empty())
      throw Error(ErrorCode::kEmptyMesh, path_ + ": holds no triangle (" + std::to_string(result_.skipped_primitives) +
                                             " lines and points, which have no surface); export it with its faces");
    result_.resolution = resolution(result_.mesh, largest_, path_);
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
      if (f % kFacesBetweenChecks == 0) control_.check();
      const aiFace& face = source.mFaces[f];
      if (face.mNumIndices < 3) {
        ++result_.skipped_primitives;
      } else {
        addFace(source, f, placement);
      }
    }
    if (result_.mesh.triangles.size() > before) ++result_.submeshes;
  }

  void addFace(const aiMesh& source, unsigned f, const Placement& placement) {
    const aiFace& face = source.mFaces[f];
    if (result_.mesh.triangles.size() + face.mNumIndices - 2 > max_triangles_)
      throw Error(ErrorCode::kTooLarge, path_ + ": more triangles than the limit of " + std::to_string(max_triangles_) +
                                            "; simplify the mesh or raise the limit");
    polygon_.clear();
    for (unsigned k = 0; k < face.mNumIndices; ++k) polygon_.push_back(vertexNumber(source, f, k, placement));
    if (polygon_.size() == 3) {
      result_.mesh.triangles.push_back({polygon_[0], polygon_[1], polygon_[2]});
      return;
    }
    std::vector<Eigen::Vector3d> corners;
    for (const int v : polygon_) corners.push_back(result_.mesh.vertices[static_cast<std::size_t>(v)]);
    for (const Triangle& t : triangulate(corners)) result_.mesh.triangles.push_back({polygonAt(t[0]), polygonAt(t[1]), polygonAt(t[2])});
  }

  int polygonAt(int k) const { return polygon_[static_cast<std::size_t>(k)]; }

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
  std::size_t max_triangles_;
  const RunControl& control_;
  LoadedMesh result_;
  double largest_ = 0;        // [m] largest of the numbers that single precision rounded
  std::vector<int> number_;   // per vertex of the current instance: its index in the result, -1 before its first use
  std::vector<int> polygon_;  // the current face
};

}  // namespace

LoadedMesh decodeMesh(const std::string& bytes, const std::string& name, const MeshLimits& limits, const RunControl& control) {
  const std::string extension = lowerExtension(name);
  const std::optional<Announced> announced = checkSource(bytes, name, extension, limits.max_triangles);
  if (extension == ".stl" && isBinaryStl(bytes)) return readBinaryStl(bytes, name, control);
  std::string text;  // Assimp drops a last line without a line end
  if (extension == ".obj" || extension == ".off") text = bytes + '\n';
  Assimp::Importer importer;
  const aiScene* scene = import(&importer, text.empty() ? bytes : text, name, extension, control);
  if (announced) expectAll(*announced, *scene, name);
  return SceneReader(*scene, name, limits.max_triangles, control).read();
}

}  // namespace collision_hulls
