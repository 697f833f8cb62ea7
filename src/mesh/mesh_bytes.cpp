// Which files a .gltf file needs is for a worker to find out, and what it answers is as foreign as the file: names that lead to other
// folders are refused here, as spelled and, once a file is open, by where it lies. Beyond that, the roots of base/roots.h count for each
// file that is opened.
#include "mesh/mesh_bytes.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <vector>

#include "base/read_file.h"
#include "base/roots.h"
#include "base/string_parts.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "mesh/formats/gltf_container.h"
#include "mesh/formats/scan.h"
#include "mesh/mesh_question.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr std::size_t kMostFiles = 1000;  // that hold buffers; see kMostPacked
constexpr std::string_view kLfsPointer = "version https://git-lfs.github.com/spec/";
constexpr const char* kRemedy = "export the mesh as .glb, which holds everything";

bool hasScheme(const std::string& uri) {
  const std::size_t colon = uri.find(':');
  return colon < uri.find('/');
}

/// The path of a file that holds buffers, below the mesh's folder.
std::string pathOf(const std::string& uri, const std::string& mesh) {
  checkCharacters(uri);
  const std::string name = percentDecoded(uri), path = (fs::path(mesh).parent_path() / fs::path(name).lexically_normal()).string();
  if (name.empty() || hasScheme(uri) || leadsOut(name))
    throw Error(
        ErrorCode::kOutsideRoots,
        "'" + shown(uri) + "' is not a file in the mesh's folder; put the file there and name it relative to the mesh, or " + kRemedy);
  return path;
}

/// Reads the files that hold a mesh's buffers, and adds up their sizes.
class MeshFiles {
 public:
  /// `size`: [bytes] of the .gltf file itself.
  MeshFiles(const std::string& mesh, std::uintmax_t size, const MeshLimits& limits, const RunControl& control)
      : mesh_(mesh), size_(size), most_(std::min(limits.max_bytes, kMostPacked)), control_(control) {}

  std::string read(const BufferFile& buffer) {
    try {
      return contentOf(pathOf(buffer.uri, mesh_));
    } catch (const Error& error) {
      if (error.code() == ErrorCode::kCancelled) throw;
      throw Error(error.code(), mesh_ + ": buffers[" + std::to_string(buffer.buffer) + "]: " + error.what());
    }
  }

 private:
  std::string contentOf(const std::string& path) {
    const OpenFile file(path);
    if (file.error() == ENOENT) throw Error(ErrorCode::kFileNotFound, "'" + path + "' does not exist; put the file there, or " + kRemedy);
    file.expectAllowed();
    if (file.error() == 0 && !liesBeside(path, file.number(), mesh_))
      throw Error(ErrorCode::kOutsideRoots,
                  "'" + path + "' leads out of the mesh's folder by a link; put the file itself there, or " + kRemedy);
    file.expectRegular("file of the buffer");
    count(path, static_cast<std::uintmax_t>(file.status().st_size));
    std::string bytes = file.content("mesh", most_, control_);
    if (isLfsPointer(bytes))
      throw Error(ErrorCode::kNotAMesh, "'" + path + "' is a Git LFS pointer, not the buffer itself; fetch the buffer with 'git lfs pull'");
    return bytes;
  }

  /// Before a byte is read.
  void count(const std::string& path, std::uintmax_t bytes) {
    size_ += bytes;
    if (size_ > most_)
      throw Error(ErrorCode::kTooLarge, "with '" + path + "' the mesh has " + std::to_string(size_) + " bytes, above the limit of " +
                                            std::to_string(most_) + "; simplify it");
  }

  const std::string& mesh_;
  std::uintmax_t size_;  // [bytes] of all files so far
  const std::uintmax_t most_;
  const RunControl& control_;
};

}  // namespace

std::string readMeshBytes(const std::string& path, const MeshLimits& limits, const RunControl& control) {
  std::string bytes = readFile(path, "mesh", limits.max_bytes, control);
  const std::string extension = lowerExtension(path);
  if (extension != ".gltf" && extension != ".glb") return bytes;
  if (isPackedGltf(bytes)) failNotAMesh(path, "is not a glTF file");
  if (extension == ".glb" || isGltfContainer(bytes)) return bytes;

  const std::vector<BufferFile> buffers = askForBufferFiles(bytes, path, limits, control);
  if (buffers.empty()) return bytes;
  if (buffers.size() > kMostFiles)
    throw Error(ErrorCode::kTooLarge, path + ": has its buffers in " + std::to_string(buffers.size()) + " files, above the limit of " +
                                          std::to_string(kMostFiles) + "; " + kRemedy);
  MeshFiles files(path, bytes.size(), limits, control);
  std::vector<std::string> contents;
  for (const BufferFile& buffer : buffers) contents.push_back(files.read(buffer));
  return packedGltf(bytes, contents);
}

bool isLfsPointer(std::string_view bytes) {
  return bytes.substr(0, kLfsPointer.size()) == kLfsPointer;
}

void expectMeshFile(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw Error(ErrorCode::kEmptyMesh, name + ": the file is empty (0 bytes); export the mesh again");
  if (isLfsPointer(bytes))
    throw Error(ErrorCode::kNotAMesh, name + ": a Git LFS pointer, not the mesh itself; fetch the mesh with 'git lfs pull'");
}

}  // namespace collision_hulls
