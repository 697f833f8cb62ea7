// The two doors to a kind of job: a service and an action that take the same request and give the same answer.
//
// Both hand the request to the node's one worker and refuse it where that is busy. The service's call waits for the answer; the action
// passes on feedback meanwhile, and cancels.
#pragma once

#include <actionlib/server/action_server.h>
#include <ros/message_traits.h>
#include <ros/ros.h>
#include <ros/serialization.h>

#include <functional>
#include <future>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "conversions.h"
#include "worker.h"

namespace collision_hulls {

/// A message as another type that has the same fields: those of a .srv and its .action. Where they differ this does not compile.
template <class To, class From>
To recast(const From& from) {
  using ros::message_traits::MD5Sum;
  static_assert(MD5Sum<To>::static_value1 == MD5Sum<From>::static_value1 && MD5Sum<To>::static_value2 == MD5Sum<From>::static_value2,
                "the .srv and the .action differ; make their fields the same");
  ros::SerializedMessage bytes = ros::serialization::serializeMessage(from);
  To to;
  ros::serialization::deserializeMessage(bytes, to);
  return to;
}

/// What a job answers, or why it cannot, which the log says as well.
template <class Response>
Response answered(const std::function<Response()>& job) {
  Response response;
  try {
    return job();
  } catch (const Error& error) {
    const bool cancelled = error.code() == ErrorCode::kCancelled;
    response.message = cancelled ? "cancelled; nothing was written" : inNodeWords(error.what());
    ROS_LOG(cancelled ? ros::console::levels::Info : ros::console::levels::Error, ROSCONSOLE_DEFAULT_NAME, "%s", response.message.c_str());
  } catch (const std::bad_alloc&) {
    response.message = "out of memory; nothing was written. Send smaller meshes, or free memory on the node's machine";
    ROS_ERROR("%s", response.message.c_str());
  } catch (const std::exception& error) {
    response.message = error.what();
    ROS_ERROR("%s", error.what());
  }
  return response;
}

/// Whether an answer says that something was written; where it cannot say so, whether all went well.
template <class Response>
auto hasWritten(const Response& response, int) -> decltype(response.urdf_path.empty()) {
  return !response.urdf_path.empty();
}
template <class Response>
bool hasWritten(const Response& response, long) {
  return response.success;
}

template <class Service, class Action>
class Door {
 public:
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  using Job = std::function<Response(const Request& request, const RunControl& control, const StepCallback& step)>;  ///< may throw

  /// `name` in the name space of `node` is the service's, `name`_action the action's.
  Door(ros::NodeHandle node, std::string name, Worker& worker, Job job)
      : node_(std::move(node)),
        name_(std::move(name)),
        worker_(worker),
        job_(std::move(job)),
        server_(
            node_, name_ + "_action", [this](Goal goal) { pursue(std::move(goal)); },
            [this](const Goal& goal) { worker_.cancel(nameOf(goal)); }, false) {}

  /// Nothing comes in before.
  void open() {
    server_.start();
    service_ = node_.advertiseService(name_, &Door::serve, this);
  }

 private:
  using Server = actionlib::ActionServer<Action>;
  using Goal = typename Server::GoalHandle;
  using Result = typename Server::Result;
  using Feedback = typename Server::Feedback;

  bool serve(Request& request, Response& response) {
    const auto done = std::make_shared<std::promise<void>>();  // shared: this call may return before set_value() does
    const auto work = [&](const RunControl& control) { response = answered<Response>([&] { return job_(request, control, {}); }); };
    const std::string refusal = refusalOf({"a call of " + name_, work, [done] { done->set_value(); }});
    if (refusal.empty()) {
      done->get_future().wait();
    } else {
      response.message = refusal;
    }
    return true;
  }

  void pursue(Goal goal) {
    const auto response = std::make_shared<Response>();
    const auto cancelled = std::make_shared<bool>(false);
    const auto work = [=](const RunControl& control) mutable {
      goal.setAccepted();
      if (goal.getGoalStatus().status == actionlib_msgs::GoalStatus::PREEMPTING) control.cancel();  // it came before the job began
      const auto feedback = [&](const Step& step) { goal.publishFeedback(recast<Feedback>(toMessage(step))); };
      *response = answered<Response>([&] { return job_(recast<Request>(*goal.getGoal()), control, feedback); });
      *cancelled = control.cancelled() && !hasWritten(*response, 0);
    };
    const auto reply = [=]() mutable {
      try {
        finish(goal, *response, *cancelled);
      } catch (const std::bad_alloc&) {
        goal.setAborted(Result(), "out of memory while the answer was made; set brief");
      }
    };
    const std::string refusal = refusalOf({nameOf(goal), work, reply});
    if (refusal.empty()) return;
    response->message = refusal;
    goal.setRejected(recast<Result>(*response), response->message);
  }

  /// Of the job for it.
  std::string nameOf(const Goal& goal) const { return "goal '" + goal.getGoalID().id + "' of " + name_ + "_action"; }

  /// Starts a job. Why that cannot be; empty if it began.
  std::string refusalOf(Worker::Job job) {
    try {
      return worker_.start(std::move(job)) ? "" : worker_.refusal();
    } catch (const std::exception& error) {
      return std::string("the request cannot begin: ") + error.what() + "; free memory on the node's machine";
    }
  }

  static void finish(Goal& goal, const Response& response, bool cancelled) {
    const Result result = recast<Result>(response);
    if (cancelled) {
      goal.setCanceled(result, response.message);
    } else if (response.success) {
      goal.setSucceeded(result, response.message);
    } else {
      goal.setAborted(result, response.message);
    }
  }

  ros::NodeHandle node_;
  const std::string name_;
  Worker& worker_;
  const Job job_;
  Server server_;
  ros::ServiceServer service_;
};

}  // namespace collision_hulls
