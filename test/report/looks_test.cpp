// A report of many rows looks at the control while it is written, and says the same as row by row.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "collision_hulls/report/report.h"
#include "counted_looks.h"

namespace collision_hulls {
namespace {

Report reportOf(std::size_t rows) {
  Report report;
  report.links.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) report.links[i].link = "link\n \"links\": [] " + std::to_string(i);
  return report;
}

TEST(LooksOfReport, OneForSoManyRows) {
  const Report report = reportOf(3000);
  EXPECT_GE(looksOf([&](const RunControl& control) { toJson(report, control); }), 3000 / kLargeItemsBetweenLooks);
  EXPECT_EQ(looksAfterCancel(3, [&](const RunControl& control) { toJson(report, control); }), 1u);
}

TEST(LooksOfReport, RowsLieWhereTheDocumentHasThem) {
  Report report = reportOf(3);
  report.models.emplace_back();
  report.models.emplace_back(reportOf(2));
  const std::string text = toJson(report);
  const nlohmann::json read = nlohmann::json::parse(text);
  EXPECT_EQ(text, read.dump(1) + "\n");
  ASSERT_EQ(read["links"].size(), 3u);
  EXPECT_EQ(read["links"][2]["link"], report.links[2].link);
  EXPECT_TRUE(read["models"][0]["links"].empty());
  EXPECT_EQ(read["models"][1]["links"].size(), 2u);
}

}  // namespace
}  // namespace collision_hulls
