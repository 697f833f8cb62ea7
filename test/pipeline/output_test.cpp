// Also tests src/pipeline/collision_model.cpp and src/pipeline/how_to_use.cpp.
#include "collision_hulls/pipeline/output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "base/descriptor.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "pipeline/fixtures.h"
#include "pipeline/sample_output.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::expectError;
using fixtures::sample;
using fixtures::TempFolder;

TEST(WriteOutput, RefusesFoldersItDidNotWrite) {
  const TempFolder folder;
  fixtures::write(folder / "foreign/notes.txt", "mine");
  fixtures::write(folder / "other_report/report.json", "{\"report\": 1}");
  fixtures::write(folder / "no_json/report.json", "collision_hulls");
  fixtures::write(folder / "file", "");
  const auto before = fixtures::contents(folder.path());
  for (const char* name : {"foreign", "other_report", "no_json", "file"}) expectError(folder / name, ErrorCode::kNotOurOutput);
  EXPECT_EQ(fixtures::contents(folder.path()), before);
}

TEST(WriteOutput, NobodyIsToldToRemoveAPackage) {
  const TempFolder folder;
  fixtures::write(folder / "notes/notes.txt", "");
  fixtures::write(folder / "robot/package.xml", "<package/>");
  const auto refusal = [&](const std::string& name) {
    try {
      checkOutput(folder / name);
      return std::string("accepted");
    } catch (const Error& e) {
      return std::string(e.what());
    }
  };
  EXPECT_NE(refusal("notes").find("choose another output, or remove it yourself"), std::string::npos) << refusal("notes");
  EXPECT_NE(refusal("robot").find("choose another output"), std::string::npos) << refusal("robot");
  EXPECT_EQ(refusal("robot").find("remove"), std::string::npos) << refusal("robot");
}

TEST(WriteOutput, UnwritablePlaces) {
  const TempFolder folder;
  fixtures::write(folder / "file", "");
  expectError(folder / "file/out", ErrorCode::kUnwritableOutput);
  if (geteuid() != 0) {  // root may write everywhere
    fs::create_directory(folder / "locked");
    fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    expectError(folder / "locked/out", ErrorCode::kUnwritableOutput);
  }
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(WriteOutput, APageOfAllRowsAndModels) {
  const TempFolder folder;
  RobotResult result = sample();
  result.elements.pop_back();  // a row without an element is in the table alone
  result.report.models.resize(1);
  result.report.models[0].model = "contact";
  result.report.models[0].links = {result.report.links[0]};
  result.models.resize(1);
  result.models[0].elements = {result.elements[0]};
  writeOutput(result, folder / "out");
  const std::string page = fixtures::read(folder / "out/report.html");
  EXPECT_EQ(occurrences(page, "<h1>My Arm</h1>"), 1u);
  EXPECT_EQ(occurrences(page, "<tbody data-row="), 3u);
  EXPECT_EQ(occurrences(page, "\"link\":\"a\""), 2u);
  EXPECT_EQ(occurrences(page, "\"link\":\"b\""), 0u);
  EXPECT_EQ(std::count(result.report.files.begin(), result.report.files.end(), "report.html"), 1);
}

TEST(WriteOutput, NoPageWhereNoneIsWanted) {
  const TempFolder folder;
  RobotResult first = sample(), second = sample();
  writeOutput(first, folder / "out");
  second.report.options.html = false;
  writeOutput(second, folder / "out");
  EXPECT_FALSE(fs::exists(folder / "out/report.html")) << "nor that of the run before";
  EXPECT_EQ(fixtures::read(folder / "out/CMakeLists.txt").find("report.html"), std::string::npos);
}

TEST(WriteOutput, RefusesToReplaceTheWorkingFolder) {
  const TempFolder folder;
  const fs::path before = fs::current_path(), out = folder / "out", within = out / "a/b";
  fs::create_directories(within);
  for (const fs::path& here : {out, within}) {
    fs::current_path(here);
    for (const fs::path& name : {fs::relative(out, here), out}) {
      try {
        checkOutput(name.string());
        ADD_FAILURE() << name << " from " << here;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput) << error.what();
        for (const char* part :
             {here == out ? "but it is the current folder;" : "lies in it;", "choose another output, such as a folder within it"})
          EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      }
    }
  }
  fs::current_path(folder / ".");
  fs::remove_all(out / "a");
  EXPECT_NO_THROW(checkOutput("out"));
  fs::current_path(before);
}

TEST(WriteOutput, NeedsAName) {
  const TempFolder folder;
  const std::string mesh = fixtures::write(folder / "box.obj", fixtures::obj(test_shapes::box(1, 1, 1)));
  Input input;
  input.kind = Input::Kind::kMesh;
  input.path = mesh;
  const std::vector<std::function<void()>> calls{[] { checkOutput(""); }, [&] { decompose(input, Options(), ""); }};
  for (const auto& call : calls) {
    try {
      call();
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput);
    }
  }
}

TEST(WriteOutput, APackage) {
  const TempFolder folder;
  RobotResult result = sample();
  writeOutput(result, folder / "out");
  const auto files = fixtures::contents(folder.path());
  std::vector<std::string> names;
  for (const auto& [name, text] : files) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"out/CMakeLists.txt", "out/config/My_Arm_hulls.yaml", "out/meshes/a/0_0.stl",
                                             "out/meshes/a/0_1.stl", "out/meshes/b/0_0.stl", "out/meshes/b/0_1.stl", "out/package.xml",
                                             "out/report.html", "out/report.json", "out/urdf/My_Arm.urdf"}));
  EXPECT_EQ(files.at("out/urdf/My_Arm.urdf"), result.urdf);
  EXPECT_NE(files.at("out/package.xml").find("<name>out</name>"), std::string::npos) << "as its folder";
  EXPECT_NE(files.at("out/CMakeLists.txt").find("project(out)"), std::string::npos);
  const auto report = nlohmann::json::parse(files.at("out/report.json"));
  EXPECT_GT(report["links"][1]["seconds"]["write"].get<double>(), 0);
}

TEST(WriteOutput, ThePackagesName) {
  const TempFolder folder;
  RobotResult result = sample();
  const auto name = [&](const std::string& output) {
    writeOutput(result, folder / output);
    const std::string text = fixtures::read(fs::path(folder / output) / "package.xml");
    return text.substr(text.find("<name>") + 6, text.find("</name>") - text.find("<name>") - 6);
  };
  EXPECT_EQ(name("my_robot_collision"), "my_robot_collision");
  EXPECT_EQ(name("deep/cell/"), "cell");
  EXPECT_EQ(name("deep/../My Robot"), "my_robot") << "made legal";
  result.report.options.package_name = "another";
  EXPECT_EQ(name("my_robot_collision"), "another");
}

TEST(HowToUse, AsTheUrisWantIt) {
  const TempFolder folder;
  RobotResult result = sample();
  const std::string out = folder / "arm_collision", urdf = out + "/urdf/My_Arm.urdf";
  const auto expect = [&](const std::vector<std::string>& parts, const std::vector<std::string>& absent) {
    const std::string text = howToUse(result, out);
    for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << text;
    for (const std::string& part : absent) EXPECT_EQ(text.find(part), std::string::npos) << text;
  };
  const std::string in_package = "textfile=\"$(find arm_collision)/urdf/My_Arm.urdf\"/>";
  const std::string export_line = "export ROS_PACKAGE_PATH=" + folder.path().string() + ":$ROS_PACKAGE_PATH";
  writeOutput(result, out);
  expect({"Written to " + out + "\n", in_package, export_line}, {});
  setenv("ROS_PACKAGE_PATH", folder.path().c_str(), 1);
  expect({in_package}, {export_line});
  unsetenv("ROS_PACKAGE_PATH");
  fixtures::write(folder / "arm/package.xml", "<package><name>arm</name></package>");
  writeOutput(result, folder / "arm/out/hulls");
  EXPECT_NE(howToUse(result, folder / "arm/out/hulls").find("export ROS_PACKAGE_PATH=" + folder.path().string() + "/arm/out/hulls:$"),
            std::string::npos)
      << "ROS looks for no package within one";
  writeOutput(result, folder / "my out/arm");
  EXPECT_NE(howToUse(result, folder / "my out/arm").find("export ROS_PACKAGE_PATH='" + folder.path().string() + "/my out':$"),
            std::string::npos);
  fixtures::write(folder / "robots/arm_description/package.xml", "<package><name>arm_description</name></package>");
  result.report.input_path = folder / "robots/arm_description/urdf/arm.urdf";
  result.urdf =
      R"(<robot name="My Arm"><link name="l"><visual><geometry><mesh filename="package://arm_description/l.stl"/></geometry></visual></link></robot>)";
  expect({"export ROS_PACKAGE_PATH=" + folder.path().string() + ":" + folder.path().string() + "/robots:$ROS_PACKAGE_PATH"}, {});
  result.report.input_path = folder / "elsewhere/arm.urdf";
  const std::string others = folder.path().string() + "/robots:$ROS_PACKAGE_PATH";
  EXPECT_EQ(howToUse(result, out).find(others), std::string::npos) << "where it lies, nobody knows";
  EXPECT_NE(howToUse(result, out, {folder / "robots"}).find(others), std::string::npos) << howToUse(result, out, {folder / "robots"});
  setenv("ROS_PACKAGE_PATH", (folder.path().string() + "/robots").c_str(), 1);
  expect({export_line}, {"/robots"});
  unsetenv("ROS_PACKAGE_PATH");
  result.report.options.uri = UriStyle::kFile;
  expect({"textfile=\"" + urdf + "\"/>"}, {"ROS_PACKAGE_PATH"});
  result.report.options.uri = UriStyle::kRelative;
  expect({urdf, "--uri package"}, {"ROS_PACKAGE_PATH", "textfile"});
  result.single_mesh = true;
  result.report.links.front().files = {"part_hulls.obj", "hull_0.stl", "hull_1.stl"};
  expect({out + "/part_hulls.obj", "<mesh filename=\"file://" + out + "/hull_0.stl\"/> to hull_1.stl"}, {"package"});
}

TEST(WriteReport, InOneRename) {
  const TempFolder folder;
  const Report report = sample().report;
  writeReport(report, folder / "deep/report.json");
  EXPECT_EQ(fixtures::read(folder / "deep/report.json"), toJson(report));
  EXPECT_EQ(fixtures::contents(folder.path()).size(), 1u);
  fs::create_directory(folder / "folder");
  EXPECT_THROW(writeReport(report, folder / "folder"), Error);
  EXPECT_EQ(fixtures::contents(folder.path()).size(), 1u) << "a half-written file is left";
}

TEST(WriteReport, FollowsALink) {
  const TempFolder folder;
  const Report report = sample().report;
  fixtures::write(folder / "old.json", "old");
  fs::create_symlink("old.json", folder / "link.json");
  fs::create_symlink("new.json", folder / "dangling.json");
  for (const char* link : {"link.json", "dangling.json"}) {
    writeReport(report, folder / link);
    EXPECT_TRUE(fs::is_symlink(folder / link));
  }
  EXPECT_EQ(fixtures::read(folder / "old.json"), toJson(report));
  EXPECT_EQ(fixtures::read(folder / "new.json"), toJson(report));
}

TEST(WriteReport, IntoAPipe) {
  const TempFolder folder;
  const Report report = sample().report;
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(0, mkfifo(pipe.c_str(), 0600));
  const Descriptor reader(open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  writeReport(report, pipe);  // it takes all of it
  std::string text(std::size_t{1} << 16, '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(reader.number(), text.data(), text.size()))));
  EXPECT_EQ(text, toJson(report));
  EXPECT_TRUE(fs::is_fifo(pipe));
}

}  // namespace
}  // namespace collision_hulls
