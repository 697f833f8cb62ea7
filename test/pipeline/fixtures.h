// Folders, meshes and robots made for tests.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {
namespace fixtures {

namespace fs = std::filesystem;

/// A new temporary folder, removed with everything in it.
class TempFolder {
 public:
  TempFolder() {
    std::string pattern = (fs::temp_directory_path() / "collision_hulls_test-XXXXXX").string();
    if (!mkdtemp(pattern.data())) ADD_FAILURE() << "no temporary folder like " << pattern;
    path_ = fs::canonical(pattern);
  }
  ~TempFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// An empty cache for each test, so that neither tests nor the programs they run touch the user's cache.
class OwnCache : public ::testing::EmptyTestEventListener {
 public:
  OwnCache() { setenv("COLLISION_HULLS_CACHE", path().c_str(), 1); }
  fs::path path() const { return folder_.path() / "cache"; }
  void OnTestStart(const ::testing::TestInfo&) override { fs::remove_all(path()); }

  static OwnCache* listener() {
    static auto* const only = new OwnCache;  // googletest deletes it
    return only;
  }

 private:
  TempFolder folder_;
};
inline const bool has_own_cache = (::testing::UnitTest::GetInstance()->listeners().Append(OwnCache::listener()), true);

inline std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline std::string write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file.string();
}

/// Every file below a folder, hidden ones included: relative path to content.
inline std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> result;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) result[fs::relative(entry.path(), folder).string()] = read(entry.path());
  }
  return result;
}

inline std::string obj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  for (const Eigen::Vector3d& v : mesh.vertices) text << "v " << v.x() << " " << v.y() << " " << v.z() << "\n";
  for (const Triangle& t : mesh.triangles) text << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
  return text.str();
}

inline std::string meshTag(const std::string& uri, const std::string& more = "") {
  return "<geometry><mesh filename=\"" + uri + "\"" + more + "/></geometry>";
}

/// A link with the given content, attached to `parent` (none for the root).
inline std::string link(const std::string& name, const std::string& content, const std::string& parent = "") {
  std::string text = "  <link name=\"" + name + "\">\n" + content + "  </link>\n";
  if (!parent.empty()) {
    text += "  <joint name=\"to_" + name + "\" type=\"fixed\">\n    <parent link=\"" + parent + "\"/>\n    <child link=\"" + name +
            "\"/>\n    <origin xyz=\"0 0 0.5\" rpy=\"0 0.3 0\"/>\n  </joint>\n";
  }
  return text;
}

inline std::string robot(const std::string& name, const std::string& links) {
  return "<?xml version=\"1.0\"?>\n<robot name=\"" + name + "\">\n" + links + "</robot>\n";
}

/// How often `part` occurs in the text.
inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// A line for each text.
inline std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += text + "\n";
  return all;
}

}  // namespace fixtures
}  // namespace collision_hulls
