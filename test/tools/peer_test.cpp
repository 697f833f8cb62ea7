// The programs that wrap Bullet's decompositions, if they were built.
// Also tests src/tools/peer_bullet_hacd.cpp and src/tools/peer_bullet_vcd.cpp.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/hull_objects.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

class Peer : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    program_ = std::string(PROGRAMS "/") + GetParam();
    if (access(program_.c_str(), X_OK) != 0) GTEST_SKIP() << program_ << " was not built: libbullet-extras-dev is missing";
    fixtures::write(folder_ / "box.obj", fixtures::obj(test_shapes::box(1, 2, 3)));
  }
  int run(const std::string& arguments) {
    const int status = std::system(("cd '" + folder_.path().string() + "' && '" + program_ + "' " + arguments + " >said 2>&1").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string program_;
  fixtures::TempFolder folder_;
};

TEST_P(Peer, ReturnsABoxUnchanged) {
  ASSERT_EQ(run("box.obj out.obj 0.05"), 0) << fixtures::read(folder_ / "said");
  const auto objects = readHullObjects((folder_ / "out.obj"));
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].size(), 8u);
}

TEST_P(Peer, HelpExplainsHowTheToleranceIsMapped) {
  EXPECT_EQ(run("--help"), 0);
  EXPECT_NE(fixtures::read(folder_ / "said").find("tolerance"), std::string::npos);
}

TEST_P(Peer, WrongUse) {
  for (const char* arguments : {"", "box.obj out.obj", "box.obj out.obj 0", "box.obj out.obj 5mm", "none.obj out.obj 1"})
    EXPECT_EQ(run(arguments), 2) << arguments;
}

INSTANTIATE_TEST_SUITE_P(Bullet, Peer, ::testing::Values("peer_bullet_hacd", "peer_bullet_vcd"));

}  // namespace
}  // namespace collision_hulls
