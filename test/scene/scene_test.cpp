#include "collision_hulls/scene/scene.h"

#include "base/roots.h"
#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

TEST(ReadScene, RejectsUnknownAndMissingFiles) {
  const TemporaryFolder folder;
  expectError(ErrorCode::kUnsupportedFormat, {"a.txt", ".scene", ".yaml"}, [&] { sceneOf(folder, "a.txt", "x"); });
  expectError(ErrorCode::kUnsupportedFormat, {".yaml"}, [&] { readScene("", noPackages()); });
  expectError(ErrorCode::kUnsupportedFormat, {"is a folder; give a scene file in it"}, [&] { readScene(folder.path(""), noPackages()); });
  for (const char* name : {"a.scene", "a.urdf", "a.sdf", "a.yaml", "a.stl"}) {
    expectError(ErrorCode::kFileNotFound, {name}, [&] { readScene(folder.path(name), noPackages()); });
  }
}

TEST(ReadScene, EmptyScenesMustBeExplicit) {
  const TemporaryFolder folder;
  EXPECT_TRUE(sceneOf(folder, "a.yaml", "bodies: []").bodies.empty());
  const auto expectNone = [&](const char* name, const char* text) {
    expectError(ErrorCode::kBadScene, {name, "without geometry", "bodies: []"}, [&] { sceneOf(folder, name, text); });
  };
  expectNone("a.scene", "name\n.\n");
  expectNone("a.urdf", "<robot name='r'><link name='a'/></robot>");
  expectNone("a.sdf", "<sdf version='1.6'><model name='m'><link name='l'/></model></sdf>");
}

TEST(ReadScene, OneMeshInPlace) {
  const TemporaryFolder folder;
  const Scene scene = sceneOf(folder, "table top.OBJ", kTriangleObj);
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.bodies[0].name, "table top");
  expectBox(scene.bodies[0], {0, 0, 0}, {1, 1, 0});
}

TEST(ReadScene, Urdf) {
  const TemporaryFolder folder;
  folder.write("t.obj", kTriangleObj);
  const Scene scene = sceneOf(folder, "cell.urdf", R"(<robot name="cell"><link name="world"/>
    <link name="table"><visual><geometry><sphere radius="9"/></geometry></visual>
      <collision><origin xyz="0 0 1"/><geometry><box size="1 2 0.5"/></geometry></collision>
      <collision><geometry><cylinder radius="0.1" length="2"/></geometry></collision></link>
    <link name="seen"><visual><geometry><mesh filename="t.obj" scale="2 2 2"/></geometry></visual></link>
    <joint name="a" type="fixed"><parent link="world"/><child link="table"/><origin xyz="1 0 0"/></joint>
    <joint name="b" type="prismatic"><parent link="table"/><child link="seen"/><axis xyz="0 0 1"/>
      <limit lower="3" upper="4" effort="1" velocity="1"/></joint></robot>)");
  EXPECT_EQ(scene.name, "cell");
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[0].name, "table/1");
  expectBox(scene.bodies[0], {0.5, -1, 0.75}, {1.5, 1, 1.25});
  EXPECT_EQ(scene.bodies[1].name, "table/2");
  EXPECT_EQ(scene.bodies[2].name, "seen");
  expectBox(scene.bodies[2], {1, 0, 3}, {3, 2, 3});
}

TEST(ReadScene, UrdfErrorsNameTheLink) {
  const TemporaryFolder folder;
  const auto link = [](const std::string& geometry) {
    return "<robot name='r'><link name='shelf'><collision><geometry>" + geometry + "</geometry></collision></link></robot>";
  };
  expectError(ErrorCode::kBadScene, {"'shelf'", "a box"}, [&] { sceneOf(folder, "a.urdf", link("<box size='1 0 1'/>")); });
  expectError(ErrorCode::kFileNotFound, {"'shelf'", "no.stl"}, [&] { sceneOf(folder, "a.urdf", link("<mesh filename='no.stl'/>")); });
  expectError(ErrorCode::kNotXml, {"a.urdf"}, [&] { sceneOf(folder, "a.urdf", "<robot"); });
}

TEST(ReadScene, NamesTheFilesThatItWasReadFrom) {
  const TemporaryFolder folder;
  const std::string mesh = folder.write("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(sceneOf(folder, "a.yaml", "bodies:\n- {name: part, mesh: part.obj}\n").files, std::vector<std::string>{mesh});
  const std::string collision = "<collision name='c'><geometry><mesh><uri>part.obj</uri></mesh></geometry></collision>";
  const std::string world = "<sdf version='1.7'><model name='m'><link name='l'>" + collision + "</link></model></sdf>";
  EXPECT_EQ(sceneOf(folder, "a.sdf", world).files, (std::vector<std::string>{mesh, folder.path("a.sdf")}));
  EXPECT_EQ(sceneOf(folder, "a.urdf",
                    "<robot name='r'><link name='a'><collision><geometry><mesh filename='part.obj'/></geometry>"
                    "</collision></link></robot>")
                .files,
            std::vector<std::string>{mesh});
}

TEST(ReadScene, NamesThatMessagesCannotRepeat) {
  const TemporaryFolder folder;
  const auto body = [](const std::string& name) { return "bodies:\n- {name: \"" + name + "\", sphere: 1}\n"; };
  expectError(ErrorCode::kBadScene, {"a body", "'a?[2Jb'", "control character"}, [&] { sceneOf(folder, "a.yaml", body("a\\e[2Jb")); });
  expectError(ErrorCode::kBadScene, {"a body", "longer than 1000"}, [&] { sceneOf(folder, "a.yaml", body(std::string(1001, 'a'))); });
  expectError(ErrorCode::kBadScene, {"the scene", "control character"},
              [&] { sceneOf(folder, "a.scene", "a\x1b[2Jb\n* s\n1\nsphere\n1\n0 0 0\n0 0 0 1\n0 0 0 0\n.\n"); });
}

TEST(AddBody, RefusesMoreThanASceneCanUse) {
  Scene scene;
  scene.bodies.resize(100'000);
  expectError(ErrorCode::kTooLarge, {"more than 100000 bodies"}, [&] {
    SceneBody body{"one", {}, {}};
    setShape(body, "sphere", {1});
    addBody(scene, body);
  });
}

TEST(ReadScene, CancelledAtOnce) {
  const TemporaryFolder folder;
  RunControl control;
  control.cancel();
  for (const char* name : {"a.yaml", "a.sdf", "a.scene", "a.bt", "a.urdf", "a.obj"})
    expectError(ErrorCode::kCancelled, {}, [&] { readScene(folder.write(name, "x"), noPackages(), {}, control); });
}

TEST(ReadScene, XacroIsCodeThatNoRequestMayBring) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.xacro", "<robot/>");
  const Confinement confinement({{folder.path("")}, {}, {}, {}, "", ""});
  expectError(ErrorCode::kOutsideRoots, {"a.xacro", "xacro FILE.xacro > FILE.urdf"}, [&] { readScene(file, noPackages()); });
}

}  // namespace
}  // namespace collision_hulls
