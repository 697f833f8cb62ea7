// Meshes that are decoded by another process, and what that process may do to this one. Also tests src/mesh/read_mesh.cpp and
// src/tools/reader.cpp.
#include "mesh/mesh_question.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <thread>
#include <vector>

#include "base/sanitizer.h"
#include "collision_hulls/error.h"
#include "decode/decode_mesh.h"
#include "files.h"

namespace collision_hulls {
namespace {

using namespace test_files;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

void expectError(const std::string& content, const std::string& part, const MeshLimits& limits = {},
                 ErrorCode code = ErrorCode::kReaderFailed) {
  try {
    parseMesh(content, "a.obj", limits);
    ADD_FAILURE() << content << " was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << content << ": " << error.what();
  }
}

/// Within its scope, the test's own program reads meshes, and does what they say.
class Misbehaving {
 public:
  Misbehaving() { setenv("COLLISION_HULLS_READER", TEST_READER, 1); }
  ~Misbehaving() { unsetenv("COLLISION_HULLS_READER"); }
};

TEST(MeshQuestion, SameAsInThisProcess) {
  const LoadedMesh there = parseMesh(kTriangle, "a.obj"), here = decodeMesh(kTriangle, "a.obj", {}, {});
  EXPECT_EQ(there.mesh.vertices, here.mesh.vertices);
  EXPECT_EQ(there.mesh.triangles, here.mesh.triangles);
  EXPECT_EQ(there.submeshes, 1);
  EXPECT_EQ(there.resolution, here.resolution);
  EXPECT_GT(there.resolution, 0);
}

TEST(MeshQuestion, PassesLimitsAndNameOn) {
  MeshLimits limits;
  limits.max_triangles = 1;
  try {
    parseMesh(kTriangle + "f 1 3 2\n", "two words.obj", limits);
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kTooLarge) << error.what();
    EXPECT_EQ(std::string(error.what()).rfind("two words.obj: ", 0), 0u) << error.what();
  }
}

TEST(MeshQuestion, ChecksTheAnswer) {
  const Misbehaving misbehaving;
  EXPECT_EQ(parseMesh("good_mesh\n", "a.obj").mesh.triangles.size(), 1u);
  expectError("garbage\n", "a.obj: its reader's answer makes no sense (");
  expectError("echo\n", "its reader's answer makes no sense (it ends inside a value");
  expectError("huge_count\n", "its reader's answer makes no sense (it ends inside a value");
  expectError("too_short\n", "it ends inside a value");
  expectError("too_much\n", "4 bytes follow its end");
  expectError("no_triangles\n", "its number of triangles is out of range");
  expectError("index_above\n", "an index is out of range");
  expectError("index_below\n", "an index is out of range");
  expectError("not_finite\n", "a coordinate is not finite");
  expectError("negative_count\n", "a count is negative");
  expectError("bad_resolution\n", "a count is negative");
  MeshLimits limits;
  limits.max_triangles = 0;
  expectError("good_mesh\n", "its number of triangles is out of range", limits);
}

TEST(MeshQuestion, NeedsTime) {
  MeshLimits limits;
  for (const double seconds : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    limits.reader_seconds = seconds;
    expectError(kTriangle, "reader_seconds is", limits, ErrorCode::kBadOption);
  }
}

TEST(MeshQuestion, LimitsGrowWithTheFile) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer needs more memory than any limit";
  const Misbehaving misbehaving;
  expectError("memory\n", "more memory than the limit of 536 MB; simplify the mesh, or raise reader-memory", {}, ErrorCode::kOutOfMemory);
  expectError("memory\n" + std::string(1'000'000, ' '), "more memory than the limit of 576 MB", {}, ErrorCode::kOutOfMemory);
  MeshLimits limits;
  limits.reader_memory = 100'000'000;
  expectError("memory\n", "more memory than the limit of 100 MB", limits, ErrorCode::kOutOfMemory);
  limits.reader_seconds = 0.5;  // and a few microseconds for the file
  expectError("loop\n", "more computing than the limit of 1 s", limits, ErrorCode::kOutOfTime);
}

/// A square of side * side vertices as Collada.
std::string collada(int side) {
  const int vertices = side * side, triangles = 2 * (side - 1) * (side - 1);
  std::string numbers, indices;
  for (int i = 0; i < vertices; ++i) numbers += std::to_string(i % side) + " " + std::to_string(i / side) + " 0.1234567 ";
  for (int i = 0; i < vertices - side; ++i) {
    if (i % side == side - 1) continue;
    const std::string a = std::to_string(i), b = std::to_string(i + 1), c = std::to_string(i + side), d = std::to_string(i + side + 1);
    indices += a + " " + b + " " + d + " " + a + " " + d + " " + c + " ";
  }
  return "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset/><library_geometries>"
         "<geometry id=\"g\"><mesh><source id=\"s\"><float_array id=\"f\" count=\"" +
         std::to_string(3 * vertices) + "\">" + numbers + "</float_array><technique_common><accessor source=\"#f\" count=\"" +
         std::to_string(vertices) +
         "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
         "</technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/></vertices><triangles count=\"" +
         std::to_string(triangles) + "\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" + indices +
         "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"w\"><node>"
         "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url=\"#w\"/></scene></COLLADA>";
}

/// Of all formats, Collada takes the most memory for its size.
TEST(MeshQuestion, HalfTheLimitsWouldDo) {
  const std::string text = collada(250);
  MeshLimits limits;
  limits.reader_memory = limits.reader_memory / 2 - 20 * text.size();  // to which 40 * text.size() is added
  limits.reader_seconds = limits.reader_seconds / 2 - 0.5e-6 * static_cast<double>(text.size());
  EXPECT_EQ(parseMesh(text, "a.dae", limits).mesh.triangles.size(), 2u * 249 * 249);
}

TEST(MeshQuestion, BinaryStlNeedsNoOtherProcess) {
  setenv("COLLISION_HULLS_READER", "/no/such/program", 1);
  EXPECT_EQ(parseMesh(binaryStl("", 2, 2), "a.stl").mesh.triangles.size(), 2u);
  expectError(kTriangle, "'/no/such/program', cannot be started");
  unsetenv("COLLISION_HULLS_READER");
}

TEST(MeshQuestion, CancelEndsIt) {
  const Misbehaving misbehaving;
  RunControl control;
  std::thread cancelling([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    control.cancel();
  });
  try {
    parseMesh("sleep\n", "a.obj", {}, control);
    ADD_FAILURE() << "it answered";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled) << error.what();
  }
  cancelling.join();
}

TEST(MeshQuestion, SaysWhatProtects) {
  EXPECT_EQ(readerProtection().rfind("a process of its own, confined by resource limits", 0), 0u) << readerProtection();
}

}  // namespace
}  // namespace collision_hulls
