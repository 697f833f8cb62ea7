#include "decompose/certified/known_facets.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::boxHull;

std::size_t known(const KnownFacets& facets, double distance, const ConvexHull& hull) {
  const std::vector<char> within = facets.within(distance, hull);
  EXPECT_EQ(within.size(), hull.triangles.size());
  const auto count = static_cast<std::size_t>(std::count(within.begin(), within.end(), 1));
  EXPECT_EQ(facets.unknown(distance, hull), within.size() - count);
  return count;
}

TEST(KnownFacets, NothingAtFirst) {
  EXPECT_EQ(known({}, 1e9, boxHull({0, 0, 0}, {1, 1, 1})), 0U);
  EXPECT_TRUE(KnownFacets().within(1, ConvexHull()).empty());
}

TEST(KnownFacets, TheLeastBoundCounts) {
  const ConvexHull hull = boxHull({0, 0, 0}, {1, 1, 1});
  KnownFacets facets;
  for (const double bound : {0.5, 0.3, 0.4}) facets.learn(hull, bound);
  EXPECT_EQ(known(facets, 0.299, hull), 0U);
  EXPECT_EQ(known(facets, 0.3, hull), 12U);
}

TEST(KnownFacets, ATriangleIsTheSameWhateverItsFirstCorner) {
  ConvexHull hull = convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  KnownFacets facets;
  facets.learn(hull, 0.1);
  for (Triangle& t : hull.triangles) t = {t[1], t[2], t[0]};
  for (Vector3d& v : hull.vertices) v = v.unaryExpr([](double c) { return c == 0 ? -0.0 : c; });
  EXPECT_EQ(known(facets, 0.1, hull), 4U);
}

TEST(KnownFacets, HullsShareWhatTheyHaveInCommon) {
  const std::vector<Vector3d> base{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}};
  std::vector<Vector3d> more = base, moved = base;
  more.push_back({0.3, 0.3, -1});  // beneath: three facets remain
  moved[3].z() = 1 + 1e-15;        // the top: one facet remains
  KnownFacets facets;
  facets.learn(convexHull(base), 0.1);
  EXPECT_EQ(known(facets, 0.1, convexHull(more)), 3U);
  EXPECT_EQ(known(facets, 0.1, convexHull(moved)), 1U);
}

TEST(KnownFacets, LearnFromOthers) {
  const ConvexHull a = boxHull({0, 0, 0}, {1, 1, 1}), b = boxHull({2, 0, 0}, {3, 1, 1});
  KnownFacets first, second;
  first.learn(a, 0.1);
  second.learn(a, 0.2);
  second.learn(b, 0.3);
  first.learn(second);
  EXPECT_EQ(known(first, 0.1, a), 12U);
  EXPECT_EQ(known(first, 0.29, b), 0U);
  EXPECT_EQ(known(first, 0.3, b), 12U);
}

}  // namespace
}  // namespace collision_hulls
