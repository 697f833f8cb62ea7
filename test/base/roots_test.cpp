#include "base/roots.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/read_file.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

class RootsTest : public testing::Test {
 protected:
  RootsTest() {
    std::string name = (fs::temp_directory_path() / "roots_XXXXXX").string();
    folder_ = fs::canonical(mkdtemp(name.data()));
    for (const char* file : {"open/mesh", "openly/mesh", "shut/mesh", "package/mesh"}) {
      fs::create_directories(folder_ / fs::path(file).parent_path());
      std::ofstream(folder_ / file) << file;
    }
  }
  ~RootsTest() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  Roots roots() const { return {{path("open")}, {path("open")}, {}, {}, "set ~read_roots", "set ~output_root"}; }

  /// The message, which is empty if there is none.
  template <class Action>
  static std::string refusal(const Action& action) {
    try {
      action();
    } catch (const Error& error) {
      EXPECT_STREQ(name(error.code()), "OutsideRoots") << error.what();
      return error.what();
    }
    return "";
  }
  std::string readRefusal(const std::string& name) const {
    return refusal([&] { checkRead(path(name)); });
  }
  std::string writeRefusal(const std::string& name) const {
    return refusal([&] { writablePath(path(name)); });
  }

  fs::path folder_;
};

TEST_F(RootsTest, WithoutConfinementEverythingGoes) {
  EXPECT_EQ(readRefusal("shut/mesh"), "");
  EXPECT_EQ(writablePath("anywhere"), "anywhere");
}

TEST_F(RootsTest, ReadingStaysBelow) {
  const Confinement confinement(roots());
  for (const char* inside : {"open/mesh", "open", "open/none", "shut/../open/mesh"}) EXPECT_EQ(readRefusal(inside), "") << inside;
  for (const char* outside : {"shut/mesh", "openly/mesh", ".", "open/../shut/mesh"}) EXPECT_NE(readRefusal(outside), "") << outside;
  const std::string message = readRefusal("shut/mesh");
  for (const std::string& part : {path("shut/mesh"), path("open"), std::string("set ~read_roots")})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST_F(RootsTest, ConfinementEndsWithItsObject) {
  { const Confinement confinement(roots()); }
  EXPECT_EQ(readRefusal("shut/mesh"), "");
}

TEST_F(RootsTest, ALinkCountsAsWhatItLeadsTo) {
  fs::create_symlink(folder_ / "shut", folder_ / "open/way_out");
  fs::create_symlink(folder_ / "open", folder_ / "shut/way_in");
  const Confinement confinement(roots());
  EXPECT_NE(readRefusal("open/way_out/mesh").find(path("shut/mesh")), std::string::npos);
  EXPECT_NE(writeRefusal("open/way_out/new"), "");
  EXPECT_EQ(readRefusal("shut/way_in/mesh"), "");
  EXPECT_EQ(writablePath(path("shut/way_in/new")), path("open/new"));
}

TEST_F(RootsTest, WhatWasOpenedCounts) {
  const int open_file = open(path("open/mesh").c_str(), O_RDONLY), shut_file = open(path("shut/mesh").c_str(), O_RDONLY);
  {
    const Confinement confinement(roots());
    EXPECT_EQ(refusal([&] { checkRead(path("open/mesh"), open_file); }), "");
    EXPECT_NE(refusal([&] { checkRead(path("open/mesh"), shut_file); }), "") << "the path was a link when it was opened";
  }
  close(open_file);
  close(shut_file);
}

TEST_F(RootsTest, FilesAreReadThroughThem) {
  fs::create_symlink(folder_ / "shut/mesh", folder_ / "open/link");
  const Confinement confinement(roots());
  EXPECT_EQ(readFile(path("open/mesh"), "mesh", 100), "open/mesh");
  for (const char* outside : {"shut/mesh", "open/link"}) EXPECT_NE(refusal([&] { readFile(path(outside), "mesh", 100); }), "") << outside;
}

TEST_F(RootsTest, PackagesCanBeRead) {
  Roots with_packages = roots();
  with_packages.package_with = [&](const std::string& file) { return file == path("package/mesh") ? path("package") : ""; };
  const Confinement confinement(with_packages);
  EXPECT_NE(readRefusal("package/other"), "");
  EXPECT_EQ(readRefusal("package/mesh"), "");
  EXPECT_EQ(readRefusal("package/other"), "") << "the package is known now";
  EXPECT_NE(readRefusal("shut/mesh"), "");
  allowPackage(path("shut"));
  EXPECT_EQ(readRefusal("shut/mesh"), "");
  EXPECT_NE(writeRefusal("shut/new"), "");
}

TEST_F(RootsTest, FilesBesideAnother) {
  fs::create_directories(folder_ / "open/sub");
  fs::copy_file(folder_ / "open/mesh", folder_ / "open/sub/mesh");
  fs::create_symlink(folder_ / "shut", folder_ / "open/way_out");
  fs::create_symlink(folder_ / "open/mesh", folder_ / "shut/link");
  const auto beside = [this](const char* file, const char* mesh) {
    const OpenFile open(path(file));
    return liesBeside(path(file), open.number(), path(mesh));
  };
  for (const char* file : {"open/mesh", "open/sub/../mesh", "open/sub/mesh", "open/way_out/link"})
    EXPECT_TRUE(beside(file, "open/mesh")) << file;
  for (const char* file : {"openly/mesh", "shut/mesh", "open/way_out/mesh"}) EXPECT_FALSE(beside(file, "open/mesh")) << file;
  for (const char* file : {"shut/mesh", "open/sub/mesh"}) EXPECT_TRUE(beside(file, "shut/link")) << file;
  EXPECT_FALSE(beside("openly/mesh", "shut/link"));
}

TEST_F(RootsTest, AnOpenFileLiesWhereItWasOpened) {
  const std::string link = path("open/link");
  fs::create_symlink(folder_ / "shut/mesh", link);
  const OpenFile elsewhere(link);
  fs::remove(link);
  fs::create_symlink(folder_ / "open/mesh", link);
  const OpenFile beside(link);
  EXPECT_TRUE(liesBeside(link, beside.number(), path("open/mesh")));
  EXPECT_FALSE(liesBeside(link, elsewhere.number(), path("open/mesh")));
}

}  // namespace
}  // namespace collision_hulls
