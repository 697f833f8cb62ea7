#include "storage/text_file.h"

#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

TEST(ReadTextFile, ByteForByte) {
  const TemporaryFolder folder;
  const std::string text("a\r\n\0\xff end", 10);
  EXPECT_EQ(readTextFile(folder.write("a.txt", text), "text"), text);
  EXPECT_EQ(readTextFile(folder.write("empty.txt"), "text"), "");
}

TEST(ReadTextFile, SaysWhatItCannotRead) {
  const TemporaryFolder folder;
  expectError(ErrorCode::kFileNotFound, {"robot description", "missing.urdf"},
              [&] { readTextFile(folder.path("missing.urdf"), "robot description"); });
  expectError(ErrorCode::kFileNotFound, {folder.path()}, [&] { readTextFile(folder.path(), "robot description"); });
}

}  // namespace
}  // namespace collision_hulls
