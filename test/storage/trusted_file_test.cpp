#include "storage/trusted_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

std::string distrustOf(uid_t owner, mode_t mode) {
  struct stat status {};
  status.st_uid = owner;
  status.st_mode = mode;
  return distrust(status);
}

TEST(Distrust, OfOwnersAndPermissions) {
  const uid_t stranger = geteuid() + 1;
  for (const uid_t owner : {geteuid(), uid_t{0}}) {
    for (const mode_t mode : {0600u, 0644u, 0755u, 01755u}) EXPECT_EQ(distrustOf(owner, mode), "") << owner << " " << mode;
    for (const mode_t mode : {0620u, 0602u, 0777u, 01777u}) EXPECT_EQ(distrustOf(owner, mode), "it can be written by others") << mode;
  }
  EXPECT_EQ(distrustOf(stranger, 0600), "it belongs to another user");
}

TEST(ReadTrustedFile, ContentOrFault) {
  const fixtures::TempFolder folder;
  const std::string file = fixtures::write(folder / "file", "12345");
  chmod(file.c_str(), 0644);
  EXPECT_EQ(readTrustedFile(file, 5).content, "12345");
  EXPECT_NE(readTrustedFile(file, 4).fault.find("above the limit of 4"), std::string::npos);
  EXPECT_EQ(readTrustedFile(file, 4).content, "");
  EXPECT_TRUE(readTrustedFile(folder / "none", 5).missing);
  EXPECT_FALSE(readTrustedFile(folder.path().string(), 5).fault.empty()) << "a folder";
  symlink(file.c_str(), (folder / "link").c_str());
  EXPECT_EQ(readTrustedFile(folder / "link", 5).fault, "it is a symbolic link");
  chmod(file.c_str(), 0664);
  EXPECT_EQ(readTrustedFile(file, 5).fault, "it can be written by others");
  EXPECT_EQ(readTrustedFile(file, 5).content, "");
}

TEST(LinkTrustedFile, WhatOthersCannotChange) {
  const fixtures::TempFolder folder;
  const std::string file = fixtures::write(folder / "file", "12345"), link = folder / "link";
  chmod(file.c_str(), 0644);
  symlink(file.c_str(), (folder / "symbolic").c_str());
  EXPECT_FALSE(linkTrustedFile(folder / "symbolic", "12345", 0644, link));
  for (const char* other : {"1234", "12346", "123456"}) EXPECT_FALSE(linkTrustedFile(file, other, 0644, link)) << other;
  for (const mode_t mode : {0664u, 0646u}) {
    chmod(file.c_str(), mode);
    EXPECT_FALSE(linkTrustedFile(file, "12345", mode, link)) << mode;
  }
  chmod(file.c_str(), 0644);
  if (geteuid() == 0) {  // only root can give files away
    ASSERT_EQ(chown(file.c_str(), 12345, static_cast<gid_t>(-1)), 0);
    EXPECT_FALSE(linkTrustedFile(file, "12345", 0644, link)) << "of another user";
    ASSERT_EQ(chown(file.c_str(), 0, static_cast<gid_t>(-1)), 0);
  }
  EXPECT_FALSE(linkTrustedFile(file, "12345", 0600, link)) << "other permissions";
  EXPECT_FALSE(std::filesystem::exists(link));
  EXPECT_TRUE(linkTrustedFile(file, "12345", 0644, link));
  EXPECT_EQ(std::filesystem::hard_link_count(file), 2u);
  EXPECT_FALSE(linkTrustedFile(file, "12345", 0644, link)) << "there is one already";
}

}  // namespace
}  // namespace collision_hulls
