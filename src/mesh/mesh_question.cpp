// The answer comes from a process that hostile bytes may have taken over. So it is taken for what it is, numbers: their count, each index
// and each coordinate are checked before anything relies on them.
//
// What a worker may use grows with its file, so that a small file can do little harm and a large one is read. Collada takes most, as Assimp
// reads it, too: of 3 million triangles, 11 bytes of memory per byte of the file.
#include "mesh/mesh_question.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "geometry/bytes.h"
#include "mesh/formats/gltf_document.h"
#include "mesh/mesh_bytes.h"
#include "sandbox/file_reader.h"

namespace collision_hulls {

template <typename Archive>
void fields(Archive& archive, LoadedMesh& loaded) {
  archive(loaded.mesh, loaded.submeshes, loaded.skipped_primitives, loaded.resolution);
}

template <typename Archive>
void fields(Archive& archive, BufferFile& file) {
  archive(file.buffer, file.uri);
}

namespace {

constexpr std::uint64_t kMemoryPerByte = 40;  // [bytes]
constexpr double kSecondsPerByte = 1e-6;      // [s] of computing
constexpr double kClockPerComputing = 10;     // on a machine with much else to do

constexpr const char* kReplace = "the file is damaged or malicious: replace it";
constexpr const char* kSimplify =
    "simplify the mesh, or raise reader-memory or reader-time (MeshLimits: reader_memory, reader_seconds) if it is to be trusted";

constexpr std::uint64_t kBytesPerTriangle = sizeof(Triangle) + 3 * sizeof(Eigen::Vector3d), kLongestError = 1 << 16;
constexpr std::uint64_t kLongestList = 1 << 23;  // [bytes] of files that hold buffers: a thousand of the longest names are half of it

/// A quarter of the memory is enough for any answer, and no mesh within the limits takes more than so many bytes per triangle.
ReadingLimits readingLimits(const MeshLimits& limits, std::size_t bytes) {
  if (!(limits.reader_seconds > 0 && std::isfinite(limits.reader_seconds)))
    throw Error(ErrorCode::kBadOption, "reader_seconds is " + decimal(limits.reader_seconds) + "; it must be a positive time, in seconds");
  ReadingLimits result;
  result.worker.memory = limits.reader_memory + kMemoryPerByte * bytes;
  const std::uint64_t triangles = std::min<std::uint64_t>(limits.max_triangles, std::numeric_limits<int>::max());
  result.answer = std::min(result.worker.memory / 4, kBytesPerTriangle * triangles + kLongestError);
  const double seconds = limits.reader_seconds + kSecondsPerByte * static_cast<double>(bytes);
  result.worker.cpu_seconds = static_cast<std::uint64_t>(std::ceil(std::max(seconds, 1.0)));
  result.clock_seconds = kClockPerComputing * seconds;
  return result;
}

void expectSound(const LoadedMesh& loaded, const MeshLimits& limits) {
  const TriangleMesh& mesh = loaded.mesh;
  if (mesh.triangles.empty() || mesh.triangles.size() > limits.max_triangles) throw ByteFault("its number of triangles is out of range");
  if (mesh.vertices.size() > 3 * mesh.triangles.size()) throw ByteFault("it has vertices of no triangle");
  const auto is_corner = [&mesh](int v) { return v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size(); };
  for (const Triangle& t : mesh.triangles)
    if (!std::all_of(t.begin(), t.end(), is_corner)) throw ByteFault("an index is out of range");
  for (const Eigen::Vector3d& v : mesh.vertices)
    if (!v.allFinite()) throw ByteFault("a coordinate is not finite");
  if (loaded.submeshes < 0 || !std::isfinite(loaded.resolution) || loaded.resolution < 0) throw ByteFault("a count is negative");
}

}  // namespace

LoadedMesh meshIn(const std::string& answer, const std::string& name, const MeshLimits& limits) {
  return madeOfAnswer(name, kReplace, [&] {
    LoadedMesh loaded;
    fromBytes(answer, loaded);
    expectSound(loaded, limits);
    return loaded;
  });
}

std::vector<BufferFile> bufferFilesIn(const std::string& answer, const std::string& name) {
  return madeOfAnswer(name, kReplace, [&] {
    std::vector<BufferFile> files;
    fromBytes(answer, files);
    return files;
  });
}

LoadedMesh decodeInWorker(const std::string& bytes, const std::string& name, const MeshLimits& limits, const RunControl& control) {
  const std::string head = toBytes(Reading::kMesh, name, limits.max_bytes, limits.max_triangles);
  return meshIn(fileReader().ask({head, bytes, -1}, readingLimits(limits, bytes.size()), name, kSimplify, control), name, limits);
}

std::vector<BufferFile> askForBufferFiles(const std::string& bytes, const std::string& name, const MeshLimits& limits,
                                          const RunControl& control) {
  const std::string head = toBytes(Reading::kBufferFiles, name);
  ReadingLimits reading = readingLimits(limits, bytes.size());
  reading.answer = kLongestList;
  return bufferFilesIn(fileReader().ask({head, bytes, -1}, reading, name, kSimplify, control), name);
}

std::string answerMeshQuestion(const Question& question, const MeshDecoder& decode) {
  auto kind = Reading::kMesh;
  std::string name;
  MeshLimits limits;
  fromBytes(question.head, kind, name, limits.max_bytes, limits.max_triangles);
  return toBytes(decode(question.body, name, limits, {}));
}

std::string answerBufferQuestion(const Question& question) {
  auto kind = Reading::kBufferFiles;
  std::string name;
  fromBytes(question.head, kind, name);
  expectMeshFile(question.body, name);
  return toBytes(buffersInFiles(question.body, name));
}

std::string readerProtection() {
  return fileReader().protection();
}

}  // namespace collision_hulls
