// Each call runs in an isolated task group: by default TBB would bind it to an enclosing one and silently drop its work when that is
// cancelled.
#include "base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string_view>

#include "collision_hulls/error.h"

namespace collision_hulls {

void forEach(std::size_t count, const std::function<void(std::size_t)>& work) {
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::parallel_for(std::size_t{0}, count, work, context);
}

void forEachInTurn(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};  // TBB splits the range in halves; the order is ours
  forEach(count, [&](std::size_t) { tbb::this_task_arena::isolate([&] { work(next++); }); });
}

void atOnce(const std::function<void()>& one, const std::function<void()>& other) {
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::parallel_invoke(one, other, context);
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
