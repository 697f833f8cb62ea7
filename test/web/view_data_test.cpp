#include "web/view_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "web/pages.h"

namespace collision_hulls {
namespace {

using nlohmann::json;
using pages::row;
using pages::Sample;

/// The vertices of a block.
std::vector<Eigen::Vector3d> vertices(const json& block, const std::string& geometry) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t v = 0; v < block["vertices"]; ++v) {
    Eigen::Vector3d p;
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint16_t x = 0;
      std::memcpy(&x, geometry.data() + block["offset"].get<std::size_t>() + 6 * v + 2 * k, sizeof x);
      p[static_cast<int>(k)] = block["origin"][k].get<double>() + block["step"].get<double>() * x;
    }
    points.push_back(p);
  }
  return points;
}

TEST(ViewData, AMeshWithItsHullsAndTheirTree) {
  const Sample sample({row("arm")});
  const ViewData data = viewData(sample.content());
  const json view = json::parse(data.json);
  ASSERT_EQ(view["meshes"].size(), 1u);
  const json& mesh = view["meshes"][0];
  EXPECT_EQ(mesh["triangles"], 12);
  EXPECT_EQ(mesh["original"]["triangles"], 12);
  ASSERT_EQ(mesh["nodes"].size(), 3u);
  EXPECT_EQ(mesh["nodes"][0]["bound"], 0.0098);
  EXPECT_EQ(mesh["nodes"][1]["left"], -1);
  EXPECT_GE(mesh["nodes"][2]["bound"].get<double>(), 0.5 + 0.0098) << "half of the gap";
  EXPECT_LE(mesh["nodes"][2]["bound"].get<double>(), 0.52 + 0.0098);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : vertices(mesh["nodes"][2]["at"], data.geometry)) box.extend(p);
  EXPECT_TRUE(box.isApprox(Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 1, 1)), 1e-4));
}

TEST(ViewData, AnElementSaysWhereItIs) {
  Sample sample({row("arm")});
  sample.report.links[0].worst = {1, 2, 3};
  PageContent content = sample.content();
  content.models[0].elements[0].pose.translation() = Eigen::Vector3d(4, 5, 6);
  const json element = json::parse(viewData(content).json)["models"][0]["elements"][0];
  EXPECT_EQ(element["pose"], (json{1, 0, 0, 4, 0, 1, 0, 5, 0, 0, 1, 6}));
  EXPECT_EQ(element["worst"], (json{1, 2, 3}));
  EXPECT_EQ(element["found"], 0.0095);
  EXPECT_EQ(element["link"], "arm");
  EXPECT_EQ(element["row"], 0);
}

TEST(ViewData, RegionsAsFarAsTheyAreNear) {
  Sample sample({row("hand")});
  sample.report.links[0].regions_given = {halfSpaceRegion({0, 0, 1}, 0.5, 0.001), halfSpaceRegion({0, 0, 1}, 9, 0.001)};
  const ViewData data = viewData(sample.content());
  const json regions = json::parse(data.json)["models"][0]["elements"][0]["regions"];
  ASSERT_EQ(regions.size(), 1u) << "the other one is far away";
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : vertices(regions[0], data.geometry)) box.extend(p);
  const double more = 0.15 * std::sqrt(11);
  EXPECT_NEAR(box.min().z(), 0.5, 1e-3);
  EXPECT_NEAR(box.max().z(), 1 + more, 1e-3);
  EXPECT_NEAR(box.min().x(), -more, 1e-3);
}

GeometryElement sphere(double radius, const Eigen::Vector3d& centre) {
  GeometryElement element;
  element.kind = GeometryElement::Kind::kSphere;
  element.size.x() = radius;
  element.origin.translation() = centre;
  return element;
}

TEST(ViewData, APrimitiveStandsInThePlaceOfItsHull) {
  Sample sample({row("arm")});
  sample.primitives = {sphere(0.7, {2, 0, 0})};
  const json nodes = json::parse(viewData(sample.content()).json)["meshes"][0]["nodes"];
  EXPECT_FALSE(nodes[0]["at"].contains("shape"));
  EXPECT_EQ(nodes[1]["at"]["shape"], "sphere");
  EXPECT_EQ(nodes[1]["at"]["size"][0], 0.7);
  EXPECT_EQ(nodes[1]["at"]["pose"][3], 2);
  EXPECT_TRUE(nodes[2]["at"].contains("offset")) << "merged, they are a hull";
}

TEST(ViewData, ATreesCutsAndTheirBounds) {
  Sample sample({row("arm")});
  HullTree tree;
  for (const ConvexHull& hull : sample.hulls) tree.nodes.push_back({hull, 0.01, 2, -1, -1});
  tree.nodes.push_back({sample.hulls[0], 0.123, -1, 0, 1});
  PageContent content = sample.content();
  EXPECT_EQ(json::parse(viewData(content).json)["meshes"][0]["cuts"], false);
  content.models[0].elements[0].tree = &tree;
  const json mesh = json::parse(viewData(content).json)["meshes"][0];
  EXPECT_EQ(mesh["cuts"], true);
  ASSERT_EQ(mesh["nodes"].size(), 3u);
  EXPECT_EQ(mesh["nodes"][2]["bound"], 0.123);
  EXPECT_EQ(mesh["nodes"][2]["right"], 1);
}

TEST(ViewData, WhatStaysAsItIs) {
  const Sample sample({row("arm")});
  PageContent content = sample.content();
  const GeometryElement mesh, ball = sphere(0.5, Eigen::Vector3d::Zero());
  const TriangleMesh surface = test_shapes::box(1, 2, 3), none;
  content.models[0].kept.push_back({mesh, surface, Eigen::Isometry3d(Eigen::Translation3d(4, 5, 6))});
  content.models[0].kept.push_back({ball, none, Eigen::Isometry3d::Identity()});
  const json kept = json::parse(viewData(content).json)["models"][0]["kept"];
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0]["at"]["triangles"], 12);
  EXPECT_EQ(kept[0]["pose"][7], 5);
  EXPECT_EQ(kept[1]["at"]["shape"], "sphere");
}

TEST(ViewData, EqualMeshesAreThereOnce) {
  Sample sample({row("left"), row("right"), row("hand")});
  sample.report.links[0].sha256 = sample.report.links[1].sha256 = "finger";
  const json view = json::parse(viewData(sample.content()).json);
  ASSERT_EQ(view["meshes"].size(), 2u);
  EXPECT_EQ(view["models"][0]["elements"][1]["mesh"], 0);
  EXPECT_EQ(view["models"][0]["elements"][2]["mesh"], 1);
}

TEST(ViewData, EqualMeshesWithOtherHullsAreNot) {
  Sample sample({row("left"), row("right")});
  sample.report.links[0].sha256 = sample.report.links[1].sha256 = "finger";
  const std::vector<ConvexHull> others{sample.hulls[0]};
  PageContent content = sample.content();
  const Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  content.models.push_back(PageModel{
      sample.report, {{sample.original, others, pose, sample.primitives}, {sample.original, sample.hulls, pose, sample.primitives}}, {}});
  EXPECT_EQ(json::parse(viewData(content).json)["meshes"].size(), 2u);
}

TEST(ViewData, AFailedMeshHasNoHulls) {
  const Sample sample({row("lost", Status::kFailed)});
  const json mesh = json::parse(viewData(sample.content()).json)["meshes"][0];
  EXPECT_EQ(mesh["nodes"], json::array());
  EXPECT_EQ(mesh["original"]["triangles"], 12);
}

TEST(ViewData, ManyHullsStayAsTheyAre) {
  Sample sample({row("foam")});
  sample.hulls.assign(151, sample.hulls[0]);
  const json mesh = json::parse(viewData(sample.content()).json)["meshes"][0];
  EXPECT_EQ(mesh["nodes"].size(), 151u);
}

TEST(ViewData, LargeOriginalsAreThinned) {
  Sample sample({row("arm")});
  sample.original = test_shapes::box(1, 1, 1, 120);
  ASSERT_GT(sample.original.triangles.size(), 170000u);
  const ViewData data = viewData(sample.content());
  const json mesh = json::parse(data.json)["meshes"][0];
  EXPECT_LE(mesh["original"]["triangles"].get<std::size_t>(), 150000u);
  EXPECT_EQ(mesh["triangles"], sample.original.triangles.size());
  EXPECT_LT(data.geometry.size(), 2500000u);
}

TEST(ViewData, TheSceneIsOneMesh) {
  Sample sample;
  EXPECT_TRUE(json::parse(viewData(sample.content()).json)["scene"].is_null());
  sample.scene = test_shapes::moved(test_shapes::box(2, 2, 0.1), {-1, -1, -1.05});
  const ViewData data = viewData(sample.content());
  const json block = json::parse(data.json)["scene"];
  EXPECT_EQ(block["triangles"], 12);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : vertices(block, data.geometry)) box.extend(p);
  EXPECT_TRUE(box.isApprox(Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, -1.05), Eigen::Vector3d(1, 1, -0.95)), 1e-4));
}

TEST(ViewData, OddNamesAndNumbers) {
  Sample sample({row("\xff\x01\"</script>")});
  sample.report.links[0].protrusion_found = NAN;
  const json element = json::parse(viewData(sample.content()).json)["models"][0]["elements"][0];
  EXPECT_EQ(element["link"], "\xEF\xBF\xBD\x01\"</script>");
  EXPECT_TRUE(element["found"].is_null());
}

}  // namespace
}  // namespace collision_hulls
