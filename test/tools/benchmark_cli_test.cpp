// The program benchmark: a row whatever happens, and the same rows in every run.
// Also tests src/bench/benchmark.cpp, src/bench/contender.cpp, src/bench/job_runner.cpp, src/bench/machine.cpp,
// src/bench/queries/query_benchmark.cpp and src/tools/benchmark.cpp.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <map>
#include <nlohmann/json.hpp>

#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::TempFolder;
using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

class BenchmarkProgram : public ::testing::Test {
 protected:
  BenchmarkProgram() { fixtures::write(folder_ / "bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1))); }

  int run(const std::string& arguments) {
    const std::string command = "cd '" + folder_.path().string() + "' && '" PROGRAMS "/benchmark' --no-charts " + arguments + " > '" +
                                (folder_ / ".log") + "' 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string log() { return fixtures::read(folder_ / ".log"); }

  std::vector<Row> rows(const std::string& file) {
    std::istringstream in(fixtures::read(folder_ / file));
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = split(line);
    std::vector<Row> result;
    while (std::getline(in, line)) {
      const std::vector<std::string> fields = split(line);
      Row row;
      for (std::size_t i = 0; i < names.size() && i < fields.size(); ++i) row[names[i]] = fields[i];
      result.push_back(row);
    }
    return result;
  }

  TempFolder folder_;
};

TEST_F(BenchmarkProgram, WrongUse) {
  const std::vector<std::pair<std::string, std::string>> cases{{"bracket.obj", "--output"},
                                                               {"missing.obj -o out", "missing.obj"},
                                                               {"bracket.obj -o out -m fast", "'fast'"},
                                                               {"bracket.obj -o out -t 1furlong", "'1furlong'"},
                                                               {"bracket.obj -o out --effort least", "'least'"},
                                                               {"bracket.obj -o out --repeat 0", "--repeat"},
                                                               {"bracket.obj -o out --max-vertices 5", "max_vertices is 5"},
                                                               {"bracket.obj -o out --peer nobody", "peer_nobody"}};
  for (const auto& [arguments, part] : cases) {
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_NE(log().find(part), std::string::npos) << arguments << "\n" << log();
    EXPECT_FALSE(fs::exists(folder_ / "out")) << arguments;
  }
}

TEST_F(BenchmarkProgram, WritesARowForEachMeshMethodAndTolerance) {
  ASSERT_EQ(run("bracket.obj -o out -m hacd,single_hull -t 5%,2mm"), 0) << log();
  const std::vector<Row> all = rows("out/benchmark.csv");
  ASSERT_EQ(all.size(), 4u);
  for (const Row& row : all) {
    EXPECT_EQ(row.at("mesh"), "bracket.obj");
    EXPECT_EQ(row.at("triangles"), "20");
    EXPECT_EQ(row.at("status"), "ok");
    EXPECT_EQ(row.at("uncovered"), "0");
    EXPECT_EQ(row.at("hash").size(), 64u);
    EXPECT_GT(std::stod(row.at("cpu_seconds")), 0);
    EXPECT_GT(std::stod(row.at("peak_mb")), 0);
  }
  EXPECT_EQ(all[0].at("method"), "hacd");
  EXPECT_EQ(all[0].at("hulls"), "2");
  EXPECT_NEAR(std::stod(all[0].at("tolerance")), 0.05 * std::hypot(0.2, 0.2, 0.1), 1e-6);
  EXPECT_EQ(all[1].at("tolerance"), "0.002");
  EXPECT_NEAR(std::stod(all[3].at("protrusion")), (0.2 - 0.03) / 2, 1e-3);
  EXPECT_TRUE(nlohmann::json::parse(fixtures::read(folder_ / "out/machine.json")).contains("cpu"));
  EXPECT_FALSE(fs::exists(folder_ / "out/.benchmark"));
}

TEST_F(BenchmarkProgram, GoesOnWhenNobodyReadsItsProgress) {
  run("bracket.obj -o out -m hacd,single_hull -t 5%,2mm 2>&1 | head -1");
  EXPECT_EQ(rows("out/benchmark.csv").size(), 4u) << log();
}

TEST_F(BenchmarkProgram, HullsKeepTheCapOnVertices) {
  fixtures::write(folder_ / "ball.obj", fixtures::obj(test_shapes::sphere(0.1, 6)));
  for (const int most : {0, 8, 20}) {
    ASSERT_EQ(run("ball.obj -o out -m certified,single_hull -t 100% --max-vertices " + std::to_string(most)), 0) << log();
    const auto all = rows("out/benchmark.csv");
    EXPECT_EQ(all.size(), 2u);
    for (const Row& row : all) {
      EXPECT_EQ(row.at("hulls"), "1");
      const int vertices = std::stoi(row.at("hull_vertices"));
      EXPECT_LE(vertices, most == 0 ? 1000 : most);
      EXPECT_GT(vertices, most == 0 ? 64 : 3);
    }
  }
}

TEST_F(BenchmarkProgram, HangsCrashesAndFailuresAreRows) {
  fixtures::write(folder_ / "rubbish.stl", "no mesh");
  ASSERT_EQ(run("bracket.obj rubbish.stl -o out -m single_hull -t 1% --time-limit 1 --peer hangs='sleep 100' --peer dies='kill -9 $$' "
                "--peer child_dies='sh -c \"kill -11 \\$\\$\"; exit $?' --peer fails='echo no licence; exit 3' --peer nothing=true "
                "--peer 'rubbish=echo v 1 2 >{out}' --peer 'copies=cp {in} {out}'"),
            0)
      << log();
  std::map<std::string, Row> by_method;
  for (const Row& row : rows("out/benchmark.csv")) {
    if (row.at("mesh") == "bracket.obj") by_method[row.at("method")] = row;
    if (row.at("mesh") == "rubbish.stl") {
      EXPECT_EQ(row.at("status"), "error");
      EXPECT_EQ(row.at("hulls"), "");
      EXPECT_NE(row.at("message").find("rubbish.stl"), std::string::npos);
    }
  }
  const auto expect = [&](const std::string& method, const std::string& status, const std::string& message) {
    EXPECT_EQ(by_method[method]["status"], status) << method;
    EXPECT_NE(by_method[method]["message"].find(message), std::string::npos) << method << ": " << by_method[method]["message"];
  };
  expect("single_hull", "ok", "");
  expect("hangs", "timeout", "1 s");
  expect("dies", "crash", "Killed");
  expect("child_dies", "crash", "Segmentation fault");
  expect("fails", "error", "no licence");
  expect("nothing", "error", "no hulls were written");
  expect("rubbish", "error", "'hulls_0.obj', line 1");
  expect("copies", "ok", "");
  EXPECT_NEAR(std::stod(by_method["copies"]["protrusion"]), std::stod(by_method["single_hull"]["protrusion"]), 1e-6) << "scored alike";
}

TEST_F(BenchmarkProgram, TwoRunsDifferOnlyInTimes) {
  for (const char* out : {"a", "b"}) ASSERT_EQ(run("bracket.obj -t 5%,1% --repeat 2 -o " + std::string(out)), 0) << log();
  std::vector<Row> a = rows("a/benchmark.csv"), b = rows("b/benchmark.csv");
  for (auto* all : {&a, &b}) {
    for (Row& row : *all)
      for (const char* measured : {"cpu_seconds", "wall_seconds", "peak_mb"}) row[measured].clear();
  }
  EXPECT_GE(a.size(), 8u);
  EXPECT_EQ(a, b);
}

TEST_F(BenchmarkProgram, QueriesTheMeshAndEachModel) {
  ASSERT_EQ(run("bracket.obj -m hacd -t 5%,2% --queries -o out --peer fails=false"), 0) << log();
  const std::vector<Row> all = rows("out/queries.csv");
  ASSERT_EQ(all.size(), 6u) << log();
  EXPECT_EQ(all[0].at("method"), "original");
  EXPECT_EQ(all[1].at("method") + all[1].at("requested"), "hacd5%");
  EXPECT_EQ(all[2].at("method") + all[2].at("requested"), "hacd2%");
  EXPECT_EQ(all[3].at("method") + all[3].at("requested"), "single_hull") << "always queried, once";
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(all[i].at("status"), "ok") << all[i].at("message");
    EXPECT_GT(std::stod(all[i].at("collisions_per_second")), 0);
    EXPECT_GT(std::stod(all[i].at("tree_collisions_per_second")), 0);
    EXPECT_EQ(all[i].at("missed"), i ? "0" : "");
  }
  EXPECT_EQ(all[4].at("status"), "error");
  EXPECT_EQ(all[4].at("message"), "no hulls of 1 meshes");
  EXPECT_FALSE(fs::exists(folder_ / "out/.hulls"));
  EXPECT_FALSE(fs::exists(folder_ / "out/.benchmark"));
}

TEST_F(BenchmarkProgram, ReportsAProgramWhoseResultVaries) {
  ASSERT_EQ(run("bracket.obj -m single_hull -t 1% --repeat 3 -o out --peer 'varies=echo o >>count; "
                "(cat {in}; echo v 0 0 $(wc -l <count); echo f 1 2 -1) >{out}'"),
            0);
  EXPECT_NE(rows("out/benchmark.csv")[1]["message"].find("3 different results in 3 runs"), std::string::npos);
}

}  // namespace
}  // namespace collision_hulls
