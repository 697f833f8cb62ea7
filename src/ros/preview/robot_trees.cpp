// Builds in the frame that every run has (pipeline/run.h), with one stage of its own: read, tree, certify. What it reads stays, so that a
// later cut needs neither file nor search: it picks nodes of a tree, whose hulls have their vertices reduced already. A cut through n nodes
// takes O(n), and the copies of its hulls.
#include "robot_trees.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

#include "base/millimetres.h"
#include "base/parallel.h"
#include "decompose/hulls_of_tree.h"
#include "pipeline/run.h"
#include "pipeline/shapes/shapes.h"
#include "pipeline/stages.h"

namespace collision_hulls {
namespace {

constexpr double kTreeShare = 0.7;    // of the time of a mesh, approximately
constexpr double kStepApart = 1.005;  // steps that are nearer to each other than this count as one
constexpr double kMostTolerance = 1;  // [m] see checkTolerance()
constexpr int kBuildsHeld = 4;        // of a mesh, so that a few settings can be compared and memory stays bounded

std::string useKey(const GeometryElement& element) {
  std::ostringstream key;
  key.precision(17);
  key << element.uri << '\n' << element.scale.transpose();
  return key.str();
}

/// Rounded up to three digits, so that a tolerance of this value has a short text and still lets the node pass.
double roundedUp(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return std::ceil(value / unit * (1 - 1e-12)) * unit;
}

std::string limitText(int limit) {
  return limit == 0 ? "0 (no limit)" : std::to_string(limit);
}

/// Why a mesh's tree that was built with other options does not serve, as in "its hull tree has max_vertices 64, and 32 is asked for":
/// the first of the options that treeKey() has.
std::string difference(const LinkOptions& held, const LinkOptions& needed, double diagonal) {
  const auto differ = [](const std::string& item, const std::string& one, const std::string& other) {
    return "its hull tree has " + item + " " + one + ", and " + other + " is asked for";
  };
  const auto flag = [](bool value) { return std::string(value ? "true" : "false"); };
  if (held.max_vertices != needed.max_vertices) return differ("max_vertices", limitText(held.max_vertices), limitText(needed.max_vertices));
  if (held.effort != needed.effort) return differ("effort", name(held.effort), name(needed.effort));
  if (held.fill != needed.fill) return differ("fill", flag(held.fill), flag(needed.fill));
  if (takesTreeWithoutProof(held) != takesTreeWithoutProof(needed))
    return differ("bounds", flag(!takesTreeWithoutProof(held)), flag(!takesTreeWithoutProof(needed)));
  return differ("leaves of", millimetres(treeLeaves(held, diagonal)), millimetres(treeLeaves(needed, diagonal)));
}

}  // namespace

/// A tree with its reduced hulls, and the last of its mesh's builds that asked for it.
struct RobotTrees::Tree {
  Tree(std::shared_ptr<const HullTree> built, const LinkOptions& with)
      : options(with), tree(std::move(built)), cutter(*tree, options.max_vertices) {
    cutter.mergedBounds();  // reduces them all, so that no cut has to
  }
  const LinkOptions options;  // of the link that it was built for
  const std::shared_ptr<const HullTree> tree;
  TreeCutter cutter;
  std::mutex mutex;  // of the cutter
  int build = 0;
};

/// A mesh that was read, with its trees by their keys.
struct RobotTrees::Mesh {
  Mesh(const MeshTask& of, const Options& with)
      : task(of), options(with), cache(options.cache ? cacheFolder() : std::filesystem::path()), shared(task, options, cache) {}
  MeshTask task;
  const Options options;
  Cache cache;
  SharedMesh shared;
  const ReadMesh* read = nullptr;
  MeshResult known;  // once it is read
  std::map<std::string, std::shared_ptr<Tree>> trees;
  int builds = 0;
};

/// A mesh of a link; without its tree where that is not held.
struct RobotTrees::Held {
  ElementResult element;
  ElementReport row;
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<Tree> tree;
};

RobotTrees::RobotTrees() = default;
RobotTrees::~RobotTrees() = default;

RobotResult RobotTrees::build(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                              const RunControl& control, const StepCallback& step) {
  check(options);
  RobotResult result = emptyResult(robot, options, control);
  const std::vector<MeshUse> uses = meshUses(robot, {LinkDecisions(options, robot, control)});
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (robot_ != robot.text) meshes_.clear(), by_use_.clear();
    robot_ = robot.text;
  }
  runStages({uses, resolverFor(robot, find_package, control), 1, control, step}, result,
            [&](Run& run) { forEachInTurn(run.tasks.size(), [&](std::size_t task) { buildTask(task, run); }); });
  dropUnused();
  return result;
}

/// Lets go of meshes whose file has other content by now.
void RobotTrees::dropUnused() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::set<std::shared_ptr<Mesh>> used;
  for (const auto& [use, mesh] : by_use_) used.insert(mesh);
  for (auto mesh = meshes_.begin(); mesh != meshes_.end();) mesh = used.count(mesh->second) > 0 ? std::next(mesh) : meshes_.erase(mesh);
}

/// The held mesh of a task's content; a new one where there is none. Its uses are known from now on.
std::shared_ptr<RobotTrees::Mesh> RobotTrees::meshFor(const MeshTask& task, const Run& run) {
  std::ostringstream key;
  key.precision(17);
  key << task.sha256 << std::filesystem::path(task.file).extension().string() << task.scale.transpose() << ' ' << task.close_openings << ' '
      << run.options.reader_memory << ' ' << run.options.reader_time << ' ' << run.options.seed << ' ' << run.options.cache;
  const std::lock_guard<std::mutex> lock(mutex_);
  std::shared_ptr<Mesh>& mesh = meshes_[key.str()];
  if (!mesh) mesh = std::make_shared<Mesh>(task, run.options);
  if (!mesh->read) mesh->task = task;  // its file may have moved since a read that failed
  for (const MeshVariant& variant : task.variants)
    for (const std::size_t use : variant.uses) by_use_[useKey(run.uses[use].source)] = mesh;
  return mesh;
}

/// A build of a mesh begins: trees that none of its last builds asked for go.
void RobotTrees::beginBuild(Mesh& mesh) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++mesh.builds;
  for (auto tree = mesh.trees.begin(); tree != mesh.trees.end();) {
    const auto next = std::next(tree);
    if (tree->second->build + kBuildsHeld <= mesh.builds) {
      mesh.shared.letGo(tree->first);
      mesh.trees.erase(tree);
    }
    tree = next;
  }
}

/// The tree that a link's options need, held from now on.
std::shared_ptr<const HullTree> RobotTrees::hold(Mesh& mesh, const LinkOptions& options, const RunControl& control) {
  const double leaves = treeLeaves(options, mesh.known.mesh.diagonal);
  const std::shared_ptr<const HullTree> tree = mesh.shared.tree(options, leaves, control);
  const std::string key = treeKey(mesh.task, options, mesh.options.seed, leaves);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto known = mesh.trees.find(key);
    if (known != mesh.trees.end()) {
      known->second->build = mesh.builds;
      return tree;
    }
  }
  auto held = std::make_shared<Tree>(tree, options);
  const std::lock_guard<std::mutex> lock(mutex_);
  held->build = mesh.builds;
  mesh.trees.emplace(key, std::move(held));
  return tree;
}

/// Steps 1 to 4 of decomposeRobot() for one variant. Throws Error.
MeshResult RobotTrees::resultOf(Mesh& mesh, const LinkOptions& options, const RunControl& preparing, const RunControl& certifying) {
  MeshResult known;
  if (!mesh.read) {
    mesh.read = &mesh.shared.read(options, preparing, known);
    const std::lock_guard<std::mutex> lock(mutex_);
    mesh.known = std::move(known);
  }
  MeshResult result = mesh.known;
  setTolerance(mesh.task, options, result);
  const bool needs_tree = options.tree || options.shapes == Shapes::kPrimitives;
  const std::shared_ptr<const HullTree> tree = needs_tree ? hold(mesh, options, preparing) : nullptr;
  decomposeAndCertify(*mesh.read, options, tree.get(), mesh.task.uri, mesh.options.seed, certifying, result);
  return result;
}

void RobotTrees::buildTask(std::size_t index, Run& run) {
  const MeshTask& task = run.tasks[index];
  const std::shared_ptr<Mesh> mesh = meshFor(task, run);
  beginBuild(*mesh);
  const auto count = static_cast<double>(task.variants.size());
  for (std::size_t v = 0; v < task.variants.size(); ++v) {
    const double from = static_cast<double>(v) / count;
    RunControl preparing, certifying;
    run.progress.follow(preparing, index, from, from + kTreeShare / count);
    run.progress.follow(certifying, index, from + kTreeShare / count, from + 1 / count);
    auto result = std::make_shared<MeshResult>();
    try {
      *result = resultOf(*mesh, task.variants[v].options, preparing, certifying);
    } catch (...) {
      fail(*result);
    }
    finishVariant(task, task.variants[v], result, result->hulls.size(), run);
  }
  run.progress.finish(index);
}

std::shared_ptr<RobotTrees::Tree> RobotTrees::treeOf(const Mesh& mesh, const LinkOptions& options) const {
  const auto tree = mesh.trees.find(treeKey(mesh.task, options, mesh.options.seed, treeLeaves(options, mesh.known.mesh.diagonal)));
  return tree == mesh.trees.end() ? nullptr : tree->second;
}

/// The one that the mesh's last build asked for; null: there is none.
std::shared_ptr<RobotTrees::Tree> RobotTrees::lastTreeOf(const Mesh& mesh) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto last = std::max_element(mesh.trees.begin(), mesh.trees.end(),
                                     [](const auto& a, const auto& b) { return a.second->build < b.second->build; });
  return last == mesh.trees.end() ? nullptr : last->second;
}

std::vector<RobotTrees::Held> RobotTrees::heldOf(const LinkDescription& link, const LinkOptions& options) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const SourceElements source = sourceElements(link, options.source);
  std::vector<Held> held;
  for (std::size_t i = 0; i < source.elements.size(); ++i) {
    const GeometryElement& element = source.elements[i];
    if (element.kind != GeometryElement::Kind::kMesh) continue;
    Held one;
    one.element.link = one.row.link = link.name;
    one.element.source = element;
    one.element.pose = link.pose * element.origin;
    one.row.element = static_cast<int>(i);
    one.row.visual = source.visual;
    one.row.uri = element.uri;
    one.row.scale = element.scale;
    one.row.method = options.method;
    const auto mesh = by_use_.find(useKey(element));
    const bool is_same = mesh != by_use_.end() && mesh->second->task.close_openings == options.close_openings;
    if (is_same && mesh->second->known.solid && options.tree) {
      one.mesh = mesh->second;
      one.tree = treeOf(*one.mesh, options);
      static_cast<MeshFacts&>(one.row) = one.mesh->known.mesh;
      one.row.tolerance = options.tolerance.metres(one.row.diagonal);
    }
    held.push_back(std::move(one));
  }
  return held;
}

std::optional<LinkResult> RobotTrees::cut(const LinkDescription& link, const LinkOptions& options, const RunControl& control) const {
  LinkResult result;
  if (options.padding > 0 || options.shapes != Shapes::kHulls) return std::nullopt;
  for (Held& held : heldOf(link, options)) {
    control.check();
    if (!held.tree) return std::nullopt;
    cutThrough(held, options);
    result.elements.push_back(std::move(held.element));
    result.rows.push_back(std::move(held.row));
  }
  return result;
}

std::string RobotTrees::whyNoCut(const LinkDescription& link, const LinkOptions& options) const {
  if (options.padding > 0) return "hulls with padding are not cut from hull trees";
  if (options.shapes != Shapes::kHulls) return "shapes '" + std::string(name(options.shapes)) + "' are not cut from hull trees";
  if (options.method != Method::kCertified) return "method '" + std::string(name(options.method)) + "' has no hull tree";
  if (!options.regions.empty()) return "a link in a region has no hull tree";
  for (const Held& held : heldOf(link, options)) {
    const std::shared_ptr<Tree> last = held.mesh ? lastTreeOf(*held.mesh) : nullptr;
    if (!last) return "no hull tree of '" + held.row.uri + "' is held";
    if (!held.tree) return difference(last->options, options, held.row.diagonal);
  }
  return "its hull trees were built meanwhile";
}

void RobotTrees::cutThrough(Held& held, const LinkOptions& options) {
  const double margin = held.mesh->read->margin;
  ElementReport& row = held.row;
  const std::lock_guard<std::mutex> lock(held.tree->mutex);
  TreeCutter& cutter = held.tree->cutter;
  const TreeCutter::Cut cut = cutter.cut(firstAim(row.tolerance, margin), options.max_hulls);
  for (const int node : cut.nodes) {
    held.element.hulls.push_back(cutter.hull(node));
    row.hull_vertices += held.element.hulls.back().vertices.size();
  }
  row.hulls = cut.nodes.size();
  row.protrusion = cut.bound + margin;
  if (row.protrusion <= row.tolerance) return;
  row.status = Status::kDegraded;
  row.reason = "the hulls protrude by up to " + millimetres(row.protrusion) + ", more than the tolerance of " + millimetres(row.tolerance) +
               (cut.capped ? ": raise max_hulls" : ": give the tree finer leaves");
}

std::vector<double> RobotTrees::steps(const LinkDescription& link, const LinkOptions& options, const RunControl& control) const {
  if (options.padding > 0 || options.shapes != Shapes::kHulls) return {};
  double finest = 0;
  std::set<double> offered;
  for (const Held& held : heldOf(link, options)) {
    control.check();
    if (!held.tree) return {};
    finest = std::max(finest, treeLeaves(options, held.mesh->known.mesh.diagonal));
    const std::lock_guard<std::mutex> lock(held.tree->mutex);
    for (const double bound : held.tree->cutter.mergedBounds()) offered.insert(toleranceForAim(bound, held.mesh->read->margin));
  }
  std::vector<double> steps;
  if (finest > 0) steps.push_back(roundedUp(finest));
  for (const double step : offered)
    if (step <= kMostTolerance && step > kStepApart * steps.back()) steps.push_back(roundedUp(step));
  return steps;
}

}  // namespace collision_hulls
