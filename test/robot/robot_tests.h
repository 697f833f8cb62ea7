// What the tests of robot descriptions share.
#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "collision_hulls/error.h"
#include "scoped_variable.h"

namespace collision_hulls {

/// Expects an Error with this code whose text holds each of `parts`.
inline void expectError(ErrorCode code, const std::vector<std::string>& parts, const std::function<void()>& action) {
  try {
    action();
    ADD_FAILURE() << "no error; expected " << name(code);
  } catch (const Error& error) {
    EXPECT_STREQ(name(code), name(error.code())) << error.what();
    for (const std::string& part : parts) EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

/// A folder that is gone after the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "robot_test_XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path(const std::string& relative = "") const { return relative.empty() ? path_ : path_ + "/" + relative; }

  /// Writes a file, with the folders above it; returns its path.
  std::string write(const std::string& relative, const std::string& text = "") const {
    std::filesystem::create_directories(std::filesystem::path(path(relative)).parent_path());
    std::ofstream(path(relative), std::ios::binary) << text;
    return path(relative);
  }

 private:
  std::string path_;
};

/// A small robot.
inline constexpr char kUrdf[] = "<robot name=\"r\">\r\n<link name=\"a\"/></robot>";

/// Writes a shell script that can be run.
inline void writeProgram(const TemporaryFolder& folder, const std::string& name, const std::string& script) {
  chmod(folder.write(name, "#!/bin/sh\n" + script).c_str(), 0755);
}

inline std::string readFile(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// The text without its collision elements and the white space before each: what has to be equal before and after a rewriting.
/// The same as re.sub(r"\s*<collision\b.*?</collision>|\s*<collision\b[^>]*/>", "", text, flags=re.S) in Python.
inline std::string withoutCollisions(const std::string& text) {
  const std::string opening = "<collision", closing = "</collision>";
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    const char next = at + opening.size() < text.size() ? text[at + opening.size()] : ' ';
    const std::size_t close = text.find(closing, at), tag_end = text.find('>', at);
    const bool word_goes_on = std::isalnum(static_cast<unsigned char>(next)) || next == '_';
    const bool self_closing = tag_end != std::string::npos && text[tag_end - 1] == '/';
    if (word_goes_on || (close == std::string::npos && !self_closing)) {
      ++at;
      continue;
    }
    const std::size_t before = text.find_last_not_of(" \t\r\n", at - 1);
    if (before + 1 > done) result.append(text, done, before + 1 - done);
    done = at = close == std::string::npos ? tag_end + 1 : close + closing.size();
  }
  return result + text.substr(done);
}

}  // namespace collision_hulls
