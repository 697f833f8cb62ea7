// Work on several cores. Nothing else sees TBB.
#pragma once

#include <cstddef>
#include <functional>

namespace collision_hulls {

// Calls may be nested. Each call completes all of its work, or else waits for what it has begun, begins no more, and throws the first
// exception that its work threw. An exception elsewhere never cuts a call short: whoever returns from one has all of its results. (TBB by
// itself silently skips whatever is nested in a cancelled call.)

/// Calls work(0) .. work(count - 1), each once, in any order, on the available threads.
void forEach(std::size_t count, const std::function<void(std::size_t)>& work);

/// The same for large pieces of work: they start in this order, and a thread that waits inside one does not pick up another.
void forEachInTurn(std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls both, in parallel.
void atOnce(const std::function<void()>& one, const std::function<void()>& other);

/// Runs `work`, including any parallel calls inside, on at most `jobs` threads and never more than there are cores; 0: one per core.
void withJobs(int jobs, const std::function<void()>& work);

/// The most threads that parallel calls use here.
std::size_t mostThreads();

}  // namespace collision_hulls
