// --for: files of a consumer beside the hulls, from the command line.
#include <gtest/gtest.h>

#include "shapes.h"
#include "tools/program_test.h"

namespace collision_hulls {
namespace {

class ForOption : public ProgramTest {
 protected:
  ForOption() : ProgramTest("decompose") {
    const std::string mesh = fixtures::write(folder_ / "cube.obj", fixtures::obj(test_shapes::box(0.1, 0.1, 0.1)));
    fixtures::write(folder_ / "r.urdf",
                    fixtures::robot("r", fixtures::link("a", "<collision>" + fixtures::meshTag(mesh) + "</collision>")));
  }
};

TEST_F(ForOption, WrongUse) {
  expectWrongUse("r.urdf --for moveit3", {"--for", "'moveit3'", "moveit, gazebo, mujoco, drake, isaac"});
  expectWrongUse("r.urdf --for moveit,mujoco", {"--for 'moveit,mujoco' is a list, and takes one name: repeat --for, as in"});
  expectWrongUse("r.urdf --for drake --format stl", {"--for drake", "format 'stl'", "leave the format out"});
  expectWrongUse("cube.obj --for gazebo", {"--for gazebo", "is a mesh"});
}

TEST_F(ForOption, SaysWhichFileEachConsumerLoads) {
  const std::string out = run("r.urdf --for mujoco --for drake --no-validate -o out").out;
  const std::size_t ros = out.find("urdf/r.urdf"), mujoco = out.find("\nFor mujoco: /"), drake = out.find("\nFor drake: /");
  ASSERT_NE(ros, std::string::npos) << out;
  EXPECT_LT(ros, mujoco) << out;
  EXPECT_LT(mujoco, drake) << out;
  EXPECT_NE(out.find("/out/urdf/r_drake.urdf", drake), std::string::npos) << out;
}

TEST_F(ForOption, WritesAndReplacesTheFiles) {
  const std::string rest = " --no-validate --quiet -o out";
  ASSERT_EQ(run("r.urdf --for mujoco --for gazebo" + rest).status, 0);
  for (const char* file : {"mjcf/r.xml", "model.sdf", "model.config"})
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / file)) << file;
  EXPECT_NE(fixtures::read(folder_ / "out/report.json").find("\"mjcf/r.xml\""), std::string::npos);
  ASSERT_EQ(run("r.urdf --for drake" + rest).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/meshes/a/0_0.obj")) << "Drake reads no STL";
  ASSERT_EQ(run("r.urdf --for moveit" + rest).status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/model.sdf"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/config/r.srdf"));
}

}  // namespace
}  // namespace collision_hulls
