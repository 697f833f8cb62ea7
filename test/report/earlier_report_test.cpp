#include "report/earlier_report.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/roots.h"
#include "counted_looks.h"
#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using Files = std::set<fs::path>;

class EarlierReport : public ::testing::Test {
 protected:
  std::optional<EarlierOutput> read(const std::string& report) {
    fixtures::write(file(), report);
    return earlierOutput(folder_.path());
  }
  std::string file() const { return folder_ / "report.json"; }

  const fixtures::TempFolder folder_;
};

TEST_F(EarlierReport, FilesAndWhetherARowFailed) {
  const std::string begin = R"({"collision_hulls": "1", "notes": [{"files": ["no"]}], "files": ["urdf/a.urdf"], "links": [)";
  const auto row = [](const std::string& status, const std::string& file) {
    return R"({"status": ")" + status + R"(", "repair": {"files": ["no"], "status": "failed"}, "files": [")" + file + R"("]})";
  };
  const auto complete = read(begin + row("ok", "a.stl") + "," + row("degraded", "b.stl") + "]}");
  ASSERT_TRUE(complete);
  EXPECT_EQ(complete->files, (Files{"report.json", "urdf/a.urdf", "a.stl", "b.stl"}));
  EXPECT_TRUE(complete->complete);
  EXPECT_FALSE(read(begin + row("ok", "a.stl") + "," + row("failed", "b.stl") + "]}")->complete);
  const auto with_model = [&](const std::string& status) {
    return read(begin + row("ok", "a.stl") + R"(], "models": [{"links": [)" + row(status, "c.stl") + "]}]}");
  };
  EXPECT_TRUE(with_model("degraded")->complete);
  EXPECT_FALSE(with_model("failed")->complete);
}

TEST_F(EarlierReport, OfTensOfThousandsOfRows) {
  std::string rows;
  for (int i = 0; i < 20'000; ++i) rows += R"({"note": ")" + std::string(1000, 'x') + R"(", "status": "ok", "files": ["a.stl"]},)";
  rows.back() = ']';
  const auto earlier = read(R"({"collision_hulls": "1", "files": [], "links": [)" + rows + "}");
  ASSERT_TRUE(earlier);
  EXPECT_EQ(earlier->files, (Files{"report.json", "a.stl"}));
}

TEST_F(EarlierReport, WhatTheModelWasMadeFrom) {
  const auto written = [&](const std::string& rows, const std::string& more = "") {
    fixtures::write(file(),
                    R"({"collision_hulls": "1", "files": [], "input": {"path": "a", "sha256": "12"}, "options": {"source": "visual"}, )" +
                        more + "\"links\": [" + rows + "]}");
    return earlierSource(folder_.path());
  };
  const auto source = written(R"({"link": "a", "source": "collision", "status": "ok", "files": [], "close_openings": 0.25},)"
                              R"({"link": "b", "source": "visual", "sha256": "34", "status": "ok", "files": []})");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->input_sha256, "12");
  EXPECT_EQ(source->source, Source::kVisual);
  EXPECT_EQ(source->close_openings, 0.25);
  EXPECT_EQ(source->of_link, (std::map<std::string, Source>{{"a", Source::kCollision}, {"b", Source::kVisual}}));
  EXPECT_FALSE(source->fitted);
  EXPECT_TRUE(written("", R"("scene": {"name": "table", "links": []}, )")->fitted);
  EXPECT_FALSE(written(R"({"link": "a"})"));
  EXPECT_FALSE(written("5"));
  fs::remove(file());
  EXPECT_FALSE(earlierSource(folder_.path()));
}

TEST_F(EarlierReport, NamesNoFileElsewhere) {
  const auto output = read(R"({"collision_hulls": "1", "links": [], "files": ["/etc/passwd", "../a", "b/../../c", "b/../d", ""]})");
  ASSERT_TRUE(output);
  EXPECT_EQ(output->files, (Files{"report.json", "d"}));
}

TEST_F(EarlierReport, WhatIsNone) {
  EXPECT_FALSE(earlierOutput(folder_.path()));
  for (const char* text :
       {"", "{", "[]", "5", "{}", R"({"collision_hulls": "1"})", R"({"collision_hulls": "1", "files": [], "links": [5]})",
        R"({"collision_hulls": "1", "files": [5], "links": []})", R"({"files": [], "links": []})",
        R"({"collision_hulls": "1", "files": {"a": "b"}, "links": []})", R"({"collision_hulls": "1", "files": []})",
        R"({"collision_hulls": "1", "files": [], "links": [{"files": []}, {}]})",
        R"({"collision_hulls": "1", "files": [], "links": [{"files": [], "status": 5}]})",
        R"({"collision_hulls": "1", "files": [], "links": []} 5)"})
    EXPECT_FALSE(read(text)) << text;
  EXPECT_FALSE(read(std::string(1'000'000, '['))) << "nested deeply";
}

// A tree of JSON that is filtered while it grows takes a time that grows with the square of this.
TEST_F(EarlierReport, EachValueIsLookedAtOnce) {
  constexpr std::size_t kRows = 100'000, kPasses = 2 * kRows / kLargeItemsBetweenLooks;  // two values in each row
  std::string rows = R"({"files": []})";
  for (std::size_t i = 1; i < kRows; ++i) rows += R"(,{"files": []})";
  ASSERT_TRUE(read(R"({"collision_hulls": "1", "files": [], "links": [)" + rows + "]}"));
  const auto work = [&](const RunControl& control) { earlierOutput(folder_.path(), control); };
  const std::size_t looks = looksOf(work);
  EXPECT_GE(looks, kPasses);
  EXPECT_LE(looks, kPasses + 10) << "while the file is read";
  EXPECT_EQ(looksAfterCancel(kPasses / 2, work), 1u);
  EXPECT_EQ(looksAfterCancel(kPasses / 2, [&](const RunControl& control) { earlierSource(folder_.path(), control); }), 1u);
}

TEST_F(EarlierReport, APathThatNoFileHasIsNoFile) {
  std::string deep = "a";
  while (deep.size() < 5000) deep += "/a";
  const auto output = read(R"({"collision_hulls": "1", "links": [], "files": ["b", ")" + deep + "\"]}");
  ASSERT_TRUE(output);
  EXPECT_EQ(output->files, (Files{"report.json", "b"}));
}

TEST_F(EarlierReport, WhatMayNotBeReadIsNone) {
  ASSERT_TRUE(read(R"({"collision_hulls": "1", "files": [], "links": []})"));
  fs::create_directory(folder_ / "root");
  const auto readable = [&](const std::string& root) {
    const Confinement confinement({{root}, {root}, {}, {}, "", ""});
    return earlierOutput(folder_.path()).has_value();
  };
  EXPECT_TRUE(readable(folder_.path()));
  EXPECT_FALSE(readable(folder_ / "root"));
  fs::rename(file(), folder_ / "root/other");
  fs::create_symlink(folder_ / "root/other", file());
  EXPECT_TRUE(readable(folder_ / "root")) << "it lies below the root";
}

// Looked at before anything is read: these would wait, or fill the memory.
TEST_F(EarlierReport, NoRegularFile) {
  ASSERT_TRUE(read(R"({"collision_hulls": "1", "files": [], "links": []})"));
  fs::resize_file(file(), std::uintmax_t{1} << 40);  // sparse
  EXPECT_FALSE(earlierOutput(folder_.path()));
  fs::remove(file());
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  EXPECT_FALSE(earlierOutput(folder_.path()));
  fs::remove(file());
  fs::create_symlink("/dev/zero", file());
  EXPECT_FALSE(earlierOutput(folder_.path()));
  fs::remove(file());
  fs::create_directory(file());
  EXPECT_FALSE(earlierOutput(folder_.path()));
}

}  // namespace
}  // namespace collision_hulls
