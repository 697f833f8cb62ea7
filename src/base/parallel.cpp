// Each call runs in an isolated task group: by default TBB would bind it to an enclosing one and silently drop its work when that is
// cancelled.
//
// ThreadSanitizer cannot see how TBB's library, which is not built with it, hands work to its threads. So a build with ThreadSanitizer
// leaves this file uninstrumented, and CallOrder tells what comes before what.
#include "base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string_view>

#include "collision_hulls/error.h"

#ifdef COLLISION_HULLS_SANITIZE_THREADS
#include <sanitizer/tsan_interface.h>
#endif

namespace collision_hulls {
namespace {

#ifdef COLLISION_HULLS_SANITIZE_THREADS
void passOn(char& place) {
  __tsan_release(&place);
}
void takeOver(char& place) {
  __tsan_acquire(&place);
}
#else
void passOn(char&) {}
void takeOver(char&) {}
#endif

/// A call's work sees what was done before the call, and is seen after it. Pieces of one call are in no order.
class CallOrder {
 public:
  CallOrder() { passOn(begin_); }
  ~CallOrder() { takeOver(end_); }
  CallOrder(const CallOrder&) = delete;
  CallOrder& operator=(const CallOrder&) = delete;

  /// Around one piece of work.
  class Turn {
   public:
    explicit Turn(CallOrder& order) : order_(order) { takeOver(order_.begin_); }
    ~Turn() { passOn(order_.end_); }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    CallOrder& order_;
  };

 private:
  char begin_ = 0, end_ = 0;
};

}  // namespace

void forEach(std::size_t count, const std::function<void(std::size_t)>& work) {
  CallOrder order;
  const auto piece = [&](std::size_t i) {
    const CallOrder::Turn ordered(order);
    work(i);
  };
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::parallel_for(std::size_t{0}, count, piece, context);
}

void forEachInTurn(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};  // TBB splits the range in halves; the order is ours
  forEach(count, [&](std::size_t) { tbb::this_task_arena::isolate([&] { work(next++); }); });
}

void atOnce(const std::function<void()>& one, const std::function<void()>& other) {
  CallOrder order;
  const auto piece = [&](const std::function<void()>& work) {
    const CallOrder::Turn ordered(order);
    work();
  };
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::parallel_invoke([&] { piece(one); }, [&] { piece(other); }, context);
}

void withJobs(int jobs, const std::function<void()>& work) {
  const auto threads = static_cast<int>(mostThreads());  // more than the cores would only make TBB print a warning
  tbb::task_arena arena(jobs > 0 ? std::min(jobs, threads) : threads);
  try {
    arena.execute(work);
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {
    if (std::string_view(error.what()).find("pthread_create") == std::string_view::npos) throw;
    throw Error(ErrorCode::kOutOfMemory, std::string("no further thread can be started (") + error.what() +
                                             "); use fewer jobs, end other programs, or raise the limit of processes (ulimit -u)");
  }
}

std::size_t mostThreads() {
  return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
}

}  // namespace collision_hulls
