// rosrun collision_hulls collision_hulls_node: see node.h and doc/ros.md.
//
// Handles its signals itself: ROS's own handler shuts the log down first, which would swallow what becomes of the running job, and a
// shutdown waits for the service call in progress, which only Node::stop() cuts short.
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <clocale>
#include <cstdio>
#include <exception>
#include <thread>
#include <vector>

#include "base/standard_files.h"
#include "master_watch.h"
#include "node.h"

namespace {

volatile sig_atomic_t interrupted = 0;

/// The first signal shuts the node down cleanly, a second one kills it.
void handleSignals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  signal(SIGXFSZ, SIG_IGN);  // a file beyond `ulimit -f` is then an error like a full disk
}

/// roscpp waits for a master for ever, and for nothing else. False if a signal came first.
bool waitForMaster() {
  if (!ros::master::check()) ROS_WARN("waiting for a master at %s: start roscore, or set ROS_MASTER_URI", ros::master::getURI().c_str());
  while (!interrupted && !ros::master::check()) ros::WallDuration(0.1).sleep();
  return !interrupted;
}

/// Handles callbacks as ros::AsyncSpinner does, but outlives one that throws, as any may where memory ends.
class Spinner {
 public:
  void start() {
    constexpr int kThreads = 4;
    for (int i = 0; i < kThreads; ++i) threads_.emplace_back([this] { spin(); });
  }
  void stop() {
    stopped_ = true;
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
  }
  ~Spinner() { stop(); }

 private:
  void spin() const {
    while (!stopped_) {
      try {
        ros::getGlobalCallbackQueue()->callOne(ros::WallDuration(0.1));  // one: what waits behind a long call is for another thread
      } catch (const std::exception& error) {
        ROS_ERROR("a message could not be handled: %s", error.what());
      }
    }
  }

  std::atomic<bool> stopped_{false};
  std::vector<std::thread> threads_;
};

/// Until a signal or ROS ends it, or a master has forgotten it. Returns the exit status.
int serve() {
  if (geteuid() == 0) ROS_WARN("running as root, which can read and write every file on this machine; run it as an ordinary user");
  Spinner spinner;
  collision_hulls::MasterWatch watch;
  collision_hulls::Node node;
  spinner.start();
  bool forgotten = false;
  while (!interrupted && !ros::isShuttingDown() && !forgotten) {
    ros::WallDuration(0.02).sleep();
    forgotten = watch.forgotten() && node.idle();
  }
  if (forgotten) {
    ROS_ERROR(
        "the master was restarted and does not know this node, which now shuts down; start it again (decompose.launch does so by itself)");
    watch.restore();
  }
  ros::master::setRetryTimeout(ros::WallDuration(2));  // a job that would tell a lost master does not wait for it
  node.stop();
  spinner.stop();
  return forgotten ? 1 : 0;
}  // the job has ended

/// Returns the exit status.
int usage(const std::string& argument) {
  const bool is_help = argument == "-h" || argument == "--help";
  if (!is_help) std::fprintf(stderr, "collision_hulls_node: it takes no argument '%s'\n", argument.c_str());
  std::fputs(
      "The node of collision_hulls. It takes parameters alone, such as _tolerance:=5mm,5%, and is started by\n"
      "  roslaunch collision_hulls decompose.launch    or, with rviz, view.launch\n"
      "Services, actions, topics and parameters: doc/ros.md\n",
      is_help ? stdout : stderr);
  return is_help ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  collision_hulls::holdStandardFiles();
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // or a log in a file or pipe would say nothing before the node ends
  std::setlocale(LC_CTYPE, "C.UTF-8");            // or the log would show each letter beyond ASCII, as paths have, as '??'
  ros::init(argc, argv, "collision_hulls", ros::init_options::NoSigintHandler);
  if (argc > 1) return usage(argv[1]);  // what is left once ROS has taken its own
  handleSignals();
  if (!waitForMaster()) return 0;
  const ros::NodeHandle last;  // when there is none any more the log ends
  int status = 0;
  try {
    status = serve();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    status = 1;
  }
  ros::shutdown();
  return status;
}
