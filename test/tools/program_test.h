// Runs a program of the package in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "pipeline/fixtures.h"

namespace collision_hulls {

struct Finished {
  int status = -1;
  std::string out, err;
};

class ProgramTest : public ::testing::Test {
 protected:
  explicit ProgramTest(const std::string& name) : name_(name) {}

  /// Runs in the folder, through a shell: quote arguments with spaces. `first`: commands before it, such as "ulimit -f 8; ".
  Finished run(const std::string& arguments, const std::string& first = "") {
    const std::string folder = folder_.path().string();
    const std::string command = "cd '" + folder + "' && " + first + "ROS_PACKAGE_PATH='" + folder + "' '" PROGRAMS "/" + name_ + "' " +
                                arguments + " >'" + (folder_ / ".out") + "' 2>'" + (folder_ / ".err") + "'";
    const int status = std::system(command.c_str());
    Finished result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, fixtures::read(folder_ / ".out"), fixtures::read(folder_ / ".err")};
    std::filesystem::remove(folder_ / ".out");
    std::filesystem::remove(folder_ / ".err");
    return result;
  }

  void expectWrongUse(const std::string& arguments, const std::vector<std::string>& parts) {
    const auto before = fixtures::contents(folder_.path());
    const Finished result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    for (const std::string& part : parts) EXPECT_NE(result.err.find(part), std::string::npos) << arguments << "\n" << result.err;
    EXPECT_EQ(fixtures::contents(folder_.path()), before) << arguments;
  }

  fixtures::TempFolder folder_;

 private:
  std::string name_;
};

}  // namespace collision_hulls
