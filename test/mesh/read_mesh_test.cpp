// What all formats have in common; each has a test of its own in formats/. Also tests src/mesh/read_mesh.cpp and
// src/decode/decode_mesh.cpp.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "files.h"

namespace collision_hulls {
namespace {

using namespace test_files;

LoadedMesh read(const std::string& name, const std::string& bytes, const MeshLimits& limits = {}) {
  const TempFile file(name, bytes);
  return readMesh(file.path(), limits);
}

/// Expects an error with this code and a text that names the file and contains `part`.
void expectError(ErrorCode code, const std::string& part, const std::string& name, const std::string& bytes,
                 const MeshLimits& limits = {}) {
  try {
    read(name, bytes, limits);
    ADD_FAILURE() << name << " was read; expected " << collision_hulls::name(code) << " with '" << part << "'";
  } catch (const Error& error) {
    EXPECT_EQ(code, error.code()) << error.what();
    EXPECT_NE(std::string::npos, std::string(error.what()).find(part)) << error.what();
    EXPECT_NE(std::string::npos, std::string(error.what()).find(name)) << error.what();
  }
}

void expectBox(const LoadedMesh& loaded, const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  const Eigen::AlignedBox3d box = boundingBox(loaded.mesh);
  const double tolerance = 1e-6 * box.diagonal().norm();
  EXPECT_LT((box.min() - min).norm(), tolerance) << box.min().transpose();
  EXPECT_LT((box.max() - max).norm(), tolerance) << box.max().transpose();
}

const std::string kObjCorners = "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 3\n";
const std::string kOffCorners = "0 0 0\n1 0 0\n1 2 0\n0 2 0\n0 0 3\n";
const std::string kTextStl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\nendloop\nendfacet\nendsolid a\n";

std::string plyHeader(const std::string& format, int vertices, int faces) {
  return "ply\nformat " + format + " 1.0\ncomment made up\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

// --- Errors, one by one ---

TEST(ReadMeshError, Cancelled) {
  RunControl control;
  control.cancel();
  for (const auto& [name, bytes] : {std::pair<std::string, std::string>("a.stl", binaryStl("", 2, 2)), {"b.stl", kTextStl}}) {
    const TempFile file(name, bytes);
    try {
      readMesh(file.path(), {}, control);
      ADD_FAILURE() << name << " was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kCancelled);
    }
  }
}

TEST(ReadMeshError, FileNotFound) {
  try {
    readMesh("/nowhere/at_all.stl");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(ErrorCode::kFileNotFound, error.code());
    EXPECT_STREQ("'/nowhere/at_all.stl' does not exist; give the path of a mesh", error.what());
  }
}

TEST(ReadMeshError, AFolderIsNotAFile) {
  const TempFile file("a.stl/b.txt", "");
  std::filesystem::create_directories(file.path() + ".stl");
  EXPECT_THROW(readMesh(file.path() + ".stl"), Error);
}

TEST(ReadMeshError, BytesAboveTheLimit) {
  MeshLimits limits;
  for (const auto& [name, bytes] : {std::pair<std::string, std::string>("a.stl", binaryStl("", 2, 2)), {"b.stl", kTextStl}}) {
    limits.max_bytes = bytes.size();
    EXPECT_NO_THROW(parseMesh(bytes, name, limits));
    limits.max_bytes = bytes.size() - 1;
    expectError(ErrorCode::kTooLarge, "above the limit", name, bytes, limits);
    try {
      parseMesh(bytes, name, limits);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kTooLarge);
      EXPECT_EQ(std::string(error.what()).rfind(name + ": has " + std::to_string(bytes.size()) + " bytes, above the limit", 0), 0u)
          << error.what();
    }
  }
}

TEST(ReadMeshError, UnsupportedFormat) {
  expectError(ErrorCode::kUnsupportedFormat, "'.fbx' is not supported; convert the file to one of .stl .dae .obj .off .ply", "a.fbx", "x");
  expectError(ErrorCode::kUnsupportedFormat, "''", "no_extension", "x");
}

TEST(ReadMeshError, NotAMesh) {
  const std::string text = "Dear sir, I enclose the mesh that you asked for. It is attached to the next letter, not to this one.\n";
  for (const std::string& extension : meshExtensions()) expectError(ErrorCode::kNotAMesh, "check the file", "letter" + extension, text);
}

TEST(ReadMeshError, GitLfsPointer) {
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:" + std::string(64, 'a') + "\nsize 12345\n";
  for (const std::string& extension : meshExtensions()) expectError(ErrorCode::kNotAMesh, "git lfs pull", "left_out" + extension, pointer);
}

TEST(ReadMeshError, EmptyMesh) {
  for (const std::string& extension : meshExtensions()) expectError(ErrorCode::kEmptyMesh, "0 bytes", "nothing" + extension, "");
  expectError(ErrorCode::kEmptyMesh, "0 triangles", "nothing.stl", binaryStl("", 0, 0));
  expectError(ErrorCode::kEmptyMesh, "no triangle", "nothing.obj", kObjCorners);
  expectError(ErrorCode::kEmptyMesh, "1 vertices and 0 faces", "nothing.off", "OFF\n1 0 0\n0 0 0\n");
  expectError(ErrorCode::kEmptyMesh, "no triangle", "nothing.dae", dae("", "", "<node id=\"empty\"/>"));
}

TEST(ReadMeshError, OnlyLinesAreAnEmptyMesh) {
  expectError(ErrorCode::kEmptyMesh, "2 lines and points", "lines.obj", kObjCorners + "l 1 2 3\n");
}

TEST(ReadMeshError, TooLarge) {
  MeshLimits limits;
  limits.max_bytes = 100;
  expectError(ErrorCode::kTooLarge, "184 bytes, above the limit of 100", "big.stl", binaryStl("", 2, 2), limits);
  limits = {};
  limits.max_triangles = 1;
  const std::string two_faces = "3 0 1 2\n3 0 2 4\n";
  expectError(ErrorCode::kTooLarge, "limit of 1;", "big.stl", binaryStl("", 2, 2), limits);
  expectError(ErrorCode::kTooLarge, "limit of 1;", "big.obj", kObjCorners + "f 1 2 3 4\n", limits);
  expectError(ErrorCode::kTooLarge, "limit of 1;", "big.off", "OFF\n5 2 0\n" + kOffCorners + two_faces, limits);
  expectError(ErrorCode::kTooLarge, "limit of 1;", "big.ply", plyHeader("ascii", 5, 2) + kOffCorners + two_faces, limits);
  expectError(ErrorCode::kTooLarge, "limit of 1;", "big.dae", dae("", kTwoTriangles, kPlainNode), limits);
}

TEST(ReadMeshError, NonFiniteCoordinate) {
  expectError(ErrorCode::kNonFiniteCoordinate, "vertex 1 (of face 0", "nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n");
  expectError(ErrorCode::kNonFiniteCoordinate, "vertex 2 (of face 0", "inf.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1e39 0\n3 0 1 2\n");
  std::string stl = binaryStl("", 2, 2);
  stl.replace(84 + 50 + 12 + 24, 4, raw(std::nanf("")));  // second triangle, third corner
  expectError(ErrorCode::kNonFiniteCoordinate, "vertex 5 (of face 1", "nan.stl", stl);
}

TEST(ReadMeshError, IndexOutOfRange) {
  expectError(ErrorCode::kIndexOutOfRange, "line 6 names vertex 6, but there are 5", "a.obj", kObjCorners + "f 1 2 6\n");
  expectError(ErrorCode::kIndexOutOfRange, "line 6 names vertex 0, but there are 5", "b.obj", kObjCorners + "f 0 1 2\n");
  expectError(ErrorCode::kIndexOutOfRange, "line 6 names vertex -6", "c.obj", kObjCorners + "f -1 -2 -6\n");
  expectError(ErrorCode::kIndexOutOfRange, "line 9 names vertex 5, but there are 5", "a.off",
              "OFF\n# corners\n5 1 0\n" + kOffCorners + "3 0 1 5\n");
  expectError(ErrorCode::kIndexOutOfRange, "face 0 names vertex 5, but there are 5", "a.ply",
              plyHeader("ascii", 5, 1) + kOffCorners + "3 0 1 5\n");
}

TEST(ReadMeshError, TooFarFromOrigin) {
  expectError(ErrorCode::kTooFarFromOrigin, "move the mesh to its origin", "far.obj",
              "v 1600 0 0\nv 1600.001 0 0\nv 1600 0.001 0\nf 1 2 3\n");
}

TEST(ReadMeshError, TooFarFromOriginBeforeItsNodeMovesItBack) {
  const std::string node = R"(<node id="n"><translate>1e4 0 0</translate><instance_geometry url="#shape"/></node>)";
  const std::string moved = R"(<node id="m"><translate>-1e4 0 0</translate>)" + node + "</node>";
  EXPECT_NO_THROW(read("back.dae", dae("", kTwoTriangles, moved)));
  std::string further = moved;
  for (std::size_t at = further.find("1e4"); at != std::string::npos; at = further.find("1e4")) further.replace(at, 3, "1e6");
  expectError(ErrorCode::kTooFarFromOrigin, "single precision", "back.dae", dae("", kTwoTriangles, further));
}

// --- Faults that a trusting reader would miss ---

TEST(ReadMeshTrust, TruncatedStl) {
  expectError(ErrorCode::kNotAMesh, "announces 3 triangles, which take 234 bytes, but it has 184", "cut.stl", binaryStl("", 2, 3));
  expectError(ErrorCode::kNotAMesh, "announces 4294967295", "huge.stl", binaryStl("", 2, 0xffffffffu));
  expectError(ErrorCode::kNotAMesh, "without 'endsolid'", "cut.stl", kTextStl.substr(0, kTextStl.size() - 11));
}

TEST(ReadMeshTrust, TextStlWithFourVerticesInAFacet) {
  std::string four = kTextStl;
  four.insert(four.find("endloop"), "vertex 1 2 0\n");
  expectError(ErrorCode::kNotAMesh, "facet 1 has 4 vertices instead of 3", "four.stl", four);
}

// --- Formats ---

TEST(ReadMesh, BinaryStlWithAHeaderThatBeginsWithSolid) {
  const LoadedMesh loaded = read("UPPER.STL", binaryStl("solid from a CAD program", 2, 2));
  EXPECT_EQ(2u, loaded.mesh.triangles.size());
  expectBox(loaded, {0, 0, 0}, {1, 1, 0});
}

TEST(ReadMesh, TextStl) {
  const LoadedMesh loaded = read("a.stl", kTextStl + kTextStl);
  EXPECT_EQ(2u, loaded.mesh.triangles.size());
  EXPECT_EQ(2, loaded.submeshes);
  expectBox(loaded, {0, 0, 0}, {1, 2, 0});
}

TEST(ReadMesh, ObjWithQuadsNegativeIndicesContinuedLinesAndNoMaterialFile) {
  const LoadedMesh loaded =
      read("a.obj", "mtllib missing.mtl\no one\n" + kObjCorners +
                        "usemtl steel\nf 1/1/1 2//2 3 4\nf -5 -4 \\\n  -1\n# no line end after the last face\no two\nf 1 4 5");
  EXPECT_EQ(4u, loaded.mesh.triangles.size());
  EXPECT_EQ(2, loaded.submeshes);
  expectBox(loaded, {0, 0, 0}, {1, 2, 3});
}

TEST(ReadMesh, LinesAndPointsAreSkippedAndCounted) {
  const LoadedMesh obj = read("a.obj", kObjCorners + "f 1 2 3\nl 1 2 3 4\np 1\n");
  EXPECT_EQ(1u, obj.mesh.triangles.size());
  EXPECT_EQ(4u, obj.skipped_primitives);
  const LoadedMesh collada =
      read("a.dae", dae("", kTwoTriangles + "<lines count=\"2\">" + kVertexInput + "<p>0 1 2 3</p></lines>", kPlainNode));
  EXPECT_EQ(2u, collada.mesh.triangles.size());
  EXPECT_EQ(2u, collada.skipped_primitives);
  EXPECT_EQ(1, collada.submeshes);
}

TEST(ReadMesh, OffWithPolygonsAndComments) {
  const LoadedMesh loaded = read("a.OFF", "# a comment\nOFF\n5 2 0\n\n" + kOffCorners + "4 0 1 2 3\n3 0 1 4");
  EXPECT_EQ(3u, loaded.mesh.triangles.size());
  expectBox(loaded, {0, 0, 0}, {1, 2, 3});
}

TEST(ReadMesh, PlyTextAndBinaryOfEitherByteOrder) {
  expectBox(read("a.ply", plyHeader("ascii", 5, 2) + kOffCorners + "4 0 1 2 3\n3 0 1 4\n"), {0, 0, 0}, {1, 2, 3});
  for (const bool big : {false, true}) {
    const auto word = [&](std::string bytes) { return big ? std::string(bytes.rbegin(), bytes.rend()) : bytes; };
    std::string bytes = plyHeader(big ? "binary_big_endian" : "binary_little_endian", 3, 1);
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.5f}) bytes += word(raw(x));
    bytes += '\3' + word(raw(0)) + word(raw(1)) + word(raw(2));
    expectBox(read("b.ply", bytes), {0, 0, 0}, {1, 2, 0.5});
  }
}

// --- Resolution ---

TEST(ReadMesh, ResolutionIsHalfAUnitInTheLastPlaceOfTheLargestCoordinate) {
  EXPECT_EQ(std::ldexp(1, -24), read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").resolution);
  EXPECT_EQ(std::ldexp(1, -25), read("a.obj", "v 0 0 0\nv 0.9 0 0\nv 0 0.9 0\nf 1 2 3\n").resolution);
  EXPECT_EQ(std::ldexp(1, -21), read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 -8.5 0\nf 1 2 3\n").resolution);
  const double millimetres = read("a.dae", dae(unit("0.001"), kTwoTriangles, kPlainNode)).resolution;
  EXPECT_EQ(std::ldexp(1, -33), millimetres) << "of 0.003, after applying the unit";
}

TEST(ReadMesh, IgnoresUnusedVertices) {
  const LoadedMesh loaded = read("a.off", "OFF\n4 1 0\n0 0 0\nnan 1e30 0\n1 0 0\n0 1 0\n3 0 2 3\n");
  EXPECT_EQ(3u, loaded.mesh.vertices.size());
  expectBox(loaded, {0, 0, 0}, {1, 1, 0});
}

TEST(ReadMesh, BinaryAndTextStlGiveTheSameMesh) {
  const LoadedMesh binary = read("b.stl", binaryStl("solid, though it is not text", 1, 1)), text = read("t.stl", kTextStl);
  EXPECT_EQ(binary.mesh.vertices, (std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(binary.mesh.triangles, text.mesh.triangles);
  EXPECT_EQ(binary.submeshes, 1);
  EXPECT_EQ(binary.skipped_primitives, 0u);
  EXPECT_EQ(binary.resolution, text.resolution / 2);  // the text has a coordinate of 2
}

}  // namespace
}  // namespace collision_hulls
