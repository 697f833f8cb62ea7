#include "base/read_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

class ReadFile : public testing::Test {
 protected:
  ReadFile() {
    std::string name = (std::filesystem::temp_directory_path() / "read_file_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~ReadFile() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return (folder_ / name).string();
  }

  /// Expects an error with this code that names the path.
  static void expectError(ErrorCode code, const std::string& path, const std::string& part, std::uintmax_t most = 100) {
    try {
      readFile(path, "mesh", most);
      ADD_FAILURE() << path << " was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << error.what();
      EXPECT_NE(std::string(error.what()).find("'" + path + "' " + part), std::string::npos) << error.what();
    }
  }

  std::filesystem::path folder_;
};

TEST_F(ReadFile, ByteForByte) {
  std::string bytes(3'000'001, '\x80');  // more than one piece
  bytes[1'500'000] = '\0';
  EXPECT_EQ(readFile(write("a", bytes), "mesh", bytes.size()), bytes);
  EXPECT_EQ(readFile(write("b", ""), "mesh", 0), "");
}

TEST_F(ReadFile, LargerThanTheLimit) {
  expectError(ErrorCode::kTooLarge, write("a", "12345"), "has 5 bytes, above the limit of 4", 4);
}

TEST_F(ReadFile, AHugeFileCostsNothing) {
  const std::string path = write("a", "");
  std::filesystem::resize_file(path, std::uintmax_t{1} << 40);  // sparse
  expectError(ErrorCode::kTooLarge, path, "has 1099511627776 bytes");
}

TEST_F(ReadFile, NothingThere) {
  expectError(ErrorCode::kFileNotFound, (folder_ / "missing").string(), "does not exist");
}

TEST_F(ReadFile, Folder) {
  expectError(ErrorCode::kFileNotFound, folder_.string(), "is a folder");
}

// Opening a FIFO without a writer would wait for one.
TEST_F(ReadFile, FifosAndDevices) {
  const std::string fifo = (folder_ / "fifo").string();
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  expectError(ErrorCode::kFileNotFound, fifo, "is not a regular file");
  expectError(ErrorCode::kFileNotFound, "/dev/zero", "is not a regular file");
}

TEST_F(ReadFile, Cancelled) {
  const RunControl control;
  control.cancel();
  EXPECT_THROW(readFile(write("a", "1"), "mesh", 100, control), Error);
}

class ReadPipe : public ReadFile {
 protected:
  ReadPipe() : fifo_((folder_ / "fifo").string()) { mkfifo(fifo_.c_str(), 0600); }

  const std::string fifo_;
};

TEST_F(ReadPipe, UntilItsWriterClosesIt) {
  const std::string bytes(1'000'000, 'x');
  std::thread writer([&] {
    std::ofstream out(fifo_);
    for (std::size_t done = 0; done < bytes.size(); done += 100'000) out << bytes.substr(done, 100'000) << std::flush;
  });
  EXPECT_EQ(readFileOrPipe(fifo_, "list", bytes.size(), {}), bytes);
  writer.join();
  EXPECT_EQ(readFileOrPipe(write("a", "a file"), "list", 100, {}), "a file");
}

TEST_F(ReadPipe, WithoutEnd) {
  std::thread writer([&] { std::ofstream(fifo_) << std::string(10'000, 'x'); });
  try {
    readFileOrPipe(fifo_, "list", 9'999, {});
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kTooLarge) << error.what();
  }
  writer.join();
  EXPECT_THROW(readFileOrPipe("/dev/zero", "list", 100, {}), Error);
}

// Whether nobody writes, or somebody who never ends.
TEST_F(ReadPipe, IsCancelledWhileItWaits) {
  for (const bool opened : {false, true}) {
    const int other_end = opened ? open(fifo_.c_str(), O_RDWR) : -1;
    const RunControl control;
    std::thread canceller([&] { control.cancel(); });
    EXPECT_THROW(readFileOrPipe(fifo_, "list", 100, control), Error);
    canceller.join();
    if (other_end >= 0) close(other_end);
  }
}

}  // namespace
}  // namespace collision_hulls
