// FCL's slow answers, in src/check/validate_pair.cpp: told by a clock that the test sets forward, as no test waits for seconds to pass.
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <ctime>

#include "collision_hulls/check/validate.h"
#include "solids.h"

namespace {

std::atomic<long> seconds_ahead{0}, seconds_each_time{0};

}  // namespace

/// Takes the place of the C library's in this program and its libraries: each look at the clock sets it forward.
extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const int result = static_cast<int>(syscall(SYS_clock_gettime, clock, time));
  if (result == 0) time->tv_sec += seconds_ahead += seconds_each_time;
  return result;
}

namespace collision_hulls {
namespace {

Validation validated(long seconds) {
  ValidationOptions options;
  options.queries_per_pair = 50;
  seconds_each_time = seconds;
  const Validation result = validate({{"box", test_shapes::box(1, 1, 1), {test_shapes::boxHull({0, 0, 0}, {1, 1, 1})}, 0}}, options);
  seconds_each_time = 0;
  return result;
}

TEST(SlowAnswers, OfMoreThanASecondAreCounted) {
  EXPECT_EQ(validated(0).timeouts, 0U);
  const Validation slow = validated(2);
  EXPECT_GE(slow.timeouts, 50U);
  EXPECT_GE(slow.mesh_query_us, 2e6);
  EXPECT_EQ(slow.missed + slow.phantom, 0U) << "they count as any others";
}

}  // namespace
}  // namespace collision_hulls
