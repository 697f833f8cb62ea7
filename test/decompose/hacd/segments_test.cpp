#include "collision_hulls/decompose/segments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "shapes.h"

namespace collision_hulls {
namespace {

TEST(HierarchyCsv, HasTheNumberOfClustersForEveryConcavity) {
  const TriangleMesh torus = test_shapes::torus(1, 0.3, 16, 8);
  const double epsilon = 0.03 * diagonal(torus);
  const Segments segments = segmentsOf(torus, epsilon);
  std::istringstream text(hierarchyCsv(segments));
  std::string header;
  std::getline(text, header);
  EXPECT_EQ(header, "concavity,clusters");
  double concavity = 0, last = -1;
  std::size_t clusters = 0, at_epsilon = 0, rows = 0;
  for (char comma; text >> concavity >> comma >> clusters; ++rows) {
    EXPECT_GT(concavity, last);
    EXPECT_EQ(clusters, clustersAt(segments.segmentation, concavity * (1 + 1e-7)));
    if (concavity <= epsilon) at_epsilon = clusters;
    last = concavity;
  }
  EXPECT_GT(rows, 3u);
  EXPECT_EQ(at_epsilon, segments.segmentation.clusters.size());
  EXPECT_EQ(clusters, 1u);
}

TEST(HierarchyCsv, LeavesOutThousandsOfClusters) {
  const Segments segments{test_shapes::torus(1, 0.3, 60, 30), {{}, std::vector<double>(3000, 0.5)}};
  Segments distinct = segments;
  for (std::size_t i = 0; i < 3000; ++i) distinct.segmentation.merges[i] = 1e-3 * static_cast<double>(i);
  const std::string text = hierarchyCsv(distinct);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 1000 - 600 + 1);
  EXPECT_EQ(hierarchyCsv(segments), "concavity,clusters\n0.5,600\n");
}

TEST(ClusterColour, ManyDiffer) {
  std::set<Rgb> colours;
  for (std::size_t k = 0; k < 100; ++k) colours.insert(clusterColour(k));
  EXPECT_EQ(colours.size(), 100u);
}

TEST(SegmentsOf, RepairsAsDecomposingDoes) {
  TriangleMesh soup;  // every triangle with corners of its own
  const TriangleMesh bracket = test_shapes::lBracket();
  for (int t = 0; t < static_cast<int>(bracket.triangles.size()); ++t) {
    const int first = static_cast<int>(soup.vertices.size());
    for (int k = 0; k < 3; ++k) soup.vertices.push_back(bracket.corner(t, k));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(segmentsOf(soup, 0.03 * diagonal(soup)).segmentation.clusters.size(), 2u);
}

TEST(SegmentsOf, NeedsAnEpsilon) {
  for (const double epsilon : {0.0, -1.0, std::nan("")}) EXPECT_THROW(segmentsOf(test_shapes::lBracket(), epsilon), Error);
}

}  // namespace
}  // namespace collision_hulls
