// Where the URIs of a run's new description lead. rebase_test.cpp has the cases of --rebase.
// Also tests src/pipeline/collision_model.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "collision_hulls/pipeline/output.h"
#include "pipeline/robot_run.h"

namespace collision_hulls {
namespace {

using fixtures::link;
using fixtures::meshTag;

class OutputUris : public fixtures::RobotRun {};

TEST_F(OutputUris, Styles) {
  const auto uri = [&](UriStyle style) {
    options_.uri = style;
    const RobotResult result = run(link("base", collision("box.obj")));
    return parseRobotDescription(result.urdf).links[0].collisions[0].uri;
  };
  EXPECT_EQ(uri(UriStyle::kPackage), "package://out/meshes/base/0_0.stl");
  EXPECT_EQ(uri(UriStyle::kFile), "file://" + (folder_ / "out/meshes/base/0_0.stl"));
  EXPECT_EQ(uri(UriStyle::kRelative), "../meshes/base/0_0.stl");
}

TEST_F(OutputUris, EscapesFolderNames) {
  options_.uri = UriStyle::kFile;
  RobotResult result =
      decomposeRobot(description(link("base", collision("box.obj"))), defaultPackageFinder(), options_, folder_ / "a b#%20é");
  const std::string uri = parseRobotDescription(result.urdf).links[0].collisions[0].uri;
  EXPECT_EQ(uri, "file://" + (folder_ / "a%20b%23%2520é/meshes/base/0_0.stl"));
  writeOutput(result, folder_ / "a b#%20é");
  EXPECT_EQ(resolveUri(uri, "", defaultPackageFinder()), folder_ / "a b#%20é/meshes/base/0_0.stl");
}

TEST_F(OutputUris, AreWrittenWhereTheyLead) {
  const auto refused = [&](UriStyle style, const std::string& place) {
    options_.uri = style;
    RobotResult result = run(link("base", collision("box.obj")));  // for folder_ / "out"
    try {
      writeOutput(result, folder_ / place);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kBadOption) << e.what();
      EXPECT_NE(std::string(e.what()).find("give writeOutput() the folder"), std::string::npos) << e.what();
      return true;
    }
    return false;
  };
  for (const UriStyle style : {UriStyle::kPackage, UriStyle::kFile, UriStyle::kRelative}) {
    EXPECT_TRUE(refused(style, "other"));
    EXPECT_FALSE(refused(style, "out/"));
    EXPECT_EQ(refused(style, "copy/out"), style != UriStyle::kPackage) << "a package may lie anywhere";
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "other"));
}

TEST_F(OutputUris, NotesThoseThatNowResolveElsewhere) {
  const auto notes = [&](const std::string& links) { return run(links).report.notes; };
  const std::string absolute = "    <visual>" + meshTag("file://" + (folder_ / "meshes/box.obj")) + "</visual>\n";
  for (const UriStyle style : {UriStyle::kPackage, UriStyle::kRelative}) {
    options_.uri = style;
    EXPECT_TRUE(notes(link("base", absolute + collision("bracket.obj"))).empty()) << "a URI that is replaced needs no note";
    const auto kept = notes(link("base", visual("box.obj") + visual("box.obj", "2 2 2") + collision("box.obj")));
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].rfind("1 mesh URI is", 0), 0u) << kept[0];
    for (const std::string part : {"'../meshes/box.obj'", "out/urdf/arm.urdf'", ": add --rebase"})
      EXPECT_NE(kept[0].find(part), std::string::npos) << kept[0];
  }
  options_.links = "tip";
  EXPECT_EQ(notes(link("base", collision("bracket.obj")) + link("tip", collision("box.obj"), "base")).size(), 1u) << "collisions that stay";
}

TEST_F(OutputUris, TheDescriptionOfARobotThatIsNamedAsAFile) {
  for (const std::string name : {"cube", "cube.urdf", "cube.urdf.xacro", "cube.URDF"}) {
    const std::string file = fixtures::write(folder_ / "urdf/c.urdf", fixtures::robot(name, link("base", collision("box.obj"))));
    const RobotResult result = decomposeRobot(readRobotDescription(file), defaultPackageFinder(), options_, folder_ / "out");
    EXPECT_EQ(result.report.urdf, "urdf/cube.urdf") << name;
  }
}

TEST_F(OutputUris, RebasingIsNotProposedForFilesThatDoNotExist) {
  const std::vector<std::string> notes = run(link("base", visual("gone.obj") + collision("bracket.obj"))).report.notes;
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "1 mesh URI is relative to the folder of the input, such as '../meshes/gone.obj', and stayed so, as no file that may be read "
            "was found there: correct the input");
  EXPECT_EQ(run(link("base", visual("gone.obj") + visual("box.obj") + collision("bracket.obj"))).report.notes.size(), 2u);
}

TEST_F(OutputUris, NotesThoseOfAPackageThatAFolderStandsInFor) {
  const std::string links = link("base", "    <visual>" + meshTag("package://meshes/box.obj") + "</visual>\n" + collision("bracket.obj"));
  const auto mention = [&](const std::string& part) {
    const std::vector<std::string> notes = run(links).report.notes;
    return std::count_if(notes.begin(), notes.end(), [&](const std::string& note) { return note.find(part) != std::string::npos; });
  };
  EXPECT_EQ(mention("1 mesh URI of the new description names a package that was not found, such as 'package://meshes/box.obj'"), 1);
  RobotResult result = run(links);
  writeOutput(result, folder_ / "out");
  EXPECT_EQ(mention("1 mesh URI of the new description names"), 1) << "the hulls' own package is not meant";
  options_.rebase = true;
  EXPECT_EQ(mention("of the new description names"), 0);
  EXPECT_EQ(run(links).urdf.find("package://meshes/"), std::string::npos);
}

TEST_F(OutputUris, RebasedAreFoundFromTheOutput) {
  options_.rebase = true;
  options_.links = "tip";
  const std::string gone = link("gone", visual("gone.obj"), "tip");
  const std::string links = link("base", visual("box.obj") + collision("bracket.obj")) + link("tip", visual("box.obj"), "base");
  for (const UriStyle style : {UriStyle::kPackage, UriStyle::kFile, UriStyle::kRelative}) {
    options_.uri = style;
    RobotResult result = run(links);
    EXPECT_TRUE(result.report.notes.empty()) << result.report.notes[0];
    writeOutput(result, folder_ / "out");
    const RobotDescription written = readRobotDescription(folder_ / "out/urdf/arm.urdf");
    for (const LinkDescription& each : written.links)
      EXPECT_EQ(resolveUri(each.visuals.at(0).uri, written.path, defaultPackageFinder()), folder_ / "meshes/box.obj");
    EXPECT_EQ(resolveUri(written.links[0].collisions.at(0).uri, written.path, defaultPackageFinder()), folder_ / "meshes/bracket.obj");
    const std::vector<std::string> notes = run(links + gone).report.notes;
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0],
              "1 mesh URI is relative to the folder of the input, such as '../meshes/gone.obj', and stayed so, as no file that may be read "
              "was found there: correct the input");
  }
}

// The page draws the meshes that links keep.
TEST_F(OutputUris, RebasedOfLinksThatAreKept) {
  options_.rebase = true;
  options_.uri = UriStyle::kRelative;
  options_.rules.resize(1);
  options_.rules[0].pattern = "base";
  options_.rules[0].settings.action = Action::kKeep;
  const RobotResult result = run(link("base", collision("bracket.obj")) + link("tip", collision("box.obj"), "base"));
  ASSERT_EQ(result.kept.size(), 1u);
  EXPECT_EQ(result.kept[0].element.uri, "../../meshes/bracket.obj");
  EXPECT_FALSE(result.kept[0].surface.triangles.empty());
}

}  // namespace
}  // namespace collision_hulls
