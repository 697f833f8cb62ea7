// Reads the machine's description from uname, sysconf and /proc/cpuinfo (Linux); compiler and library versions are fixed at build time.
#include "bench/machine.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <thread>

#include "collision_hulls/report/report.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

std::string cpuName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

json describeMachine() {
  utsname system{};
  uname(&system);
  return {{"system", std::string(system.sysname) + " " + system.release + " " + system.machine},
          {"cpu", cpuName()},
          {"cores", std::thread::hardware_concurrency()},
          {"memory_mb", sysconf(_SC_PHYS_PAGES) / 1024 * sysconf(_SC_PAGESIZE) / 1024},
          {"build", COLLISION_HULLS_BUILD},
          {"libraries", COLLISION_HULLS_LIBRARIES},
          {"collision_hulls", version()}};
}

}  // namespace collision_hulls
