#include "base/failure_cause.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(FailureCause, LeavesOutFileLinkAndLine) {
  const auto cause = [](const std::string& reason, const std::string& uri, const std::string& link) {
    return failureCause(reason, uri, link, Folder::kKept);
  };
  EXPECT_EQ(cause("'m/a.stl' resolves to '/r/m/a.stl', which does not exist", "m/a.stl", "arm"),
            cause("'m/b.obj' resolves to '/r/m/b.obj', which does not exist", "m/b.obj", "hand"));
  EXPECT_EQ(cause("'r.urdf', line 7: link 'arm': its box has no size", "", "arm"),
            cause("'r.urdf', line 12: link 'hand': its box has no size", "", "hand"));
  EXPECT_EQ(cause("robot.link[arm] has a mesh without a file", "", "arm"), "robot.link has a mesh without a file");
  EXPECT_NE(cause("'m/a.stl' is empty", "m/a.stl", "arm"), cause("'m/a.stl' does not exist", "m/a.stl", "arm"));
  EXPECT_EQ(cause("'m/' is a folder", "m/", "arm"), "'m/' is a folder");
}

TEST(FailureCause, TellsFoldersApartIfTheyAreKept) {
  const auto cause = [](const std::string& file, Folder folder) { return failureCause("'" + file + "' is empty", file, "arm", folder); };
  EXPECT_NE(cause("m/a.stl", Folder::kKept), cause("n/b.stl", Folder::kKept));
  EXPECT_EQ(cause("m/a.stl", Folder::kLeftOut), "'' is empty");
  EXPECT_EQ(failureCause("m/a.stl is empty", "m/a.stl", "arm", Folder::kLeftOut), " is empty") << "the first word";
}

TEST(FailureCause, OfACopyIsThatOfTheFirst) {
  const std::string reason = "/r/m/a.stl: is empty", copy = reasonOfCopy("m/b.stl", "m/a.stl", reason);
  EXPECT_EQ(copy, "'m/b.stl' is equal to 'm/a.stl': /r/m/a.stl: is empty");
  EXPECT_EQ(failureCause(copy, "m/b.stl", "hand", Folder::kLeftOut), failureCause(reason, "m/a.stl", "arm", Folder::kLeftOut));
  EXPECT_EQ(failureCause("'m/b.stl' is equal to 'm/a", "m/b.stl", "hand", Folder::kLeftOut), "'' is equal to 'm/a") << "a name was cut";
}

TEST(FailureCause, SaysHowManyShareIt) {
  EXPECT_EQ(theSameFor(8, 3), " (the same for 8 more, of 3 links in all)");
  EXPECT_EQ(theSameFor(1, 1), " (the same for 1 more, of 1 link in all)");
}

}  // namespace
}  // namespace collision_hulls
