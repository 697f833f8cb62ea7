// Python runs its handlers of signals on its main thread alone, and only while that thread is in the interpreter. So it is the caller's
// thread that waits and looks, and a new one that works.
#include "interruptible.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace collision_hulls {
namespace {

namespace py = pybind11;

constexpr std::chrono::milliseconds kLook{50};  // between looks at signals and at what Python wants

/// What the working thread tells the waiting one.
class News {
 public:
  void tell(double fraction) {
    const std::lock_guard<std::mutex> lock(mutex_);
    fraction_ = fraction;
  }

  void end(std::exception_ptr failure) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      failure_ = std::move(failure);
      ended_ = true;
    }
    changed_.notify_one();
  }

  /// Whether the work has ended; waits for it, but not for long.
  bool await() {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, kLook, [&] { return ended_; });
  }

  double fraction() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return fraction_;
  }

  /// What the work threw, if anything, once it has ended.
  const std::exception_ptr& failure() const { return failure_; }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  double fraction_ = 0;
  std::exception_ptr failure_;
};

/// Calls Python's handlers of signals, and `look`.
void lookAround(const News& news, const py::object& look) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  look(news.fraction());
}

void work(const std::function<void(const RunControl&)>& what, const RunControl& control, News& news) {
  try {
    what(control);
    news.end(nullptr);
  } catch (...) {
    news.end(std::current_exception());
  }
}

/// Waits for the end of the work. Returns what Python threw meanwhile, if anything.
std::exception_ptr await(News& news, const RunControl& control, const py::object& look) {
  std::exception_ptr thrown;
  for (;;) {
    {
      const py::gil_scoped_release release;
      if (news.await()) return thrown;
    }
    if (thrown) continue;
    try {
      lookAround(news, look);
    } catch (...) {
      thrown = std::current_exception();
      control.cancel();
    }
  }
}

}  // namespace

void runInterruptibly(const std::function<void(const RunControl&)>& what, const py::object& look) {
  News news;
  RunControl control;
  control.progress = [&](double fraction) { news.tell(fraction); };
  std::thread worker([&] { work(what, control, news); });
  const std::exception_ptr thrown = await(news, control, look);
  worker.join();
  if (thrown) std::rethrow_exception(thrown);
  if (news.failure()) std::rethrow_exception(news.failure());
  look(1.0);
}

}  // namespace collision_hulls
