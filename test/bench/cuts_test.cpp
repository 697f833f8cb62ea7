// Random cuts through trees with known extremes.
#include "bench/cuts.h"

#include <gtest/gtest.h>

#include <set>

#include "collision_hulls/error.h"
#include "pipeline/fixtures.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using nlohmann::json;
using namespace test_shapes;

class Cuts : public ::testing::Test {
 protected:
  json of(const TriangleMesh& mesh, int cuts, int seed = 1) {
    const std::string file = fixtures::write(folder_ / "mesh.obj", fixtures::obj(mesh));
    return measureCuts({{"file", file}, {"scale", {1, 1, 1}}, {"tolerance", "1%"}, {"seed", seed}, {"cuts", cuts}});
  }

  fixtures::TempFolder folder_;
};

TEST_F(Cuts, BoxHasOneCutAndItIsTight) {
  const json found = of(box(1, 2, 3), 3);
  EXPECT_EQ(found["leaves"], 1);
  ASSERT_EQ(found["cuts"].size(), 3u);
  for (const json& cut : found["cuts"]) {
    EXPECT_EQ(cut["hulls"], 1);
    EXPECT_EQ(cut["uncovered"], 0.0);
    EXPECT_LE(cut["bound"].get<double>(), 4e-4);  // a hundredth of the tolerance
  }
}

TEST_F(Cuts, UChannelHasDifferentValidCuts) {
  const json found = of(uChannel(), 60);
  std::set<std::size_t> sizes;
  std::set<std::string> kinds;
  for (const json& cut : found["cuts"]) {
    sizes.insert(cut["hulls"].get<std::size_t>());
    kinds.insert(cut["kind"].get<std::string>());
    EXPECT_EQ(cut["uncovered"], 0.0);
    EXPECT_LE(cut["protrusion"].get<double>(), cut["bound"].get<double>());
    if (cut["hulls"] == 1) {  // the middle of the mouth is 0.4 from the walls
      EXPECT_NEAR(cut["protrusion"].get<double>(), 0.4, 1e-3);
    }
  }
  EXPECT_GE(found["leaves"], 3);
  EXPECT_EQ(*sizes.begin(), 1u);
  EXPECT_LE(*sizes.rbegin(), found["leaves"].get<std::size_t>());
  EXPECT_GE(sizes.size(), 3u);
  EXPECT_EQ(kinds, (std::set<std::string>{"tolerance", "hulls", "nodes"}));
  EXPECT_EQ(found, of(uChannel(), 60)) << "the same seed";
  EXPECT_NE(found["cuts"], of(uChannel(), 60, 2)["cuts"]) << "another seed";
}

TEST_F(Cuts, MissingMeshIsAnError) {
  EXPECT_THROW(measureCuts({{"file", folder_ / "none.obj"}, {"scale", {1, 1, 1}}, {"tolerance", "1%"}, {"seed", 1}, {"cuts", 1}}), Error);
}

}  // namespace
}  // namespace collision_hulls
