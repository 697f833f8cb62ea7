#include "base/parallel.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <functional>
#include <stdexcept>
#include <vector>

#include "collision_hulls/error.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

/// Calls `work` inside a TBB call that was cancelled, as it is when another thread throws.
void withinCancelled(const std::function<void()>& work) {
  tbb::task_group_context context;
  const auto cancelThenWork = [&](int) {
    context.cancel_group_execution();
    work();
  };
  tbb::parallel_for(0, 1, cancelThenWork, context);
}

TEST(Parallel, CallsEachIndexOnce) {
  std::vector<std::atomic<int>> calls(1000);
  forEach(calls.size(), [&](std::size_t i) { ++calls[i]; });
  forEachInTurn(calls.size(), [&](std::size_t i) { ++calls[i]; });
  for (const std::atomic<int>& count : calls) EXPECT_EQ(2, count);
}

TEST(Parallel, PassesExceptionsOn) {
  const auto fail = [] { throw std::runtime_error("failed"); };
  EXPECT_THROW(forEach(10, [&](std::size_t i) { return i == 5 ? fail() : void(); }), std::runtime_error);
  EXPECT_THROW(forEachInTurn(10, [&](std::size_t i) { return i == 5 ? fail() : void(); }), std::runtime_error);
  EXPECT_THROW(atOnce(fail, [] {}), std::runtime_error);
  EXPECT_THROW(withJobs(1, fail), std::runtime_error);
}

TEST(Parallel, SkipsNothingInsideACancelledCall) {
  std::atomic<int> calls{0};
  withinCancelled([&] {
    forEach(100, [&](std::size_t) { ++calls; });
    forEachInTurn(10, [&](std::size_t) { ++calls; });
    atOnce([&] { ++calls; }, [&] { ++calls; });
  });
  EXPECT_EQ(112, calls);
}

// Once, the caller of a tree with missing halves ran in circles in it for ever.
TEST(Parallel, ATreeBuiltInsideACancelledCallIsComplete) {
  const TriangleMesh mesh = test_shapes::sphere(1, 30);
  ASSERT_GT(mesh.triangles.size(), 10000U);
  const Eigen::Vector3d p(0.1, 0.2, 0.3);
  const double distance = TriangleBvh(mesh).nearest(p).distance;
  double within = 0;
  withinCancelled([&] { within = TriangleBvh(mesh).nearest(p).distance; });
  EXPECT_EQ(distance, within);
}

TEST(WithJobs, AThreadThatCannotBeStartedHasARemedy) {
  try {
    withJobs(1, [] { throw std::runtime_error("pthread_create has failed: Resource temporarily unavailable"); });
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kOutOfMemory);
    EXPECT_NE(std::string(error.what()).find("ulimit -u"), std::string::npos) << error.what();
  }
  EXPECT_THROW(withJobs(1, [] { throw Error(ErrorCode::kBadScale, "pthread_create"); }), Error);
  EXPECT_THROW(withJobs(1, [] { throw std::runtime_error("other"); }), std::runtime_error);
}

}  // namespace
}  // namespace collision_hulls
