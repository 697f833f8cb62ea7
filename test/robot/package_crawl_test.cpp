#include "robot/package_crawl.h"

#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

constexpr char kManifest[] = "<package><name>arm</name></package>";

TEST(PackageAt, ReadsTheNameOfAManifest) {
  const TemporaryFolder folder;
  folder.write("one/package.xml", kManifest);
  folder.write("two/manifest.xml", "<package/>");
  folder.write("three/package.xml", "<package><name>");
  folder.write("four/readme.txt");
  EXPECT_EQ(packageAt(folder.path("one"))->name, "arm");
  EXPECT_EQ(packageAt(folder.path("two"))->name, "two") << "the old kind takes its folder's name";
  EXPECT_EQ(packageAt(folder.path("three"))->name, "three");
  EXPECT_TRUE(packageAt(folder.path("three"))->broken);
  EXPECT_FALSE(packageAt(folder.path("four")));
}

TEST(PackageAround, IsTheInnermostBelowTheTop) {
  const TemporaryFolder folder;
  const std::string file = folder.write("ws/arm/inner/urdf/arm.urdf");
  EXPECT_EQ(packageAround(file), "");
  folder.write("ws/arm/package.xml", kManifest);
  EXPECT_EQ(packageAround(file), folder.path("ws/arm"));
  EXPECT_EQ(packageAround(file, folder.path("ws")), folder.path("ws/arm"));
  EXPECT_EQ(packageAround(file, folder.path("ws/arm")), "");
  folder.write("ws/arm/inner/package.xml", kManifest);
  EXPECT_EQ(packageAround(file), folder.path("ws/arm/inner"));
}

TEST(PackageCrawl, StopsWhereRospackDoes) {
  const TemporaryFolder folder;
  folder.write("a/arm/package.xml", kManifest);
  folder.write("a/arm/inner/package.xml", "<package><name>inner</name></package>");
  folder.write("b/CATKIN_IGNORE");
  folder.write("b/lost/package.xml", "<package><name>lost</name></package>");
  folder.write("c/.hidden/package.xml", "<package><name>hidden</name></package>");
  const PackageCrawl crawl({folder.path()});
  EXPECT_EQ(crawl.find("arm"), folder.path("a/arm"));
  for (const char* name : {"inner", "lost", "hidden"}) EXPECT_FALSE(crawl.find(name)) << name;
}

TEST(PackageCrawl, TheFirstOfANameCounts) {
  const TemporaryFolder folder;
  folder.write("y/package.xml", kManifest);
  folder.write("x/package.xml", kManifest);
  EXPECT_EQ(PackageCrawl({folder.path("y"), folder.path("x")}).find("arm"), folder.path("y"));
}

TEST(SortedEntries, OfAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  folder.write("b");
  folder.write("a");
  ASSERT_EQ(sortedEntries(folder.path()).size(), 2u);
  EXPECT_EQ(sortedEntries(folder.path()).front(), folder.path("a"));
  EXPECT_TRUE(sortedEntries(folder.path("missing")).empty());
}

}  // namespace
}  // namespace collision_hulls
