// What a run tells of itself while it works, and how it is stopped.
#include "pipeline/run.h"

#include <algorithm>
#include <set>

#include "collision_hulls/error.h"
#include "pipeline/robot_run.h"

namespace collision_hulls {
namespace {

using fixtures::link;

class StepsOfARun : public fixtures::RobotRun {};

TEST_F(StepsOfARun, AreReported) {
  options_.jobs = 1;  // the larger file first
  RunControl control;
  std::vector<double> fractions;
  control.progress = [&](double fraction) { fractions.push_back(fraction); };
  std::vector<Step> steps;
  run(link("a", collision("bracket.obj")) + link("b", collision("rubbish.stl"), "a"), control,
      [&](const Step& step) { steps.push_back(step); });
  std::vector<std::string> stages, items;
  std::size_t done = 0;
  double fraction = 0;
  for (const Step& step : steps) {
    if (stages.empty() || stages.back() != step.stage) stages.push_back(step.stage);
    if (step.done > done) items.push_back(step.item);
    EXPECT_GE(step.done, done);
    EXPECT_GE(step.fraction, fraction);
    EXPECT_EQ(step.total, 2u);
    done = step.done;
    fraction = step.fraction;
  }
  EXPECT_EQ(stages, (std::vector<std::string>{"read", "decompose", "validate"}));
  EXPECT_EQ(items, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(steps.front().fraction, 0);
  EXPECT_EQ(steps.back().fraction, 1);
  EXPECT_GT(steps.back().hulls, 0u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1);
}

TEST_F(StepsOfARun, PrimitivesAreNoHulls) {
  options_.shapes = Shapes::kBox;
  Step last;
  run(link("a", collision("bracket.obj")) + link("b", collision("channel.obj"), "a"), {}, [&](const Step& step) { last = step; });
  EXPECT_EQ(last.hulls, 0u);
  EXPECT_EQ(last.primitives, 2u);
}

TEST_F(StepsOfARun, ProgressComesFromWithinAMesh) {
  RunControl control;
  std::set<double> within;
  std::size_t finished = 0;
  control.progress = [&](double fraction) {
    if (finished == 0 && fraction > 0 && fraction < 1) within.insert(fraction);
  };
  run(link("a", collision("bracket.obj")), control, [&](const Step& step) { finished = step.done; });
  EXPECT_GE(within.size(), 3u);
}

TEST_F(StepsOfARun, Cancelled) {
  const RunControl control;
  try {
    run(link("a", collision("bracket.obj")) + link("b", collision("channel.obj"), "a"), control, [&](const Step&) { control.cancel(); });
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kCancelled);
  }
}

}  // namespace
}  // namespace collision_hulls
