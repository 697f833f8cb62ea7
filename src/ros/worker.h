// One job at a time, on a thread of its own.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// Keeps the node's callbacks free while a robot is decomposed, and two requests from interleaving. Thread safe.
class Worker {
 public:
  struct Job {
    std::string name;                             ///< what is being worked on, for messages and for cancel()
    std::function<void(const RunControl&)> work;  ///< must not throw
    std::function<void()> reply;                  ///< called when the next job may already be started; must not throw
  };

  /// Cancels the job and waits for its end.
  ~Worker();

  /// Starts the job, unless one is running or stop() was called: then it returns false at once and neither function is called.
  bool start(Job job);

  /// Cancels the running job if it has this name.
  void cancel(const std::string& name);

  /// Cancels the running job, whatever its name, and starts no other one.
  void stop();

  /// Name of the running job; empty when there is none.
  std::string current() const;

  /// What to tell whoever's job was not started: "busy: ...".
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
