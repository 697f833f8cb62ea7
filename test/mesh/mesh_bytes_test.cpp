#include "mesh/mesh_bytes.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "base/roots.h"
#include "collision_hulls/error.h"
#include "files.h"
#include "mesh/formats/gltf_container.h"
#include "reading.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using namespace test_files;

/// Three points of a triangle, and its corners 0 1 2.
const std::string kPoints = raw(0.f) + raw(0.f) + raw(0.f) + raw(1.f) + raw(0.f) + raw(0.f) + raw(0.f) + raw(1.f) + raw(0.f);
const std::string kCorners("\0\1\2", 3);

const std::string kPointsAlone = R"({"buffer": 0, "byteLength": 36})";

/// A triangle whose buffers and views of them are given as JSON. If there are two views, the second is of the corners.
std::string gltf(const std::string& buffers, const std::string& views = kPointsAlone) {
  const bool indexed = views != kPointsAlone;
  return R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes":
      {"POSITION": 0})" +
         std::string(indexed ? R"(, "indices": 1)" : "") +
         R"(}]}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"})" +
         (indexed ? R"(, {"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"})" : "") + R"(], "bufferViews": [)" + views +
         R"(], "buffers": [)" + buffers + "]}";
}

std::string buffer(const std::string& uri, std::size_t bytes = 36) {
  return R"({"uri": ")" + uri + R"(", "byteLength": )" + std::to_string(bytes) + "}";
}

class MeshBytes : public testing::Test {
 protected:
  MeshBytes() {
    std::string name = (fs::temp_directory_path() / "mesh_bytes_XXXXXX").string();
    folder_ = fs::canonical(mkdtemp(name.data()));
  }
  ~MeshBytes() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& bytes) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return path(name);
  }

  void expectTriangle(const std::string& file) const {
    SCOPED_TRACE(file);
    try {
      EXPECT_EQ(readMesh(path(file)).mesh.vertices, (std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }

  /// Expects that mesh/a.gltf with this URI is refused, and returns the message.
  std::string refusal(const std::string& uri, ErrorCode code, const MeshLimits& limits = {}) const {
    return refusalOf(write("mesh/a.gltf", gltf(buffer(uri))), code, limits);
  }
  std::string refusalOf(const std::string& file, ErrorCode code, const MeshLimits& limits = {}, const RunControl& control = {}) const {
    try {
      readMesh(file, limits, control);
      ADD_FAILURE() << file << " was read";
    } catch (const Error& error) {
      EXPECT_STREQ(name(error.code()), name(code)) << error.what();
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(MeshBytes, BuffersInFiles) {
  write("part.bin", kPoints);
  write("sub folder/50%.bin", kPoints);
  write("longer.bin", kPoints + "and more");
  for (const char* uri : {"part.bin", "./part.bin", "sub%20folder/50%25.bin", "sub folder/../part.bin", "longer.bin"}) {
    write("a.gltf", gltf(buffer(uri)));
    expectTriangle("a.gltf");
  }
}

TEST_F(MeshBytes, ByARelativePath) {
  write("part.bin", kPoints);
  write("a.gltf", gltf(buffer("part.bin")));
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  EXPECT_EQ(readMeshBytes("a.gltf", {}), readMeshBytes(path("a.gltf"), {}));
  fs::current_path(before);
}

TEST_F(MeshBytes, SeveralBuffers) {
  const std::string corners = R"({"buffer": 1, "byteLength": 3})", inside = R"({"uri": "data:;base64,AAEC", "byteLength": 3})";
  write("points.bin", kPoints);
  write("corners.bin", kCorners);
  write("apart.gltf", gltf(buffer("points.bin") + ", " + buffer("corners.bin", 3), kPointsAlone + ", " + corners));
  write("one_inside.gltf", gltf(buffer("points.bin") + ", " + inside, kPointsAlone + ", " + corners));
  write("one_after_it.gltf",
        gltf(inside + ", " + buffer("points.bin"), R"({"buffer": 1, "byteLength": 36}, {"buffer": 0, "byteLength": 3})"));
  for (const char* file : {"apart.gltf", "one_inside.gltf", "one_after_it.gltf"}) expectTriangle(file);
}

TEST_F(MeshBytes, AFileOfTwoBuffersIsReadOnce) {
  write("both.bin", kPoints + kCorners);
  const std::string text =
      gltf(buffer("both.bin", 36) + ", " + buffer("both.bin", 39), kPointsAlone + R"(, {"buffer": 1, "byteOffset": 36, "byteLength": 3})");
  const std::string file = write("a.gltf", text);
  expectTriangle("a.gltf");
  EXPECT_EQ(readMeshBytes(file, {}), packedGltf(text, {kPoints + kCorners}));
}

TEST_F(MeshBytes, OtherFilesAreTheirBytes) {
  const std::string inside = gltf(R"({"uri": "data:;base64,AAAA", "byteLength": 3})"), container = glb(gltf(buffer("part.bin")), kPoints);
  EXPECT_EQ(readMeshBytes(write("a.gltf", inside), {}), inside);
  for (const char* name : {"b.gltf", "b.glb", "b.stl"}) EXPECT_EQ(readMeshBytes(write(name, container), {}), container) << name;
  for (const char* name : {"c.glb", "c.stl"}) EXPECT_EQ(readMeshBytes(write(name, gltf(buffer("none.bin"))), {}), gltf(buffer("none.bin")));
  const std::string packed = packedGltf(gltf(buffer("part.bin")), {kPoints});
  EXPECT_EQ(readMeshBytes(write("d.stl", packed), {}), packed) << "an STL file may begin with anything";
}

TEST_F(MeshBytes, EqualOnlyIfTheBuffersAre) {
  write("part.bin", kPoints);
  const std::string file = write("a.gltf", gltf(buffer("part.bin"))), before = readMeshBytes(file, {});
  EXPECT_EQ(readMeshBytes(file, {}), before);
  write("part.bin", kPoints.substr(0, 35) + "\x40");
  EXPECT_NE(readMeshBytes(file, {}), before);
}

TEST_F(MeshBytes, AContainerHoldsItsBuffers) {
  write("part.bin", kPoints);
  std::string text = gltf(buffer("part.bin"));
  text.resize((text.size() + 3) / 4 * 4, ' ');
  for (const char* name : {"a.glb", "a.gltf"})
    EXPECT_NE(refusalOf(write(name, glb(text, kPoints)), ErrorCode::kNotAMesh).find("buffers[0] is in another file, 'part.bin'; export"),
              std::string::npos);
  for (const char* name : {"b.glb", "b.gltf"})
    EXPECT_NE(refusalOf(write(name, packedGltf(text, {kPoints})), ErrorCode::kNotAMesh).find("is not a glTF file"), std::string::npos)
        << name;
}

TEST_F(MeshBytes, NamesThatLeadOutOfTheFolder) {
  write("part.bin", kPoints);
  write("mesh/sub/part.bin", kPoints);
  for (const std::string& uri :
       {std::string("../part.bin"), std::string("%2e%2e/part.bin"), std::string("sub/../../part.bin"), std::string("../mesh/sub/part.bin"),
        path("part.bin"), path("mesh/sub/part.bin"), "file://" + path("mesh/sub/part.bin"), std::string("http://host/part.bin"),
        std::string("//host/part.bin"), std::string("c:part.bin"), std::string()}) {
    const std::string message = refusal(uri, ErrorCode::kOutsideRoots);
    EXPECT_EQ(message.rfind(path("mesh/a.gltf") + ": buffers[0]: '" + uri + "' is not a file in the mesh's folder; put the file there", 0),
              0u)
        << message;
    EXPECT_NE(message.find("or export the mesh as .glb"), std::string::npos) << message;
  }
  for (const char* uri : {"a%00.bin", "a\\u0001.bin"})
    EXPECT_NE(refusal(uri, ErrorCode::kFileNotFound).find("buffers[0]: '"), std::string::npos) << uri;
  EXPECT_NE(refusal(std::string(5000, 'a'), ErrorCode::kFileNotFound).find("5000 bytes"), std::string::npos);
}

TEST_F(MeshBytes, LinksThatLeadOutOfTheFolder) {
  write("elsewhere/part.bin", kPoints);
  write("mesh/part.bin", kPoints);
  fs::create_symlink("part.bin", path("mesh/within.bin"));
  fs::create_symlink(path("elsewhere/part.bin"), path("mesh/out.bin"));
  fs::create_symlink(path("elsewhere"), path("mesh/way_out"));
  fs::create_symlink("loop.bin", path("mesh/loop.bin"));
  write("mesh/a.gltf", gltf(buffer("within.bin")));
  expectTriangle("mesh/a.gltf");
  for (const char* uri : {"out.bin", "way_out/part.bin"})
    EXPECT_NE(refusal(uri, ErrorCode::kOutsideRoots).find(uri + std::string("' leads out of the mesh's folder by a link")),
              std::string::npos);
  EXPECT_NE(refusal("loop.bin", ErrorCode::kFileNotFound).find("symbolic links"), std::string::npos);
}

TEST_F(MeshBytes, AMeshThatIsALink) {
  write("real/part.bin", kPoints);
  write("real/a.gltf", gltf(buffer("part.bin")));
  fs::create_directories(path("linked"));
  for (const char* file : {"a.gltf", "part.bin"}) fs::create_symlink(folder_ / "real" / file, folder_ / "linked" / file);
  expectTriangle("linked/a.gltf");
  fs::remove(path("linked/part.bin"));
  write("linked/part.bin", kPoints);
  expectTriangle("linked/a.gltf");
  const Confinement confinement({{path("real")}, {}, {}, {}, "set ~read_roots", ""});
  EXPECT_NE(refusalOf(path("linked/a.gltf"), ErrorCode::kOutsideRoots).find("set ~read_roots"), std::string::npos)
      << "the mesh may be read, but not what lies beside the link";
}

TEST_F(MeshBytes, FilesThatCannotBeRead) {
  EXPECT_EQ(refusal("part.bin", ErrorCode::kFileNotFound),
            path("mesh/a.gltf") + ": buffers[0]: '" + path("mesh/part.bin") +
                "' does not exist; put the file there, or export the mesh as .glb, which holds everything");
  mkfifo(path("mesh/fifo.bin").c_str(), 0600);
  EXPECT_NE(refusal("fifo.bin", ErrorCode::kFileNotFound).find("fifo.bin' is not a regular file; copy its content"), std::string::npos);
  fs::create_directories(path("mesh/folder"));
  EXPECT_NE(refusal("folder", ErrorCode::kFileNotFound).find("folder' is a folder; give the file of the buffer"), std::string::npos);
  write("mesh/short.bin", kPoints.substr(1));
  EXPECT_EQ(refusal("short.bin", ErrorCode::kNotAMesh), path("mesh/a.gltf") +
                                                            ": buffers[0] announces 36 bytes, of which 35 are in "
                                                            "'short.bin'; check the file or export it again");
  write("mesh/pointer.bin", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 36\n");
  EXPECT_NE(refusal("pointer.bin", ErrorCode::kNotAMesh).find("pointer.bin' is a Git LFS pointer"), std::string::npos);
}

TEST_F(MeshBytes, TheBufferIsNamed) {
  write("points.bin", kPoints);
  const std::string views = kPointsAlone + R"(, {"buffer": 1, "byteLength": 3})";
  const std::string file = write("a.gltf", gltf(buffer("points.bin") + ", " + buffer("none.bin", 3), views));
  EXPECT_NE(refusalOf(file, ErrorCode::kFileNotFound).find("a.gltf: buffers[1]: '" + path("none.bin")), std::string::npos);
}

TEST_F(MeshBytes, AllFilesAreWithinTheLimitTogether) {
  write("points.bin", kPoints);
  write("corners.bin", kCorners);
  const std::string text =
      gltf(buffer("points.bin") + ", " + buffer("corners.bin", 3), kPointsAlone + R"(, {"buffer": 1, "byteLength": 3})");
  const std::string file = write("a.gltf", text);
  MeshLimits limits;
  limits.max_bytes = text.size() + 39;
  EXPECT_NO_THROW(readMesh(file, limits));
  limits.max_bytes -= 1;
  const std::string size = std::to_string(text.size() + 39), limit = std::to_string(limits.max_bytes);
  EXPECT_EQ(refusalOf(file, ErrorCode::kTooLarge, limits), file + ": buffers[1]: with '" + path("corners.bin") + "' the mesh has " + size +
                                                               " bytes, above the limit of " + limit + "; simplify it");
}

TEST_F(MeshBytes, LengthsHave32Bits) {
  write("part.bin", "");
  fs::resize_file(path("part.bin"), std::uintmax_t{1} << 32);  // a hole, which takes no space
  MeshLimits limits;
  limits.max_bytes = std::uintmax_t{1} << 40;
  EXPECT_NE(refusalOf(write("a.gltf", gltf(buffer("part.bin"))), ErrorCode::kTooLarge, limits).find("limit of 4294901760"),
            std::string::npos);
}

TEST_F(MeshBytes, AtMostAThousandFiles) {
  std::string buffers = buffer("0.bin");
  for (int i = 1; i < 1000; ++i) buffers += ", " + buffer(std::to_string(i) + ".bin");
  EXPECT_NE(refusalOf(write("a.gltf", gltf(buffers)), ErrorCode::kFileNotFound).find("buffers[0]"), std::string::npos);
  EXPECT_NE(refusalOf(write("a.gltf", gltf(buffers + ", " + buffer("more.bin"))), ErrorCode::kTooLarge).find("in 1001 files"),
            std::string::npos);
}

TEST_F(MeshBytes, ACancelledRunDoesNotWaitForTheWorker) {
  setenv("COLLISION_HULLS_READER", TEST_READER, 1);
  const std::string file = write("a.gltf", "sleep\n");
  RunControl control;
  std::thread cancelling([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    control.cancel();
  });
  refusalOf(file, ErrorCode::kCancelled, {}, control);
  cancelling.join();
  unsetenv("COLLISION_HULLS_READER");
}

TEST_F(MeshBytes, TheWorkersAnswerIsNotTrusted) {
  setenv("COLLISION_HULLS_READER", TEST_READER, 1);
  for (const char* deed : {"garbage\n", "echo\n", "huge_count\n"})
    EXPECT_NE(refusalOf(write("a.gltf", deed), ErrorCode::kReaderFailed).find("a.gltf: its reader's answer makes no sense"),
              std::string::npos);
  unsetenv("COLLISION_HULLS_READER");
}

}  // namespace
}  // namespace collision_hulls
