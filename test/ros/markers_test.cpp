// Also tests src/ros/pen.cpp and src/ros/robot_bounds.cpp.
#include "ros/markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "collision_hulls/decompose/segments.h"
#include "collision_hulls/error.h"
#include "ros/annotations.h"

namespace collision_hulls {
namespace {

using visualization_msgs::Marker;

const char* const kUrdf = R"(<robot name="r">
  <link name="arm"><collision><geometry><mesh filename="arm.stl"/></geometry></collision></link>
  <link name="hand">
    <collision><origin xyz="0 0 0.3"/><geometry><cylinder radius="0.02" length="0.1"/></geometry></collision>
    <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
  </link>
  <joint name="wrist" type="fixed"><parent link="arm"/><child link="hand"/><origin xyz="0 0 2"/></joint>
</robot>)";

/// A link's mesh at (0, 0, 0.5), turned by a quarter about z, with `hulls` tetrahedra; it protrudes by 1 cm at (0.1, 0, 0).
ElementResult element(const std::string& link, std::size_t hulls) {
  ElementResult result;
  result.link = link;
  result.source.origin = Eigen::Translation3d(0, 0, 0.5) * Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitZ());
  result.pose = result.source.origin;
  result.original.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  result.original.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  result.hulls.assign(hulls, convexHull(result.original.vertices));
  return result;
}

ElementReport row(const ElementResult& element) {
  ElementReport row;
  row.link = element.link;
  row.hulls = element.hulls.size();
  row.diagonal = 1;
  row.protrusion = 0.0124;
  row.protrusion_found = 0.01;
  row.worst = {0.1, 0, 0};
  row.worst_nearest = {0.09, 0, 0};
  return row;
}

RobotResult robot(std::vector<ElementResult> elements) {
  RobotResult result;
  for (const ElementResult& element : elements) result.report.links.push_back(row(element));
  result.elements = std::move(elements);
  result.urdf = kUrdf;
  return result;
}

std::vector<std::string> names(const MarkerList& markers) {
  std::vector<std::string> result;
  for (const Marker& marker : markers) result.push_back(marker.ns + ":" + std::to_string(marker.id));
  return result;
}

using Names = std::vector<std::string>;

TEST(DrawResult, IdsCountWithinANamespace) {
  const Drawing drawing = drawResult(robot({element("arm", 2), element("arm", 1), element("hand", 1)}), {}, nullptr, 1);
  EXPECT_EQ((Names{"hulls/arm:0", "hulls/arm:1", "hulls/arm:2", "hulls/hand:0", "primitives/hand:0", "primitives/hand:1"}),
            names(drawing.hulls));
  EXPECT_EQ((Names{"original/arm:0", "original/arm:1", "original/hand:0"}), names(drawing.original));
  EXPECT_EQ((Names{"worst/arm:0", "worst/arm:1", "worst/arm:2", "worst/hand:0", "worst/hand:1", "worst/hand:2"}),
            names(drawing.protrusion));
  EXPECT_EQ((Names{"labels/arm:0", "labels/arm:1", "labels/hand:0", "labels/hand:1"}), names(drawing.labels));
  EXPECT_TRUE(drawing.scene.empty());
}

TEST(DrawResult, NothingOfNothing) {
  const Drawing drawing = drawResult({}, {}, nullptr, 1);
  EXPECT_TRUE(drawing.hulls.empty() && drawing.original.empty() && drawing.protrusion.empty() && drawing.labels.empty());
}

TEST(DrawResult, AFailedMeshHasItsOriginalAlone) {
  RobotResult result = robot({element("arm", 0)});
  result.report.links[0].protrusion_found = result.report.links[0].protrusion = 0;
  const Drawing drawing = drawResult(result, {}, nullptr, 1);
  EXPECT_EQ((Names{"primitives/hand:0", "primitives/hand:1"}), names(drawing.hulls));
  EXPECT_EQ((Names{"original/arm:0"}), names(drawing.original));
  EXPECT_TRUE(drawing.protrusion.empty());
  EXPECT_EQ("arm: 0 hulls", drawing.labels[0].text);
}

TEST(DrawResult, PrimitivesAreDrawnAsTheDescriptionHasThem) {
  const MarkerList hulls = drawResult(robot({element("arm", 1)}), {}, nullptr, 1).hulls;
  const Marker &cylinder = hulls[1], &box = hulls[2];
  EXPECT_EQ(Marker::CYLINDER, cylinder.type);
  EXPECT_EQ("hand", cylinder.header.frame_id);
  EXPECT_DOUBLE_EQ(0.04, cylinder.scale.x);
  EXPECT_DOUBLE_EQ(0.1, cylinder.scale.z);
  EXPECT_DOUBLE_EQ(0.3, cylinder.pose.position.z);
  EXPECT_EQ(Marker::CUBE, box.type);
  EXPECT_DOUBLE_EQ(0.2, box.scale.y);
}

TEST(DrawResult, OriginalPrimitivesAreInsideThoseOfTheModel) {
  const MarkerList original = drawResult(robot({element("arm", 1)}), parseRobotDescription(kUrdf), nullptr, 1).original;
  ASSERT_EQ((Names{"original/arm:0", "original/hand:0", "original/hand:1"}), names(original));
  EXPECT_LT(original[2].scale.x, 0.1);
  EXPECT_GT(original[2].scale.x, 0.0995);
}

TEST(DrawResult, AHullThatAPrimitiveStandsInForIsNotDrawn) {
  RobotResult result = robot({element("arm", 3)});
  result.elements[0].primitives.resize(1);
  EXPECT_EQ((Names{"hulls/arm:0", "hulls/arm:1", "primitives/hand:0", "primitives/hand:1"}),
            names(drawResult(result, {}, nullptr, 1).hulls));
}

TEST(DrawResult, SegmentsHaveTheColoursOfTheirClusters) {
  RobotResult result = robot({element("arm", 1)});
  const TriangleMesh& mesh = result.elements[0].original;
  result.elements[0].segments = std::make_shared<const Segments>(Segments{mesh, {{{0, 2, 3}, {1}}, {}}});
  const MarkerList segments = drawResult(result, {}, nullptr, 1).segments;
  ASSERT_EQ((Names{"segments/arm:0"}), names(segments));
  ASSERT_EQ(segments[0].points.size(), 12u);
  ASSERT_EQ(segments[0].colors.size(), 12u);
  EXPECT_EQ(segments[0].colors[0].r, segments[0].colors[8].r);
  EXPECT_NE(segments[0].colors[0].r, segments[0].colors[9].r);
  EXPECT_FLOAT_EQ(segments[0].colors[9].g, static_cast<float>(clusterColour(1)[1]) / 255);
  EXPECT_EQ(segments[0].points[9].x, mesh.corner(1, 0).x());
  EXPECT_DOUBLE_EQ(segments[0].pose.position.z, 0.5);
}

TEST(DrawResult, UnneededHullsAreGrey) {
  RobotResult result = robot({element("arm", 1)});
  result.elements[0].unneeded.assign(2, result.elements[0].hulls.front());
  int found = 0;
  for (const Marker& marker : drawResult(result, {}, nullptr, 1).unneeded) {
    EXPECT_EQ("unneeded/arm", marker.ns);
    ++found;
    EXPECT_EQ(marker.color.r, marker.color.g);
    EXPECT_EQ(marker.color.r, marker.color.b);
    EXPECT_LT(marker.color.a, 1);
  }
  EXPECT_EQ(found, 2);
}

TEST(DrawResult, MarkersAreLockedToTheirLink) {
  const Drawing drawing = drawResult(robot({element("arm", 1)}), {}, nullptr, 0.5);
  const Marker& hull = drawing.hulls[0];
  EXPECT_EQ("arm", hull.header.frame_id);
  EXPECT_TRUE(hull.frame_locked);
  EXPECT_EQ(0.5, hull.pose.position.z);
  EXPECT_NEAR(std::sqrt(0.5), hull.pose.orientation.z, 1e-12);
  EXPECT_EQ(12u, hull.points.size());
  EXPECT_EQ(0.5f, hull.color.a);
  EXPECT_EQ(1, drawing.original[0].color.a);
}

TEST(DrawResult, TheOriginalIsInsideItsSurfaceByLessThanOneSees) {
  const Drawing drawing = drawResult(robot({element("arm", 1)}), {}, nullptr, 1);
  const Marker &hull = drawing.hulls[0], &original = drawing.original[0];
  ASSERT_EQ(hull.points.size(), original.points.size());
  double lowest = 1;
  for (const geometry_msgs::Point& point : original.points) lowest = std::min(lowest, point.x + point.y + point.z);
  const auto total = [](const geometry_msgs::Point& p) { return p.x + p.y + p.z; };
  const auto highest =
      std::max_element(original.points.begin(), original.points.end(), [&](const auto& a, const auto& b) { return total(a) < total(b); });
  EXPECT_LT(total(*highest), 0.1 + 1e-4);  // the slanted face's sum is 0.1; triangles of other faces end beyond it by their inset
  EXPECT_GT(lowest, 0);                    // the corner at the origin: three faces, each moved along its own normal
}

TEST(DrawResult, TheArrowEndsAtTheWorstPlaceAndHasItsNumber) {
  const MarkerList protrusion = drawResult(robot({element("arm", 1)}), {}, nullptr, 1).protrusion;
  ASSERT_EQ(3u, protrusion.size());
  const Marker &sphere = protrusion[0], &arrow = protrusion[1], &text = protrusion[2];
  EXPECT_NEAR(0, sphere.pose.position.x, 1e-12);
  EXPECT_NEAR(0.1, sphere.pose.position.y, 1e-12);
  ASSERT_EQ(2u, arrow.points.size());
  EXPECT_EQ(0.1, arrow.points[1].x);
  EXPECT_GT(arrow.points[0].x, 0.1);  // it comes from outside
  EXPECT_GT(arrow.scale.y, arrow.scale.x);
  EXPECT_EQ("10 mm", text.text);
  EXPECT_GT(text.pose.position.y, arrow.points[0].x);
}

TEST(DrawResult, TheArrowAvoidsOtherHulls) {
  RobotResult result = robot({element("arm", 1), element("hand", 1)});
  for (Eigen::Vector3d& vertex : result.elements[1].original.vertices) vertex = 2 * vertex + Eigen::Vector3d(0.101, -0.1, -0.1);
  result.elements[1].hulls = {convexHull(result.elements[1].original.vertices)};
  const Marker arrow = drawResult(result, {}, nullptr, 1).protrusion[1];
  const Eigen::Vector3d tail(arrow.points[0].x, arrow.points[0].y, arrow.points[0].z);
  EXPECT_GT(planeDistance(result.elements[1].hulls[0], 0.5 * (tail + Eigen::Vector3d(0.1, 0, 0))), 0);
}

TEST(DrawResult, OneArrowForALink) {
  RobotResult result = robot({element("arm", 1), element("arm", 1)});
  result.report.links[1].protrusion_found = 0.0234;
  const MarkerList protrusion = drawResult(result, {}, nullptr, 1).protrusion;
  ASSERT_EQ(3u, protrusion.size());
  EXPECT_EQ("23.4 mm", protrusion[2].text);
}

TEST(DrawResult, LabelsSayWhatALinkHas) {
  const MarkerList labels = drawResult(robot({element("arm", 5), element("hand", 1)}), {}, nullptr, 1).labels;
  ASSERT_EQ(4u, labels.size());
  EXPECT_EQ("arm: 5 hulls, 12.4 mm", labels[0].text);
  EXPECT_EQ("hand: 1 hull and 2 primitives, 12.4 mm", labels[2].text);
}

TEST(DrawResult, LabelsNeverOverlap) {
  RobotResult result;
  result.urdf = "<robot name='r'><link name='root'/>";
  for (int i = 0; i < 40; ++i) {
    const std::string link = "l" + std::to_string(i);
    result.elements.push_back(element(link, 1));
    result.report.links.push_back(row(result.elements.back()));
    result.urdf +=
        "<link name='" + link + "'/><joint name='j" + link + "' type='fixed'><parent link='root'/><child link='" + link + "'/></joint>";
  }
  result.urdf += "</robot>";
  std::map<double, std::vector<double>> columns;  // heights by y
  double height = 0;
  for (const Marker& marker : drawResult(result, {}, nullptr, 1).labels) {
    if (marker.type != Marker::TEXT_VIEW_FACING) continue;
    columns[marker.pose.position.y].push_back(marker.pose.position.z);
    height = marker.scale.z;
  }
  ASSERT_EQ(2u, columns.size());
  for (auto& [y, heights] : columns) {
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_GT(heights[i] - heights[i - 1], height);
  }
}

TEST(DrawResult, TheSceneIsOneMarkerInTheRootsFrame) {
  Scene scene;
  for (const char* name : {"a", "b"}) {
    SceneBody body;
    body.name = name;
    body.shape = boxShape({1, 1, 1});
    body.pose.translation() = Eigen::Vector3d(5, 0, 0);
    addBody(scene, body);
  }
  const MarkerList markers = drawResult(robot({element("arm", 1)}), {}, &scene, 1).scene;
  ASSERT_EQ(1u, markers.size());
  EXPECT_EQ("scene", markers[0].ns);
  EXPECT_EQ("arm", markers[0].header.frame_id);
  EXPECT_EQ(2u * 36, markers[0].points.size());
  for (const geometry_msgs::Point& point : markers[0].points) EXPECT_NEAR(5, point.x, 0.501);
}

TEST(DrawOriginal, MeshesAndPrimitivesBeforeAnyWork) {
  const RobotDescription description = parseRobotDescription(kUrdf);
  const Drawing drawing = drawOriginal(description, Source::kAuto, [](const std::string& uri) { return "/meshes of mine/" + uri; });
  EXPECT_EQ((Names{"original/arm:0", "original/hand:0", "original/hand:1"}), names(drawing.original));
  EXPECT_EQ(Marker::MESH_RESOURCE, drawing.original[0].type);
  EXPECT_EQ("file:///meshes%20of%20mine/arm.stl", drawing.original[0].mesh_resource);
  EXPECT_TRUE(drawing.hulls.empty());
}

TEST(DrawOriginal, AMeshThatIsNotFoundLosesNothingElse) {
  const auto nowhere = [](const std::string&) -> std::string { throw Error(ErrorCode::kFileNotFound, "no such file"); };
  EXPECT_EQ((Names{"original/hand:0", "original/hand:1"}),
            names(drawOriginal(parseRobotDescription(kUrdf), Source::kAuto, nowhere).original));
}

TEST(Bounds, OfPrimitivesWhereNoMeshCanBeRead) {
  const auto nowhere = [](const std::string&) -> std::string { throw Error(ErrorCode::kFileNotFound, "no such file"); };
  const RobotBounds bounds = robotBounds(parseRobotDescription(kUrdf), Source::kAuto, {nowhere, {}, RunControl()});
  EXPECT_DOUBLE_EQ(2.35, bounds.top);           // the cylinder ends at 2 + 0.3 + 0.05
  EXPECT_NEAR(1.175, bounds.centre.z(), 1e-9);  // from the arm's origin on
  EXPECT_NEAR(0.5 * std::hypot(0.1, 0.2, 2.35), bounds.radius, 1e-9);
}

TEST(Bounds, AJointWhoseLimitsExcludeZeroIsInTheirMiddle) {
  const auto bounds = [](const std::string& lower) {
    const std::string urdf =
        "<robot name='r'><link name='a'/><link name='b'><collision><geometry><box size='2 2 2'/></geometry></collision></link>"
        "<joint name='j' type='prismatic'><parent link='a'/><child link='b'/><axis xyz='1 0 0'/><limit lower='" +
        lower + "' upper='6' effort='1' velocity='1'/></joint></robot>";
    return robotBounds(parseRobotDescription(urdf), Source::kAuto, {[](const std::string& uri) { return uri; }, {}, RunControl()});
  };
  EXPECT_NEAR(0, bounds("-2").centre.x(), 1e-9);
  EXPECT_NEAR(4, bounds("2").centre.x(), 1e-9);
}

TEST(Bounds, NeverEmpty) {
  const auto file = [](const std::string& uri) { return uri; };
  EXPECT_GT(robotBounds(parseRobotDescription("<robot name='r'><link name='a'/></robot>"), Source::kAuto, {file, {}, RunControl()}).radius,
            0);
}

TEST(Colours, LinksDifferInHueAndHullsInShade) {
  std::set<std::tuple<float, float, float>> colours;
  for (std::size_t link = 0; link < 100; ++link) {
    for (std::size_t hull = 0; hull < 7; ++hull) {
      const auto colour = shade(linkHue(link), hull, 1);
      colours.emplace(colour.r, colour.g, colour.b);
      EXPECT_GT(std::max({colour.r, colour.g, colour.b}) - std::min({colour.r, colour.g, colour.b}), 0.4f) << hull;
    }
    const double apart = std::abs(linkHue(link) - linkHue(link + 1));
    EXPECT_GT(std::min(apart, 1 - apart), 0.3) << link;
  }
  EXPECT_EQ(700u, colours.size());
}

TEST(DrawProgress, AboveTheRobot) {
  const Marker marker = drawProgress("43 %", "base", {{1, 2, 3}, 2, 5});
  EXPECT_EQ(Marker::TEXT_VIEW_FACING, marker.type);
  EXPECT_EQ("base", marker.header.frame_id);
  EXPECT_EQ(1, marker.pose.position.x);
  EXPECT_GT(marker.pose.position.z, 5);
  EXPECT_GT(marker.scale.z, 0);
}

TEST(DrawLink, IsDrawnAsInTheWholeResult) {
  const RobotResult result = robot({element("arm", 2)});
  ShownLink shown{parseRobotDescription(kUrdf).links[0], linkHue(0), result.elements, result.report.links};
  shown.link.collisions.clear();
  const Drawing whole = drawResult(result, {}, nullptr, 0.5), link = drawLink(shown, 1, 0.5);
  ASSERT_EQ((Names{"hulls/arm:0", "hulls/arm:1"}), names(link.hulls));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(whole.hulls[i].color, link.hulls[i].color);
    EXPECT_EQ(whole.hulls[i].points, link.hulls[i].points);
    EXPECT_EQ(whole.hulls[i].pose, link.hulls[i].pose);
  }
  EXPECT_EQ(names(whole.protrusion), names(link.protrusion));
}

TEST(DrawLink, HasTheEdgesBetweenFacesOfDifferentPlanesAlone) {
  ElementResult cube = element("arm", 0);
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  cube.hulls = {convexHull(corners)};
  const Drawing drawing = drawLink({LinkDescription(), 0, {cube}, {row(cube)}}, 1, 1);
  ASSERT_EQ(1u, drawing.chosen.size());
  EXPECT_EQ(Marker::LINE_LIST, drawing.chosen[0].type);
  EXPECT_EQ(2u * 12, drawing.chosen[0].points.size());  // without the diagonals of its sides
}

}  // namespace
}  // namespace collision_hulls
