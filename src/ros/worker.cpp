// One thread for each job, joined when the next one starts or at the end.
#include "worker.h"

#include <exception>
#include <iostream>
#include <utility>

namespace collision_hulls {
namespace {

/// What throws ends by itself alone: an exception that leaves a thread would end the node.
template <class Function>
void attempt(const Function& function) {
  try {
    function();
  } catch (const std::exception& error) {
    std::cerr << "a job of the node ended early: " << error.what() << "\n";
  }
}

}  // namespace

Worker::~Worker() {
  stop();
  if (thread_.joinable()) thread_.join();
}

bool Worker::start(Job job) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (running_ || stopped_) return false;
  if (thread_.joinable()) thread_.join();  // its job is done and it no longer needs the mutex
  control_ = std::make_shared<RunControl>();
  std::string name = job.name;
  thread_ = std::thread([this, job = std::move(job), control = control_] { run(job, *control); });
  running_ = true;  // not before a thread is there; its job cannot end while the mutex is held
  current_ = std::move(name);
  return true;
}

void Worker::run(const Job& job, const RunControl& control) {
  attempt([&] { job.work(control); });
  {
    // Free before the reply, as its receiver may send the next job right away.
    const std::lock_guard<std::mutex> lock(mutex_);
    running_ = false;
    current_.clear();
  }
  attempt(job.reply);
}

void Worker::cancel(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (running_ && current_ == name) control_->cancel();
}

void Worker::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  stopped_ = true;
  if (running_) control_->cancel();
}

std::string Worker::current() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return current_;
}

std::string Worker::refusal() const {
  const std::string job = current();
  return "busy: working on " + (job.empty() ? "another request" : job) + "; try again when it is done";
}

}  // namespace collision_hulls
