#include "ros/conversions.h"

#include <collision_hulls/DecomposeRequest.h>
#include <gtest/gtest.h>

#include <cmath>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

TEST(Summary, NamesEachFailure) {
  Report report;
  EXPECT_EQ("robot 'arm': 0 hulls for 0 meshes", summary("arm", report));
  report.links.resize(2);
  report.links[0].hulls = 3;
  report.links[1].link = "hand";
  report.links[1].uri = "hand.stl";
  report.links[1].status = Status::kFailed;
  report.links[1].reason = "no such file";
  EXPECT_EQ("link hand: hand.stl: no such file\nrobot 'arm': 3 hulls for 1 mesh, 1 failed", summary("arm", report));
}

TEST(Summary, SaysThatNoneSucceeded) {
  Report report;
  report.links.resize(1);
  report.links[0].link = "hand";
  report.links[0].uri = "hand.stl";
  report.links[0].status = Status::kFailed;
  report.links[0].reason = "no such file";
  EXPECT_EQ("link hand: hand.stl: no such file\nrobot 'arm': its mesh could not be decomposed", summary("arm", report));
  report.links.push_back(report.links[0]);
  EXPECT_NE(summary("arm", report).find("\nrobot 'arm': none of its 2 meshes could be decomposed"), std::string::npos);
}

TEST(Summary, SaysWhatIsBeyondTheTolerance) {
  Report report;
  report.links.resize(2);
  for (ElementReport& row : report.links) {
    row.link = "hand";
    row.uri = "hand.stl";
    row.hulls = 1;
    row.protrusion = 0.02;
    row.status = Status::kDegraded;
    row.reason = "too few hulls";
  }
  EXPECT_EQ(
      "degraded: hand, hand.stl: too few hulls (1 more mesh: see the table)\n"
      "robot 'arm': 2 hulls for 2 meshes, 2 degraded; largest protrusion 20.0 mm (hand)",
      summary("arm", report));
}

TEST(Summary, CountsPrimitivesAndNamesTheLargestProtrusion) {
  Report report;
  report.links.resize(2);
  report.links[0].primitives = 2;
  EXPECT_EQ("robot 'arm': 2 primitives for 2 meshes", summary("arm", report));
  report.links[1].link = "hand";
  report.links[1].hulls = 1;
  report.links[1].protrusion = 0.00491;
  EXPECT_EQ("robot 'arm': 1 hull and 2 primitives for 2 meshes; largest protrusion 4.91 mm (hand)", summary("arm", report));
}

TEST(InNodeWords, OptionsAreParameters) {
  for (const auto& [said, expected] : std::vector<std::pair<std::string, std::string>>{
           {"say where it is with --package-path a=DIR", "say where it is with the start-up parameter ~package_path a=DIR"},
           {"check: skipped (--no-validate)\n--jobs 1", "check: skipped (~validate false)\n~jobs 1"},
           {"max-hulls '-3' is invalid", "max_hulls '-3' is invalid"},
           {"a robot's --fill and '--fill' and 'x", "a robot's ~fill and '--fill' and 'x"},
           {"run\n  decompose --jobs 1\nor --jobs 2", "run\n  decompose --jobs 1\nor ~jobs 2"},
           {"a--b --- -t '5' -- --", "a--b --- -t '5' -- --"},
           {"--- '5'", "--- '5'"},
           {"(--scale 0.001 for a mesh file)", "(--scale 0.001 for a mesh file)"},
           {"max-hulls", "max-hulls"},
           {"", ""}})
    EXPECT_EQ(expected, inNodeWords(said));
}

TEST(Summary, NamesTheNodesOwnParameters) {
  Report report;
  report.links.resize(1);
  report.links[0].status = Status::kFailed;
  report.links[0].reason = "say where it is with --package-path a=DIR";
  EXPECT_NE(std::string::npos, summary("arm", report).find("~package_path a=DIR")) << summary("arm", report);
}

TEST(ToMessage, LinkReport) {
  ElementReport report;
  report.link = "arm";
  report.element = 2;
  report.status = Status::kDegraded;
  report.reason = "capped";
  report.triangles = 12;
  report.protrusion = 0.002;
  report.seconds = {1, 2, 3, 4, 5};
  report.worst = {1, 0, 0};
  report.worst_nearest = {2, 0, 0};
  const LinkReport message = toMessage(report, Eigen::Translation3d(0, 0, 3) * Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitZ()));
  EXPECT_EQ("arm", message.link);
  EXPECT_EQ(2, message.element);
  EXPECT_EQ(LinkReport::DEGRADED, message.status);
  EXPECT_EQ("capped", message.reason);
  EXPECT_EQ(12u, message.triangles);
  EXPECT_EQ(0.002, message.protrusion);
  EXPECT_EQ(15, message.seconds);
  // In the link's frame, beyond the element's origin.
  EXPECT_NEAR(0, message.worst.x, 1e-15);
  EXPECT_NEAR(1, message.worst.y, 1e-15);
  EXPECT_NEAR(3, message.worst.z, 1e-15);
  EXPECT_NEAR(2, message.worst_nearest.y, 1e-15);
  report.status = Status::kFailed;
  const LinkReport failed = toMessage(report, Eigen::Isometry3d::Identity());
  for (const double measure : {failed.uncovered, failed.protrusion, failed.protrusion_found}) EXPECT_TRUE(std::isnan(measure));
}

TEST(ToMessage, StatusConstants) {
  EXPECT_EQ(name(Status::kOk), LinkReport::OK);
  EXPECT_EQ(name(Status::kDegraded), LinkReport::DEGRADED);
  EXPECT_EQ(name(Status::kFailed), LinkReport::FAILED);
  EXPECT_EQ(name(Status::kKept), LinkReport::KEPT);
  EXPECT_EQ(name(Status::kRemoved), LinkReport::REMOVED);
}

TEST(ToMessage, MethodConstants) {
  const std::vector<std::string> constants = {DecomposeRequest::CERTIFIED, DecomposeRequest::HACD, DecomposeRequest::ACD,
                                              DecomposeRequest::SINGLE_HULL, DecomposeRequest::BOUNDING_BOX};
  std::vector<std::string> names;
  for (const Method method : allMethods()) names.emplace_back(name(method));
  EXPECT_TRUE(std::is_permutation(names.begin(), names.end(), constants.begin(), constants.end()));
}

TEST(ToMessage, Totals) {
  Report report;
  report.seconds = 4;
  report.links.resize(3);
  const double protrusions[] = {0.001, 0.003, 0.002};
  for (std::size_t i = 0; i < 3; ++i) {
    report.links[i].link = "link" + std::to_string(i);
    report.links[i].hulls = i;
    report.links[i].hull_vertices = 10 * i;
    report.links[i].protrusion = protrusions[i];
  }
  report.links[1].status = Status::kDegraded;
  const RunTotals sums = toTotals(report);
  EXPECT_EQ(3u, sums.meshes);
  EXPECT_EQ(3u, sums.hulls);
  EXPECT_EQ(30u, sums.hull_vertices);
  EXPECT_EQ(1u, sums.degraded);
  EXPECT_EQ(0u, sums.failed);
  EXPECT_EQ(0.003, sums.protrusion);
  EXPECT_EQ("link1", sums.worst_link);
  EXPECT_EQ(4, sums.seconds);
}

TEST(ToMessage, Feedback) {
  const DecomposeFeedback feedback = toMessage(Step{"decompose", "arm", 1, 4, 7, 0.25, 12, 3});
  EXPECT_EQ("arm", feedback.link);
  EXPECT_EQ(7u, feedback.hulls);
  EXPECT_EQ(3u, feedback.primitives);
  EXPECT_EQ(0.25, feedback.fraction);
  EXPECT_EQ(12, feedback.seconds_left);
  EXPECT_EQ("1 of 4 meshes, 7 hulls and 3 primitives, about 15 s left", feedback.text);
  EXPECT_EQ(-1, toMessage(Step{"read", "", 0, 4, 0, 0, -0.5}).seconds_left);
}

TEST(CheckBase, IsAnAbsolutePathAndAUriGetsTheRemedy) {
  EXPECT_NO_THROW(checkBase(""));
  EXPECT_NO_THROW(checkBase("/robots/arm.urdf"));
  for (const auto& [base, expected] : std::vector<std::pair<std::string, std::string>>{
           {"arm.urdf", "is relative; give an absolute path"},
           {"package://arm/urdf/arm.urdf",
            "is a URI, and a request's base is a path; give the file's absolute path: what 'rospack find arm' "
            "prints, and '/urdf/arm.urdf'"},
           {"file:///my%20robots/arm.urdf", "give '/my robots/arm.urdf'"},
           {"http://host/arm.urdf", "give the file's absolute path"}}) {
    try {
      checkBase(base);
      ADD_FAILURE() << base;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
      EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
      EXPECT_NE(inNodeWords(error.what()).find("base '" + base + "' is "), std::string::npos) << inNodeWords(error.what());
    }
  }
}

}  // namespace
}  // namespace collision_hulls
