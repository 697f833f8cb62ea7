#include "bench/inputs.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

class Inputs : public ::testing::Test {
 protected:
  Inputs() {
    for (const char* file : {"meshes/b.obj", "meshes/a.obj", "meshes/deep/c.OBJ", "arm/meshes/d.obj"})
      fixtures::write(folder_ / file, fixtures::obj(test_shapes::box(1, 1, 1)));
    fixtures::write(folder_ / "meshes/readme.txt", "no mesh");
    fixtures::write(folder_ / "arm/package.xml", "<package format=\"2\"><name>arm</name></package>");
    const auto part = [](const std::string& more) {
      return "<collision>" + fixtures::meshTag("package://arm/meshes/d.obj", more) + "</collision>";
    };
    fixtures::write(folder_ / "arm/urdf/arm.urdf",
                    fixtures::robot("arm", fixtures::link("base", part("")) + fixtures::link("left", part(" scale=\"2 2 2\""), "base") +
                                               fixtures::link("right", part(""), "base")));
  }
  std::vector<std::string> names(const std::vector<std::string>& inputs) {
    std::vector<std::string> result;
    for (const BenchmarkMesh& mesh : benchmarkMeshes(inputs)) result.push_back(mesh.name);
    return result;
  }
  fixtures::TempFolder folder_;
};

using Names = std::vector<std::string>;

TEST_F(Inputs, InputWithoutMeshesIsAnError) {
  std::filesystem::create_directories(folder_ / "empty");
  EXPECT_THROW(benchmarkMeshes({folder_ / "empty"}), Error);
  EXPECT_THROW(benchmarkMeshes({folder_ / "missing.obj"}), Error);
  EXPECT_THROW(benchmarkMeshes({folder_ / "meshes/readme.txt"}), Error);
}

TEST_F(Inputs, SortsAFolder) {
  EXPECT_EQ(names({folder_ / "meshes"}), (Names{"a.obj", "b.obj", "deep/c.OBJ"}));
}

TEST_F(Inputs, RobotContributesEachMeshOncePerScale) {
  const std::vector<BenchmarkMesh> meshes = benchmarkMeshes({folder_ / "arm/urdf/arm.urdf"});
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].name, "arm/d.obj");
  EXPECT_EQ(meshes[0].scale, Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(meshes[1].name, "arm/d.obj#2");
  EXPECT_EQ(meshes[1].scale, Eigen::Vector3d(2, 2, 2));
}

TEST_F(Inputs, SubjectsOfQueries) {
  const BenchmarkInputs inputs = benchmarkInputs({folder_ / "meshes/a.obj", folder_ / "arm/urdf/arm.urdf"});
  ASSERT_EQ(inputs.subjects.size(), 2u);
  EXPECT_EQ(inputs.subjects[0].name, "a.obj");
  EXPECT_TRUE(inputs.subjects[0].robot.links.empty());
  const QuerySubject& arm = inputs.subjects[1];
  ASSERT_EQ(arm.parts.size(), 3u) << "a mesh shared by two links is two parts";
  EXPECT_EQ(arm.parts[0].mesh, 1u);
  EXPECT_EQ(arm.parts[1].link, 2u);
  EXPECT_EQ(arm.parts[1].mesh, 1u);
  EXPECT_EQ(arm.parts[2].link, 1u);
  EXPECT_EQ(arm.parts[2].mesh, 2u);
}

TEST_F(Inputs, FolderOfPackagesContributesRobots) {
  EXPECT_EQ(names({folder_.path().string()}), (Names{"arm/d.obj", "arm/d.obj#2", "meshes/a.obj", "meshes/b.obj", "meshes/deep/c.OBJ"}));
}

TEST_F(Inputs, NamesAreUnique) {
  EXPECT_EQ(names({folder_ / "meshes/a.obj", folder_ / "meshes/a.obj"}), (Names{"a.obj", "a.obj#2"}));
}

TEST_F(Inputs, MissingMeshStaysInTheList) {
  fixtures::write(folder_ / "arm/urdf/arm.urdf",
                  fixtures::robot("arm", fixtures::link("base", "<collision>" + fixtures::meshTag("gone.stl") + "</collision>")));
  EXPECT_EQ(names({folder_ / "arm/urdf/arm.urdf"}), (Names{"arm/base"}));
}

}  // namespace
}  // namespace collision_hulls
