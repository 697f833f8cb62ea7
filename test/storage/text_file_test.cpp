#include "storage/text_file.h"

#include <sys/stat.h>

#include <fstream>
#include <thread>

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

TEST(ReadTextFile, DevicesAndPipes) {
  const TemporaryFolder folder;
  const std::string fifo = folder.path("fifo.urdf");
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  for (const std::string& path : {fifo, std::string("/dev/zero")})
    expectError(ErrorCode::kFileNotFound, {path, "is not a regular file"}, [&] { readTextFile(path, "robot description"); });
  std::thread writer([&] { std::ofstream(fifo) << "a text"; });
  EXPECT_EQ(readTextFileOrPipe(fifo, "list", {}), "a text");
  writer.join();
}

}  // namespace
}  // namespace collision_hulls
