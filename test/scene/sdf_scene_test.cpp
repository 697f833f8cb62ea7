// SDF worlds and models: shapes, poses relative to any frame, includes, saved states, and everything that is refused.
// Also tests src/scene/sdf_frames.cpp.
#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

std::string collision(const std::string& geometry, const std::string& more = "") {
  return "<collision name='c'>" + more + "<geometry>" + geometry + "</geometry></collision>";
}

std::string model(const std::string& content) {
  return "<sdf version='1.7'><model name='m'>" + content + "</model></sdf>";
}

const std::string kBox = "<box><size>2 2 2</size></box>";

Eigen::Vector3d placeOfFirst(const TemporaryFolder& folder, const std::string& text) {
  return sceneOf(folder, "a.sdf", text).bodies.at(0).pose.translation();
}

TEST(SdfScene, WorldOfModels) {
  const TemporaryFolder folder;
  const Scene scene = sceneOf(folder, "a.world", R"(<?xml version="1.0"?><sdf version="1.6"><world name="lab">
    <light name="sun"/>
    <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal>
      <size>100 100</size></plane></geometry></collision></link></model>
    <model name="table"><pose>1 0 0 0 0 1.5707963267948966</pose><link name="top"><pose>0 0 1 0 0 0</pose>
      <collision name="a"><pose>0.5 0 0 0 0 0</pose><geometry><box><size>2 1 0.1</size></box></geometry></collision>
      <collision name="b"><geometry><cylinder><radius>0.1</radius><length>2</length></cylinder></geometry></collision>
      <visual name="v"><geometry><sphere><radius>9</radius></sphere></geometry></visual></link></model></world></sdf>)");
  EXPECT_EQ(scene.name, "lab");
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[0].name, "ground::l::c");
  EXPECT_NEAR(boxOf(scene.bodies[0]).max().z(), 0, 1e-12);
  EXPECT_EQ(scene.bodies[1].name, "table::top::a");
  expectBox(scene.bodies[1], {0.5, -0.5, 0.95}, {1.5, 1.5, 1.05});
}

TEST(SdfScene, OtherShapes) {
  const TemporaryFolder folder;
  const auto boxOfShape = [&](const std::string& geometry) {
    return boxOf(sceneOf(folder, "a.sdf", model("<link name='l'>" + collision(geometry) + "</link>")).bodies.at(0));
  };
  const double rounded = 1 + SceneBody::kRoundness;
  EXPECT_LE(boxOfShape("<sphere><radius>1</radius></sphere>").max().z(), rounded);
  EXPECT_NEAR(boxOfShape("<capsule><radius>1</radius><length>2</length></capsule>").max().z(), 2, SceneBody::kRoundness);
  EXPECT_NEAR(boxOfShape("<ellipsoid><radii>1 2 3</radii></ellipsoid>").max().z(), 3, 3 * SceneBody::kRoundness);
  EXPECT_NEAR(boxOfShape("<cone><radius>1</radius><length>2</length></cone>").max().z(), 1, 1e-12);
  folder.write("t.obj", kTriangleObj);
  EXPECT_NEAR(boxOfShape("<mesh><uri>t.obj</uri><scale>1 3 1</scale></mesh>").max().y(), 3, 1e-12);
  const std::string two = "<link name='l'>" + collision("<empty/>") + "</link><link name='k'>" + collision(kBox) + "</link>";
  EXPECT_EQ(sceneOf(folder, "a.sdf", model(two)).bodies.size(), 1u);
}

TEST(SdfScene, PosesRelativeToOtherFrames) {
  const TemporaryFolder folder;
  const std::string link = "<link name='a'><pose>1 0 0 0 0 0</pose></link>";
  const auto place = [&](const std::string& content) { return placeOfFirst(folder, model(link + content)); };
  EXPECT_TRUE(
      place("<link name='b'><pose relative_to='a'>0 1 0 0 0 0</pose>" + collision(kBox) + "</link>").isApprox(Eigen::Vector3d(1, 1, 0)));
  EXPECT_TRUE(place("<frame name='f' attached_to='a'><pose>0 0 2 0 0 0</pose></frame><link name='b'>" +
                    collision(kBox, "<pose relative_to='f'>0 0 1 0 0 0</pose>") + "</link>")
                  .isApprox(Eigen::Vector3d(1, 0, 3)));
  EXPECT_TRUE(place("<joint name='j' type='fixed'><parent>world</parent><child>a</child><pose>0 0 1 0 0 0</pose></joint>"
                    "<link name='b'><pose relative_to='j'/>" +
                    collision(kBox) + "</link>")
                  .isApprox(Eigen::Vector3d(1, 0, 1)));
  EXPECT_TRUE(place("<model name='n'><pose relative_to='a'>0 0 5 0 0 0</pose><link name='b'>" + collision(kBox) + "</link></model>")
                  .isApprox(Eigen::Vector3d(1, 0, 5)));
  EXPECT_TRUE(place("<link name='b'><pose degrees='true'>0 0 0 0 0 90</pose>" + collision(kBox, "<pose>1 0 0 0 0 0</pose>") + "</link>")
                  .isApprox(Eigen::Vector3d(0, 1, 0)));
  EXPECT_TRUE(place("<link name='b'><pose rotation_format='quat_xyzw'>0 0 0 0 0 1 0</pose>" + collision(kBox, "<pose>1 0 0 0 0 0</pose>") +
                    "</link>")
                  .isApprox(Eigen::Vector3d(-1, 0, 0)));
}

TEST(SdfScene, Includes) {
  const TemporaryFolder folder;
  const ScopedVariable home("HOME", folder.path()), models("GAZEBO_MODEL_PATH", folder.path("shared"));
  const std::string part = "<link name='l'>" + collision("<mesh><uri>model://part/t.obj</uri></mesh>") + "</link>";
  folder.write("shared/part/t.obj", kTriangleObj);
  folder.write("shared/part/model.config", "<model><sdf version='1.4'>old.sdf</sdf><sdf version='1.6'>new.sdf</sdf></model>");
  folder.write("shared/part/new.sdf", model(part));
  folder.write("near/model.sdf", model("<pose>0 0 1 0 0 0</pose><link name='l'>" + collision(kBox) + "</link>"));
  const Scene scene = sceneOf(folder, "a.sdf", R"(<sdf version="1.6"><world name="w">
    <include><uri>model://part</uri><name>p</name><pose>1 0 0 0 0 0</pose></include>
    <include><uri>model://part</uri><name>q</name></include>
    <include><uri>near</uri></include></world></sdf>)");
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[0].name, "p::l::c");
  expectBox(scene.bodies[0], {1, 0, 0}, {2, 1, 0});
  EXPECT_EQ(scene.bodies[1].name, "q::l::c");
  EXPECT_EQ(scene.bodies[2].name, "m::l::c");
  expectBox(scene.bodies[2], {-1, -1, 0}, {1, 1, 2});
}

TEST(SdfScene, IncludedLightsAndActorsAddNoBodies) {
  const TemporaryFolder folder;
  folder.write("sun/model.sdf", "<sdf version='1.6'><light type='directional' name='sun'/></sdf>");
  folder.write("man/model.sdf", "<sdf version='1.6'><actor name='man'/></sdf>");
  folder.write("empty/model.sdf", "<sdf version='1.6'/>");
  const auto world = [](const std::string& uri) {
    return "<sdf version='1.6'><world name='w'><include><uri>" + uri + "</uri></include><model name='m'><link name='l'>" + collision(kBox) +
           "</link></model></world></sdf>";
  };
  for (const char* uri : {"sun", "man"}) EXPECT_EQ(sceneOf(folder, "a.sdf", world(uri)).bodies.size(), 1U) << uri;
  expectError(ErrorCode::kBadScene, {"has no <model>"}, [&] { sceneOf(folder, "a.sdf", world("empty")); });
}

TEST(SdfScene, LinkWinsOverAJointOfTheSameName) {
  const TemporaryFolder folder;
  const std::string joint = "<joint name='a' type='fixed'><parent>world</parent><child>b</child><pose>0 0 9 0 0 0</pose></joint>";
  EXPECT_TRUE(placeOfFirst(folder, model(joint + "<link name='a'><pose>1 0 0 0 0 0</pose></link><link name='b'>" +
                                         collision(kBox, "<pose relative_to='a'>0 1 0 0 0 0</pose>") + "</link>"))
                  .isApprox(Eigen::Vector3d(1, 1, 0)));
}

TEST(SdfScene, FramesOfNestedModels) {
  const TemporaryFolder folder;
  folder.write("near/model.sdf", model("<frame name='top'><pose>0 0 3 0 0 0</pose></frame><model name='k'><pose>0 1 0 0 0 0</pose>"
                                       "<link name='tip'><pose>0 0 0.5 0 0 0</pose></link></model>"));
  const std::string near = "<include><uri>near</uri><name>n</name><pose>1 0 0 0 0 1.5707963267948966</pose></include>";
  const auto place = [&](const std::string& frame) {
    return placeOfFirst(folder,
                        model(near + "<link name='l'><pose relative_to='" + frame + "'>1 0 0 0 0 0</pose>" + collision(kBox) + "</link>"));
  };
  EXPECT_TRUE(place("n").isApprox(Eigen::Vector3d(1, 1, 0)));
  EXPECT_TRUE(place("n::top").isApprox(Eigen::Vector3d(1, 1, 3)));
  EXPECT_TRUE(place("n::k::tip").isApprox(Eigen::Vector3d(0, 1, 0.5)));
  EXPECT_TRUE(place("n::k::__model__").isApprox(Eigen::Vector3d(0, 1, 0)));
  expectError(ErrorCode::kBadScene, {"no model 'o'"}, [&] { place("o::top"); });
  expectError(ErrorCode::kBadScene, {"no frame 'no'"}, [&] { place("n::no"); });
}

TEST(SdfScene, StateOfASavedWorld) {
  const TemporaryFolder folder;
  const std::string link = "<pose>1 0 0 0 0 0</pose>" + collision(kBox, "<pose>0 0 1 0 0 0</pose>");
  const auto scene = [&](const std::string& state) {
    return sceneOf(folder, "a.world",
                   "<sdf version='1.6'><world name='w'><model name='m'><pose>9 0 0 0 0 0</pose><link name='l'>" + link +
                       "</link><link name='k'>" + link + "</link></model><state world_name='w'>" + state + "</state></world></sdf>");
  };
  const auto expectPlaces = [](const Scene& found, const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
    EXPECT_TRUE(found.bodies.at(0).pose.translation().isApprox(first));
    EXPECT_TRUE(found.bodies.at(1).pose.translation().isApprox(second));
  };
  expectPlaces(scene(""), {10, 0, 1}, {10, 0, 1});
  expectPlaces(scene("<model name='other'><pose>5 0 0 0 0 0</pose></model>"), {10, 0, 1}, {10, 0, 1});
  const std::string moved = "<model name='m'><scale>1 1 1</scale><pose>0 5 0 0 0 0</pose>";
  expectPlaces(scene(moved + "</model>"), {1, 5, 1}, {1, 5, 1});
  expectPlaces(scene(moved + "<link name='k'><pose>7 7 0 0 0 0</pose></link></model>"), {1, 5, 1}, {7, 7, 1});
  const auto expectBad = [&](const std::string& part, const std::string& state) {
    expectError(ErrorCode::kBadScene, {part}, [&] { scene(state); });
  };
  expectBad("<scale>", "<model name='m'><scale>2 1 1</scale><pose>0 5 0 0 0 0</pose></model>");
  expectBad("<scale>", "<model name='m'><scale>2 1 1</scale></model>");
  expectBad("<insertions>", "<insertions/>");
  expectBad("second <state>", "</state><state>");
}

TEST(SdfScene, ErrorsNameTheFaultAndTheLine) {
  const TemporaryFolder folder;
  const ScopedVariable home("HOME", folder.path());
  const auto expectBad = [&](ErrorCode code, const std::vector<std::string>& parts, const std::string& text) {
    expectError(code, parts, [&] { sceneOf(folder, "a.sdf", text); });
  };
  const auto link = [](const std::string& geometry, const std::string& more = "") {
    return model("\n<link name='l'>" + collision(geometry, more) + "</link>");
  };
  constexpr ErrorCode kBad = ErrorCode::kBadScene;
  expectBad(ErrorCode::kNotXml, {"a.sdf"}, "<sdf>");
  expectBad(kBad, {"line 1", "<robot>"}, "<robot/>");
  expectBad(kBad, {"second <world>"}, "<sdf><world name='a'/><world name='b'/></sdf>");
  expectBad(kBad, {"no geometry"}, link(""));
  expectBad(kBad, {"line 2", "<heightmap>", "mesh"}, link("<heightmap/>"));
  expectBad(kBad, {"line 2", "<box> has no <size>"}, link("<box/>"));
  expectBad(kBad, {"<size>", "2 numbers"}, link("<box><size>1 1</size></box>"));
  expectBad(kBad, {"'inf'"}, link("<box><size>1 1 inf</size></box>"));
  expectBad(kBad, {"m::l::c", "a sphere of -1"}, link("<sphere><radius>-1</radius></sphere>"));
  expectBad(kBad, {"<submesh>"}, link("<mesh><uri>t.obj</uri><submesh/></mesh>"));
  expectBad(kBad, {"line 2", "no frame 'x'"}, link(kBox, "<pose relative_to='x'/>"));
  expectBad(kBad, {"<pose>", "5 numbers"}, link(kBox, "<pose>0 0 0 0 0</pose>"));
  expectBad(kBad, {"relative to itself"},
            model("<frame name='f' attached_to='g'/><frame name='g' attached_to='f'/><link name='l'>" +
                  collision(kBox, "<pose relative_to='f'/>") + "</link>"));
  expectBad(kBad, {"'l' appears twice"}, model("<link name='l'/><link name='l'/>"));
  expectBad(kBad, {"m::l::c", "twice"}, model("<link name='l'>" + collision(kBox) + collision(kBox) + "</link>"));
  expectBad(kBad, {"placement_frame"}, "<sdf><model name='m' placement_frame='l'/></sdf>");
  expectBad(kBad, {"no <uri>"}, "<sdf><world name='w'><include/></world></sdf>");
  expectBad(ErrorCode::kPackageNotFound, {"line 1", "model://no", "GAZEBO_MODEL_PATH"},
            "<sdf><world name='w'><include><uri>model://no</uri></include></world></sdf>");
  expectBad(ErrorCode::kUnsupportedFormat, {"https://", "download"},
            "<sdf><world name='w'><include><uri>https://a.b/c.sdf</uri></include></world></sdf>");
  expectBad(kBad, {"<population>"}, "<sdf><world name='w'><population name='cans'/></world></sdf>");
  expectBad(kBad, {"capsule", "-3"}, link("<capsule><radius>1</radius><length>-3</length></capsule>"));
  expectBad(kBad, {"line 2", "capsule", "1e+300 m", "1e6 m"}, link("<capsule><radius>1</radius><length>1e300</length></capsule>"));
  expectBad(kBad, {"line 2", "<sphere> is the second shape", "after <box>", "<collision> of its own"},
            link(kBox + "<sphere><radius>9</radius></sphere>"));
  expectBad(kBad, {"second <geometry>", "<collision> of its own"}, link(kBox + "</geometry><geometry>" + kBox));
  expectBad(kBad, {"include itself"}, model("<include><uri>a.sdf</uri></include>"));
}

TEST(ReadSdf, ALongChainOfFramesTakesNoStack) {
  const TemporaryFolder folder;
  std::string text = "<sdf version='1.7'><model name='m'><frame name='f0'/>";
  for (int i = 1; i < 60'000; ++i)
    text += "<frame name='f" + std::to_string(i) + "'><pose relative_to='f" + std::to_string(i - 1) + "'>0 0 0 0 0 0</pose></frame>";
  text +=
      "<link name='l'><pose relative_to='f59999'>0 0 0 0 0 0</pose><collision name='c'><geometry><sphere><radius>1</radius></sphere>"
      "</geometry></collision></link></model></sdf>";
  expectError(ErrorCode::kBadScene, {"chain of more than 1000 frames"}, [&] { sceneOf(folder, "a.sdf", text); });
}

/// A model with a chain of frames, whose last one is relative to the first of a model within, and so on.
std::string chains(int level, int levels, int frames) {
  std::string text = "<model name='m" + std::to_string(level) + "'><link name='l'/>";
  for (int i = 0; i < frames; ++i) {
    const bool last = i + 1 == frames;
    const std::string next = !last ? "f" + std::to_string(i + 1) : level + 1 < levels ? "m" + std::to_string(level + 1) + "::f0" : "";
    text += "<frame name='f" + std::to_string(i) + "'><pose relative_to='" + next + "'>0 0 0 0 0 0</pose></frame>";
  }
  return text + (level + 1 < levels ? chains(level + 1, levels, frames) : "") + "</model>";
}

TEST(ReadSdf, AChainThroughNestedModelsTakesNoStack) {
  const TemporaryFolder folder;
  const auto load = [&](int levels) {
    return sceneOf(folder, "a.sdf",
                   "<sdf version='1.9'><world name='w'>" + chains(0, levels, 400) +
                       "<model name='z'><pose relative_to='m0::f0'>0 0 0 0 0 0</pose><link name='l'><collision name='c'><geometry><sphere>"
                       "<radius>1</radius></sphere></geometry></collision></link></model></world></sdf>");
  };
  EXPECT_EQ(load(2).bodies.size(), 1u);
  expectError(ErrorCode::kBadScene, {"chain of more than 1000 frames"}, [&] { load(40); });
}

// Each file includes the next three times, and each include is relative to a frame of the one before it: 3^12 ways lead to the last file.
TEST(ReadSdf, FramesOfIncludedModelsAreFollowedOnce) {
  const TemporaryFolder folder;
  const auto include = [](int file, int copy) {
    return "<include><uri>f" + std::to_string(file) + ".sdf</uri><name>s" + std::to_string(copy) + "</name><pose" +
           (copy < 2 ? " relative_to='s" + std::to_string(copy + 1) + "::x'" : "") + ">0 0 0 0 0 0</pose></include>";
  };
  const int files = 12;
  for (int file = 1; file <= files; ++file) {
    std::string text = "<sdf version='1.9'><model name='m'><link name='l'/>";
    for (int copy = 0; file < files && copy < 3; ++copy) text += include(file + 1, copy);
    folder.write("f" + std::to_string(file) + ".sdf", text + "<frame name='x'><pose" + (file < files ? " relative_to='s0::x'" : "") +
                                                          ">0 0 0 0 0 0</pose></frame></model></sdf>");
  }
  std::string world = "<sdf version='1.9'><world name='w'>";
  for (int copy = 0; copy < 3; ++copy) world += include(1, copy);
  expectError(ErrorCode::kBadScene, {"more than 10,000", "split the world"}, [&] { sceneOf(folder, "a.sdf", world + "</world></sdf>"); });
}

}  // namespace
}  // namespace collision_hulls
