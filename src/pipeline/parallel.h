// Work on several cores. The only place of this room that sees TBB.
#pragma once

#include <cstddef>
#include <functional>

namespace collision_hulls {

/// Runs `work` so that it, and what is parallel inside, uses at most `jobs` threads, and never more than cores; 0: as many
/// as cores.
void withJobs(int jobs, const std::function<void()>& work);

/// Calls work(0) .. work(count - 1), each once, on the threads there are; they begin in this order. The first exception is
/// thrown when all calls that had begun are done, and no further one begins.
void forEach(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace collision_hulls
