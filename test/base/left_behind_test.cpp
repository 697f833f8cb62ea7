// Calls that a cancelled caller leaves behind.
#include "base/left_behind.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace collision_hulls {
namespace {

TEST(OrLeftBehind, ReturnsAndThrowsWhatTheWorkDoes) {
  EXPECT_EQ(orLeftBehind([](const RunControl&) { return 7; }, {}), 7);
  EXPECT_THROW(orLeftBehind([](const RunControl&) -> int { throw std::logic_error("no"); }, {}), std::logic_error);
}

TEST(OrLeftBehind, RunsInAThreadOfItsOwn) {
  EXPECT_NE(orLeftBehind([](const RunControl&) { return std::this_thread::get_id(); }, {}), std::this_thread::get_id());
}

TEST(OrLeftBehind, ACancelledCallerDoesNotWaitForTheWorkWhichIsTold) {
  struct Seen {
    std::atomic<bool> release{false}, told{false}, gone{false};
  };
  const auto seen = std::make_shared<Seen>();
  std::atomic<int> looks{0};
  RunControl control;
  control.ends = [&] { return ++looks > 1; };
  const auto work = [seen](const RunControl& mine) {
    while (!seen->release) std::this_thread::yield();
    seen->told = mine.cancelled();
    seen->gone = true;
    return 0;
  };
  try {
    orLeftBehind(work, control);  // waiting for the work would never end
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
  EXPECT_EQ(looks, 2) << "one before the work starts";
  EXPECT_FALSE(seen->gone);
  seen->release = true;
  while (!seen->gone) std::this_thread::yield();
  EXPECT_TRUE(seen->told);
}

}  // namespace
}  // namespace collision_hulls
