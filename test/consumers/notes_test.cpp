// What consumers cannot take, or assume, is said in notes.
#include "consumers/fixture.h"

namespace collision_hulls {
namespace {

using ConsumerNotes = Consumers;

TEST_F(ConsumerNotes, SimulatorsSayWhatTheyTakeLinksWithoutInertialToWeigh) {
  const auto noted = [&](Consumer consumer, const std::string& urdf) { return notesOf(consumer, urdf); };
  std::string urdf = threeLinks(cube());
  EXPECT_NE(noted(Consumer::kMujoco, urdf).find("links 'b', 'c' have no <inertial>: the file gives such links a density of 1 kg/m^3"),
            std::string::npos)
      << "a stands still: " << noted(Consumer::kMujoco, urdf);
  EXPECT_NE(noted(Consumer::kGazebo, urdf).find("links 'a', 'b', 'c' have no <inertial>: SDF assumes a mass of 1 kg"), std::string::npos)
      << noted(Consumer::kGazebo, urdf);
  EXPECT_NE(noted(Consumer::kDart, urdf).find("links 'a', 'b', 'c' have no <inertial>: DART assumes a mass of 1 kg"), std::string::npos)
      << noted(Consumer::kDart, urdf);
  EXPECT_EQ(noted(Consumer::kMoveit, urdf).find("<inertial>"), std::string::npos);
  const std::string inertial =
      "<inertial><mass value=\"2\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>";
  for (const std::string link : {"<link name=\"a\">", "<link name=\"b\">", "<link name=\"c\">"})
    urdf.insert(urdf.find(link) + link.size(), inertial);
  for (const Consumer consumer : {Consumer::kMujoco, Consumer::kGazebo, Consumer::kDart})
    EXPECT_EQ(noted(consumer, urdf).find("<inertial>"), std::string::npos) << noted(consumer, urdf);
}

// MuJoCo and Isaac Sim would take the convex hull of a mesh that was kept, or read none of its formats.
TEST_F(ConsumerNotes, SayWhatTheyLeaveOut) {
  options_.links = "[ac]";
  const std::string urdf = threeLinks(cube());
  for (const Consumer consumer : {Consumer::kMujoco, Consumer::kIsaac})
    for (const char* part :
         {"link 'b' has a mesh that is not a hull of this output; the file leaves it out", "(its action is decompose, and"})
      EXPECT_NE(notesOf(consumer, urdf).find(part), std::string::npos) << notesOf(consumer, urdf);
  EXPECT_NE(notesOf(Consumer::kMujoco, urdf).find("leaves it out, as MuJoCo would take its convex hull, which"), std::string::npos);
  EXPECT_NE(notesOf(Consumer::kIsaac, urdf).find("leaves it out, as the reader would choose an approximation of it;"), std::string::npos);
  for (const Consumer consumer : {Consumer::kGazebo, Consumer::kDart})
    EXPECT_EQ(notesOf(consumer, urdf).find("leaves it out"), std::string::npos) << "it has the mesh";
  options_.links.clear();
  for (const Consumer consumer : {Consumer::kMujoco, Consumer::kIsaac})
    EXPECT_EQ(notesOf(consumer, urdf).find("leaves it out"), std::string::npos);
}

TEST_F(ConsumerNotes, SayWhichJointsTheyHaveNot) {
  const auto with = [&](const std::string& joints) {
    std::string text = threeLinks(cube());
    for (const char* name : {"d", "e", "f"}) text.insert(text.find("</robot>"), "<link name=\"" + std::string(name) + "\"/>");
    return text.insert(text.rfind("</robot>"), joints);
  };
  const auto joint = [](const std::string& child, const std::string& type, const std::string& more = "") {
    return "<joint name=\"j" + child + "\" type=\"" + type + "\"><parent link=\"c\"/><child link=\"" + child +
           "\"/><limit lower=\"-1\" upper=\"1\" effort=\"5\" velocity=\"2\"/>" + more + "</joint>";
  };
  const std::string mimic = "<mimic joint=\"ab\"/>";
  const std::string urdf = with(joint("d", "planar") + joint("e", "floating") + joint("f", "revolute", mimic));
  const std::string mujoco = notesOf(Consumer::kMujoco, urdf), gazebo = notesOf(Consumer::kGazebo, urdf),
                    dart = notesOf(Consumer::kDart, urdf), follows = "joints that mimic others ('jf') move by themselves, as ";
  EXPECT_NE(mujoco.find("planar joints ('jd') are fixed"), std::string::npos) << mujoco;
  EXPECT_EQ(mujoco.find("mimic"), std::string::npos) << "it has them";
  EXPECT_NE(gazebo.find("floating and planar joints ('jd', 'je') are fixed"), std::string::npos) << gazebo;
  EXPECT_NE(gazebo.find(follows + "SDF 1.9"), std::string::npos) << gazebo;
  EXPECT_NE(dart.find("planar joints ('jd') are fixed"), std::string::npos) << dart;
  EXPECT_NE(dart.find(follows + "a SKEL file"), std::string::npos) << dart;
  const std::string flying = "<robot name=\"drone\"><link name=\"world\"/><link name=\"body\">" + cube() +
                             "</link><joint name=\"fly\" type=\"floating\"><parent link=\"world\"/><child link=\"body\"/></joint></robot>";
  EXPECT_EQ(notesOf(Consumer::kGazebo, flying).find("fixed"), std::string::npos) << "a link without a joint floats in SDF";
  const std::string locked = with(joint("d", "fixed", mimic) + joint("e", "fixed") + joint("f", "fixed"));
  for (const Consumer consumer : {Consumer::kMujoco, Consumer::kGazebo, Consumer::kDart})
    EXPECT_EQ(notesOf(consumer, locked).find("joint"), std::string::npos) << notesOf(consumer, locked);
}

// A hostile description has joints by the thousand.
TEST_F(ConsumerNotes, FewOfManyJointsAreNamed) {
  std::string urdf = threeLinks(cube());
  for (int i = 0; i < 9; ++i) {
    const std::string number = std::to_string(i);
    urdf.insert(urdf.rfind("</robot>"), "<link name=\"l" + number + "\"/><joint name=\"j" + number +
                                            "\" type=\"planar\"><parent link=\"c\"/><child link=\"l" + number + "\"/></joint>");
  }
  EXPECT_NE(notesOf(Consumer::kMujoco, urdf).find("planar joints ('j0', 'j1', 'j2' and 6 more) are fixed"), std::string::npos)
      << notesOf(Consumer::kMujoco, urdf);
}

// It refuses the whole description for one mesh that it does not find. Also tests src/consumers/bullet.cpp.
TEST_F(ConsumerNotes, BulletSaysWhichMeshesItWillNotFind) {
  const auto seen = [&](const std::string& uri) { return threeLinks("<visual>" + fixtures::meshTag(uri) + "</visual>" + cube()); };
  const std::string refuses = "refuses the description for 1 mesh, such as '";
  EXPECT_EQ(notesOf(Consumer::kBullet, seen("../meshes/cube.obj")).find(refuses), std::string::npos);
  const std::string own = notesOf(Consumer::kBullet, seen("file:///robots/skin.obj"));
  EXPECT_NE(own.find(refuses + "file:///robots/skin.obj': name the files in the input relative to its folder, and add --rebase --uri "
                               "relative\n"),
            std::string::npos)
      << own;
}

// It knows no package path: a folder of the package's name has to be above the description.
TEST_F(ConsumerNotes, BulletSaysWhichPackagesItWillNotFind) {
  fixtures::write(folder_ / "near_description/meshes/skin.obj", "o skin");
  const auto notes = [&](const std::string& uri) {
    return notesOf(Consumer::kBullet, threeLinks("<visual>" + fixtures::meshTag(uri) + "</visual>" + cube()));
  };
  for (const std::string found : {"package://near_description/meshes/skin.obj", "model://near_description/meshes/skin.obj"})
    EXPECT_EQ(notes(found).find("refuses"), std::string::npos) << notes(found);
  const std::string far = notes("package://far_description/meshes/skin.obj");
  EXPECT_NE(far.find("not where ROS has it, and refuses the description for 1 mesh, such as 'package://far_description/meshes/skin.obj': "
                     "link the folder of package 'far_description', under its name, into '" +
                     folder_.path().string() + "'\n"),
            std::string::npos)
      << far;
}

// Those that lie in no package.
TEST_F(ConsumerNotes, BulletSaysHowRebasedMeshesAreFound) {
  fixtures::write(folder_ / "skin.obj", fixtures::obj(test_shapes::box(0.2, 0.2, 0.2)));
  const std::string urdf = threeLinks("<visual>" + fixtures::meshTag("skin.obj") + "</visual>" + cube());
  const auto noted = [&] {
    RobotResult result =
        decomposeRobot(parseRobotDescription(urdf, folder_ / "three.urdf"), PackageFinder(), options_, folder_ / "three_c");
    addConsumerFiles({Consumer::kBullet}, folder_ / "three_c", result);
    return ::testing::PrintToString(result.report.notes);
  };
  options_.rebase = true;
  EXPECT_NE(noted().find("such as '" + fileUri(folder_ / "skin.obj") + "': add --uri relative"), std::string::npos) << noted();
  options_.uri = UriStyle::kRelative;
  EXPECT_EQ(noted().find("refuses"), std::string::npos) << noted();
}

TEST_F(ConsumerNotes, AnImpossibleInertiaIsBalancedWithANote) {
  const std::string inertial =
      "<inertial><mass value=\"2\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"4\"/></inertial>";
  RobotResult result = decomposed(threeLinks(inertial + cube()));
  addConsumerFiles({Consumer::kGazebo}, folder_ / "three_c", result);
  EXPECT_EQ(fixtures::count(result.extra_files["model.sdf"], "<izz>2</izz>"), 1u);
  ASSERT_FALSE(result.report.notes.empty());
  const std::string all = ::testing::PrintToString(result.report.notes);
  EXPECT_NE(
      all.find(
          "link 'c': moments of inertia of 1 1 4 are impossible (one is not positive, or larger than the sum of the others); the files"),
      std::string::npos)
      << all;
}

TEST_F(ConsumerNotes, TheInertiaOfAFlatPlateIsPossible) {
  for (const char* moments :
       {"ixx=\"0.002\" iyy=\"0.002\" izz=\"0.004\"", "ixx=\"0.1\" iyy=\"0.2\" izz=\"0.3\"", "ixx=\"1\" iyy=\"1\" izz=\"0.0000001\""}) {
    RobotResult result = decomposed(threeLinks("<inertial><mass value=\"2\"/><inertia ixy=\"0\" ixz=\"0\" iyz=\"0\" " +
                                               std::string(moments) + "/></inertial>" + cube()));
    addConsumerFiles({Consumer::kGazebo}, folder_ / "three_c", result);
    const std::string all = ::testing::PrintToString(result.report.notes), sdf = result.extra_files["model.sdf"];
    EXPECT_EQ(all.find("impossible"), std::string::npos) << all;
    const auto value = [&](const std::string& name) { return std::stod(sdf.substr(sdf.find("<" + name + ">") + name.size() + 2)); };
    const std::array<double, 3> written{value("ixx"), value("iyy"), value("izz")};
    const double most = *std::max_element(written.begin(), written.end()), others = written[0] + written[1] + written[2] - most;
    EXPECT_LT(most, others);
    EXPECT_GT(most, (1 - 1e-5) * others);
  }
}

TEST_F(ConsumerNotes, NoInertiaIsTheLeast) {
  const std::string inertial =
      "<inertial><mass value=\"2\"/><inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial>";
  RobotResult result = decomposed(threeLinks(inertial + cube()));
  addConsumerFiles({Consumer::kGazebo}, folder_ / "three_c", result);
  EXPECT_EQ(fixtures::count(result.extra_files["model.sdf"], "<izz>0.000000001</izz>"), 1u) << result.extra_files["model.sdf"];
  const std::string all = ::testing::PrintToString(result.report.notes);
  EXPECT_NE(all.find("of 0 0 0 are impossible (one is not positive, or larger than the sum of the others); the files of --for use their "
                     "mean instead, but at least 1e-9"),
            std::string::npos)
      << all;
}

}  // namespace
}  // namespace collision_hulls
