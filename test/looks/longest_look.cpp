// Decomposes meshes or robots and prints where the longest computing time passed between two looks of one thread at the control: what a
// cancel may have to wait for. Only the time that a thread computes counts, so that neither waiting nor other work on the machine does.
//
// It also prints the most memory that it saw in use, and where that was.
//
// usage: longest_look MESH_OR_ROBOT... [--method NAME] [--count N] [--no-validate]
#include <execinfo.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/pipeline/output.h"
#include "collision_hulls/report/totals.h"

namespace {

using namespace collision_hulls;

using Stack = std::array<void*, 24>;

double computed() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Gap {
  double seconds = 0;
  Stack from{}, to{};
};

/// The longest gap for each place that ends one.
class Gaps {
 public:
  void look() {
    thread_local double last = 0;
    thread_local Stack before{};
    const double now = computed();
    sample();
    Gap gap{now - last, before, {}};
    backtrace(gap.to.data(), static_cast<int>(gap.to.size()));
    if (gap.seconds > kWorth) {
      const std::lock_guard<std::mutex> lock(mutex_);
      gaps_.push_back(gap);
    }
    before = gap.to;
    last = computed();
  }

  /// How much memory is in use, now and then.
  void sample() {
    static std::atomic<long> next{0};
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    const long now = time.tv_sec * 1000 + time.tv_nsec / 1000000;
    long due = next.load();
    if (now < due || !next.compare_exchange_strong(due, now + 5)) return;
    long pages = 0, resident = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
      if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
      std::fclose(file);
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    if (resident <= most_) return;
    most_ = resident;
    at_most_ = {};
    backtrace(at_most_.data(), static_cast<int>(at_most_.size()));
  }

  void print(std::size_t count) {
    std::printf("most seen: %ld MB\n", most_ * 4 / 1024);
    std::fflush(stdout);
    backtrace_symbols_fd(at_most_.data() + 2, 14, 1);
    std::sort(gaps_.begin(), gaps_.end(), [](const Gap& a, const Gap& b) { return a.seconds > b.seconds; });
    for (std::size_t i = 0; i < std::min(count, gaps_.size()); ++i) {
      std::printf("%.3f s\n", gaps_[i].seconds);
      for (const Stack* stack : {&gaps_[i].from, &gaps_[i].to}) {
        std::printf(stack == &gaps_[i].from ? " from\n" : " to\n");
        std::fflush(stdout);
        int depth = 0;
        while (depth < static_cast<int>(stack->size()) && (*stack)[static_cast<std::size_t>(depth)]) ++depth;
        backtrace_symbols_fd(stack->data() + 2, std::max(0, std::min(depth, 14) - 2), 1);
      }
    }
  }

 private:
  static constexpr double kWorth = 0.01;  // [s]
  long most_ = 0;
  Stack at_most_{};
  std::mutex mutex_;
  std::vector<Gap> gaps_;
};

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.cache = false;
  std::vector<std::string> meshes;
  std::size_t count = 10;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--method")
      options.method = *methodNamed(argv[++i]);
    else if (word == "--count")
      count = static_cast<std::size_t>(std::atoi(argv[++i]));
    else if (word == "--no-validate")
      options.validate = false;
    else
      meshes.push_back(word);
  }
  const std::filesystem::path output = std::filesystem::temp_directory_path() / ("longest_look_" + std::to_string(getpid()));
  for (const std::string& mesh : meshes) {
    Gaps gaps;
    RunControl control;
    control.ends = [&] { return gaps.look(), false; };
    RobotResult result = decompose(openInput(mesh, {}, control), options, output.string(), control);
    std::printf("%s: %zu hulls\n", mesh.c_str(), totals(result.report).hulls);
    writeOutput(result, output.string(), control);
    std::filesystem::remove_all(output);
    gaps.print(count);
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    std::printf("peak %ld MB\n", used.ru_maxrss / 1024);
  }
}
