// Draws random cuts in three ways and measures each as it would be written. Certificates are remembered per hull, as most hulls are in many
// cuts.
#include "bench/cuts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "base/random.h"
#include "bench/job_runner.h"
#include "bench/original.h"
#include "bench/table.h"
#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/decompose/round_outward.h"
#include "collision_hulls/measure/measures.h"
#include "storage/csv.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

constexpr const char* kKinds[] = {"tolerance", "hulls", "nodes"};
// Moving a hull's faces outward by a margin moves its corners further than that; allow this many margins.
constexpr double kMargins = 3;

/// Opens each node with the same random probability, from the root down.
std::vector<int> openedByChance(const HullTree& tree, Dice& dice) {
  const double chance = dice.unit();
  std::vector<int> cut, open{static_cast<int>(tree.nodes.size()) - 1};
  while (!open.empty()) {
    const int id = open.back();
    const HullNode& node = tree.nodes[static_cast<std::size_t>(id)];
    open.pop_back();
    if (node.left < 0 || dice.unit() >= chance)
      cut.push_back(id);
    else
      open.insert(open.end(), {node.left, node.right});
  }
  return cut;
}

std::vector<int> randomCut(const HullTree& tree, const std::string& kind, std::size_t leaves, Dice& dice) {
  if (kind == "nodes") return openedByChance(tree, dice);
  if (kind == "hulls") return tree.cutTo(1 + static_cast<int>(dice.below(leaves)));
  const double span = std::max(1.0, tree.nodes.back().protrusion / tree.tolerance);
  return tree.cutAt(tree.tolerance * std::pow(span, dice.unit()));
}

/// Certifies hulls, each only once.
class Certificates {
 public:
  Certificates(const Solid& solid, double gap) : solid_(solid), gap_(gap) {}

  double bound(const std::vector<ConvexHull>& hulls) {
    double largest = 0;
    for (const ConvexHull& hull : hulls) largest = std::max(largest, bound(hull));
    return largest;
  }

 private:
  double bound(const ConvexHull& hull) {
    std::vector<double> key;
    for (const Eigen::Vector3d& v : hull.vertices) key.insert(key.end(), v.data(), v.data() + 3);
    const auto [known, is_new] = known_.emplace(std::move(key), 0.0);
    if (is_new) known->second = protrusion({hull}, solid_, gap_).bound;
    return known->second;
  }

  const Solid& solid_;
  const double gap_;
  std::map<std::vector<double>, double> known_;
};

}  // namespace

json measureCuts(const json& job) {
  const Original original = readOriginal(job);
  DecomposeOptions options;
  options.tolerance = parseLength(job["tolerance"]).metres(diagonal(original.mesh));
  options.seed = job["seed"];
  const HullTree tree = hullTree(original.repaired, options);
  const auto leaves =
      static_cast<std::size_t>(std::count_if(tree.nodes.begin(), tree.nodes.end(), [](const HullNode& node) { return node.left < 0; }));
  const Solid solid(original.repaired);
  const double gap = kCertificateGap * options.tolerance;
  Certificates certificates(solid, gap);
  Dice dice(options.seed);
  json cuts = json::array();
  for (std::size_t i = 0; i < job["cuts"].get<std::size_t>(); ++i) {
    const std::string kind = kKinds[i % std::size(kKinds)];
    const std::vector<int> cut = randomCut(tree, kind, leaves, dice);
    double told = 0;
    for (const int id : cut) told = std::max(told, tree.nodes[static_cast<std::size_t>(id)].protrusion);
    const RoundedHulls rounded = roundOutward(tree.hullsOf(cut), original.mesh, original.margin, 0);
    cuts.push_back({{"kind", kind},
                    {"hulls", cut.size()},
                    {"bound", told + gap + kMargins * (original.margin + rounded.nudge)},
                    {"uncovered", uncovered(original.mesh, rounded.hulls)},
                    {"protrusion", certificates.bound(rounded.hulls) + original.margin}});
  }
  return {{"leaves", leaves}, {"cuts", cuts}};
}

std::string cutHeader() {
  return "mesh,status,kind,leaves,hulls,bound,uncovered,protrusion,message\n";
}

std::string toCsv(const CutRow& row) {
  return csvLine({row.mesh, row.status, row.kind, csvCount(row.leaves), csvCount(row.hulls), csvNumber(row.bound), csvNumber(row.uncovered),
                  csvNumber(row.protrusion), row.message});
}

namespace {

void handOver(const json& found, CutRow row, const std::function<void(const CutRow&)>& take) {
  row.leaves = found["leaves"].get<std::size_t>();
  for (const json& cut : found["cuts"]) {
    row.kind = cut["kind"];
    row.hulls = cut["hulls"].get<std::size_t>();
    row.bound = cut["bound"].get<double>();
    row.uncovered = cut["uncovered"].get<double>();
    row.protrusion = cut["protrusion"].get<double>();
    take(row);
  }
}

}  // namespace

void runCuts(const std::vector<BenchmarkMesh>& meshes, const BenchmarkOptions& options, const Length& leaves, int cuts,
             const std::function<void(const CutRow&)>& row) {
  const JobRunner runner(options.program, options.folder);
  for (const BenchmarkMesh& mesh : meshes) {
    JobOutcome outcome;
    const json job{{"job", "cuts"}, {"tolerance", toString(leaves)}, {"seed", options.seed}, {"cuts", cuts}};
    const json found = runner.result(toJob(mesh, job), outcome);
    CutRow common;
    common.mesh = mesh.name;
    common.status = outcome.status;
    common.message = outcome.message;
    if (outcome.ok())
      handOver(found, common, row);
    else
      row(common);
  }
}

}  // namespace collision_hulls
