// The files of each consumer, as text; test/with_packages loads them with the consumers themselves.
// Also tests src/consumers/curobo.cpp, src/consumers/dart.cpp, src/consumers/drake.cpp, src/consumers/gazebo.cpp,
// src/consumers/how_to_load.cpp, src/consumers/isaac.cpp, src/consumers/marked_hulls.cpp, src/consumers/moveit.cpp,
// src/consumers/mujoco.cpp, src/consumers/tesseract.cpp and src/consumers/written_model.cpp.
#include "collision_hulls/consumers/consumers.h"

#include <map>

#include "collision_hulls/error.h"
#include "consumers/fixture.h"
#include "scene/yaml_node.h"

namespace collision_hulls {
namespace {

TEST_F(Consumers, NamesAreReadBack) {
  for (const char* each : {"moveit", "gazebo", "mujoco", "drake", "isaac", "tesseract", "curobo", "dart", "bullet"}) {
    ASSERT_TRUE(consumerNamed(each)) << each;
    EXPECT_STREQ(name(*consumerNamed(each)), each);
    EXPECT_NE(consumerChoices().find(each), std::string::npos);
  }
  EXPECT_FALSE(consumerNamed("moveit3"));
}

TEST_F(Consumers, EachIsToldWhichFileToLoad) {
  options_.shapes = Shapes::kSpheres;  // which all of them take
  options_.tolerance = lengthOf(0.05);
  options_.format = MeshFormat::kObj;
  RobotResult result = decomposed(threeLinks(cube()));
  const std::string out = folder_ / "three_c";
  for (const char* each : {"moveit", "gazebo", "mujoco", "drake", "isaac", "tesseract", "curobo", "dart"}) {
    const Consumer consumer = *consumerNamed(each);
    result.extra_files.clear();
    addConsumerFiles({consumer}, out, result);
    const std::string text = howToLoad({consumer}, result, out), start = "For " + std::string(each) + ": " + out + "/";
    ASSERT_EQ(text.substr(0, start.size()), start);
    const std::string file = text.substr(start.size(), text.find_first_of(" ,", start.size()) - start.size());
    EXPECT_EQ(result.extra_files.count(file), 1u) << text;
    EXPECT_EQ(fixtures::count(text, "\n"), 1u) << text;
  }
  EXPECT_NE(howToLoad({Consumer::kBullet}, result, out).find("/three_c/urdf/three.urdf, by loadURDF()"), std::string::npos);
  const std::string both = howToLoad({Consumer::kGazebo, Consumer::kDrake}, result, out);
  EXPECT_NE(both.find("as model://three_c with " + folder_.path().string() + " in GZ_SIM_RESOURCE_PATH\nFor drake:"), std::string::npos);
  EXPECT_NE(both.find("_drake.urdf in place of urdf/three.urdf"), std::string::npos) << both;
  EXPECT_NE(both.find("AddPackageXml(\"" + out + "/package.xml\")"), std::string::npos) << both;
  EXPECT_EQ(howToLoad({}, result, out), "");
}

TEST_F(Consumers, AModelWhoseDescriptionWouldReplaceAConsumersIsRefused) {
  for (const Consumer consumer : {Consumer::kDrake, Consumer::kTesseract}) {
    Options options;
    options.format = MeshFormat::kObj;
    options.models = {{name(consumer), {}}, {"fine", {}}};
    EXPECT_NO_THROW(check({consumer}, options)) << "the first model has the robot's own name";
    std::swap(options.models[0], options.models[1]);
    EXPECT_NO_THROW(check({Consumer::kMoveit}, options));
    try {
      check({consumer}, options);
      ADD_FAILURE() << name(consumer);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kBadOption);
      EXPECT_NE(std::string(e.what()).find("give the model another"), std::string::npos) << e.what();
    }
  }
}

TEST_F(Consumers, AFormatThatAConsumerCannotReadIsRefusedWithARemedy) {
  Options options;
  EXPECT_NO_THROW(check({Consumer::kMoveit, Consumer::kGazebo, Consumer::kMujoco}, options));
  try {
    check({Consumer::kDrake}, options);
    FAIL() << "Drake reads no STL";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kBadOption);
    EXPECT_NE(std::string(e.what()).find("leave the format out"), std::string::npos) << e.what();
  }
  options.format = MeshFormat::kDae;
  EXPECT_THROW(check({Consumer::kMujoco}, options), Error);
}

// A search to the end of the text for each comment takes minutes.
TEST_F(Consumers, ManyCommentsBeforeTheRoot) {
  std::string comments;
  for (int i = 0; i < 300'000; ++i) comments += "<!---->";
  std::string text = threeLinks(cube());
  text.insert(text.find("<!-- <robot> -->"), comments);
  options_.format = MeshFormat::kObj;
  const std::string urdf = fileOf(Consumer::kDrake, text, "urdf/three_drake.urdf");
  EXPECT_EQ(fixtures::count(urdf, "<drake:declare_convex/>"), 3u);
  EXPECT_EQ(fixtures::count(urdf, "<robot xmlns:drake"), 1u);
}

// Indented by each level, the text would grow with the square of the depth.
TEST_F(Consumers, ADeepRobotHasALongTextAndNoMore) {
  std::string text = "<robot name=\"deep\"><link name=\"l0\">" + cube() + "</link>";
  for (int i = 1; i < 1500; ++i) {
    const std::string link = "l" + std::to_string(i);
    text += "<link name=\"" + link + "\"/><joint name=\"j" + std::to_string(i) + "\" type=\"fixed\"><parent link=\"l" +
            std::to_string(i - 1) + "\"/><child link=\"" + link + "\"/></joint>";
  }
  const std::string model = fileOf(Consumer::kMujoco, text + "</robot>", "mjcf/deep.xml");
  EXPECT_EQ(fixtures::count(model, "<body "), 1500u);
  EXPECT_LT(model.size(), 1500u * 150);
}

TEST_F(Consumers, ASingleMeshHasNoSuchForm) {
  RobotResult result = decomposeMesh(mesh_, options_);
  EXPECT_THROW(addConsumerFiles({Consumer::kMoveit}, folder_ / "out", result), Error);
  EXPECT_NO_THROW(addConsumerFiles({}, folder_ / "out", result));
}

TEST_F(Consumers, DrakeChoosesTheFormatThatNobodyAskedFor) {
  EXPECT_EQ(formatFor({Consumer::kMoveit}, MeshFormat::kStl), MeshFormat::kStl);
  EXPECT_EQ(formatFor({Consumer::kMoveit, Consumer::kDrake}, MeshFormat::kStl), MeshFormat::kObj);
}

TEST_F(Consumers, IsaacIsToldHowToApproximate) {
  const std::string round =
      "<collision name=\"ball\"><geometry><sphere radius=\"0.25\"/></geometry></collision><collision name=\"7th\">"
      "<origin xyz=\"1 2 3\" rpy=\"0 0 1.5707963267948966\"/><geometry><box size=\"2 4 6\"/></geometry></collision>";
  const std::string usda = fileOf(Consumer::kIsaac, threeLinks(round), "usd/three.usda");
  EXPECT_EQ(usda.substr(0, 10), "#usda 1.0\n");
  EXPECT_EQ(fixtures::count(usda, "def Xform \""), 4u) << "the robot and its links";
  EXPECT_EQ(fixtures::count(usda, "physics:approximation = \"convexHull\""), 2u);
  EXPECT_EQ(fixtures::count(usda, "int[] faceVertexCounts = [3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3]"), 2u);
  EXPECT_NE(
      usda.find("def Xform \"b\"\n    {\n        matrix4d xformOp:transform = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0.5, 0, 0, 1))"),
      std::string::npos)
      << usda;
  EXPECT_NE(usda.find("def Sphere \"ball\" (\n            prepend apiSchemas = [\"PhysicsCollisionAPI\"]"), std::string::npos) << usda;
  const std::size_t box = usda.find("def Cube \"_7th\"");
  ASSERT_NE(box, std::string::npos) << usda;
  EXPECT_NE(usda.find("(1, 2, 3, 1)", box), std::string::npos);
  EXPECT_NE(usda.find(" 2, 0, 0), (-4,", box), std::string::npos) << "rows are the turned axes, as long as the box: " << usda.substr(box);
}

TEST_F(Consumers, DrakeIsToldWhichMeshesAreConvex) {
  options_.format = MeshFormat::kObj;
  const std::string visual = "<visual>" + fixtures::meshTag(mesh_) + "</visual>";
  const std::string urdf = fileOf(Consumer::kDrake, threeLinks(visual + cube()), "urdf/three_drake.urdf");
  EXPECT_EQ(fixtures::count(urdf, "/0_0.obj\"><drake:declare_convex/></mesh>"), 3u) << urdf;
  EXPECT_EQ(fixtures::count(urdf, "declare_convex"), 3u);
  EXPECT_NE(urdf.find("<!-- <robot> -->"), std::string::npos);
  EXPECT_NE(urdf.find("<robot xmlns:drake=\"http://drake.mit.edu\" name=\"three\">"), std::string::npos) << urdf;
  EXPECT_EQ(parseRobotDescription(urdf).links.size(), 3u);
}

TEST_F(Consumers, TesseractIsToldWhichMeshesAreConvex) {
  const std::string visual = "<visual>" + fixtures::meshTag(mesh_) + "</visual>";
  const std::string urdf = fileOf(Consumer::kTesseract, threeLinks(visual + cube()), "urdf/three_tesseract.urdf");
  EXPECT_EQ(fixtures::count(urdf, "/0_0.stl\" tesseract:make_convex=\"true\"/>"), 3u) << urdf;
  EXPECT_EQ(fixtures::count(urdf, "make_convex"), 3u);
  EXPECT_NE(urdf.find("<robot xmlns:tesseract="), std::string::npos) << urdf;
  EXPECT_EQ(parseRobotDescription(urdf).links.size(), 3u);
}

TEST_F(Consumers, DartTakesEachHullAsAMeshBesideTheFile) {
  const std::string moved =
      "<collision name=\"turned\"><origin xyz=\"0 0 1\" rpy=\"0 0 1.5707963267948966\"/>" + fixtures::meshTag(mesh_) + "</collision>";
  const std::string box = "<collision><origin xyz=\"1 2 3\" rpy=\"0.1 0.2 0.3\"/><geometry><box size=\"2 4 6\"/></geometry></collision>";
  const std::string skel = fileOf(Consumer::kDart, threeLinks(moved + box), "skel/three.skel");
  EXPECT_EQ(fixtures::count(skel, "<mesh><file_name>../meshes/"), 3u) << skel;
  EXPECT_EQ(skel.find("<multi_sphere>"), std::string::npos) << "hulls that Bullet's margin would turn inside out";
  const std::size_t turned = skel.find("<collision_shape name=\"turned");
  ASSERT_NE(turned, std::string::npos) << skel;
  EXPECT_NE(skel.find("<transformation>0 0 1 0 0 1.57079632679489", turned), std::string::npos) << skel.substr(turned);
  EXPECT_NE(skel.find("<joint type=\"free\" name=\"rootJoint\"><parent>world</parent><child>a</child>"), std::string::npos);
  EXPECT_NE(skel.find("<body name=\"b\">\n        <transformation>0.5 0 0 0 0 0"), std::string::npos);
  EXPECT_NE(skel.find("<xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit>"), std::string::npos);
}

/// The importer is no part of Debian's Bullet, so what it does with the description is read, not tested: see doc/options.md.
TEST_F(Consumers, BulletTakesTheDescriptionAsItIs) {
  RobotResult result = decomposed(threeLinks(cube()));
  const auto before = result.extra_files;
  const std::string urdf = result.urdf;
  addConsumerFiles({Consumer::kBullet, Consumer::kBullet}, folder_ / "three_c", result);
  EXPECT_EQ(result.extra_files, before);
  EXPECT_EQ(result.urdf, urdf);
  EXPECT_EQ(fixtures::count(urdf, "filename=\"package://three_c/meshes/"), 3u)
      << "found by looking for the folder three_c above the description";
  ASSERT_FALSE(result.report.notes.empty());
  EXPECT_NE(result.report.notes.back().find("as it is"), std::string::npos) << result.report.notes.back();
  Options options;
  options.uri = UriStyle::kFile;
  EXPECT_THROW(check({Consumer::kBullet}, options), Error);
  options.uri = UriStyle::kRelative;
  EXPECT_NO_THROW(check({Consumer::kBullet}, options));
}

TEST_F(Consumers, CuroboTakesSpheresInTheLinksFrames) {
  EXPECT_EQ(shapesFor({Consumer::kMoveit}, Shapes::kMixed), Shapes::kMixed);
  options_.shapes = shapesFor({Consumer::kMoveit, Consumer::kCurobo}, Shapes::kHulls);
  options_.tolerance = lengthOf(0.05);
  const std::string moved = "<collision><origin xyz=\"1 2 3\"/>" + fixtures::meshTag(mesh_) + "</collision>";
  const std::string yaml = fileOf(Consumer::kCurobo, threeLinks(moved), "config/three_spheres.yml");
  const YamlValue root = YamlValue::parse(yaml, "spheres", ErrorCode::kInternal);
  std::map<std::string, YamlValue> sections;
  for (const auto& [key, value] : root.entries()) sections.emplace(key.text(), value);
  EXPECT_EQ(sections.at("collision_link_names").items().size(), 3u);
  const auto links = sections.at("collision_spheres").entries();
  ASSERT_EQ(links.size(), 3u);
  EXPECT_EQ(links[2].first.text(), "c");
  for (const YamlValue& sphere : links[2].second.items()) {
    const auto centre = sphere.entries().at(0).second.items();
    EXPECT_NEAR(std::stod(centre.at(0).text()), 1.05, 0.06);
    EXPECT_NEAR(std::stod(centre.at(1).text()), 2.05, 0.06);
    EXPECT_NEAR(std::stod(centre.at(2).text()), 3.05, 0.06);
    EXPECT_GT(std::stod(sphere.entries().at(1).second.text()), 0.04);
  }
  const auto ignored = sections.at("self_collision_ignore").entries();
  ASSERT_EQ(ignored.size(), 2u);
  EXPECT_EQ(ignored[0].second.items().at(0).text(), "b") << "the neighbour of a";
}

/// What check() says of a description before any work, and addConsumerFiles() after it; empty: nothing.
template <typename F>
std::string refusal(F&& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    return error.what();
  }
  return "";
}

TEST_F(Consumers, CuroboWouldMissWhatIsNoSphere) {
  EXPECT_THROW(check({Consumer::kCurobo}, Options()), Error) << "these are hulls";
  options_.shapes = Shapes::kSpheres;
  const std::string box = "<geometry><box size=\"1 1 1\"/></geometry>",
                    ball = "<collision><geometry><sphere radius=\"1\"/></geometry></collision>";
  const std::string alone = "<collision>" + box + "</collision>", mesh = "<visual>" + fixtures::meshTag(mesh_) + "</visual>";
  const auto before = [&](const std::string& content) {
    return refusal([&] { check({Consumer::kMoveit, Consumer::kCurobo}, options_, parseRobotDescription(threeLinks(content))); });
  };
  const auto after = [&](const std::string& content) {
    RobotResult result = decomposed(threeLinks(content));
    return refusal([&] { addConsumerFiles({Consumer::kCurobo}, folder_ / "three_c", result); });
  };
  for (const std::string& missed : {alone, alone + mesh, "<visual>" + box + "</visual>", cube() + alone})
    for (const std::string& said : {before(missed), after(missed)})
      EXPECT_NE(said.find("link 'c' has other collision elements than spheres"), std::string::npos) << missed << ": " << said;
  EXPECT_EQ(before(alone).find("remove"), std::string::npos) << "cuRobo would miss it all the same: " << before(alone);
  const std::string flat = "<collision><geometry><box size=\"1 0 1\"/></geometry></collision>";  // stays, as all primitives there
  EXPECT_NE(before(cube() + flat), "");
  for (const std::string& taken : {cube(), ball, mesh, mesh + ball, std::string()}) {
    EXPECT_EQ(before(taken), "") << taken;
    EXPECT_EQ(after(taken), "") << taken;
  }
  const auto of_one = [&](const std::string& content, Source source) {
    options_.source = source;
    const std::string urdf = fixtures::robot("one", fixtures::link("c", content));
    return refusal([&] { check({Consumer::kCurobo}, options_, parseRobotDescription(urdf)); });
  };
  EXPECT_NE(of_one(alone + mesh, Source::kCollision)
                .find("choose --source visual, describe them by spheres or by meshes that are not kept, or leave --for"),
            std::string::npos);
  EXPECT_EQ(of_one(alone, Source::kCollision).find("--source visual"), std::string::npos) << "it does not help";
  EXPECT_NE(of_one(alone, Source::kCollision), "");
  EXPECT_EQ(of_one(alone + mesh, Source::kVisual), "");
  options_.source = Source::kAuto;
  options_.links = "a";
  EXPECT_NE(before(alone).find("leave --links out, describe"), std::string::npos) << before(alone);
  options_.links_place = "'f.yaml', line 1";
  EXPECT_NE(before(alone).find("leave 'only' out, describe"), std::string::npos) << before(alone);
}

TEST_F(Consumers, CuroboIsRefusedForAllLinksAtOnce) {
  options_.shapes = Shapes::kSpheres;
  options_.source = Source::kVisual;
  std::string text = "<robot name=\"star\"><link name=\"base\"><visual>" + fixtures::meshTag(mesh_) + "</visual></link>";
  for (const std::string link : {"l0", "l1", "l2", "l3", "l4"})
    text += "<link name=\"" + link + "\"><visual><geometry><box size=\"1 1 1\"/></geometry></visual></link><joint name=\"j" + link +
            "\" type=\"fixed\"><parent link=\"base\"/><child link=\"" + link + "\"/></joint>";
  RobotResult result = decomposed(text + "</robot>");
  try {
    addConsumerFiles({Consumer::kCurobo}, folder_ / "three_c", result);
    FAIL() << "the boxes are missing";
  } catch (const Error& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("links 'l0', 'l1', 'l2' and 2 more have other collision elements"), std::string::npos) << said;
    EXPECT_EQ(said.find("--source"), std::string::npos) << "that is chosen: " << said;
  }
}

TEST_F(Consumers, MoveitHasTheSpheresOfLinksThatHaveNothingElse) {
  options_.shapes = Shapes::kSpheres;
  options_.tolerance = lengthOf(0.05);
  const std::string box = "<collision><geometry><box size=\"1 1 1\"/></geometry></collision>";
  const std::string srdf = fileOf(Consumer::kMoveit, threeLinks(cube() + box), "config/three.srdf");
  EXPECT_NE(srdf.find("<link_sphere_approximation link=\"b\">\n    <sphere center=\""), std::string::npos) << srdf;
  EXPECT_EQ(fixtures::count(srdf, "<link_sphere_approximation"), 2u);
}

TEST_F(Consumers, MujocoHasAGeomForEachHull) {
  const std::string xml =
      fileOf(Consumer::kMujoco, threeLinks("<collision><geometry><cylinder radius=\"0.1\" length=\"0.4\"/></geometry></collision>"),
             "mjcf/three.xml");
  EXPECT_EQ(fixtures::count(xml, "<mesh "), 2u) << xml;
  EXPECT_EQ(fixtures::count(xml, "<geom "), 3u);
  EXPECT_NE(xml.find("file=\"meshes/a/0_0.stl\""), std::string::npos);
  EXPECT_NE(xml.find("name=\"&lt;cube&gt;_0\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("type=\"cylinder\" size=\"0.1 0.2\""), std::string::npos);
  EXPECT_NE(xml.find("<joint name=\"bc\" type=\"hinge\" axis=\"0 0 1\" limited=\"true\" range=\"-1 1\"/>"), std::string::npos) << xml;
}

TEST_F(Consumers, GazeboFixesToTheWorldOnlyWhatIsFixed) {
  const auto sdf = [this](const std::string& type) {
    const std::string urdf = "<robot name=\"three\"><link name=\"world\"/><link name=\"body\">" + cube() +
                             "</link><joint name=\"fly\" type=\"" + type +
                             "\"><parent link=\"world\"/><child link=\"body\"/><origin xyz=\"0 0 2\"/></joint></robot>";
    return fileOf(Consumer::kGazebo, urdf, "model.sdf");
  };
  EXPECT_EQ(fixtures::count(sdf("fixed"), "<joint "), 1u);
  EXPECT_EQ(fixtures::count(sdf("floating"), "<joint "), 0u);
  EXPECT_NE(sdf("floating").find("<pose relative_to=\"__model__\">0 0 2 0 0 0</pose>"), std::string::npos) << sdf("floating");
}

// "unknown element in equality constraint", and "free joint can only be used on top level", MuJoCo says otherwise.
TEST_F(Consumers, MujocoHasNoEqualityForALockedJointAndNoFreeJointBelowABody) {
  std::string urdf = threeLinks(cube());
  const std::string end =
      "<link name=\"d\"/><link name=\"e\"/><joint name=\"cd\" type=\"floating\"><parent link=\"c\"/>"
      "<child link=\"d\"/><origin xyz=\"0 0 2\"/></joint><joint name=\"de\" type=\"fixed\"><parent link=\"d\"/>"
      "<child link=\"e\"/><mimic joint=\"ab\"/></joint></robot>";
  urdf.replace(urdf.rfind("</robot>"), std::string::npos, end);
  const std::string xml = fileOf(Consumer::kMujoco, urdf, "mjcf/three.xml");
  EXPECT_EQ(xml.find("<equality>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("\n    <body name=\"d\" pos=\"1 0 2\" quat=\"1 0 0 0\">\n      <freejoint name=\"cd\"/>\n      <body name=\"e\">"),
            std::string::npos)
      << "a body of the world, where it is at rest: " << xml;
  EXPECT_EQ(fixtures::count(xml, "<body "), 5u);
  const std::string mimics = "<mimic joint=\"ab\"/></joint>\n</robot>";
  std::string follows = threeLinks(cube());
  follows.replace(follows.rfind("</joint>"), std::string::npos, mimics);
  EXPECT_NE(fileOf(Consumer::kMujoco, follows, "mjcf/three.xml").find("<joint joint1=\"bc\" joint2=\"ab\" polycoef=\"0 1 0 0 0\"/>"),
            std::string::npos);
}

// "range[0] should be smaller than range[1]", it says otherwise.
TEST_F(Consumers, MujocoHasNoJointThatCannotMove) {
  std::string urdf = threeLinks(cube());
  const std::string limits = "lower=\"-1\" upper=\"1\"", locked = "lower=\"0.5\" upper=\"0.5\"";
  urdf.replace(urdf.find(limits), limits.size(), locked);
  urdf.replace(urdf.rfind("</joint>"), std::string::npos, "<mimic joint=\"ab\" multiplier=\"2\" offset=\"0.25\"/></joint>\n</robot>");
  const std::string xml = fileOf(Consumer::kMujoco, urdf, "mjcf/three.xml");
  EXPECT_EQ(xml.find("<joint name=\"ab\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<joint joint1=\"bc\" polycoef=\"1.25 0 0 0 0\"/>"), std::string::npos) << "where its master is for good: " << xml;
  const std::string turned = "<body name=\"b\" pos=\"0.5 0 0\" quat=\"0.96891242171064";  // cos 0.25
  EXPECT_NE(xml.find(turned), std::string::npos) << xml;
  EXPECT_NE(notesOf(Consumer::kMujoco, urdf).find("joints whose range is nothing ('ab') are fixed"), std::string::npos);
}

TEST_F(Consumers, MujocoBeginsOutOfRangeWithANote) {
  std::string urdf = threeLinks(cube());
  const std::string said = "out of range where MuJoCo starts, with all joints at 0: 'ab'; set their qpos first";
  EXPECT_EQ(notesOf(Consumer::kMujoco, urdf).find("out of range"), std::string::npos);
  const std::string limits = "lower=\"-1\" upper=\"1\"";
  urdf.replace(urdf.find(limits), limits.size(), "lower=\"0.5\" upper=\"1\"");
  EXPECT_NE(notesOf(Consumer::kMujoco, urdf).find(said), std::string::npos) << notesOf(Consumer::kMujoco, urdf);
}

TEST_F(Consumers, ARobotWithoutANameHasThatOfItsFile) {
  std::string urdf = threeLinks(cube());
  urdf.replace(urdf.find("\"three\""), 7, "\"\"");
  EXPECT_EQ(parseRobotDescription(urdf).name, "robot");
  EXPECT_EQ(parseRobotDescription(urdf, "/tmp/arm.urdf").name, "arm");
  EXPECT_NE(fileOf(Consumer::kGazebo, urdf, "model.sdf").find("<model name=\"robot\">"), std::string::npos);
}

TEST_F(Consumers, GazeboHasACollisionForEachHullAndTheLimits) {
  const std::string sdf = fileOf(Consumer::kGazebo, threeLinks(cube()), "model.sdf");
  EXPECT_EQ(fixtures::count(sdf, "<collision "), 3u);
  EXPECT_NE(sdf.find("<uri>model://three_c/meshes/a/0_0.stl</uri>"), std::string::npos) << sdf;
  EXPECT_NE(sdf.find("<pose relative_to=\"a\">0.5 0 0 0 0 0</pose>"), std::string::npos);
  EXPECT_NE(sdf.find("<effort>5</effort>"), std::string::npos);
  EXPECT_NE(sdf.find("<velocity>2</velocity>"), std::string::npos);
}

// In the description it counts from urdf/.
TEST_F(Consumers, GazeboFindsARelativeVisualFromTheFolderOfItsFile) {
  const auto visual = [](const std::string& uri) { return "<visual>" + fixtures::meshTag(uri) + "</visual>"; };
  const std::string sdf = fileOf(Consumer::kGazebo, threeLinks(visual("../../arm/a.dae") + visual("file://b.dae") + cube()), "model.sdf");
  EXPECT_NE(sdf.find("<uri>../arm/a.dae</uri>"), std::string::npos) << sdf;
  EXPECT_NE(sdf.find("<uri>file://b.dae</uri>"), std::string::npos) << sdf;
}

// footprint - stand - base = moved - a - tool - tip = b = c, where - is fixed and = turns.
TEST_F(Consumers, GazeboHasAFrameForALinkWithoutMassAndShape) {
  std::string urdf = threeLinks(cube());
  const auto joint = [](const std::string& type, const std::string& parent, const std::string& child) {
    return "<joint name=\"" + parent + "_" + child + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
           "\"/><origin xyz=\"0 0 0.25\"/><axis xyz=\"0 0 1\"/></joint>\n";
  };
  const std::string parent = "<parent link=\"a\"/>";
  urdf.replace(urdf.find(parent), parent.size(), "<parent link=\"tip\"/>");
  std::string more;
  for (const std::string link : {"footprint", "stand", "moved", "tool", "tip"}) more += "<link name=\"" + link + "\"/>\n";
  more += "<link name=\"base\">" + cube() + "</link>\n";
  more += joint("fixed", "footprint", "stand") + joint("fixed", "stand", "base") + joint("continuous", "base", "moved") +
          joint("fixed", "moved", "a") + joint("fixed", "a", "tool") + joint("fixed", "tool", "tip");
  urdf.insert(urdf.find("</robot>"), more);
  RobotResult result = decomposed(urdf);
  addConsumerFiles({Consumer::kGazebo}, folder_ / "three_c", result);
  const std::string& sdf = result.extra_files["model.sdf"];
  for (const char* frame : {"<frame name=\"footprint\" attached_to=\"base\">\n      <pose relative_to=\"__model__\">0 0 0 0 0 0</pose>",
                            "<frame name=\"stand\" attached_to=\"base\">\n      <pose relative_to=\"footprint\">0 0 0.25 0 0 0</pose>",
                            "<frame name=\"tool\" attached_to=\"a\">\n      <pose relative_to=\"a\">0 0 0.25 0 0 0</pose>",
                            "<frame name=\"tip\" attached_to=\"a\">\n      <pose relative_to=\"tool\">0 0 0.25 0 0 0</pose>"})
    EXPECT_NE(sdf.find(frame), std::string::npos) << frame << " in\n" << sdf;
  EXPECT_EQ(fixtures::count(sdf, "<frame "), 4u);
  EXPECT_NE(sdf.find("<link name=\"base\">\n      <pose relative_to=\"stand\">0 0 0.25 0 0 0</pose>"), std::string::npos) << sdf;
  EXPECT_NE(sdf.find("<pose relative_to=\"tip\">0.5 0 0 0 0 0</pose>\n      <parent>a</parent>\n      <child>b</child>"), std::string::npos)
      << "a joint holds links: " << sdf;
  EXPECT_NE(sdf.find("<link name=\"moved\">"), std::string::npos) << "what moves by itself needs a mass";
  EXPECT_EQ(fixtures::count(sdf, "<joint "), 4u) << sdf;
  const std::string notes = ::testing::PrintToString(result.report.notes);
  EXPECT_NE(notes.find("links 'a', 'b', 'c' and 2 more have no <inertial>"), std::string::npos) << notes;
}

TEST_F(Consumers, GazeboHasAnotherNameForAJointThatIsCalledAsALink) {
  std::string urdf = threeLinks(cube());
  for (const std::string from : {"joint name=\"ab\"", "joint name=\"bc\""})
    urdf.replace(urdf.find(from), from.size(), from == "joint name=\"ab\"" ? "joint name=\"b\"" : "joint name=\"b_joint\"");
  RobotResult result = decomposed(urdf);
  addConsumerFiles({Consumer::kGazebo}, folder_ / "three_c", result);
  const std::string& sdf = result.extra_files["model.sdf"];
  EXPECT_EQ(fixtures::count(sdf, "<joint name=\"b_joint_joint\" type=\"revolute\">"), 1u) << sdf;
  EXPECT_EQ(fixtures::count(sdf, "<pose relative_to=\"b_joint_joint\">"), 1u) << sdf;
  EXPECT_EQ(fixtures::count(sdf, "<joint name=\"b_joint\" type=\"revolute\">"), 1u) << sdf;
  ASSERT_FALSE(result.report.notes.empty());
  EXPECT_NE(result.report.notes.back().find("the joint 'b' is 'b_joint_joint'"), std::string::npos) << result.report.notes.back();
}

}  // namespace
}  // namespace collision_hulls
