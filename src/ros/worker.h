// Runs one job at a time on a thread of its own.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// Keeps the node's callbacks free while a job runs, and jobs from interleaving. Thread safe.
class Worker {
 public:
  struct Job {
    std::string name;                             ///< for messages and for cancel()
    std::function<void(const RunControl&)> work;  ///< the reply comes even if it throws
    std::function<void()> reply;                  ///< runs once the next job may start
  };

  /// Cancels the job and waits for its end.
  ~Worker();

  /// Starts the job and returns true. Returns false and calls neither function if a job is running or after stop(). Throws
  /// std::system_error where the system has no thread left; then nothing runs.
  bool start(Job job);

  /// Cancels the running job if it has this name.
  void cancel(const std::string& name);

  /// Cancels the running job, whatever its name, and lets no other start.
  void stop();

  /// The running job's name; empty if there is none.
  std::string current() const;

  /// The message for a caller whose job was not started: "busy: ...".
  std::string refusal() const;

 private:
  void run(const Job& job, const RunControl& control);

  mutable std::mutex mutex_;
  std::string current_;
  bool running_ = false, stopped_ = false;
  std::shared_ptr<RunControl> control_;
  std::thread thread_;
};

}  // namespace collision_hulls
