#include "storage/files.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace collision_hulls
