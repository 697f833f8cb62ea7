#include <gtest/gtest.h>

#include "../reading.h"

namespace collision_hulls {
namespace {

using namespace test_files;

const std::string kData = "0 0 0\n1 0 0\n1 2 0\n3 0 1 2\n";
const std::vector<Eigen::Vector3d> kFirst{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}};
const std::vector<Triangle> kOne{{0, 1, 2}};

TEST(ReadOff, Headers) {
  for (const char* header : {"OFF\n3 1 0\n", "OFF 3 1 0\n", "3 1 0\n", "OFF\n3 1\n", "OFF3 1 0\n",
                             "# note\n\nOFF # here\n# there\n3 1 3 # and here\n", "\xEF\xBB\xBFOFF\r\n3 1 0\r\n", "OFF\r3 1 0\r"})
    expectMesh("a.off", header + kData, kFirst, kOne);
}

TEST(ReadOff, WhatFollowsTheCoordinatesIsSkipped) {
  expectMesh("a.off", "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0.5 0.5 0.5\n1 2 0 7\n3 0 1 2 255 0 0\n", kFirst, kOne);
  expectMesh("a.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 2 0 0 0 1\n3 0 1 2\n", kFirst, kOne);
  expectMesh("a.off", "STCNOFF\n3 1 0\n0 0 0 1 1\n1 0 0 1 1\n1 2 0 1 1\n3 0 1 2\n", kFirst, kOne);
}

TEST(ReadOff, BlankLinesAndCommentsAnywhere) {
  expectMesh("a.off", "OFF\n3 1 0\n\n0 0 0\n  \n# two\n1 0 0 # here\n1 2 0\n\t\n3 0 1 2\n# the end\n\n", kFirst, kOne);
}

TEST(ReadOff, PolygonsOfAnySize) {
  std::string text = "OFF\n12 1 0\n", face = "12";
  for (int i = 0; i < 12; ++i) {
    text += std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    face += " " + std::to_string(i);
  }
  EXPECT_EQ(readHere(text + face, "a.off").mesh.triangles.size(), 10u);
}

TEST(ReadOff, VerticesAreSharedInTheOrderOfTheirFirstUse) {
  const LoadedMesh loaded = readHere("OFF\n5 4 0\n9 9 nan\n0 0 0\n1 0 0\n1 2 0\n0 0 3\n3 4 3 2\n3 2 1 4\n2 1 2\n1 0\n", "a.off");
  EXPECT_EQ(loaded.mesh.vertices, (std::vector<Eigen::Vector3d>{{0, 0, 3}, {1, 2, 0}, {1, 0, 0}, {0, 0, 0}}));
  EXPECT_EQ(loaded.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 3, 0}}));
  EXPECT_EQ(loaded.skipped_primitives, 2u);
  EXPECT_EQ(loaded.submeshes, 1);
}

TEST(ReadOff, RefusesNumbersThatOthersGuess) {
  for (const std::string& word : misspeltNumbers()) {
    const std::string part = "line 4: '" + word + "' is not a number";
    expectRefused("a.off", {{"OFF\n3 1 0\n0 0 0\n1 " + word + " 0\n1 2 0\n3 0 1 2\n", part},
                            {"OFF\n3 1 0\n0 0 0\n1 0 0 " + word + "\n1 2 0\n3 0 1 2\n", part}});
  }
}

TEST(ReadOff, RefusesHeadersThatOthersGuess) {
  for (const char* header :
       {"OFF\n3\n1\n0\n", "OFF\n3 1 0 7\n", "OFF\n-3 1 0\n", "OFF\n3 1.0 0\n", "OFF\n", "off\n3 1 0\n", "OFF\n0x3 1 0\n", ""})
    expectRefused("a.off", {{header + std::string("# rest\n"), "does not begin with 'OFF'"}});
  expectRefused("a.off", {{std::string("COFF BINARY\n\0\0\0\3", 16), "binary OFF"},
                          {"4OFF\n3 1 0\n" + kData, "'4OFF' is not supported"},
                          {"nOFF\n3\n", "'nOFF'"}});
}

TEST(ReadOff, RefusesCountsThatTheDataDoesNotBack) {
  expectRefused("a.off",
                {{"OFF\n3 2 0\n" + kData, "announces 3 vertices and 2 faces, but ends after 4 lines"},
                 {"OFF\n2 1 0\n" + kData, "line 5 names vertex 2, but there are 2", ErrorCode::kIndexOutOfRange},
                 {"OFF\n2 1 0\n0 0 0\n1 0 0\n0.5 2 0\n3 0 1 2\n", "line 5: a face begins with its number of corners, not with '0.5'"},
                 {"OFF\n3 1 0\n" + kData + "3 2 1 0\n", "line 7: more than the 1 faces"},
                 {"OFF\n4000000000 1 0\n" + kData, "but has only"},
                 {"OFF\n3 4000000 0\n" + kData, "but has only"},
                 {"OFF\n3 0 0\n0 0 0\n1 0 0\n1 2 0\n", "3 vertices and 0 faces", ErrorCode::kEmptyMesh}});
  expectRefused("a.off", {{"OFF\n3 1 0\n0 0 0\n1 0 0\n1 2\n3 0 1 2\n", "line 5: a number is missing"},
                          {"OFF\n3 1 0\n0 0 0\n1 0 0\n1 2 0\n4 0 1 2\n", "line 6: the face has fewer corners"},
                          {"OFF\n3 1 0\n0 0 0\n1 0 0\n1 2 0\n0\n", "line 6: a face begins with its number of corners, not with '0'"},
                          {"OFF\n3 1 0\n0 0 0\n1 0 0\n1 2 0\n3 0 1 x\n", "line 6: 'x' is not an index"}});
}

TEST(ReadOff, RefusesIndicesOutOfRange) {
  for (const char* word : {"3", "-1", "4294967297"})
    expectRefused("a.off", {{"OFF\n3 1 0\n0 0 0\n1 0 0\n1 2 0\n3 0 1 " + std::string(word) + "\n",
                             "line 6 names vertex " + std::string(word) + ", but there are 3", ErrorCode::kIndexOutOfRange}});
}

}  // namespace
}  // namespace collision_hulls
