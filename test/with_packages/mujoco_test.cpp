// MuJoCo loads what --for mujoco writes, and a ball comes to rest in the hook: with its mesh alone it would rest on the mesh's hull.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <memory>

#include "with_packages/written.h"

namespace collision_hulls {
namespace {

struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Model = std::unique_ptr<mjModel, Free>;

Model load(const std::string& file) {
  char error[1000] = "";
  Model model(mj_loadXML(file.c_str(), nullptr, error, sizeof error));
  EXPECT_TRUE(model) << file << ": " << error;
  return model;
}

class Mujoco : public ::testing::Test {
 protected:
  /// [m] where a ball of 2 cm radius comes to rest that falls along -y, above `body`: what a <worldbody> holds.
  double restingHeight(const std::string& head, const std::string& body) {
    // Rolling friction, or it rolls along the hook and off its end.
    const std::string ball =
        "<body name=\"ball\" pos=\"0.05 0.15 0.015\"><freejoint/>"
        "<geom type=\"sphere\" size=\"0.02\" mass=\"0.1\" condim=\"6\" friction=\"1 0.01 0.01\"/></body>";
    const std::string scene =
        fixtures::write(folder_ / "out/mjcf/scene.xml", "<mujoco><option gravity=\"0 -9.81 0\" timestep=\"0.001\"/>" + head +
                                                            "<worldbody>" + body + ball + "</worldbody></mujoco>");
    const Model model = load(scene);
    if (!model) return 0;
    const std::unique_ptr<mjData, Free> data(mj_makeData(model.get()));
    for (int step = 0; step < 3000; ++step) mj_step(model.get(), data.get());
    const int ball_body = mj_name2id(model.get(), mjOBJ_BODY, "ball");
    return data->xpos[3 * ball_body + 1];
  }

  fixtures::TempFolder folder_;
};

/// The hook's floor is 2 cm high and its prongs 8 cm.
TEST_F(Mujoco, ABallRestsInTheHook) {
  const std::string consumer = DEMO_ROBOT "/test/consumer";
  ASSERT_TRUE(fixtures::writeFor("mujoco", consumer + "/urdf/hook.urdf", folder_ / "out",
                                 "-t 1mm --package-path 'collision_hulls_consumer=" + consumer + "' --quiet"));
  EXPECT_NEAR(restingHeight("<include file=\"hook.xml\"/>", ""), 0.04, 0.001);
  const std::string mesh = "<asset><mesh name=\"hook\" file=\"" + consumer + "/meshes/hook.obj\"/></asset>";
  EXPECT_NEAR(restingHeight(mesh, "<geom type=\"mesh\" mesh=\"hook\"/>"), 0.1, 0.01);
}

TEST_F(Mujoco, LoadsTheDemoRobotAsItIsDescribed) {
  ASSERT_TRUE(fixtures::writeFor("mujoco", DEMO_ROBOT "/urdf/demo_arm.urdf", folder_ / "out",
                                 std::string("--package-path '" DEMO_ROBOT "'") + fixtures::kQuick));
  const Model model = load(folder_ / "out/mjcf/demo_arm.xml");
  ASSERT_TRUE(model);
  EXPECT_EQ(model->njnt, 8);
  const int base = mj_name2id(model.get(), mjOBJ_BODY, "base_link"), joint = mj_name2id(model.get(), mjOBJ_JOINT, "shoulder_pan_joint");
  ASSERT_GE(base, 0);
  ASSERT_GE(joint, 0);
  EXPECT_NEAR(model->body_mass[base], 2.7, 1e-9);
  EXPECT_NEAR(model->jnt_range[2 * joint + 1], 2.96, 1e-9);
  EXPECT_GE(mj_name2id(model.get(), mjOBJ_GEOM, "base_0"), 0);
  EXPECT_GT(model->nexclude, 0);
  const std::unique_ptr<mjData, Free> data(mj_makeData(model.get()));
  mj_forward(model.get(), data.get());
  EXPECT_EQ(data->ncon, 0) << "neighbours touch, but that is no contact";
}

TEST_F(Mujoco, LoadsTheSharedRobots) {
  if (fixtures::sharedRobots().empty()) GTEST_SKIP() << "no robots beside the repository";
  for (const std::string& robot : fixtures::sharedRobots()) {
    const std::string out = folder_ / std::filesystem::path(robot).filename().string();
    if (!fixtures::writeFor("mujoco", robot, out, fixtures::kQuick)) continue;
    for (const auto& file : std::filesystem::directory_iterator(out + "/mjcf")) {
      const Model model = load(file.path().string());
      if (!model) continue;
      EXPECT_EQ(static_cast<std::size_t>(model->nmesh), fixtures::count(fixtures::read(file.path()), "<mesh ")) << robot;
      const std::string urdf = std::filesystem::directory_iterator(out + "/urdf")->path().string();
      EXPECT_EQ(static_cast<std::size_t>(model->ngeom), fixtures::collisions(urdf)) << robot;
    }
  }
}

}  // namespace
}  // namespace collision_hulls
