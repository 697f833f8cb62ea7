#include "pipeline/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace collision_hulls {

void withJobs(int jobs, const std::function<void()>& work) {
  const int threads = tbb::this_task_arena::max_concurrency();  // more than cores would only make TBB print a warning
  tbb::task_arena arena(jobs > 0 ? std::min(jobs, threads) : threads);
  arena.execute(work);
}

void forEach(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};  // TBB splits the range in halves: the order is ours
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t) {
    // Isolated: a thread that waits inside one element must not take up another one meanwhile.
    tbb::this_task_arena::isolate([&] { work(next++); });
  });
}

}  // namespace collision_hulls
