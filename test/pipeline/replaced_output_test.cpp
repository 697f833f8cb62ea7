// What becomes of an earlier output. Tests src/pipeline/output.cpp.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/roots.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/output.h"
#include "counted_looks.h"
#include "pipeline/fixtures.h"
#include "pipeline/sample_output.h"
#include "shapes.h"
#include "umask.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::expectError;
using fixtures::sample;
using fixtures::TempFolder;

TEST(WriteOutput, ReplacesAnEarlierOutputAsAWhole) {
  const TempFolder folder;
  RobotResult result = sample();
  fs::create_directory(folder / "out");  // an empty folder is welcome
  writeOutput(result, folder / "out");
  result.elements.pop_back();
  result.report.links.pop_back();
  writeOutput(result, folder / "out");
  EXPECT_FALSE(fs::exists(folder / "out/meshes/b"));
  EXPECT_TRUE(fs::exists(folder / "out/meshes/a/0_1.stl"));
}

TEST(WriteOutput, TellsOfHullsOfLinksThatWereNotChosen) {
  const TempFolder folder;
  RobotResult result = sample();
  writeOutput(result, folder / "out");
  const auto told = [&](const std::string& links, std::size_t rows) {
    RobotResult some = sample();
    some.report.options.links = links;
    some.report.links.resize(rows), some.elements.resize(rows);
    writeOutput(some, folder / "out");
    return fixtures::joined(some.report.notes);
  };
  EXPECT_EQ(told("a|b", 2), "");
  EXPECT_NE(told("a", 1).find("had hulls of links that this run leaves out, such as 'meshes/b/0_0.stl'"), std::string::npos);
  writeOutput(result, folder / "out");
  EXPECT_EQ(told("", 1), "") << "the description itself has changed";
}

TEST(WriteOutput, RefusesAnEarlierOutputWithAddedFiles) {
  const TempFolder folder;
  RobotResult result = sample();
  result.extra_files["config/My_Arm_disabled.srdf"] = "<robot/>";
  for (const char* added :
       {"launch/mine.launch", ".git/HEAD", "notes.txt", "meshes/a/mine.stl", "urdf/notes.txt", "urdf/mine.urdf", "config/My_Arm.srdf"}) {
    writeOutput(result, folder / "out");
    fixtures::write(folder / ("out/" + std::string(added)), "mine");
    const auto before = fixtures::contents(folder.path());
    expectError(folder / "out", ErrorCode::kNotOurOutput);
    EXPECT_EQ(fixtures::contents(folder.path()), before) << added;
    fs::remove(folder / ("out/" + std::string(added)));
  }
  writeOutput(result, folder / "out");
}

TEST(WriteOutput, LooksAtTheControlForEachFileOfAnEarlierOutput) {
  const TempFolder folder;
  RobotResult result = sample();
  writeOutput(result, folder / "out");
  const auto check = [&](const RunControl& control) { checkOutput(folder / "out", control); };
  EXPECT_GE(looksOf(check), fixtures::contents(folder / "out").size());
  EXPECT_EQ(looksAfterCancel(3, check), 1u);
}

TEST(WriteOutput, RefusesAnEarlierOutputWithALinkToAFolder) {
  const TempFolder folder;
  RobotResult result = sample();
  writeOutput(result, folder / "out");
  fs::create_directory_symlink(folder.path(), folder / "out/link");
  expectError(folder / "out", ErrorCode::kNotOurOutput);
}

TEST(WriteOutput, RefusesAnInvalidReport) {
  const TempFolder folder;
  for (const char* report : {R"({"collision_hulls": "1"})", R"({"collision_hulls": "1", "files": [], "links": [5]})", "[1]", "5", "{"}) {
    fixtures::write(folder / "out/report.json", report);
    expectError(folder / "out", ErrorCode::kNotOurOutput);
  }
}

/// Files, each with where it lies on the disk.
std::map<std::string, ino_t> places(const fs::path& folder) {
  std::map<std::string, ino_t> result;
  for (const auto& [name, text] : fixtures::contents(folder)) {
    struct stat file {};
    if (stat((folder / name).c_str(), &file) == 0) result[name] = file.st_ino;
  }
  return result;
}

TEST(WriteOutput, ReusesIdenticalFiles) {
  const TempFolder folder;
  const Umask usual(022);
  RobotResult result = sample();
  writeOutput(result, folder / "out");
  const auto first = fixtures::contents(folder / "out");
  const auto before = places(folder / "out");
  fixtures::write(folder / "out/meshes/a/0_0.stl", "changed by someone");
  fs::rename(folder / "out/meshes/a/0_1.stl", folder / "elsewhere.stl");
  fs::create_symlink(folder / "elsewhere.stl", folder / "out/meshes/a/0_1.stl");
  result.elements[1].hulls[0] = convexHull(test_shapes::box(4, 5, 6).vertices);
  writeOutput(result, folder / "out");
  const auto after = places(folder / "out");
  for (const char* name : {"package.xml", "CMakeLists.txt", "urdf/My_Arm.urdf", "meshes/b/0_1.stl"})
    EXPECT_EQ(after.at(name), before.at(name));
  for (const char* name : {"meshes/a/0_0.stl", "meshes/a/0_1.stl", "meshes/b/0_0.stl"}) EXPECT_NE(after.at(name), before.at(name));
  auto files = fixtures::contents(folder / "out");
  EXPECT_EQ(files["meshes/a/0_0.stl"], first.at("meshes/a/0_0.stl"));
  EXPECT_EQ(files["meshes/a/0_1.stl"], first.at("meshes/a/0_1.stl"));
  EXPECT_NE(files["meshes/b/0_0.stl"], first.at("meshes/b/0_0.stl"));
  EXPECT_FALSE(fs::is_symlink(folder / "out/meshes/a/0_1.stl"));
}

TEST(WriteOutput, PermissionsAreThoseOfTheLastRun) {
  const TempFolder folder;
  RobotResult result = sample();
  for (const auto& [mask, mode] : {std::pair{077u, fs::perms{0600}}, {022u, fs::perms{0644}}, {077u, fs::perms{0600}}}) {
    const Umask set(mask);
    writeOutput(result, folder / "out");
    for (const auto& [name, place] : places(folder / "out")) EXPECT_EQ(fs::status(folder / ("out/" + name)).permissions(), mode) << name;
  }
}

TEST(WriteOutput, WritesAnewWhatOthersCouldChangeLater) {
  const TempFolder folder;
  RobotResult result = sample();
  writeOutput(result, folder / "out");
  const std::string open = folder / "out/meshes/a/0_0.stl", of_another = folder / "out/package.xml";
  chmod(open.c_str(), 0666);
  const bool gave = chown(of_another.c_str(), 12345, static_cast<gid_t>(-1)) == 0;  // which only root can
  const auto before = places(folder / "out");
  writeOutput(result, folder / "out");
  const auto after = places(folder / "out");
  EXPECT_NE(after.at("meshes/a/0_0.stl"), before.at("meshes/a/0_0.stl"));
  EXPECT_EQ(after.at("package.xml") != before.at("package.xml"), gave);
}

TEST(WriteOutput, CancelLeavesTheOldOutput) {
  const TempFolder folder;
  RobotResult result = sample();
  writeOutput(result, folder / "out");
  const auto before = fixtures::contents(folder.path());
  const RunControl control;
  control.cancel();
  EXPECT_THROW(writeOutput(result, folder / "out", control), Error);
  EXPECT_EQ(fixtures::contents(folder.path()), before);
}

/// A result in which the second mesh failed for this reason.
RobotResult incomplete(ErrorCode code) {
  RobotResult result = sample();
  ElementReport& row = result.report.links[1];
  row.status = Status::kFailed;
  row.error = name(code);
  row.uri = "package://arm/b.stl";
  row.files.clear();
  result.elements[1].hulls.clear();
  return result;
}

TEST(WriteOutput, MeshesThatWereThereBeforeStayIfMemoryOrTimeDidNotSuffice) {
  for (const ErrorCode lacking : {ErrorCode::kOutOfMemory, ErrorCode::kOutOfTime}) {
    const TempFolder folder;
    RobotResult complete = sample(), result = incomplete(lacking);
    writeOutput(complete, folder / "out");
    const auto before = fixtures::contents(folder.path());
    try {
      writeOutput(result, folder / "out");
      ADD_FAILURE() << "replaced";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput);
      for (const char* part : {"stays as it is", "for 1 mesh,", "package://arm/b.stl", "link 'b'", "--replace-complete"})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_EQ(fixtures::contents(folder.path()), before);
    result.report.options.replace_complete = true;
    EXPECT_TRUE(writeOutput(result, folder / "out")) << "if told to";
    EXPECT_FALSE(fs::exists(folder / "out/meshes/b"));
    result.report.options.replace_complete = false;
    EXPECT_TRUE(writeOutput(result, folder / "out")) << "what is there is not complete either";
  }
}

TEST(WriteOutput, MeshesOfAnotherModelStayToo) {
  const TempFolder folder;
  RobotResult complete = sample();
  writeOutput(complete, folder / "out");
  RobotResult result = sample(), other = incomplete(ErrorCode::kOutOfTime);
  result.models.push_back(static_cast<ModelResult>(other));
  result.report.models.push_back(static_cast<ModelReport>(other.report));
  result.report.models[0].model = "coarse";
  const auto before = fixtures::contents(folder.path());
  try {
    writeOutput(result, folder / "out");
    ADD_FAILURE() << "replaced";
  } catch (const Error& error) {
    for (const char* part : {"stays as it is", "for 1 mesh,", "package://arm/b.stl"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
  EXPECT_EQ(fixtures::contents(folder.path()), before);
}

TEST(WriteOutput, OtherFailuresReplaceACompleteOutput) {
  const TempFolder folder;
  RobotResult complete = sample(), result = incomplete(ErrorCode::kNotAMesh);
  writeOutput(complete, folder / "out");
  EXPECT_TRUE(writeOutput(result, folder / "out")) << "another run would not do better";
}

// The node may write to its ~output wherever that lies, and has to find there what it wrote.
TEST(WriteOutput, WhereOnlyTheOutputMayBeWritten) {
  const TempFolder folder;
  const Confinement confinement({{folder / "in", folder / "out"}, {folder / "in"}, {folder / "out"}, {}, "", ""});
  RobotResult result = sample();
  EXPECT_TRUE(writeOutput(result, folder / "out"));
  EXPECT_TRUE(writeOutput(result, folder / "out")) << "over the first";
}

TEST(WriteOutput, SaysThatThePairsOfAFittedModelAreGone) {
  const TempFolder folder;
  RobotResult fitted = sample(), other = sample(), again = sample();
  fitted.extra_files["config/arm_disabled.srdf"] = again.extra_files["config/arm_disabled.srdf"] = "<robot/>";
  writeOutput(fitted, folder / "out");
  EXPECT_TRUE(fitted.report.notes.empty());
  writeOutput(again, folder / "out");
  EXPECT_TRUE(again.report.notes.empty());
  writeOutput(other, folder / "out");
  ASSERT_EQ(other.report.notes.size(), 1u);
  EXPECT_NE(other.report.notes[0].find("had 'config/arm_disabled.srdf'"), std::string::npos) << other.report.notes[0];
  EXPECT_NE(fixtures::read(folder / "out/report.json").find("arm_disabled.srdf"), std::string::npos);
}

}  // namespace
}  // namespace collision_hulls
