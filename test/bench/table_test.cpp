#include "bench/table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/median.h"

namespace collision_hulls {
namespace {

TEST(Csv, QuotesFieldsThatNeedIt) {
  EXPECT_EQ(csvLine({}), "\n");
  EXPECT_EQ(csvLine({"a", "", "b c"}), "a,,b c\n");
  EXPECT_EQ(csvLine({"a,b", "say \"x\"", "two\nlines", "cr\r"}), "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\",\"cr\r\"\n");
}

TEST(Csv, Numbers) {
  EXPECT_EQ(csvNumber({}), "");
  EXPECT_EQ(csvNumber(0), "0");
  EXPECT_EQ(csvNumber(0.1), "0.1");
  EXPECT_EQ(csvNumber(1.0 / 3), "0.333333333");
  EXPECT_EQ(csvNumber(1e-12), "1e-12");
}

TEST(Csv, RowHasAFieldForEachColumn) {
  const std::string header = benchmarkHeader(), empty = toCsv({});
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(empty.begin(), empty.end(), ','));
  EXPECT_EQ(empty, ",,,,ok,,,,,,,,,,,,1,,,\n");
  BenchmarkRow row;
  row.mesh = "a,b.stl";
  row.triangles = 12;
  row.method = "hacd";
  row.tolerance = 0.01;
  row.status = "timeout";
  row.wall_seconds = 60;
  row.requested = "1%";
  row.message = "ended";
  EXPECT_EQ(toCsv(row), "\"a,b.stl\",12,hacd,0.01,timeout,,,,,,,,60,,,,1,,1%,ended\n");
}

TEST(Median, OfOddAndEvenCounts) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({3, 1}), 2);
  EXPECT_EQ(median({9, 1, 2}), 2);
  EXPECT_EQ(median({4, 100, 1, 2}), 3);
}

}  // namespace
}  // namespace collision_hulls
