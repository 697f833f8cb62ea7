// What child processes do. Scoring is independent of the method that made the hulls: it reads them back from the file, like those of any
// other program.
#include "bench/jobs.h"

#include <ctime>
#include <fstream>

#include "base/decimal.h"
#include "bench/cuts.h"
#include "bench/hull_objects.h"
#include "bench/json_file.h"
#include "bench/original.h"
#include "bench/queries/query_job.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/decompose/least_hulls.h"
#include "collision_hulls/decompose/round_outward.h"
#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "storage/files.h"

namespace collision_hulls {

using nlohmann::json;

std::string toObj(const TriangleMesh& mesh) {
  std::ostringstream text = decimalStream(17);
  for (const Eigen::Vector3d& v : mesh.vertices) text << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const Triangle& t : mesh.triangles) text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  return text.str();
}

namespace {

constexpr double kRoughGap = 0.1;  // share of the tolerance, for a first, rough bound; see kCertificateGap

json prepare(const json& job) {
  const Original original = readOriginal(job);
  writeText(job["cleaned"].get<std::string>(), toObj(original.repaired.mesh));
  return {{"triangles", original.mesh.triangles.size()}, {"diagonal", diagonal(original.mesh)}};
}

/// The hulls that `decompose` would write. The certificate is part of the method `certified`, which tries again if it fails; for other
/// methods it is left to score().
std::vector<ConvexHull> hullsOf(const Original& original, const DecomposeOptions& options) {
  if (options.method != Method::kCertified)
    return roundOutward(decompose(original.repaired, options).hulls, original.mesh, original.margin, options.max_vertices).hulls;
  const Solid solid(original.repaired);
  return certifiedHulls({original.mesh, original.repaired, solid, original.margin, nullptr, ""}, options).hulls;
}

json decomposeMesh(const json& job) {
  const Original original = readOriginal(job);
  DecomposeOptions options;
  options.method = *methodNamed(job["method"]);
  if (const auto effort = effortNamed(job["effort"])) options.effort = *effort;
  options.tolerance = job["tolerance"];
  options.seed = job["seed"];
  options.max_vertices = job["max_vertices"];
  writeText(job["hulls"].get<std::string>(), encodeHullsObj(hullsOf(original, options), "hull"));
  return json::object();
}

std::vector<ConvexHull> readHulls(const std::string& file) {
  std::vector<ConvexHull> hulls;
  for (const auto& points : readHullObjects(file)) hulls.push_back(convexHull(points));
  if (hulls.empty()) throw Error(ErrorCode::kEmptyMesh, "the program wrote no hull; it must write one object per hull");
  return hulls;
}

/// A certificate that includes the margin. Most results are far from their tolerance, so a rough bound usually decides.
Protrusion decidingProtrusion(const std::vector<ConvexHull>& hulls, const Solid& solid, double margin, double tolerance) {
  Protrusion rough = protrusion(hulls, solid, kRoughGap * tolerance);
  rough.bound += margin;
  const bool decided = rough.bound <= tolerance || rough.found > tolerance;
  return decided ? rough : certificate(hulls, solid, margin, tolerance);
}

json decide(const json& job) {
  const Original original = readOriginal(job);
  const Solid solid(original.repaired);
  json results = json::array();
  for (const json& file : job["hulls"]) {
    const std::clock_t start = std::clock();
    json result;
    try {
      const std::vector<ConvexHull> hulls = readHulls(file);
      const Protrusion found = decidingProtrusion(hulls, solid, original.margin, job["tolerance"]);
      result = {{"hulls", hulls.size()}, {"uncovered", uncovered(original.mesh, hulls)}, {"protrusion", found.bound}};
    } catch (const Error& e) {
      result["error"] = e.what();
    }
    result["seconds"] = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    results.push_back(result);
  }
  return {{"results", results}};
}

}  // namespace

nlohmann::json score(const json& job) {
  json hashes = json::array();
  for (const json& file : job["hulls"]) hashes.push_back(hashOf(readHullObjects(file)));
  const std::vector<ConvexHull> hulls = readHulls(job["hulls"][0]);
  std::size_t vertices = 0;
  for (const ConvexHull& hull : hulls) vertices += hull.vertices.size();

  const Original original = readOriginal(job);
  const Solid solid(original.repaired);
  const Protrusion found = certificate(hulls, solid, original.margin, job["tolerance"]);
  json result = {{"hulls", hulls.size()},     {"hull_vertices", vertices},       {"uncovered", uncovered(original.mesh, hulls)},
                 {"protrusion", found.bound}, {"protrusion_found", found.found}, {"volume_ratio", nullptr},
                 {"hashes", hashes}};
  if (job.value("least", false)) {
    const bool fits = result["uncovered"] == 0 && found.bound <= job["tolerance"];
    const std::vector<ConvexHull> none;
    result["least_hulls"] = leastHulls(original.mesh, solid, job["tolerance"], fits ? hulls : none, Effort::kBest);
  }
  if (solid.volume() > 0) result["volume_ratio"] = unionVolume(hulls) / solid.volume();
  return result;
}

void doJob(const std::string& job_file, const std::string& result_file) {
  const json job = readJson(job_file);
  const std::string kind = job["job"];
  const json result = kind == "prepare"     ? prepare(job)
                      : kind == "decompose" ? decomposeMesh(job)
                      : kind == "decide"    ? decide(job)
                      : kind == "query"     ? query(job)
                      : kind == "cuts"      ? measureCuts(job)
                      : kind == "score"     ? score(job)
                                            : throw Error(ErrorCode::kInternal, "there is no job '" + kind + "'");
  writeText(result_file, result.dump());
}

}  // namespace collision_hulls
