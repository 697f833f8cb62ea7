// How a program treats meshes that its reader cannot read.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/sanitizer.h"
#include "mesh/files.h"
#include "shapes.h"
#include "tools/program_test.h"

namespace collision_hulls {
namespace {

class ReaderOptions : public ProgramTest {
 protected:
  ReaderOptions() : ProgramTest("decompose") {
    fixtures::write(folder_ / "bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
  }
};

TEST_F(ReaderOptions, LimitMemory) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer needs more memory than any limit";
  std::string corners;  // two characters each: no file takes more memory for its size
  for (int tetrahedron = 0; tetrahedron < 20'000; ++tetrahedron) corners += "0 2 1 0 1 4 1 2 4 2 0 4 ";
  const std::string triangles = "<triangles count=\"80000\">" + test_files::kVertexInput + "<p>" + corners + "</p></triangles>";
  const std::string scene = R"(<node><instance_geometry url="#shape"/></node>)";
  fixtures::write(folder_ / "wedge.dae", test_files::dae(test_files::unit("1"), triangles, scene));
  const Finished result = run("wedge.dae -m bounding_box --no-cache --reader-memory 1");
  EXPECT_EQ(result.status, 2);
  const std::uintmax_t limit = (1U << 20) + 40 * std::filesystem::file_size(folder_ / "wedge.dae");
  const std::string told = "reading it takes more memory than the limit of " + std::to_string(limit / 1'000'000) + " MB";
  EXPECT_NE(result.err.find(told), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("raise reader-memory"), std::string::npos) << result.err;
  EXPECT_EQ(run("wedge.dae -m bounding_box --no-cache --reader-memory 256 --reader-time 2").status, 0);
}

TEST_F(ReaderOptions, OutOfRange) {
  expectWrongUse("bracket.obj --reader-memory 0", {"reader-memory", "'0'", "1 to 1000000"});
  expectWrongUse("bracket.obj --reader-time 0", {"reader-time", "'0'", "1 to 1000000"});
}

TEST_F(ReaderOptions, MissingReaderIsNamed) {
  setenv("COLLISION_HULLS_READER", "/no/such/reader", 1);
  const Finished result = run("bracket.obj -m bounding_box --no-cache");
  const Finished version = run("--version");
  unsetenv("COLLISION_HULLS_READER");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("'/no/such/reader', cannot be started"), std::string::npos) << result.err;
  EXPECT_EQ(version.status, 0);
  EXPECT_NE(version.out.find("Meshes cannot be read: "), std::string::npos) << version.out;
}

}  // namespace
}  // namespace collision_hulls
