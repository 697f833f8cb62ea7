// Also tests src/report/report_json.cpp and src/report/report_table.cpp.
#include "collision_hulls/report/report.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/failure_cause.h"

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
  row.least_hulls = 2;
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
    for (const char* field : {"link",          "element",       "source",      "uri",        "sha256",           "scale",
                              "triangles",     "status",        "reason",      "repair",     "method",           "tolerance",
                              "hulls",         "hull_vertices", "uncovered",   "protrusion", "protrusion_found", "interior",
                              "primitives",    "volume",        "hull_volume", "diagonal",   "seconds",          "files",
                              "covered_share", "least_hulls",   "untried"}) {
      EXPECT_TRUE(row.contains(field)) << field;
    }
    for (const char* field : {"welded", "degenerate", "duplicate", "flipped", "components", "open_edges", "nonmanifold_edges"})
      EXPECT_TRUE(row["repair"].contains(field)) << field;
    for (const char* field : {"read", "repair", "decompose", "certify", "write"}) EXPECT_TRUE(row["seconds"].contains(field)) << field;
  }
  for (const char* field : {"queries", "missed", "phantom", "max_underestimate", "exceptions", "timeouts", "nan", "disagreements",
                            "mesh_query_us", "hull_query_us"})
    EXPECT_TRUE(document["validation"].contains(field)) << field;
  for (const char* field : {"tolerance", "method", "effort", "fill", "tree", "segments", "max-hulls", "max-vertices", "links", "source",
                            "scale", "format", "uri", "rebase", "jobs", "time-limit"})
    EXPECT_TRUE(document["options"].contains(field)) << field;
}

TEST(ReportJson, ValuesAreReadBack) {
  const json document = json::parse(toJson(sample()));
  const json& row = document["links"][0];
  EXPECT_EQ(row["link"], "upper");
  EXPECT_EQ(row["element"], 2);
  EXPECT_EQ(row["source"], "visual");
  EXPECT_EQ(row["hulls"], 3);
  EXPECT_EQ(row["least_hulls"], 2);
  EXPECT_EQ(document["links"][2]["least_hulls"], 0);
  EXPECT_EQ(row["scale"], json({1.0, -1.0, 0.001}));
  EXPECT_EQ(row["tolerance"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(row["protrusion"].get<double>(), 1.0 / 3);
  EXPECT_EQ(document["links"][1]["status"], "degraded");
  EXPECT_EQ(document["links"][2]["status"], "failed");
  EXPECT_EQ(document["links"][2]["error"], "FileNotFound");
  EXPECT_EQ(document["options"]["tolerance"], "1cm,5%");
  EXPECT_EQ(document["options"]["format"], "stl");
  const json totals = {{"links", 2},          {"meshes", 3},    {"triangles", 24}, {"hulls", 6},    {"primitives", 0}, {"least_hulls", 4},
                       {"hull_vertices", 48}, {"seconds", 1.5}, {"failed", 1},     {"degraded", 1}, {"kept", 0},       {"removed", 0}};
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

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> result;
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

TEST(ReportTable, ANameOfAFileCannotForgeALine) {
  Report report = sample();
  for (ElementReport& row : report.links) row.uri = "new\nline.stl";
  std::string text = toTable(report);
  EXPECT_NE(text.find("new?line.stl"), std::string::npos) << text;
  for (const std::string& line : failures(report)) text += line;
  EXPECT_EQ(text.find("new\n"), std::string::npos) << text;
}

TEST(ReportTable, ARowForEveryMeshAndTheirTotal) {
  Report report = sample();
  report.validation.missed = 1;
  report.validation.max_underestimate = 0.0123456;
  report.validation.hull_query_us = 2.345;
  report.validation.mesh_query_us = 123.456;
  const std::vector<std::string> table = lines(toTable(report));
  ASSERT_EQ(table.size(), 13u);
  EXPECT_EQ(table[0],
            "link   mesh                 triangles  hulls  at least  vertices  protrusion [mm]  tolerance [mm]  time [s]  status");
  EXPECT_EQ(table[1], "upper  upper.stl                   12      3         2        24              333             300         0  ok");
  EXPECT_EQ(table[2],
            "upper  upper.stl                   12      3         -        24              333             300         0  degraded");
  EXPECT_EQ(table[3],
            "lower                               -      -         -         -                -               -         0  failed");
  EXPECT_EQ(table[4],
            "total  3 meshes of 2 links         24      6         2        48              333                      1.50  1 ok, 1 "
            "degraded, 1 failed");
  EXPECT_EQ(table[5].rfind("The hulls cover the whole surface of each mesh that has not failed, and no point", 0), 0u) << table[5];
  EXPECT_EQ(table[6], "\"at least\": proved, no cover within the tolerance has fewer hulls; 1 where no more is known.");
  EXPECT_EQ(table[8], "degraded: upper, upper.stl: too far");
  EXPECT_EQ(table[9],
            "check: 400 queries compared hulls and meshes: 1 collision missed, no false collision beyond the protrusion; "
            "distances at most 12.3 mm too short");
  EXPECT_EQ(table[10], "  a remark");
  EXPECT_EQ(table[11],
            "speed: a distance query between a test body and a mesh takes 2.35 us with the mesh's hulls, 123 us with the mesh itself");
  EXPECT_EQ(table[12], "note: a note");
}

TEST(Report, WhatTheProofRulesOutIsAFailure) {
  Report report = sample();
  report.links.pop_back();
  ASSERT_FALSE(anyFailed(report));
  ASSERT_TRUE(failures(report).empty());
  for (std::size_t Validation::*count : {&Validation::missed, &Validation::phantom}) {
    Report refuted = report;
    refuted.validation.*count = 1;
    EXPECT_TRUE(isRefuted(refuted) && anyFailed(refuted));
    ASSERT_EQ(failures(refuted).size(), 1u);
    EXPECT_EQ(failures(refuted)[0].rfind("the check contradicts the proof: ", 0), 0u);
    refuted.options.validate = false;
    EXPECT_FALSE(isRefuted(refuted)) << "what was not checked is not refuted";
  }
  Report other = report;
  other.models.emplace_back().validation.missed = 1;
  EXPECT_TRUE(isRefuted(other));
  Report in_scene = report;
  in_scene.scene = FitReport{};
  EXPECT_FALSE(isRefuted(in_scene));
  in_scene.scene->missed = 1;
  EXPECT_TRUE(isRefuted(in_scene));
}

TEST(ReportTable, AModelForASceneHasItsOwnCheckAndPrimitives) {
  Report report = sample();
  report.scene = FitReport{};
  report.scene->self = {{"upper", "lower", true, 7, 5, 2}};
  report.links[0].primitives = 1;
  report.links[1].primitives = 2;
  report.links[1].hulls = report.links[1].hull_vertices = 0;
  const std::string table = toTable(report);
  for (const char* part : {"  3 hulls and 1 primitive        24  ", "  2 primitives         -  ", "check of single meshes: 400 queries",
                           "The tolerance is that of the finest hulls", "speed of single meshes: ",
                           "self-collisions in 0 configurations; false ones count at any distance, also within the clearance:\n",
                           "collisions  false with single hulls  false with fitted hulls",
                           "no collision missed, no false collision beyond the clearance (at 95 %", "speed in the scene: "})
    EXPECT_NE(table.find(part), std::string::npos) << part << "\n" << table;
  EXPECT_EQ(table.find("at least"), std::string::npos) << "a fit seeks no bound on the number of hulls\n" << table;
}

TEST(ReportTable, AKeptLinksStatusStandsInItsColumn) {
  Report report = sample();
  report.links[0].status = Status::kKept;
  const std::vector<std::string> table = lines(toTable(report));
  EXPECT_EQ(table[1].rfind("kept"), table[0].rfind("status")) << toTable(report);
}

TEST(ReportTable, SaysWhatTheModelConsistsOf) {
  Report report = sample();
  for (ElementReport& row : report.links)
    row.primitives = row.hulls, row.hulls = 0, row.least_hulls = std::min<std::size_t>(row.least_hulls, 1);
  const std::string spheres = toTable(report);
  for (const char* part :
       {"  primitives  at least  ", "\nThe primitives cover", " compared primitives and meshes", " us with the mesh's primitives, "})
    EXPECT_NE(spheres.find(part), std::string::npos) << part << "\n" << spheres;
  EXPECT_EQ(spheres.find("proved, no cover"), std::string::npos) << "none was sought\n" << spheres;
  report.links[0].hulls = 1;
  EXPECT_NE(toTable(report).find("\nThe bodies cover"), std::string::npos) << toTable(report);
}

TEST(ReportTable, NoFigureForWhatWasNotFound) {
  Report report = sample();
  report.links.erase(report.links.begin());
  std::string table = toTable(report);
  EXPECT_NE(table.find("\ntotal  2 meshes of 2 links         12      3         -        24              333 "), std::string::npos) << table;
  EXPECT_EQ(table.find("proved, no cover"), std::string::npos) << table;
  report.links.erase(report.links.begin());
  table = toTable(report);
  EXPECT_NE(table.find("\ntotal  1 mesh of 1 link          0      0         -         0                -  "), std::string::npos) << table;
}

TEST(ReportTable, NoCheckWhereThereIsNothingToCheck) {
  Report report = sample();
  report.options.validate = false;
  EXPECT_NE(toTable(report).find("check: skipped (--no-validate)"), std::string::npos);
  report.links = {report.links.back()};
  for (const bool validate : {false, true}) {
    report.options.validate = validate;
    EXPECT_EQ(toTable(report).find("check"), std::string::npos) << toTable(report);
  }
}

TEST(ReportTable, FaultsOfFclAndTheCache) {
  Report report = sample();
  for (ElementReport& row : report.links) row.cached = true;
  report.links.push_back(report.links[1]);
  report.validation.exceptions = 2;
  const std::string table = toTable(report);
  for (const char* part : {"4 meshes came from the cache.", "(1 more mesh: see report.json)", "FCL failed in 2 queries"})
    EXPECT_NE(table.find(part), std::string::npos) << table;
  EXPECT_EQ(toTable(Report{}), "");
}

// Zeros would pass for measurements.
TEST(ReportJson, WhatWasNotMeasuredIsNull) {
  Report report = sample();
  for (ElementReport& row : report.links) row.diagonal = row.tolerance = row.status == Status::kFailed ? 0 : 1;
  report.links.push_back(report.links.back());
  report.links.back().status = Status::kKept;
  const json rows = json::parse(toJson(report))["links"];
  const char* const measured[] = {"uncovered", "protrusion", "protrusion_found", "worst",    "volume", "hull_volume", "covered_share",
                                  "diagonal",  "nudge",      "thickness",        "tolerance"};
  for (const json& row : rows) {
    const bool has_hulls = row["status"] == "ok" || row["status"] == "degraded";
    for (const char* field : measured) EXPECT_EQ(row.at(field).is_null(), !has_hulls) << field << row["status"];
  }
}

TEST(Report, OneLineForAMissingPackage) {
  Report report = sample();
  ElementReport row;
  row.status = Status::kFailed;
  row.error = "PackageNotFound";
  row.reason = "package 'foo' of ...";
  for (const char* link : {"a", "b", "b"}) {
    row.link = link;
    row.uri = std::string("package://foo/") + link;
    report.links.push_back(row);
  }
  const std::vector<std::string> all = failures(report);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0],
            "package 'foo' was not found (3 meshes of 2 links): install it and source its workspace, or say where it is with "
            "--package-path foo=DIR");
  EXPECT_EQ(all[1], "link lower: no file");
}

TEST(Report, AFailureNamesLinkAndMeshOnce) {
  Report report = sample();
  ElementReport& row = report.links.back();
  row.uri = "package://arm/meshes/finger.stl";
  EXPECT_EQ(failures(report).back(), "link lower: package://arm/meshes/finger.stl: no file");
  row.reason = "'" + row.uri + "' has no triangles";
  EXPECT_EQ(failures(report).back(), "link lower: 'package://arm/meshes/finger.stl' has no triangles");
  report.input_path = row.uri = "finger.stl";  // a single mesh has no link
  row.reason = "'finger.stl' has no triangles";
  EXPECT_EQ(failures(report).back(), "'finger.stl' has no triangles");
}

TEST(Report, OneLineForTheSameFault) {
  Report report = sample();
  report.links.clear();
  ElementReport row;
  row.status = Status::kFailed;
  row.error = "FileNotFound";
  const auto add = [&](const std::string& link, const std::string& uri, const std::string& reason) {
    row.link = link;
    row.uri = uri;
    row.reason = "'" + uri + "' " + reason;
    report.links.push_back(row);
  };
  for (const char* file : {"a.stl", "b.stl", "c.stl"})
    add(file == std::string("c.stl") ? "tip" : "base", std::string("meshes/") + file, "is missing");
  EXPECT_EQ(failures(report).size(), 3u) << "few are named";
  add("tip", "meshes/d.stl", "is missing");
  add("tip", "meshes/e.stl", "is empty");
  add("tip", "other/f.stl", "is missing");
  EXPECT_EQ(failures(report), (std::vector<std::string>{"link base: 'meshes/a.stl' is missing (the same for 3 more, of 2 links in all)",
                                                        "link tip: 'meshes/e.stl' is empty", "link tip: 'other/f.stl' is missing"}));
}

/// The lines for failures of as many links.
std::vector<std::string> failuresOf(int links, const std::function<void(int, ElementReport&)>& fault) {
  Report report = sample();
  report.links.clear();
  for (int i = 0; i < links; ++i) {
    ElementReport row;
    row.status = Status::kFailed;
    row.link = "l" + std::to_string(i);
    fault(i, row);
    report.links.push_back(row);
  }
  return failures(report);
}

TEST(Report, OneLineForAFormatInSeveralFolders) {
  EXPECT_EQ(failuresOf(5,
                       [](int i, ElementReport& row) {
                         row.error = "UnsupportedFormat";
                         row.uri = "package://arm/meshes/" + row.link + "/part" + std::to_string(i) + ".3dxml";
                         row.reason =
                             "/opt/arm/meshes/" + row.link + "/part" + std::to_string(i) + ".3dxml: extension '.3dxml' is not supported";
                       }),
            (std::vector<std::string>{"link l0: /opt/arm/meshes/l0/part0.3dxml: extension '.3dxml' is not supported (the same for 4 more, "
                                      "of 5 links in all)"}));
}

TEST(Report, OneLineForCopiesOfAMesh) {
  const std::vector<std::string> lines = failuresOf(5, [](int i, ElementReport& row) {
    const std::string first = "m/part0.stl", reason = "/opt/arm/m/part0.stl: the file is cut off";
    row.error = "NotAMesh";
    row.uri = "m/part" + std::to_string(i) + ".stl";
    row.reason = i == 0 ? reason : reasonOfCopy(row.uri, first, reason);
  });
  EXPECT_EQ(lines, std::vector<std::string>{"link l0: /opt/arm/m/part0.stl: the file is cut off (the same for 4 more, of 5 links in all)"});
}

TEST(Report, OneLineForAnElementThatUrdfdomDoesNotKnow) {
  const auto fault = [](int i, ElementReport& row) {
    const std::string kind = i == 6 ? "cone" : "capsule";
    row.error = "BadGeometry";
    row.uri = "<" + kind + ">";
    row.reason = "'arm.urdf', line " + std::to_string(95 + 3 * i) + ": urdfdom cannot read this <collision> of link '" + row.link +
                 "' (Unknown geometry type '" + kind + "'; Could not parse collision element for Link [" + row.link + "]); correct it";
  };
  const std::vector<std::string> lines = failuresOf(7, fault);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].find("link l0: <capsule>: 'arm.urdf', line 95: "), 0u) << lines[0];
  EXPECT_NE(lines[0].find("correct it (the same for 5 more, of 6 links in all)"), std::string::npos) << lines[0];
  EXPECT_EQ(lines[1].find("link l6: <cone>: 'arm.urdf', line 113: "), 0u) << lines[1];
}

TEST(Report, AllFailedUnlessAsManyLinksHavePrimitivesAlone) {
  Report report = sample();
  EXPECT_FALSE(allFailed(report));
  report.links.erase(report.links.begin(), report.links.end() - 1);
  EXPECT_TRUE(allFailed(report));
  report.primitive_links = 1;
  EXPECT_FALSE(allFailed(report));
  report.links.push_back(report.links.front());
  EXPECT_FALSE(allFailed(report)) << "it is the same link";
  report.links.back().link = "another";
  EXPECT_TRUE(allFailed(report));
  EXPECT_FALSE(allFailed(Report()));
}

TEST(Report, AnyFailed) {
  Report report = sample();
  EXPECT_TRUE(anyFailed(report));
  report.links.pop_back();
  EXPECT_FALSE(anyFailed(report));
}

}  // namespace
}  // namespace collision_hulls
