#include <gtest/gtest.h>

#include <cctype>

#include "../files.h"
#include "../reading.h"

namespace collision_hulls {
namespace {

using namespace test_files;

const std::string kFacet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 2 0\nendloop\nendfacet\n";
const std::vector<Eigen::Vector3d> kFirst{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}};
const std::vector<Triangle> kOne{{0, 1, 2}};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(ReadStl, EveryWayToWriteText) {
  for (const char* frame : {"solid\n%endsolid\n", "solid a facet in its name\n%endsolid a\n", "\n solid x\n%endsolid",
                            "solid x\r\n%endsolid x\r\n", "solid x\r%endsolid x\r", "solid none\nendsolid none\nsolid x\n%endsolid x\n"}) {
    const std::string text(frame);
    expectMesh("a.stl", replaced(text, "%", kFacet), kFirst, kOne);
  }
  std::string one_line = "solid x\n" + kFacet;
  for (std::size_t i = 8; i < one_line.size(); ++i)
    if (one_line[i] == '\n') one_line[i] = ' ';
  expectMesh("a.stl", one_line + "\nendsolid x", kFirst, kOne);
  std::string capitals = "solid x\n" + kFacet + "endsolid x\n";
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  expectMesh("a.stl", capitals, kFirst, kOne);
}

TEST(ReadStl, NormalsDoNotMatter) {
  for (const char* normal : {"nan nan nan", "-nan(ind) 0 0", "0,0 0 1"})
    expectMesh("a.stl", "solid x\n" + replaced(kFacet, "0 0 1", normal) + "endsolid x\n", kFirst, kOne);
}

TEST(ReadStl, RefusesNumbersThatOthersGuess) {
  for (const std::string& word : misspeltNumbers())
    expectRefused("a.stl", {{"solid x\n" + replaced(kFacet, "vertex 1 0", "vertex 1 " + word) + "endsolid x\n",
                             "line 5: '" + word + "' is not a number"}});
  expectRefused("a.stl", {{"solid x\n" + replaced(kFacet, "vertex 1 0", "vertex 1 1e39") + "endsolid x\n", "vertex 1 (of face 0",
                           ErrorCode::kNonFiniteCoordinate}});
}

TEST(ReadStl, RefusesTextThatOthersSkip) {
  struct Case {
    std::string from, to, part;
  };
  for (const Case& c : {Case{"outer loop\n", "", "line 3: expected 'outer', found 'vertex'"},
                        {"normal 0 0 1", "normal 0 0", "expected 'outer', found 'loop'"},
                        {"vertex 1 0 0\n", "", "facet 1 has 2 vertices instead of 3"},
                        {"endloop", "vertex 1 1 1\nendloop", "facet 1 has 4 vertices instead of 3"},
                        {"vertex 1 0 0", "vertex 1 0 0 0", "line 5: expected 'endloop', found '0'"},
                        {"vertex 1 0 0", "vertex 1 0", "line 6: 'vertex' is not a number"},
                        {"endfacet\n", "", "line 8: expected 'endfacet', found 'endsolid'"},
                        {"facet normal", "COLOR= 1 1 1\nfacet normal", "line 2: expected 'endsolid', found 'COLOR='"}})
    expectRefused("a.stl", {{"solid x\n" + replaced(kFacet, c.from, c.to) + "endsolid x\n", c.part}});
  expectRefused("a.stl", {{"solid x\n" + kFacet, "without 'endsolid' at its end, cut off after facet 1"},
                          {"solid x\n" + kFacet + "endsolid x\n" + kFacet, "expected 'solid', found 'facet'"},
                          {"solid x\nendsolid x\n", "no triangle", ErrorCode::kEmptyMesh}});
}

TEST(ReadStl, TheSizeTellsBinaryFromText) {
  expectMesh("a.stl", binaryStl("solid x", 1, 1), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, kOne);
  expectRefused("a.stl", {{binaryStl("solid x", 1, 1) + " ", "announces 1 triangles, which take 134 bytes, but it has 135"},
                          {binaryStl("", 0, 0), "0 triangles", ErrorCode::kEmptyMesh},
                          {"facet", "neither a text STL"}});
}

}  // namespace
}  // namespace collision_hulls
