#include <set>

#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

TEST(YamlScene, EveryShape) {
  const TemporaryFolder folder;
  folder.write("meshes/t.obj", kTriangleObj);
  const Scene scene = sceneOf(folder, "a.yaml", R"(# a cell
name: cell
bodies:
- {name: table, box: [1, 2, 0.5], pose: {xyz: [1, 0, 0.25], rpy: [0, 0, 1.5707963267948966]}}
- {name: ball, sphere: 0.5}
- name: can
  cylinder: [0.5, 2]
  pose: {quaternion: [0.7071067811865476, 0, 0, 0.7071067811865476]}
- {name: tip, cone: [1, 1]}
- {name: floor, plane: [0, 0, 1, 0], pose: {xyz: [0, 0, -1]}}
- {name: part, mesh: meshes/t.obj, scale: [2, 1, 1]}
)");
  EXPECT_EQ(scene.name, "cell");
  ASSERT_EQ(scene.bodies.size(), 6u);
  expectBox(scene.bodies[0], {0, -0.5, 0}, {2, 0.5, 0.5});
  EXPECT_NEAR(boxOf(scene.bodies[1]).max().x(), 0.5, 0.5 * SceneBody::kRoundness);
  EXPECT_NEAR(boxOf(scene.bodies[2]).max().y(), 1, 1e-9) << "lies along y";
  EXPECT_NEAR(boxOf(scene.bodies[3]).max().z(), 0.5, 1e-12);
  EXPECT_NEAR(boxOf(scene.bodies[4]).max().z(), -1, 1e-12);
  expectBox(scene.bodies[5], {0, 0, 0}, {2, 1, 0});
}

TEST(YamlScene, IsCalledAsItsFileUnlessItHasAName) {
  const TemporaryFolder folder;
  EXPECT_EQ(sceneOf(folder, "kitchen.yaml", "bodies: []").name, "kitchen");
  EXPECT_EQ(sceneOf(folder, "kitchen.yaml", "name: cell\nbodies: []").name, "cell");
}

TEST(YamlScene, MeshesInPackages) {
  const TemporaryFolder folder;
  folder.write("cell/meshes/t.obj", kTriangleObj);
  const PackageFinder finder = [&](const std::string& name) { return name == "cell" ? std::optional(folder.path("cell")) : std::nullopt; };
  const std::string file = folder.write("a.yml", "bodies:\n- {name: a, mesh: 'package://cell/meshes/t.obj'}");
  EXPECT_EQ(readScene(file, finder).bodies.size(), 1u);
  const TemporaryFolder elsewhere;  // packages beside the scene are found without a finder's help
  const std::string alone = elsewhere.write("a.yml", "bodies:\n- {name: a, mesh: 'package://cell/meshes/t.obj'}");
  expectError(ErrorCode::kPackageNotFound, {"line 2", "'a'", "cell"}, [&] { readScene(alone, noPackages()); });
}

TEST(YamlScene, TakesAllBodiesOfOtherFiles) {
  const TemporaryFolder folder;
  folder.write("rooms/t.obj", kTriangleObj);
  folder.write("rooms/hall.yaml", "bodies:\n- {name: step, box: [1, 1, 1], pose: {xyz: [0, 0, 2]}}\n- {name: part, mesh: t.obj}");
  folder.write("cell.urdf",
               "<robot name='cell'><link name='table'><collision><geometry><box size='1 1 1'/></geometry></collision></link></robot>");
  folder.write("b.yaml", "bodies:\n- {name: desk, scene: cell.urdf, pose: {xyz: [0, 5, 0]}}");
  const Scene scene = sceneOf(folder, "a.yaml", R"(bodies:
- {name: home, scene: rooms/hall.yaml, pose: {xyz: [1, 0, 0], rpy: [1.5707963267948966, 0, 0]}}
- {name: desk, scene: cell.urdf, pose: {xyz: [0, 5, 0]}}
- {name: again, scene: b.yaml, pose: {xyz: [0, 0, 10]}}
)");
  ASSERT_EQ(scene.bodies.size(), 4u);
  EXPECT_EQ(scene.bodies[0].name, "home/step");
  expectBox(scene.bodies[0], {0.5, -2.5, -0.5}, {1.5, -1.5, 0.5});
  EXPECT_EQ(scene.bodies[1].name, "home/part") << "its path is relative to the file that names it";
  EXPECT_EQ(scene.bodies[2].name, "desk/table");
  expectBox(scene.bodies[2], {-0.5, 4.5, -0.5}, {0.5, 5.5, 0.5});
  EXPECT_EQ(scene.bodies[3].name, "again/desk/table");
  expectBox(scene.bodies[3], {-0.5, 4.5, 9.5}, {0.5, 5.5, 10.5});
  const std::set<std::string> read(scene.files.begin(), scene.files.end());
  for (const char* const name : {"rooms/hall.yaml", "rooms/t.obj", "cell.urdf", "b.yaml"})
    EXPECT_TRUE(read.count(folder.path(name))) << name;
}

TEST(YamlScene, OtherFilesThatFailAreNamed) {
  const TemporaryFolder folder;
  const auto expectBad = [&](ErrorCode code, const std::vector<std::string>& parts, const std::string& bodies) {
    expectError(code, parts, [&] { sceneOf(folder, "a.yaml", "bodies:\n" + bodies); });
  };
  folder.write("bad.yaml", "bodies:\n- {name: ball, sphere: -1}");
  folder.write("t.txt", kTriangleObj);
  folder.write("good.yaml", "bodies:\n- {name: ball, sphere: 1}");
  expectBad(ErrorCode::kBadScene, {"a.yaml", "line 2, body 'room'", "bad.yaml", "'ball'", "-1"}, "- {name: room, scene: bad.yaml}");
  expectBad(ErrorCode::kFileNotFound, {"a.yaml", "'room'", "none.yaml"}, "- {name: room, scene: none.yaml}");
  expectBad(ErrorCode::kUnsupportedFormat, {"a.yaml", "'room'", "unknown scene format"}, "- {name: room, scene: t.txt}");
  expectBad(ErrorCode::kBadScene, {"a scene has no scale; remove it"}, "- {name: room, scene: good.yaml, scale: [2, 2, 2]}");
  expectBad(ErrorCode::kBadScene, {"good.yaml", "body 'room/ball' appears twice"},
            "- {name: room/ball, sphere: 1}\n- {name: room, scene: good.yaml}");
  expectBad(ErrorCode::kBadScene, {"line 2, body 'room': '", "a.yaml' contains itself that way"}, "- {name: room, scene: a.yaml}");
  expectBad(ErrorCode::kBadScene, {"line 2", "has no name"}, "- {name: '', scene: good.yaml}");
}

TEST(YamlScene, MeshesOfOtherFilesCountForItsLimit) {
  const TemporaryFolder folder;
  folder.write("t.obj", kTriangleObj);
  const std::string file = folder.write("a.yaml", "bodies:\n- {name: a, scene: t.obj}\n- {name: b, scene: t.obj}");
  MeshLimits limits;
  limits.max_triangles = 2;
  EXPECT_EQ(readScene(file, noPackages(), limits).bodies.size(), 2u);
  limits.max_triangles = 1;
  expectError(ErrorCode::kTooLarge, {"line 3, body 'b'", "more than 1 triangles in all"}, [&] { readScene(file, noPackages(), limits); });
}

TEST(YamlScene, ScenesThatMultiplyEnd) {
  const TemporaryFolder folder;
  std::string many = "bodies:\n";
  for (int i = 0; i < 30; ++i) many += "- {name: '" + std::to_string(i) + "', scene: NEXT}\n";
  for (int level = 0; level < 4; ++level) {
    std::string text = many;
    for (std::size_t at = 0; (at = text.find("NEXT", at)) != std::string::npos;) text.replace(at, 4, std::to_string(level + 1) + ".yaml");
    folder.write(std::to_string(level) + ".yaml", text);
  }
  folder.write("4.yaml", "bodies: []");
  expectError(ErrorCode::kBadScene, {"more than 1,000 scenes within scenes"}, [&] { readScene(folder.path("0.yaml"), noPackages()); });
}

TEST(YamlScene, ErrorsNameTheFaultAndTheLine) {
  const TemporaryFolder folder;
  const auto expectBad = [&](const std::vector<std::string>& parts, const std::string& text) {
    expectError(ErrorCode::kBadScene, parts, [&] { sceneOf(folder, "a.yaml", text); });
  };
  const auto body = [](const std::string& text) { return "bodies:\n- {" + text + "}\n"; };
  expectBad({"a.yaml", "bodies: []"}, "");
  expectBad({"bodies: []"}, "- a");
  expectBad({"line 2", "not valid YAML"}, "bodies: [\n}");
  expectBad({"line 3", "second document"}, "bodies: []\n---\nbodies: []\n");
  EXPECT_EQ("a", sceneOf(folder, "a.yaml", "---\nname: a\nbodies: []\n---\n").name);
  expectBad({"'boddies'", "bodies, name"}, "bodies: []\nboddies: []");
  expectBad({"list"}, "bodies: 3");
  expectBad({"list"}, "bodies:");
  expectBad({"line 2", "'name' is missing"}, body("box: [1, 1, 1]"));
  expectBad({"line 2", "one shape", "0"}, body("name: a"));
  expectBad({"line 2", "one shape", "2"}, body("name: a, sphere: 1, box: [1, 1, 1]"));
  expectBad({"line 2", "'size' is not known"}, body("name: a, size: 1"));
  expectBad({"'sphere' appears twice"}, body("name: a, sphere: 1, sphere: 2"));
  expectBad({"expected 3 numbers, found 2"}, body("name: a, box: [1, 1]"));
  expectBad({"'one'"}, body("name: a, box: [1, 1, one]"));
  expectBad({"'.nan'"}, body("name: a, sphere: .nan"));
  expectBad({"line 2", "'a'", "a sphere of 0"}, body("name: a, sphere: 0"));
  expectBad({"only a mesh"}, body("name: a, sphere: 1, scale: [1, 1, 1]"));
  expectBad({"not both"}, body("name: a, sphere: 1, pose: {rpy: [0, 0, 0], quaternion: [0, 0, 0, 1]}"));
  expectBad({"line 2", "more than a whole turn; give radians"}, body("name: a, sphere: 1, pose: {rpy: [0, 0, 90]}"));
  expectBad({"length 2"}, body("name: a, sphere: 1, pose: {quaternion: [0, 0, 0, 2]}"));
  expectBad({"line 3", "'a'", "twice"}, body("name: a, sphere: 1") + "- {name: a, sphere: 2}");
  expectError(ErrorCode::kBadScale, {"'a'"}, [&] {
    folder.write("t.obj", kTriangleObj);
    sceneOf(folder, "a.yaml", body("name: a, mesh: t.obj, scale: [0, 1, 1]"));
  });
}

TEST(YamlScene, ErrorsNameTheBodyAndTheField) {
  const TemporaryFolder folder;
  const auto expectBad = [&](const std::vector<std::string>& parts, const std::string& body) {
    expectError(ErrorCode::kBadScene, parts, [&] { sceneOf(folder, "a.yaml", "bodies:\n- {name: first, sphere: 1}\n- " + body + "\n"); });
  };
  expectBad({"line 3, body 'a', box: expected 3 numbers, found 2"}, "{name: a, box: [1, 1]}");
  expectBad({"line 3, body 'a', box: ", "'one'"}, "{name: a, box: [1, 1, one]}");
  expectBad({"line 3, body 'a', sphere: expected a single value"}, "{name: a, sphere: [1]}");
  expectBad({"line 3, body 'a', scale: expected a list of 3 numbers"}, "{name: a, mesh: t.obj, scale: 2}");
  expectBad({"line 3, body 'a', pose, xyz: expected 3 numbers, found 1"}, "{name: a, sphere: 1, pose: {xyz: [1]}}");
  expectBad({"line 3, body 'a', pose, quaternion: ", "length 2"}, "{name: a, sphere: 1, pose: {quaternion: [0, 0, 0, 2]}}");
  expectBad({"line 3, body 'a', pose: expected a map, such as {xyz: "}, "{name: a, sphere: 1, pose: [0, 0, 1]}");
  expectBad({"line 3, body 'a': a sphere of 0 m"}, "{name: a, sphere: 0}");
  expectBad({"line 3, body 2: 'name' is missing"}, "{box: [1, 1, 1]}");
  expectBad({"line 3, body 2, name: "}, "{name: [a], box: [1, 1, 1]}");
  expectBad({"line 3, body 2: expected a map"}, "box");
  expectBad({"line 3: body 'first' appears twice"}, "{name: first, sphere: 2}");
}

TEST(YamlScene, AKeyThatIsAlmostKnownIsSuggested) {
  const TemporaryFolder folder;
  const auto expectBad = [&](const std::vector<std::string>& parts, const std::string& text) {
    expectError(ErrorCode::kBadScene, parts, [&] { sceneOf(folder, "a.yaml", text); });
  };
  expectBad({"body 'a': 'poes' is not known here", "did you mean 'pose'?"}, "bodies: [{name: a, sphere: 1, poes: {}}]");
  expectBad({"body 'a', pose: 'xyzs' is not known here", "did you mean 'xyz'?"}, "bodies: [{name: a, sphere: 1, pose: {xyzs: [0, 0, 0]}}]");
  expectBad({"'frame_id' is not known here: all poses of a scene are in the frame of the robot's root link", "scene: cell.yaml"},
            "frame_id: a\nbodies: []");
  expectBad({"'boddies' is not known here", "did you mean 'bodies'?"}, "boddies: []");
}

TEST(YamlScene, AliasesAndBracketsDoNotBlowUp) {
  const TemporaryFolder folder;
  std::string text = "x0: &x0 [1, 1]\n";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "*x" + std::to_string(i - 1);
    text += "x" + std::to_string(i) + ": &x" + std::to_string(i) + " [" + before + ", " + before + "]\n";
  }
  expectError(ErrorCode::kBadScene, {"aliases"}, [&] { sceneOf(folder, "a.yaml", text + "bodies: *x39"); });
  expectError(ErrorCode::kBadScene, {"a.yaml", "brackets"}, [&] { sceneOf(folder, "a.yaml", "bodies: " + std::string(100000, '[')); });
}

}  // namespace
}  // namespace collision_hulls
