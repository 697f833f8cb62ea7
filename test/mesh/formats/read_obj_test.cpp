#include <gtest/gtest.h>

#include "../reading.h"

namespace collision_hulls {
namespace {

using namespace test_files;

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 3\n";  // five lines
const std::vector<Eigen::Vector3d> kFirst{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}};
const std::vector<Triangle> kOne{{0, 1, 2}};

TEST(ReadObj, EveryWayToWriteAFace) {
  for (const char* face :
       {"f 1 2 3", "f 1/7 2/8 3/9", "f 1//1 2//1 3//1", "f 1/1/1 2/2/2 3/3/3", "f 1/ 2// 3//", "f -5 -4 -3", "f\t1  2 3 ", "f 1 2 3 # note",
        "fo 1 2 3", "f 1 2 \\\n 3", "f 01 002 0003", "f \\\r\n1 \\\r\n2 3", "f 1/-1 2/-1/-2 3"})
    expectMesh("a.obj", kCorners + face, kFirst, kOne);
}

TEST(ReadObj, EndsOfLines) {
  for (const char* end : {"\n", "\r\n", "\r", "\f", "\n\n \t\n"}) {
    std::string text = kCorners + "f 1 2 3";
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + std::string(end).size())) text.replace(i, 1, end);
    expectMesh("a.obj", text, kFirst, kOne);
  }
}

TEST(ReadObj, VerticesWithAWeightOfOneOrAColour) {
  expectMesh("a.obj", "v 0 0 0 1\nv 1 0 0 1.0\nv 1 2 0 .5 .5 .5\nf 1 2 3\n", kFirst, kOne);
}

TEST(ReadObj, FacesMayComeBeforeTheirVertices) {
  expectMesh("a.obj", "f 1 2 3\n" + kCorners, kFirst, kOne);
}

TEST(ReadObj, SkipsWhatCarriesNoSurface) {
  expectMesh("a.obj",
             "\xEF\xBB\xBF# made up\nmtllib a.mtl\n" + kCorners +
                 "o part\ng one two\nusemtl steel\ns off\ns 1\nmg 1 0.1\nvt 0 0\nvn 0 0 1\nvp 1 2\nlod 3\nbevel on\nc_interp off\nd_interp "
                 "on\nusemap "
                 "off\nmaplib a b\nf 1 2 3\n",
             kFirst, kOne);
}

TEST(ReadObj, PartsWithoutFacesDoNotCount) {
  EXPECT_EQ(readHere(kCorners + "o one\ng two\nusemtl a\nf 1 2 3\no three\nf 1 3 4\nf 1 4 5\ng four\n", "a.obj").submeshes, 2);
}

TEST(ReadObj, CountsWhatHasNoSurface) {
  const LoadedMesh loaded = readHere(kCorners + "f 1 2 3\nl 1 2 3 4\nl 1/1 2/2\np 1 2\nf 1 2\nf 1\nf 3 3 3\n", "a.obj");
  EXPECT_EQ(loaded.skipped_primitives, 3u + 1 + 2 + 2);
  EXPECT_EQ(loaded.mesh.triangles.size(), 2u) << "a triangle without area is one still";
}

TEST(ReadObj, RefusesNumbersThatOthersGuess) {
  for (const std::string& word : misspeltNumbers())
    expectRefused("a.obj", {{"# first\nv 0 " + word + " 0\n", "line 2: '" + word + "' is not a number"},
                            {"v 0 0 0 1 1 " + word + "\n", "line 1: '" + word + "' is not a number"}});
  expectRefused("a.obj", {{"v 0 0 0\nv 1 0 0\nv 1 1e39 0\nf 1 2 3\n", "vertex 2 (of face 0", ErrorCode::kNonFiniteCoordinate},
                          {"v 0 0 0\nv 1 0 0\nv 1 nan 0\nf 1 2 3\n", "vertex 2 (of face 0", ErrorCode::kNonFiniteCoordinate}});
  expectMesh("a.obj", kCorners + "v nan 1e39 inf\nf 1 2 3\n", kFirst, kOne);  // no face uses it
}

TEST(ReadObj, RefusesVerticesOfOddLength) {
  expectRefused("a.obj", {{"v\n", "line 1: a vertex of 0 numbers"},
                          {"v 1 2\n", "a vertex of 2 numbers"},
                          {"v 1 2 3 1 1\n", "a vertex of 5 numbers"},
                          {"v 1 2 3 1 1 1 1\n", "a vertex of 7 numbers"},
                          {"v 1 2 # 3\n", "a vertex of 2 numbers"},
                          {"v 1 2 3 4\n", "w = 4.000000, by which some programs divide"},
                          {"v 1 2 3 0\n", "w = 0.000000"}});
}

TEST(ReadObj, RefusesCornersThatOthersGuess) {
  for (const char* word : {"x", "1x", "1/x", "1/2/3/4", "1.5", "+1", "1e0", "0x1", "/1", "1/2.5", "99999999999999999999"})
    expectRefused("a.obj", {{kCorners + "f 1 2 " + word + "\n", "line 6: '" + std::string(word) + "' is not a corner"},
                            {kCorners + "l 1 " + word + "\n", "line 6: '" + std::string(word) + "' is not a corner"}});
}

TEST(ReadObj, RefusesIndicesOutOfRange) {
  for (const char* word : {"0", "-6", "6", "4294967297", "4294967298", "18446744073709"})
    expectRefused("a.obj", {{kCorners + "f 1 2 " + word + "\n", "line 6 names vertex " + std::string(word) + ", but there are 5",
                             ErrorCode::kIndexOutOfRange}});
}

TEST(ReadObj, RefusesWhatItDoesNotRead) {
  for (const char* line : {"cstype bezier", "deg 3 3", "curv 0 1 1 2 3", "surf 0 1 0 1 1 2 3 4", "end", "bzp 1 2"})
    expectRefused("a.obj",
                  {{kCorners + "f 1 2 3\n" + line + "\nf 1 2 4\n",
                    "line 7: '" + std::string(line).substr(0, std::string(line).find(' ')) + "' belongs to a free-form curve or surface"}});
  expectRefused("a.obj", {{"call b.obj\n", "'call' is not carried out; put all of the mesh into this file"},
                          {"csh -c id\n", "'csh' is not carried out"},
                          {kCorners + "F 1 2 3\n", "line 6: 'F' begins no statement"},
                          {kCorners + "faces\n", "line 6: 'faces' begins no statement"},
                          {kCorners + "1 2 3\n", "line 6: '1' begins no statement"}});
}

TEST(ReadObj, RefusesBackslashesThatOthersSkip) {
  expectRefused("a.obj", {{"# C:\\meshes\\\nv 0 0 0\n", "line 1: a comment that ends with a backslash"},
                          {kCorners + "f 1 2 3 \\", "line 6: a backslash at the end"},
                          {kCorners + "f 1 2 \\\n\n3\n", "line 6: a backslash at the end, but nothing on the next line"},
                          {kCorners + "f 1 2 \\ \n3\n", "'\\' is not a corner"},
                          {kCorners + std::string(1, '\0'), "zero byte"}});
}

TEST(ReadObj, RefusesAByteOrderMarkThatOthersLoseALineBy) {
  expectRefused("a.obj", {{"\xEF\xBB\xBF" + kCorners + "f 1 2 3\n", "begins with a byte order mark"}});
}

TEST(ReadObj, StopsWhenCancelled) {
  RunControl control;
  control.cancel();
  EXPECT_THROW(readHere(kCorners + "f 1 2 3\n", "a.obj", {}, control), Error);
}

}  // namespace
}  // namespace collision_hulls
