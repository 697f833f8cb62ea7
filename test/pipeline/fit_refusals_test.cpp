// What a fit to a scene refuses. Tests src/pipeline/scene/fit_refusals.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_hulls/error.h"
#include "pipeline/fixtures.h"
#include "pipeline/scene_run.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using fixtures::FitRobotToScene;

TEST_F(FitRobotToScene, RejectsMethodsWithoutATree) {
  options_.method = Method::kHacd;
  try {
    run(fixtures::link("base", bracket()));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    EXPECT_NE(std::string(error.what()).find("hacd"), std::string::npos);
  }
}

TEST_F(FitRobotToScene, RejectsAnotherTolerancesTree) {
  options_.tree = shareOf(0.005);
  try {
    run(fixtures::link("base", bracket()));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    EXPECT_NE(std::string(error.what()).find("0.5%"), std::string::npos);
  }
}

TEST_F(FitRobotToScene, RejectsWhatAFitDoesNotKeep) {
  const auto message = [&] {
    try {
      run(fixtures::link("base", bracket()));
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
      return std::string(error.what());
    }
    return std::string();
  };
  const Options plain = options_;
  options_.time_limit = 5;
  EXPECT_NE(message().find("time-limit"), std::string::npos);
  options_ = plain;
  options_.padding = 0.02;
  EXPECT_NE(message().find("padding '2cm' does not apply"), std::string::npos);
  options_ = plain;
  LinkRule padded;
  padded.pattern = "ba.*";
  padded.settings.padding = 0.03;
  options_.rules = {padded};
  EXPECT_NE(message().find("padding '3cm' of link 'base'"), std::string::npos);
  options_ = plain;
  RegionRule region;
  region.pattern = "base";
  region.name = "mouth";
  region.shape = RegionHalfSpace{{0, 0, 1}, 0};
  options_.region_rules = {region};
  EXPECT_NE(message().find("region 'mouth' does not apply"), std::string::npos);
}

TEST_F(FitRobotToScene, AClearanceBeyondTheRobotsReachIsRefused) {
  const std::string links = fixtures::link("base", bracket()) + fixtures::link("tip", bracket(), "base");  // 0.5 m above it
  request_.clearance = 20;
  try {
    run(links);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    for (const char* part : {"clearance '20m'", "500 mm", "did you mean 2cm?"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
  request_.clearance = 1;
  EXPECT_NO_THROW(run(links));
}

TEST_F(FitRobotToScene, FindsWrongUseBeforeTheWork) {
  const std::string part = fixtures::link("base", bracket()) + fixtures::link("tip", "", "base");
  const auto code = [&](const std::string& links) {
    RunControl control;
    bool began = false;
    control.progress = [&](double) { began = true; };
    try {
      const RobotDescription robot = readRobotDescription(fixtures::write(folder_ / "urdf/arm.urdf", fixtures::robot("arm", links)));
      fitRobotToScene(robot, defaultPackageFinder(), request_, options_, folder_ / "out", control);
    } catch (const Error& error) {
      EXPECT_FALSE(began);
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  EXPECT_EQ(code(part + "<link name=\"t\"/><joint name=\"m\" type=\"continuous\"><parent link=\"tip\"/><child link=\"t\"/>"
                        "<mimic joint=\"nothing\"/></joint>"),
            ErrorCode::kNotARobot);
  for (const Configuration& wrong : {Configuration{0}, Configuration{std::nan("")}}) {
    request_.configurations = {{}, wrong};
    EXPECT_EQ(code(part), ErrorCode::kBadOption);
  }
  request_.configurations.clear();
  request_.clearance = 0;
  EXPECT_EQ(code(part), ErrorCode::kBadOption);
}

TEST_F(FitRobotToScene, NamesTheSourceWithMeshesIfTheChosenOneHasNone) {
  const std::string ball = collision("<geometry><sphere radius=\"0.02\"/></geometry>");
  const std::string visual = "    <visual>\n      " + fixtures::meshTag("../meshes/bracket.obj") + "\n    </visual>\n";
  try {
    run(fixtures::link("base", visual + ball));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    for (const char* part : {"no mesh", "--source visual"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace collision_hulls
