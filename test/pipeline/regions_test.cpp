// Regions from the configuration to the hulls: frames, the report, the cache, and a box that FCL moves through a region.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "collision_hulls/config/config.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/query/query_body.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using fixtures::TempFolder;
using nlohmann::json;

/// A gripper of two jaws, 0.16 apart and 0.2 long, in one mesh that its link turns and moves.
class RegionsTest : public ::testing::Test {
 protected:
  RegionsTest() {
    fixtures::write(folder_ / "gripper.obj", fixtures::obj(test_shapes::uChannel(0.2, 0.2, 0.02, 0.1)));
    const std::string turned =
        "<collision><origin xyz=\"0.3 0 0\" rpy=\"1.5707963267948966 0 0\"/>" + fixtures::meshTag("gripper.obj") + "</collision>";
    const std::string plain = "<collision>" + fixtures::meshTag("gripper.obj") + "</collision>";
    fixtures::write(folder_ / "arm.urdf", fixtures::robot("arm", fixtures::link("base", plain) + fixtures::link("hand", turned, "base")));
  }

  RobotResult run(const std::string& config) {
    Options options;
    options.validate = false;
    apply(parseConfig("default: {tolerance: 10cm}\n" + config, "f.yaml"), options);
    return decompose(openInput(folder_ / "arm.urdf"), options, folder_ / "out");
  }

  /// Moves the box in and out of the mouth, along the jaws; true: it touches a hull of the link.
  static bool touches(const RobotResult& result, const std::string& link, const Eigen::Vector3d& size) {
    const QueryBody box({QueryShape::Kind::kBox, size}, Eigen::Isometry3d::Identity());
    for (const ElementResult& element : result.elements) {
      if (element.link != link) continue;
      for (const ConvexHull& hull : element.hulls)
        for (double out = 0; out < 0.3; out += 0.01) {
          const Eigen::Isometry3d place = Eigen::Isometry3d(Eigen::Translation3d(kMouth + Eigen::Vector3d(0, 0, out)));
          if (touch(QueryBody(hull), box, element.source.origin.inverse() * place)) return true;
        }
    }
    return false;
  }

  // In the frame of the hand, whose mesh has its opening along +z and 0.1 along -y.
  inline static const Eigen::Vector3d kMouth{0.4, -0.05, 0.12};
  static constexpr const char* kClear =
      "regions: [{link: hand, name: mouth, box: {center: [0.4, -0.05, 0.26], size: [0.14, 0.3, 0.46]}, keep_clear: true}]";
  TempFolder folder_;
};

TEST_F(RegionsTest, ABoxGoesInAndOutOfAMouthThatIsKeptClear) {
  const Eigen::Vector3d size(0.14, 0.09, 0.1);
  const RobotResult coarse = run("");
  EXPECT_EQ(coarse.report.links[1].hulls, 1u);
  EXPECT_TRUE(touches(coarse, "hand", size));
  const RobotResult clear = run(kClear);
  EXPECT_FALSE(touches(clear, "hand", size));
  EXPECT_EQ(clear.report.links[0].hulls, 1u) << "the base has no region";
  EXPECT_EQ(clear.report.links[1].hulls, 3u);
  EXPECT_EQ(clear.report.links[1].status, Status::kOk) << clear.report.links[1].reason;
}

TEST_F(RegionsTest, TheReportSaysWhatIsProvedInside) {
  const json report = json::parse(toJson(run(kClear).report));
  EXPECT_EQ(report["links"][0]["regions"], json::array());
  const json region = report["links"][1]["regions"].at(0);
  EXPECT_EQ(region["region"], "mouth");
  EXPECT_EQ(region["tolerance"], kRegionSlack);
  EXPECT_EQ(region["protrusion"], 0.0);
  EXPECT_EQ(region["protrusion_found"], 0.0);
  EXPECT_NE(toTable(run(kClear).report)
                .find("\nregion 'mouth': in it, the hulls of hand, gripper.obj protrude by at most 0 mm; its "
                      "tolerance is 0.100 mm\n"),
            std::string::npos)
      << toTable(run(kClear).report);
}

TEST_F(RegionsTest, TheReasonNamesARegionBesideTheTolerance) {
  const ElementReport row = run("links: {hand: {tolerance: 1cm, max_hulls: 1}}\n" + std::string(kClear)).report.links[1];
  EXPECT_EQ(row.status, Status::kDegraded);
  EXPECT_NE(row.reason.find("more than the tolerance of 10 mm: the limit (max-hulls 1) made the hulls coarser; raise it, or the tolerance; "
                            "in region 'mouth' the hulls protrude by up to "),
            std::string::npos)
      << row.reason;
}

TEST_F(RegionsTest, ARegionFarFromTheMeshesIsNoted) {
  const auto notes = [this](const std::string& region) {
    return run("regions: [{link: 'hand|base', name: mouth, keep_clear: true, " + region + "}]").report.notes;
  };
  // The hand's mesh is [0.3, 0.5] x [-0.1, 0] x [0, 0.2] in its link, the base's [0, 0.2] x [0, 0.2] x [0, 0.1]; their diagonals are 0.3.
  EXPECT_EQ(
      notes("box: {center: [400.5, -50, 260], size: [140, 300, 460]}"),
      std::vector<std::string>{
          "region 'mouth' changes nothing: it is at least 330 m from link 'hand'. Regions are in metres, in the frame of their link"});
  EXPECT_EQ(notes("half_space: {normal: [0, -1, 0], offset: 0.15}").size(), 1u);
  EXPECT_EQ(notes("half_space: {normal: [0, -1, 0], offset: 0.12}"), std::vector<std::string>()) << "a table may stand beside the robot";
}

TEST_F(RegionsTest, ARegionThatIsNoFinerIsNoted) {
  const auto notes = [this](const std::string& links, const std::string& tolerance) {
    return run("links: {base: {tolerance: 20cm}}\nregions: [{link: '" + links + "', name: mouth, tolerance: " + tolerance +
               ", box: {center: [0.3, 0, 0.1], size: [0.2, 0.2, 0.2]}}]")
        .report.notes;
  };
  EXPECT_EQ(
      notes("hand", "10cm"),
      std::vector<std::string>{"region 'mouth' changes nothing: its tolerance of 100 mm is no finer than that of 'gripper.obj', 100 mm"});
  EXPECT_EQ(notes("hand", "9cm"), std::vector<std::string>());
  EXPECT_EQ(notes("hand|base", "15cm"), std::vector<std::string>()) << "finer than the base's";
}

TEST_F(RegionsTest, AnotherRegionCostsItsLinkAlone) {
  run(kClear);
  const RobotResult again = run(kClear);
  EXPECT_TRUE(again.report.links[1].cached);
  EXPECT_EQ(again.report.links[1].regions.size(), 1u) << "the cache has the proof";
  std::string wider = kClear;
  wider.replace(wider.find("0.14"), 4, "0.15");
  const RobotResult other = run(wider);
  EXPECT_TRUE(other.report.links[0].cached);
  EXPECT_FALSE(other.report.links[1].cached);
}

TEST_F(RegionsTest, OfASingleMesh) {
  Options options;
  options.validate = false;
  const std::string shape = "box: {center: [0.1, 0.12, 0.05], size: [0.14, 0.18, 0.3]}, keep_clear: true}]";
  apply(parseConfig("default: {tolerance: 10cm}\nregions: [{" + shape, "f.yaml"), options);
  const RobotResult result = decomposeMesh(folder_ / "gripper.obj", options);
  EXPECT_EQ(result.report.links[0].hulls, 3u);
  EXPECT_EQ(result.report.links[0].regions.size(), 1u);
  apply(parseConfig("regions: [{link: hand, " + shape, "f.yaml"), options);
  try {
    decomposeMesh(folder_ / "gripper.obj", options);
    ADD_FAILURE() << "a mesh has no links";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'f.yaml', line 1: link 'hand' of region '1'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace collision_hulls
