// Runs of the program that share a cache.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <set>

#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::TempFolder;
using nlohmann::json;
using Files = std::map<std::string, std::string>;

class CachedProgram : public ::testing::Test {
 protected:
  CachedProgram() {
    const auto part = [](const std::string& name, const std::string& parent = "") {
      return fixtures::link(name, "    <collision>" + fixtures::meshTag(name + ".obj") + "</collision>\n", parent);
    };
    fixtures::write(folder_ / "bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    fixtures::write(folder_ / "channel.obj", fixtures::obj(test_shapes::uChannel(0.2, 0.2, 0.02, 0.4)));
    fixtures::write(folder_ / "arm.urdf", fixtures::robot("arm", part("bracket") + part("channel", "bracket")));
  }

  /// Starts a run that writes to the folder `out`.
  pid_t start(const std::string& out, const char* option = "--quiet") {
    const pid_t child = fork();
    if (child > 0) return child;
    execl(PROGRAMS "/decompose", "decompose", (folder_ / "arm.urdf").c_str(), "--quiet", option, "--package-name=arm_hulls", "-o",
          (folder_ / out).c_str(), static_cast<char*>(nullptr));
    _exit(99);
  }

  /// Waits for a run; returns the files it wrote, with its report separate.
  std::pair<Files, json> finished(pid_t child, const std::string& out) {
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    Files files = fixtures::contents(folder_ / out);
    const json report = json::parse(files["report.json"]);
    for (const char* name : {"report.json", "report.html"}) files.erase(name);
    return {files, report};
  }

  static std::set<bool> cached(const json& report) {
    std::set<bool> values = {report["validation"]["cached"].get<bool>()};
    for (const json& row : report["links"]) values.insert(row["cached"].get<bool>());
    return values;
  }

  static Files entries() {
    Files files = fixtures::contents(fixtures::OwnCache::listener()->path());
    for (const char* no_entry : {"key", ".trimmed"}) files.erase(no_entry);
    return files;
  }

  TempFolder folder_;
};

TEST_F(CachedProgram, SecondRunUsesEntriesOfTheFirst) {
  const auto [first, first_report] = finished(start("out"), "out");
  EXPECT_EQ(cached(first_report), std::set<bool>{false});
  EXPECT_EQ(entries().size(), 3u) << "two meshes and the validation";
  const auto [second, second_report] = finished(start("out"), "out");
  EXPECT_EQ(cached(second_report), std::set<bool>{true});
  EXPECT_EQ(second, first);
  const auto [third, third_report] = finished(start("out", "--no-cache"), "out");
  EXPECT_EQ(cached(third_report), std::set<bool>{false});
  EXPECT_EQ(third, first);
}

TEST_F(CachedProgram, NoCacheWritesNoEntry) {
  finished(start("out", "--no-cache"), "out");
  EXPECT_FALSE(fs::exists(fixtures::OwnCache::listener()->path()));
}

TEST_F(CachedProgram, RunsAtTheSameTime) {
  const Files alone = finished(start("alone", "--no-cache"), "alone").first;
  const std::vector<std::string> outputs = {"one", "two", "three"};
  std::vector<pid_t> children;
  for (const std::string& out : outputs) children.push_back(start(out));
  for (std::size_t i = 0; i < children.size(); ++i) EXPECT_EQ(finished(children[i], outputs[i]).first, alone);
  EXPECT_EQ(entries().size(), 3u);
  const auto [after, report] = finished(start("after"), "after");
  EXPECT_EQ(cached(report), std::set<bool>{true});
  EXPECT_EQ(after, alone);
}

}  // namespace
}  // namespace collision_hulls
