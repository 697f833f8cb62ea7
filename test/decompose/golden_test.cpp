// A change of the hulls is a decision: this test compares what every method makes of a dozen small shapes and of the demo robot's meshes
// with test/data/golden.txt, and says in numbers what changed. To accept a change, run it with COLLISION_HULLS_ACCEPT=1, which writes the
// file anew; commit the file, and say why the hulls changed.
//
// Numbers of hulls and vertices must be equal on every machine; volumes and protrusions, but for rounding. The hash of the coordinates must
// be equal where compiler and libraries are those that made the file, which names them: others may round the last bit differently, as
// Debian 11's do in one row of a hundred.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/round_outward.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "geometry/bytes.h"
#include "shapes.h"
#include "solids.h"

namespace collision_hulls {
namespace {

constexpr double kToleranceShare = 0.03;  // of the diagonal
constexpr double kGapShare = 0.01;        // of the tolerance
constexpr double kRounding = 1e-6;        // of a value
constexpr double kLeast = 1e-9;           // what is smaller is rounding alone

/// One method's hulls of one mesh, as written.
struct GoldenRow {
  std::string subject;  ///< "torus certified"
  std::size_t hulls = 0, vertices = 0;
  double volume = 0;      ///< [m^3] sum over the hulls
  double protrusion = 0;  ///< [m] the certified bound
  std::string hash;       ///< of the hulls' coordinates and triangles, bit by bit
};

/// Rows by subject, and the compiler and libraries that made their hashes.
struct Golden {
  std::string machine;
  std::map<std::string, GoldenRow> rows;
};

std::string hashOf(const std::vector<ConvexHull>& hulls) {
  std::string bytes;
  for (const ConvexHull& hull : hulls) bytes += toBytes(hull.vertices, hull.triangles);
  std::ostringstream text;
  text << std::hex << std::setfill('0') << std::setw(16) << checksum(bytes);
  return text.str();
}

/// ", 12 hulls (was 10, +20 %)"
std::string change(const std::string& what, double was, double is) {
  if (std::abs(is - was) <= std::max(kLeast, kRounding * std::max(was, is))) return "";
  std::ostringstream text;
  text << ", " << is << " " << what << " (was " << was;
  if (was > 0) text << ", " << std::showpos << std::setprecision(3) << 100 * (is - was) / was << " %";
  return text.str() + ")";
}

double real(std::size_t count) {
  return static_cast<double>(count);
}

struct Subject {
  std::string name;
  TriangleMesh mesh;
  double resolution = 0;
};

std::vector<Subject> subjects() {
  using namespace test_shapes;
  std::vector<Subject> all{{"box", box(1, 2, 3)},           {"l_bracket", lBracket()}, {"u_channel", uChannel()},
                           {"open_box", openBox()},         {"torus", torus()},        {"sphere", sphere()},
                           {"four_spheres", fourSpheres()}, {"flange", flange()},      {"sheet", sheet()},
                           {"triangle", singleTriangle()},  {"flask", flask()},        {"box_with_window", boxWithWindow()}};
  for (const char* file : {"base.dae", "elbow_bracket.obj", "finger.stl", "flange.stl", "forearm.stl", "gripper.dae", "motor_housing.stl",
                           "shoulder_fork.obj", "upper_arm_collision.stl"}) {
    const LoadedMesh loaded = readMesh(std::string(DEMO_ROBOT "/meshes/") + file);
    all.push_back({file, loaded.mesh, loaded.resolution});
  }
  return all;
}

/// The compiler and the library on which the last bits of hulls depend.
std::string thisMachine() {
  std::ostringstream text;
  text << "compiler " << __VERSION__ << ", Eigen " << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION;
#ifdef __FMA__
  text << ", FMA";
#endif
  return text.str();
}

/// A method's row, made as the pipeline makes hulls, but with one attempt. `resolution` [m]: see LoadedMesh.
GoldenRow goldenRow(const std::string& name, const TriangleMesh& mesh, double resolution, Method method) {
  const RepairedMesh repaired = repair(mesh);
  DecomposeOptions options;
  options.method = method;
  options.tolerance = kToleranceShare * diagonal(mesh);
  const std::vector<ConvexHull> made = decompose(repaired, options).hulls;
  const std::vector<ConvexHull> hulls = roundOutward(made, mesh, repaired.counts.weld_distance + resolution, options.max_vertices).hulls;
  GoldenRow row;
  row.subject = name + " " + collision_hulls::name(method);
  row.hulls = hulls.size();
  for (const ConvexHull& hull : hulls) {
    row.vertices += hull.vertices.size();
    row.volume += volume(hull);
  }
  row.protrusion = protrusion(hulls, Solid(repaired), kGapShare * options.tolerance).bound;
  row.hash = hashOf(hulls);
  return row;
}

std::vector<GoldenRow> rowsNow() {
  const std::vector<Subject> all = subjects();
  const std::vector<Method>& methods = allMethods();
  std::vector<GoldenRow> rows(all.size() * methods.size());
  forEach(rows.size(), [&](std::size_t i) {
    const Subject& subject = all[i / methods.size()];
    rows[i] = goldenRow(subject.name, subject.mesh, subject.resolution, methods[i % methods.size()]);
  });
  return rows;
}

/// What changed, in numbers; empty if nothing did. Hashes count on the machine that made them.
std::string changes(const GoldenRow& was, const GoldenRow& is, bool same_machine) {
  std::string text = change("hulls", real(was.hulls), real(is.hulls)) + change("vertices", real(was.vertices), real(is.vertices)) +
                     change("m protrusion", was.protrusion, is.protrusion) + change("m^3 volume", was.volume, is.volume);
  if (text.empty() && same_machine && was.hash != is.hash) text = ", coordinates or order, and nothing else";
  return text.empty() ? "" : is.subject + ": " + text.substr(2);
}

Golden readGolden(const std::string& file) {
  Golden golden;
  std::ifstream stream(file);
  std::string line, method;
  std::getline(stream, line);
  golden.machine = line.substr(std::min(line.size(), line.find("compiler")));
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    GoldenRow row;
    words >> row.subject >> method >> row.hulls >> row.vertices >> row.volume >> row.protrusion >> row.hash;
    row.subject += " " + method;
    golden.rows[row.subject] = row;
  }
  return golden;
}

void writeGolden(const std::string& file, const std::vector<GoldenRow>& rows) {
  std::ofstream stream(file);
  stream << "# mesh, method, hulls, vertices, volume [m^3], protrusion [m], hash by " << thisMachine() << '\n' << std::setprecision(10);
  for (const GoldenRow& row : rows)
    stream << row.subject << ' ' << row.hulls << ' ' << row.vertices << ' ' << row.volume << ' ' << row.protrusion << ' ' << row.hash
           << '\n';
}

TEST(Golden, HullsAreThoseCommitted) {
  const std::string file = TEST_DATA "/golden.txt";
  const std::vector<GoldenRow> rows = rowsNow();
  const char* const accept = std::getenv("COLLISION_HULLS_ACCEPT");
  if (accept && *accept) writeGolden(file, rows);
  const Golden golden = readGolden(file);
  std::string differences;
  for (const GoldenRow& row : rows) {
    const auto was = golden.rows.find(row.subject);
    const std::string text =
        was == golden.rows.end() ? row.subject + ": is new" : changes(was->second, row, golden.machine == thisMachine());
    if (!text.empty()) differences += text + "\n";
  }
  EXPECT_EQ(differences, "") << "If this is meant, run the test with COLLISION_HULLS_ACCEPT=1 and commit " << file;
  EXPECT_EQ(golden.rows.size(), rows.size()) << file << " has rows that no mesh and method has; accept the change to drop them";
}

TEST(Golden, ChangesAreToldInNumbers) {
  const GoldenRow was{"torus certified", 10, 200, 0.5, 0.02, "a"};
  EXPECT_EQ(changes(was, was, true), "");
  GoldenRow is = was;
  is.volume *= 1 + 0.5 * kRounding;
  is.hash = "b";
  EXPECT_EQ(changes(was, is, false), "");
  EXPECT_EQ(changes(was, is, true), "torus certified: coordinates or order, and nothing else");
  is.hulls = 12;
  is.protrusion = 0.019;
  EXPECT_EQ(changes(was, is, false), "torus certified: 12 hulls (was 10, +20 %), 0.019 m protrusion (was 0.02, -5 %)");
  is = was;
  is.vertices = 201;
  is.volume *= 1.1;
  EXPECT_EQ(changes(was, is, false), "torus certified: 201 vertices (was 200, +0.5 %), 0.55 m^3 volume (was 0.5, +10 %)");
}

TEST(Golden, AnyBitOfAHullChangesItsHash) {
  const TriangleMesh bent = test_shapes::lBracket();
  TriangleMesh moved = bent;
  moved.vertices.front().x() += 1e-4;
  const GoldenRow one = goldenRow("l", bent, 0, Method::kSingleHull);
  EXPECT_EQ(one.hash, goldenRow("l", bent, 0, Method::kSingleHull).hash);
  EXPECT_NE(one.hash, goldenRow("l", moved, 0, Method::kSingleHull).hash);
}

}  // namespace
}  // namespace collision_hulls
