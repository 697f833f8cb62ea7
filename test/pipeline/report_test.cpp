#include "collision_hulls/pipeline/report.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

namespace collision_hulls {
namespace {

using nlohmann::json;

Report sample() {
  Report report;
  report.input_path = "robots/\"arm\".urdf";
  report.input_sha256 = "abc";
  report.options.seed = 18446744073709551615u;
  report.validation.queries = 400;
  report.validation.remarks = {"a remark"};
  report.notes = {"a note"};
  report.seconds = 1.5;
  ElementReport row;
  row.link = "upper";
  row.element = 2;
  row.visual = true;
  row.uri = "package://arm/meshes/upper.stl";
  row.scale = {1, -1, 0.001};
  row.triangles = 12;
  row.hulls = 3;
  row.hull_vertices = 24;
  row.tolerance = 0.1 + 0.2;  // takes all 17 digits
  row.protrusion = 1.0 / 3;
  row.interior = "closed";
  row.files = {"meshes/upper/2_0.stl"};
  report.links.push_back(row);
  row.element = 3;
  row.status = Status::kDegraded;
  row.reason = "too far";
  report.links.push_back(row);
  row = {};
  row.link = "lower";
  row.status = Status::kFailed;
  row.error = "FileNotFound";
  row.reason = "no file";
  report.links.push_back(row);
  return report;
}

TEST(ReportJson, HasTheFieldsOfTheContract) {
  const json document = json::parse(toJson(sample()));
  EXPECT_EQ(document["collision_hulls"], version());
  EXPECT_EQ(document["input"]["path"], "robots/\"arm\".urdf");
  EXPECT_EQ(document["seed"], 18446744073709551615u);
  for (const json& row : document["links"]) {
    for (const char* field :
         {"link",   "element",     "source",    "uri",     "sha256",        "scale",        "triangles",  "status",           "reason",
          "repair", "method",      "tolerance", "hulls",   "hull_vertices", "uncovered",    "protrusion", "protrusion_found", "interior",
          "volume", "hull_volume", "diagonal",  "seconds", "files",         "covered_share"}) {
      EXPECT_TRUE(row.contains(field)) << field;
    }
    for (const char* field : {"welded", "degenerate", "duplicate", "flipped", "components", "open_edges", "nonmanifold_edges"})
      EXPECT_TRUE(row["repair"].contains(field)) << field;
    for (const char* field : {"read", "repair", "decompose", "certify", "write"}) EXPECT_TRUE(row["seconds"].contains(field)) << field;
  }
  for (const char* field : {"queries", "missed", "phantom", "max_underestimate", "exceptions", "timeouts", "nan", "disagreements",
                            "mesh_query_us", "hull_query_us"})
    EXPECT_TRUE(document["validation"].contains(field)) << field;
  for (const char* field :
       {"tolerance", "method", "effort", "fill", "tree", "max-hulls", "max-vertices", "links", "source", "scale", "format", "uri", "jobs"})
    EXPECT_TRUE(document["options"].contains(field)) << field;
}

TEST(ReportJson, ValuesAreReadBack) {
  const json document = json::parse(toJson(sample()));
  const json& row = document["links"][0];
  EXPECT_EQ(row["link"], "upper");
  EXPECT_EQ(row["element"], 2);
  EXPECT_EQ(row["source"], "visual");
  EXPECT_EQ(row["scale"], json({1.0, -1.0, 0.001}));
  EXPECT_EQ(row["tolerance"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(row["protrusion"].get<double>(), 1.0 / 3);
  EXPECT_EQ(document["links"][1]["status"], "degraded");
  EXPECT_EQ(document["links"][2]["status"], "failed");
  EXPECT_EQ(document["links"][2]["error"], "FileNotFound");
  EXPECT_EQ(document["options"]["tolerance"], "1cm,5%");
  EXPECT_EQ(document["options"]["format"], "stl");
  const json totals = {{"links", 2},          {"meshes", 3},    {"triangles", 24}, {"hulls", 6},
                       {"hull_vertices", 48}, {"seconds", 1.5}, {"failed", 1},     {"degraded", 1}};
  EXPECT_EQ(document["totals"], totals);
  EXPECT_EQ(document["notes"], json({"a note"}));
}

TEST(ReportJson, NoRows) {
  const json document = json::parse(toJson(Report{}));
  EXPECT_EQ(document["links"], json::array());
  EXPECT_EQ(document["totals"]["meshes"], 0);
}

TEST(ReportJson, IsStrictJsonForAnyValue) {
  Report report = sample();
  report.links[0].protrusion = std::numeric_limits<double>::quiet_NaN();
  report.links[0].volume = std::numeric_limits<double>::infinity();
  report.links[0].link = "caf\xe9";  // Latin-1
  report.options.validate = false;
  const json document = json::parse(toJson(report));
  EXPECT_TRUE(document["links"][0]["protrusion"].is_null());
  EXPECT_TRUE(document["links"][0]["volume"].is_null());
  EXPECT_EQ(document["links"][0]["link"], "caf\xef\xbf\xbd");
  EXPECT_TRUE(document["validation"].is_null());
}

TEST(ReportTable, HasARowForEveryMesh) {
  std::istringstream table(toTable(sample()));
  std::vector<std::string> lines;
  for (std::string line; std::getline(table, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 9u);
  EXPECT_EQ(lines[0].rfind("link   mesh       triangles", 0), 0u) << lines[0];
  EXPECT_EQ(lines[1].rfind("upper  upper.stl         12      3        24", 0), 0u) << lines[1];
  EXPECT_NE(lines[1].find("333.3"), std::string::npos) << "protrusion in mm";
  EXPECT_EQ(lines[1].find("status"), std::string::npos);
  EXPECT_EQ(lines[0].find("status"), lines[1].find("ok"));
  EXPECT_NE(lines[3].find("failed"), std::string::npos);
  EXPECT_EQ(lines[4], "degraded: upper, upper.stl: too far");
  EXPECT_EQ(lines[5], "3 meshes of 2 links, 24 triangles -> 6 hulls with 48 vertices; 1 degraded, 1 failed; 1.5 s");
  EXPECT_EQ(lines[6].rfind("validation: 400 queries, 0 missed, 0 phantom", 0), 0u);
  EXPECT_EQ(lines[7], "  a remark");
  EXPECT_EQ(lines[8], "note: a note");
}

TEST(Report, AnyFailed) {
  Report report = sample();
  EXPECT_TRUE(anyFailed(report));
  report.links.pop_back();
  EXPECT_FALSE(anyFailed(report));
}

}  // namespace
}  // namespace collision_hulls
