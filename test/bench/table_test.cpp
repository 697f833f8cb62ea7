#include "bench/table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "storage/csv.h"

namespace collision_hulls {
namespace {

TEST(BenchmarkTable, RowHasAFieldForEachColumn) {
  const std::string header = benchmarkHeader(), empty = toCsv({});
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(empty.begin(), empty.end(), ','));
  EXPECT_EQ(empty, ",,,,ok,,,,,,,,,,,,1,,,,\n");
  BenchmarkRow row;
  row.mesh = "a,b.stl";
  row.triangles = 12;
  row.method = "hacd";
  row.tolerance = 0.01;
  row.status = "timeout";
  row.wall_seconds = 60;
  row.requested = "1%";
  row.message = "ended";
  row.least_hulls = 3;
  EXPECT_EQ(toCsv(row), "\"a,b.stl\",12,hacd,0.01,timeout,,,,,,,,60,,,,1,,1%,ended,3\n");
}

}  // namespace
}  // namespace collision_hulls
