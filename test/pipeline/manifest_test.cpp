#include "pipeline/package/manifest.h"

#include <gtest/gtest.h>

#include "base/roots.h"
#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

using fixtures::meshTag;

constexpr const char* kNobody = "<maintainer email=\"nobody@example.invalid\">nobody</maintainer>";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(PackageXml, DependsOnThePackagesThatItNames) {
  const auto urdf = [](const std::string& uri) {
    return fixtures::robot("r", fixtures::link("a", "<visual>" + meshTag(uri) + "</visual>"));
  };
  RobotResult result;
  result.urdf = fixtures::robot(
      "r", fixtures::link("a", "<visual>" + meshTag("package://my_robot/a.dae") + "</visual><visual>" + meshTag("package://arm/b.dae") +
                                   "</visual><collision>" + meshTag("package://out/meshes/a/0_0.stl") + "</collision>"));
  result.models.resize(3);
  result.models[0].urdf = urdf("package://arm/c.dae");
  result.models[1].urdf = urdf("package://a&lt;b/c.dae");
  result.models[2].urdf = urdf("../meshes/c.dae");
  const std::string text = packageXml("out", result);
  EXPECT_TRUE(has(text,
                  "<buildtool_depend>catkin</buildtool_depend>\n  <exec_depend>arm</exec_depend>\n"
                  "  <exec_depend>my_robot</exec_depend>\n  <export>"))
      << text;
  EXPECT_EQ(fixtures::count(text, "exec_depend"), 4u) << text;
  EXPECT_FALSE(has(packageXml("out", RobotResult()), "exec_depend"));
}

TEST(PackageXml, HasTheMaintainersOfTheInputsPackage) {
  const fixtures::TempFolder folder;
  RobotResult result;
  EXPECT_TRUE(has(packageXml("out", result), kNobody)) << "of a parameter";
  result.report.input_path = folder / "arm/urdf/arm.urdf";
  EXPECT_TRUE(has(packageXml("out", result), kNobody)) << "in no package";
  const auto with = [&](const std::string& manifest) {
    fixtures::write(folder / "arm/package.xml", manifest);
    return packageXml("out", result);
  };
  const std::string two =
      "  <maintainer email=\"a@b.org\">A &amp; B</maintainer>\n  <maintainer email=\"c@d.org\">J\xC3\xBCrgen</maintainer>\n";
  EXPECT_TRUE(has(with("<?xml version='1.0' encoding='UTF-8'?><package><name>arm</name>" + two + "</package>"), two + "  <license>"));
  {
    const Confinement confinement({{folder / "elsewhere"}, {}, {}, {}, "", ""});
    EXPECT_TRUE(has(packageXml("out", result), kNobody)) << "it may not be read";
  }
  for (const char* none : {"<package><name>arm</name></package>", "<package><name>arm</name><maintainer>a</maintainer></package>",
                           "<package>", "", "<package><name>arm</name><maintainer email=\"a@b.org\"/></package>",
                           "<?xml version='1.0' encoding='latin1'?><package><maintainer email='a@b.org'>J\xFCrgen</maintainer></package>"})
    EXPECT_TRUE(has(with(none), kNobody)) << none;
}

TEST(CMakeLists, InstallsTheFoldersAndFilesOfTheOutput) {
  RobotResult result;
  result.extra_files["mjcf/arm.xml"] = result.extra_files["model.sdf"] = "";
  const std::string text = cmakeLists("out", result);
  EXPECT_TRUE(has(text, "project(out)")) << text;
  EXPECT_TRUE(has(text, "install(DIRECTORY config meshes mjcf urdf DESTINATION")) << text;
  result.report.options.html = false;
  EXPECT_FALSE(has(cmakeLists("out", result), "report.html"));
}

}  // namespace
}  // namespace collision_hulls
