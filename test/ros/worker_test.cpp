#include "ros/worker.h"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <new>
#include <string>
#include <thread>

namespace collision_hulls {
namespace {

/// A job that works until it is released or cancelled.
struct Held {
  std::promise<void> begun, release;
  std::promise<bool> cancelled;  // set by the reply
  bool was_cancelled = false;

  Worker::Job job(const std::string& name) {
    const auto work = [this, released = release.get_future().share()](const RunControl& control) {
      begun.set_value();
      while (!control.cancelled() && released.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
      }
      was_cancelled = control.cancelled();
    };
    return {name, work, [this] { cancelled.set_value(was_cancelled); }};
  }
};

const auto kNothing = [](const RunControl&) {};
const auto kNoReply = [] {};

TEST(Worker, WithoutAJob) {
  Worker worker;
  EXPECT_EQ("", worker.current());
  worker.cancel("");
  worker.stop();
}

TEST(Worker, RunsOnAThreadOfItsOwn) {
  std::thread::id thread;
  std::promise<void> replied;
  Worker worker;
  ASSERT_TRUE(worker.start({"job", [&](const RunControl&) { thread = std::this_thread::get_id(); }, [&] { replied.set_value(); }}));
  replied.get_future().wait();
  EXPECT_NE(std::this_thread::get_id(), thread);
}

TEST(Worker, RefusesASecondJobUntilTheFirstIsDone) {
  Held held;
  Worker worker;
  ASSERT_TRUE(worker.start(held.job("first")));
  EXPECT_EQ("first", worker.current());
  EXPECT_FALSE(worker.start({"second", [](const RunControl&) { FAIL(); }, [] { FAIL(); }}));
  held.release.set_value();
  EXPECT_FALSE(held.cancelled.get_future().get());
  EXPECT_TRUE(worker.start({"third", kNothing, kNoReply}));
}

TEST(Worker, OutlivesAJobThatThrows) {
  std::promise<void> replied;
  const auto fail = [](const RunControl&) { throw std::bad_alloc(); };
  Worker worker;
  ASSERT_TRUE(worker.start({"job", fail, [&] { replied.set_value(), throw std::bad_alloc(); }}));
  replied.get_future().wait();
  EXPECT_TRUE(worker.start({"next", kNothing, kNoReply}));
}

TEST(Worker, IsFreeWhenItReplies) {
  Worker worker;
  for (int i = 0; i < 100; ++i) {
    const auto current = std::make_shared<std::promise<std::string>>();
    ASSERT_TRUE(worker.start({"job", kNothing, [&worker, current] { current->set_value(worker.current()); }}));
    EXPECT_EQ("", current->get_future().get());
  }
}

TEST(Worker, CancelsByName) {
  Held held;
  Worker worker;
  ASSERT_TRUE(worker.start(held.job("mine")));
  held.begun.get_future().wait();
  worker.cancel("another");
  EXPECT_EQ("mine", worker.current());
  worker.cancel("mine");
  EXPECT_TRUE(held.cancelled.get_future().get());
}

TEST(Worker, ACancelledJobDoesNotCancelTheNext) {
  Held first, second;
  Worker worker;
  ASSERT_TRUE(worker.start(first.job("job")));
  worker.cancel("job");
  EXPECT_TRUE(first.cancelled.get_future().get());
  ASSERT_TRUE(worker.start(second.job("job")));
  second.release.set_value();
  EXPECT_FALSE(second.cancelled.get_future().get());
}

TEST(Worker, StopCancelsAndRefusesFromThenOn) {
  Held held;
  Worker worker;
  ASSERT_TRUE(worker.start(held.job("job")));
  worker.stop();
  EXPECT_TRUE(held.cancelled.get_future().get());
  EXPECT_FALSE(worker.start({"late", kNothing, kNoReply}));
}

TEST(Worker, ItsEndCancelsAndWaits) {
  Held held;
  auto cancelled = held.cancelled.get_future();
  {
    Worker worker;
    ASSERT_TRUE(worker.start(held.job("job")));
  }
  ASSERT_EQ(std::future_status::ready, cancelled.wait_for(std::chrono::seconds(0)));
  EXPECT_TRUE(cancelled.get());
}

}  // namespace
}  // namespace collision_hulls
