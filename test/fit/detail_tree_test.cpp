#include "fit/detail_tree.h"

#include <gtest/gtest.h>

#include "fit/fit_fixtures.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using namespace fit_fixtures;

TEST(DetailTree, IsTheHullTreeWithPrimitivesBesideItsNodes) {
  const auto mesh = channelMesh();
  const DetailTree tree(mesh);
  EXPECT_EQ(tree.leaves(), 3u) << "the channel's three convex parts";
  EXPECT_EQ(tree.root(), static_cast<int>(mesh->tree.nodes.size()) - 1);
  EXPECT_EQ(tree.parent(tree.root()), -1);
  for (const int child : tree.children(tree.root())) EXPECT_EQ(tree.parent(child), tree.root());
  EXPECT_EQ(tree.primitive(tree.root()), nullptr);
  for (int hull = 0; hull <= tree.root(); ++hull) {
    const int cheapest = tree.cheapest(hull);
    EXPECT_EQ(tree.hull(cheapest), hull);
    EXPECT_EQ(tree.protrusion(cheapest), mesh->tree.nodes[static_cast<std::size_t>(hull)].protrusion);
  }
}

TEST(DetailTree, ABoxMayReplaceAConvexPart) {
  const DetailTree tree(channelMesh());
  for (int hull = 0; hull <= tree.root(); ++hull) {
    if (!tree.children(hull).empty()) continue;
    const GeometryElement* const primitive = tree.primitive(tree.cheapest(hull));
    ASSERT_NE(primitive, nullptr) << hull;
    EXPECT_EQ(primitive->kind, GeometryElement::Kind::kBox) << hull;
  }
}

TEST(DetailTree, OfASingleBody) {
  const DetailTree tree(QueryBody(test_shapes::boxHull({0, 0, 0}, {1, 1, 1})));
  EXPECT_EQ(tree.root(), 0);
  EXPECT_EQ(tree.leaves(), 1u);
  EXPECT_EQ(tree.cheapest(0), 0);
  EXPECT_TRUE(tree.children(0).empty());
}

TEST(WrittenHulls, OfEveryCutCoverTheMesh) {
  const auto mesh = channelMesh();
  for (const int hulls : {1, 2, 3}) {
    const std::vector<ConvexHull> written = writtenHulls(*mesh, mesh->tree.cutTo(hulls), {});
    EXPECT_EQ(written.size(), static_cast<std::size_t>(hulls));
    for (const Eigen::Vector3d& v : mesh->original.vertices)
      EXPECT_TRUE(std::any_of(written.begin(), written.end(), [&](const ConvexHull& hull) { return holds(hull, v); }));
  }
}

}  // namespace
}  // namespace collision_hulls
