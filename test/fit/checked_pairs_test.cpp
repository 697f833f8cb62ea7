#include "fit/checked_pairs.h"

#include <algorithm>

#include "fit/fit_fixtures.h"
#include "geometry/random_stream.h"

namespace collision_hulls {
namespace {

using namespace fit_fixtures;

/// Three carriages with a channel each, side by side, among 200 boxes.
FitProblem amongBoxes() {
  FitProblem problem;
  problem.robot = carriages(3);
  for (std::size_t link = 1; link <= 3; ++link)
    problem.elements.push_back({"", link, Eigen::Isometry3d(Eigen::Translation3d(0.45 * static_cast<double>(link), 0, 0)), channelMesh()});
  Random random(1, 0, 0);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d at(random.uniform(-1, 3), random.uniform(-1, 1), random.uniform(-3, 3));
    problem.scene.bodies.push_back(boxBody(std::to_string(i), random.uniform(0.01, 0.3) * Eigen::Vector3d::Ones(), at));
  }
  return problem;
}

TEST(CheckedPairs, NearAreThoseWhoseBoxesAreWithinTheDistance) {
  const FitProblem problem = amongBoxes();
  const Assembly assembly(problem, 1);
  std::vector<PartPair> pairs;
  for (std::size_t body = assembly.links(); body < assembly.parts(); ++body)
    for (const std::size_t link : {3, 1})
      if (body % 5 != link) pairs.push_back({link, body, 0.001 * static_cast<double>(body)});
  pairs.push_back({2, 3, 0});
  pairs.push_back({1, 3, 0});
  const CheckedPairs checked(assembly, pairs);
  EXPECT_NEAR(checked.clearance(), 0.203, 1e-12);
  std::size_t found = 0;
  for (std::size_t sample = 0; sample < 20; ++sample) {
    const Places places = assembly.places(sample);
    std::vector<Eigen::AlignedBox3d> boxes(assembly.parts());  // of all parts, found in another way
    for (std::size_t part = 1; part < assembly.parts(); ++part) {
      const Piece& piece = assembly.pieces()[static_cast<std::size_t>(assembly.piecesOf(part).front())];
      boxes[part] = placed(piece.tree->body(piece.tree->root()).box(), places[part] * piece.origin);
    }
    const std::vector<Eigen::AlignedBox3d> links(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(assembly.links()));
    for (const double distance : {0.0, 0.1}) {
      const std::vector<std::size_t> near = checked.near(links, distance);
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      EXPECT_EQ(std::adjacent_find(near.begin(), near.end()), near.end());
      found += near.size();
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const double apart = boxes[pairs[i].a].exteriorDistance(boxes[pairs[i].b]);
        const bool is_near = std::binary_search(near.begin(), near.end(), i);
        EXPECT_TRUE(is_near || apart > distance) << i;
        EXPECT_TRUE(!is_near || apart <= 1.74 * distance) << i << ": further than a corner of a grown box, " << apart << " m";
      }
    }
  }
  EXPECT_GT(found, 100u);
}

}  // namespace
}  // namespace collision_hulls
