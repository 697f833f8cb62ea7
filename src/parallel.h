// Work on several cores. The only place that sees TBB.
#pragma once

#include <cstddef>
#include <functional>

namespace collision_hulls {

// What is parallel here may stand inside of what is parallel. Each call does the whole of its work, or throws the first exception that
// came out of it when all that had begun is done; then no further work of this call begins. An exception elsewhere never cuts it short:
// whoever comes back from a call has all of its results. (By itself TBB leaves out, silently, whatever lies within a cancelled call.)

/// Calls work(0) .. work(count - 1), each once, in any order, on the threads there are.
void forEach(std::size_t count, const std::function<void(std::size_t)>& work);

/// The same for large pieces of work: they begin in this order, and a thread that waits inside one of them takes up no other one.
void forEachInTurn(std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls both.
void atOnce(const std::function<void()>& one, const std::function<void()>& other);

/// Runs `work` so that it, and what is parallel inside, uses at most `jobs` threads, and never more than cores; 0: as many
/// as cores.
void withJobs(int jobs, const std::function<void()>& work);

/// The most threads that what is parallel uses here.
std::size_t mostThreads();

}  // namespace collision_hulls
