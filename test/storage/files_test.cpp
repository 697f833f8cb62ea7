#include "storage/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/roots.h"
#include "collision_hulls/error.h"
#include "pipeline/fixtures.h"
#include "storage/text_file.h"

namespace collision_hulls {
namespace {

using fixtures::TempFolder;

TEST(ContentOf, NothingIsNotAnEmptyFile) {
  const TempFolder folder;
  const std::string bytes("a\0\r\n\xff", 5);
  fixtures::write(folder / "empty", "");
  fixtures::write(folder / "bytes", bytes);
  EXPECT_EQ(contentOf(folder / "empty", 5), "");
  EXPECT_EQ(contentOf(folder / "bytes", 5), bytes);
  EXPECT_EQ(contentOf(folder / "bytes", 4), std::nullopt) << "above the limit";
  EXPECT_EQ(contentOf("/dev/zero", 5), std::nullopt) << "a device";
  EXPECT_EQ(contentOf(folder / "none", 5), std::nullopt);
  EXPECT_EQ(contentOf(folder.path(), 5), std::nullopt) << "a folder";
}

TEST(ReadTextFile, SaysWhatIsWrong) {
  const TempFolder folder;
  fixtures::write(folder / "text", "a text");
  EXPECT_EQ(readTextFile(folder / "text", "scene"), "a text");
  for (const auto& [path, part] : {std::pair<std::string, std::string>{folder / "none", "does not exist; give the path of a scene"},
                                   {folder.path().string(), "is a folder; give the scene in it"}}) {
    try {
      readTextFile(path, "scene");
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kFileNotFound);
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

std::vector<std::string> namesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

TEST(WriteNamedFile, ReplacesAFileWholeAndLeavesNothingElse) {
  const TempFolder folder;
  const std::string longest(255, 'x');
  for (const char* const text : {"first", ""}) {
    writeNamedFile(folder / longest, text);
    EXPECT_EQ(fixtures::read(folder / longest), text);
  }
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{longest});
}

TEST(WriteNamedFile, KeepsThePermissionsOfWhatItReplaces) {
  using std::filesystem::perms;
  const TempFolder folder;
  fixtures::write(folder / "file", "old");
  std::filesystem::permissions(folder / "file", perms::owner_read | perms::owner_write);
  writeNamedFile(folder / "file", "new");
  EXPECT_EQ(std::filesystem::status(folder / "file").permissions(), perms::owner_read | perms::owner_write);
}

TEST(CheckHoldsReport, OnlyReportsAreReplaced) {
  const TempFolder folder;
  for (const char* const text : {"", "{\"collision_hulls\": \"0.1.0\"}", " \n{\n \"collision_hulls\" : \"0.1.0\",\n \"files\": []\n}\n"}) {
    fixtures::write(folder / "file", text);
    EXPECT_NO_THROW(checkHoldsReport(folder / "file")) << text;
  }
  EXPECT_NO_THROW(checkHoldsReport(folder / "none"));
  EXPECT_NO_THROW(checkHoldsReport("/dev/null"));
  for (const char* const text : {"<robot/>", "default: {}", "solid", "{\"asset\": {\"version\": \"2.0\"}}", "{\"coll"}) {
    fixtures::write(folder / "file", text);
    EXPECT_THROW(checkHoldsReport(folder / "file"), Error) << text;
  }
}

TEST(CheckBeginsWith, NamesTheFileAndWhatItShouldHold) {
  const TempFolder folder;
  const auto checkTable = [&](const std::string& text) { checkBeginsWith(fixtures::write(folder / "file", text), "a,b", "table"); };
  for (const char* const text : {"", "a,b", "a,b,c\n1,2,3\n"}) EXPECT_NO_THROW(checkTable(text)) << text;
  for (const char* const text : {"a", "b,a", "robot"}) EXPECT_THROW(checkTable(text), Error) << text;
  try {
    checkTable("solid");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput);
    for (const char* part : {"'", "file'", "no table", "choose another name"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(WriteNamedFile, FollowsALinkThatWasThere) {
  const TempFolder folder;
  fixtures::write(folder / "file", "old");
  std::filesystem::create_symlink("file", folder / "link");
  writeNamedFile(folder / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(fixtures::read(folder / "file"), "new");
}

TEST(WriteNamedFile, MakesFoldersBelowALink) {
  const fixtures::TempFolder folder;
  std::filesystem::create_directory(folder / "real");
  std::filesystem::create_directory_symlink(folder / "real", folder / "link");
  writeNamedFile(folder / "link/beside", "one");
  writeNamedFile(folder / "link/a/b/below", "two");
  EXPECT_EQ(fixtures::read(folder / "real/beside"), "one");
  EXPECT_EQ(fixtures::read(folder / "real/a/b/below"), "two");
}

/// What the message of `action` says.
std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput);
    return error.what();
  }
  return "no error";
}

TEST(WriteNamedFile, APipeThatNobodyReads) {
  const TempFolder folder;
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_NE(refusal([&] { writeNamedFile(pipe, "text"); }).find("'" + pipe + "': nobody reads this pipe (start its reader"),
            std::string::npos);
  const Descriptor reader(open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  writeNamedFile(pipe, "text");
  char text[10];
  EXPECT_EQ(read(reader.number(), text, sizeof text), 4);
}

TEST(CheckNamedFile, LinksThatLeadNowhere) {
  const TempFolder folder;
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink("a", folder / "b");
  std::filesystem::create_symlink("none", folder / "dangling");
  const auto check = [&](const std::string& file) { return refusal([&] { checkNamedFile(file); }); };
  EXPECT_EQ(check(folder / "a").find("cannot write '" + (folder / "a") + "': its symbolic links lead in a circle; choose"), 0u);
  for (const std::string above : {"a", "dangling"})
    EXPECT_NE(check(folder / (above + "/sub/file")).find("/" + above + "' is a symbolic link that leads nowhere; choose"),
              std::string::npos);
  EXPECT_EQ(check(folder / "dangling"), "no error") << "the file behind it is made";
}

TEST(WriteNamedFile, NeverThroughALinkOutOfTheRoots) {
  const TempFolder folder;
  for (const char* const name : {"in", "elsewhere"}) std::filesystem::create_directories(folder / name);
  fixtures::write(folder / "elsewhere/report", "theirs");
  Roots roots;
  roots.write = {folder / "in"};
  const Confinement confinement(roots);
  std::filesystem::create_symlink(folder / "elsewhere/report", folder / "in/report");
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "in/sub");
  for (const char* const name : {"in/report", "in/sub/report", "in/sub/new"}) {
    try {
      writeNamedFile(folder / name, "ours");
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kOutsideRoots) << error.what();
    }
  }
  EXPECT_EQ(fixtures::read(folder / "elsewhere/report"), "theirs");
  EXPECT_EQ(namesIn(folder / "elsewhere"), std::vector<std::string>{"report"});
}

}  // namespace
}  // namespace collision_hulls
