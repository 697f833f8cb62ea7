// The flow of decomposeRobot() with the whole robot fitted at once: read, repair and build a tree for each mesh; fit all trees to the
// scene; certify the hulls of each cut; validate. Equal meshes are read once, and certified once per cut.
#include "collision_hulls/pipeline/fit_scene.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/robot/kinematics.h"
#include "fit/enclosing.h"
#include "pipeline/collision_model.h"
#include "pipeline/earlier_output.h"
#include "pipeline/mesh_result.h"
#include "pipeline/run.h"
#include "pipeline/scene/fit_notes.h"
#include "pipeline/scene/fit_refusals.h"
#include "pipeline/scene/held_joints.h"
#include "pipeline/scene/kept_bodies.h"
#include "pipeline/stages.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

// Shares of the whole time at which stages end, approximately.
constexpr double kTreesEnd = 0.4, kFitEnd = 0.8, kCertifyEnd = 0.9;
constexpr double kFittedGap = 0.01;  // of the tolerance, or of the protrusion that the tree states if that is larger

using HeldJoints = std::map<std::string, double>;
using FitMeshes = std::vector<std::shared_ptr<const FitMesh>>;  // one per use; null: failed

/// 1 to 3 of a mesh: read, repair, and its hull tree.
std::shared_ptr<const FitMesh> fitMesh(std::size_t index, const LinkOptions& options, SharedMesh& shared, Run& run, MeshResult& result) {
  RunControl control;
  run.progress.follow(control, index);
  const ReadMesh& read = shared.read(options, control, result);
  Stopwatch stage;
  const auto mesh = std::make_shared<FitMesh>();
  mesh->tree = *shared.tree(options, result.mesh.tolerance, control);
  mesh->original = result.original;
  mesh->solid = result.solid;
  mesh->margin = read.margin;
  mesh->max_vertices = options.max_vertices;
  mesh->max_hulls = options.max_hulls;
  result.seconds.decompose = stage.lap();
  return mesh;
}

/// What becomes of one variant of a task.
struct FitVariant {
  MeshResult result;
  std::shared_ptr<const FitMesh> mesh;  // null: failed
};

std::vector<FitVariant> fitVariants(std::size_t index, Run& run) {
  SharedMesh shared(run.tasks[index], run.options, run.cache);
  std::vector<FitVariant> variants;
  for (const MeshVariant& variant : run.tasks[index].variants) {
    FitVariant& made = variants.emplace_back();
    try {
      made.mesh = fitMesh(index, variant.options, shared, run, made.result);
    } catch (...) {
      fail(made.result);
    }
  }
  const bool all_made = std::all_of(variants.begin(), variants.end(), [](const FitVariant& variant) { return variant.mesh != nullptr; });
  if (all_made && !shared.builtTree()) run.progress.skip(index);
  return variants;
}

FitMeshes fitMeshes(Run& run) {
  FitMeshes meshes(run.uses.size());
  forEachInTurn(run.tasks.size(), [&](std::size_t i) {
    std::vector<FitVariant> made = fitVariants(i, run);
    run.progress.finish(i);
    for (std::size_t v = 0; v < made.size(); ++v) {
      const MeshVariant& variant = run.tasks[i].variants[v];
      for (const std::size_t use : variant.uses) meshes[use] = made[v].mesh;
      const std::size_t leaves = made[v].mesh ? (made[v].mesh->tree.nodes.size() + 1) / 2 : 0;
      finishVariant(run.tasks[i], variant, std::make_shared<const MeshResult>(std::move(made[v].result)), leaves, run);
    }
  });
  return meshes;
}

/// A copy of what is known of a use's mesh, to add to. The mesh's first use alone keeps the time.
MeshResult copyFor(std::size_t use, const Run& run) {
  MeshResult copy = *run.results[use];
  const auto is_first_of = [&](const MeshVariant& variant) { return variant.uses.front() == use; };
  const auto is_first = [&](const MeshTask& task) { return std::any_of(task.variants.begin(), task.variants.end(), is_first_of); };
  if (std::none_of(run.tasks.begin(), run.tasks.end(), is_first)) copy.seconds = {};
  return copy;
}

/// A link is fitted as a whole, so one failed mesh also fails the other meshes of its link.
void failSiblings(FitMeshes& meshes, Run& run) {
  std::map<std::string, std::size_t> failed;  // by link: the first such mesh
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (!meshes[i]) failed.emplace(run.uses[i].link, i);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto sibling = failed.find(run.uses[i].link);
    if (!meshes[i] || sibling == failed.end()) continue;
    meshes[i] = nullptr;
    MeshResult result = copyFor(i, run);
    fail(result, run.results[sibling->second]->error,
         "'" + run.uses[sibling->second].source.uri + "' on the same link failed, and a link is fitted as a whole; fix that mesh");
    run.results[i] = std::make_shared<const MeshResult>(std::move(result));
  }
}

/// What is fitted.
struct FittedUses {
  FitProblem problem;
  std::vector<std::size_t> uses;  // of the problem's elements
  std::vector<std::string> notes;
};

/// The problem of fitting the meshes of all links without a failed mesh, beside what stays as it is.
FittedUses problemOf(const RobotDescription& robot, const LinkDecisions& decisions, const PackageFinder& find_package,
                     const SceneRequest& request, const HeldJoints& held, const FitMeshes& meshes, const Run& run,
                     const RunControl& control) {
  FittedUses fitted{{withJointsHeld(robot, held),
                     {},
                     {},
                     request.scene,
                     request.disabled,
                     request.configurations,
                     held.empty() ? Configuration() : Kinematics(robot).rest()},
                    {},
                    {}};
  std::map<std::string, std::size_t> link_index;
  for (std::size_t i = 0; i < robot.links.size(); ++i) link_index[robot.links[i].name] = i;
  std::set<std::string> failed;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const MeshUse& use = run.uses[i];
    if (!meshes[i] && use.options.action == Action::kDecompose) failed.insert(use.link);
    if (!meshes[i]) continue;
    fitted.problem.elements.push_back({use.link + "/" + std::to_string(use.element), link_index[use.link], use.source.origin, meshes[i]});
    fitted.uses.push_back(i);
  }
  fitted.problem.kept = keptBodies(robot, decisions, failed, find_package, run.options, fitted.notes, control);
  return fitted;
}

/// The leaves below a cut's nodes, without leaves that are in the cut.
std::vector<ConvexHull> leavesBelow(const HullTree& tree, const std::vector<int>& cut) {
  std::vector<ConvexHull> leaves;
  std::vector<int> open = cut;
  while (!open.empty()) {
    const HullNode& node = tree.nodes[static_cast<std::size_t>(open.back())];
    open.pop_back();
    for (const int child : {node.left, node.right}) {
      if (child < 0) continue;
      open.push_back(child);
      if (tree.nodes[static_cast<std::size_t>(child)].left < 0) leaves.push_back(tree.nodes[static_cast<std::size_t>(child)].hull);
    }
  }
  return leaves;
}

/// The polyhedron around a primitive protrudes further than the primitive itself: corrects the largest protrusion found to a point of the
/// primitive.
void tellOfPrimitive(const FittedElement& fitted, const Solid& solid, Protrusion& found) {
  const auto of_primitive = found.hull - static_cast<int>(fitted.hulls.size() - fitted.primitives.size());
  if (of_primitive < 0) return;
  found.where = nearestPoint(fitted.primitives[static_cast<std::size_t>(of_primitive)], found.where);
  found.found = solid.distance(found.where);
  found.nearest = found.found > 0 ? solid.surface().nearest(found.where).point : found.where;
}

/// Step 4: certify the hulls as written.
void certifyCut(const FitMesh& mesh, const FittedElement& fitted, const std::string& uri, const RunControl& control, MeshResult& result) {
  Stopwatch stage;
  double told = result.mesh.tolerance;
  for (const int node : fitted.cut) told = std::max(told, mesh.tree.nodes[static_cast<std::size_t>(node)].protrusion);
  result.hulls = fitted.hulls;
  result.primitives = fitted.primitives;
  result.unneeded = leavesBelow(mesh.tree, fitted.cut);
  expectCovered(mesh.original, result.hulls, uri, control);
  Protrusion proof = protrusion(result.hulls, *mesh.solid, kFittedGap * told, control);
  tellOfPrimitive(fitted, *mesh.solid, proof);
  proof.bound += mesh.margin;
  result.model = factsOf(result.hulls, result.primitives.size(), *mesh.solid, proof, control);
  result.seconds.certify = stage.lap();
}

/// All bodies, for the report's page.
TriangleMesh surfaceOf(const Scene& scene) {
  TriangleMesh all;
  for (const SceneBody& body : scene.bodies) {
    const ConvexHull* const hull = std::get_if<ConvexHull>(&body.shape);
    append(all, transformed(hull ? surface(*hull) : std::get<TriangleMesh>(body.shape), body.pose));
  }
  return all;
}

/// Identifies a fitted element: its cut, followed by negative numbers for the kinds of its primitives.
std::vector<int> cutOf(const FittedElement& fitted) {
  std::vector<int> cut = fitted.cut;
  for (const GeometryElement& primitive : fitted.primitives) cut.push_back(-1 - static_cast<int>(primitive.kind));
  return cut;
}

/// The fitted elements (indices) with the same mesh and cut.
std::vector<std::vector<std::size_t>> equalElements(const FittedUses& fitted, const SceneFit& fit) {
  std::map<std::pair<const FitMesh*, std::vector<int>>, std::vector<std::size_t>> same;
  for (std::size_t i = 0; i < fitted.uses.size(); ++i) same[{fitted.problem.elements[i].mesh.get(), cutOf(fit.elements[i])}].push_back(i);
  std::vector<std::vector<std::size_t>> groups;
  for (const auto& [what, members] : same) groups.push_back(members);
  return groups;
}

/// Certifies elements with the same mesh and cut once.
void certifyAll(const FittedUses& fitted, const SceneFit& fit, Run& run) {
  const std::vector<std::vector<std::size_t>> groups = equalElements(fitted, fit);
  run.progress.begin("certify", kCertifyEnd, std::vector<double>(groups.size(), 1));
  MeshResults results(groups.size());
  forEachInTurn(groups.size(), [&](std::size_t g) {
    const std::size_t first = groups[g].front(), use = fitted.uses[first];
    RunControl control;
    run.progress.follow(control, g);
    MeshResult result = copyFor(use, run);
    try {
      certifyCut(*fitted.problem.elements[first].mesh, fit.elements[first], run.uses[use].source.uri, control, result);
    } catch (...) {
      fail(result);
    }
    results[g] = std::make_shared<const MeshResult>(std::move(result));
    run.progress.finish(g);
  });
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::size_t i : groups[g]) run.results[fitted.uses[i]] = results[g];
}

void validateAll(Run& run) {
  if (!run.options.validate) return;
  RunControl control;
  run.progress.begin("validate", 1);
  run.progress.follow(control, 0);
  run.report.validation = validateUses(run.uses, run.results, 0, run.options.seed, control);
}

/// The links with a mesh that finer hulls would fit, if max-hulls allowed more; each once.
std::set<std::string> cappedLinks(const FittedUses& fitted, const SceneFit& fit, const Run& run) {
  std::set<std::string> links;
  for (std::size_t i = 0; i < fitted.uses.size(); ++i) {
    const FitMesh& mesh = *fitted.problem.elements[i].mesh;
    const std::size_t hulls = fit.elements[i].cut.size(), leaves = (mesh.tree.nodes.size() + 1) / 2;
    if (mesh.max_hulls > 0 && hulls >= static_cast<std::size_t>(mesh.max_hulls) && hulls < leaves)
      links.insert(run.uses[fitted.uses[i]].link);
  }
  return links;
}

/// All stages. Fills the report's scene, unless every link has a failed mesh. Returns the pairs of links that the fit disables.
std::vector<DisabledPair> fitAll(const RobotDescription& robot, const LinkDecisions& decisions, const PackageFinder& find_package,
                                 const SceneRequest& request, const HeldJoints& held, const FitOptions& options,
                                 std::vector<std::string>& notes, Run& run) {
  FitMeshes meshes = fitMeshes(run);
  failSiblings(meshes, run);
  RunControl fitting;
  run.progress.begin("fit", kFitEnd);
  run.progress.follow(fitting, 0);
  const FittedUses fitted = problemOf(robot, decisions, find_package, request, held, meshes, run, fitting);
  notes.insert(notes.end(), fitted.notes.begin(), fitted.notes.end());
  if (fitted.problem.elements.empty()) return {};
  SceneFit fit = fitScene(fitted.problem, options, fitting);
  if (const std::string note = noteOnCap(fit.report, cappedLinks(fitted, fit, run)); !note.empty()) notes.push_back(note);
  certifyAll(fitted, fit, run);
  validateAll(run);
  run.report.scene = std::move(fit.report);
  run.report.scene->held = held;
  return fit.disabled;
}

}  // namespace

RobotResult fitRobotToScene(const RobotDescription& robot, const PackageFinder& find_package, const SceneRequest& request,
                            const Options& options, const std::string& output, const RunControl& control, const StepCallback& step) {
  check(options);
  checkForRobot(options);
  const std::vector<LinkDecisions> decisions{LinkDecisions(options, robot, control)};
  refuseOtherWays(robot, options, decisions.front());
  const FitOptions fit_options{request.clearance, request.samples, options.seed, request.compare, request.primitives};
  check(fit_options);
  checkClearance(request.clearance, robot);
  const Kinematics joints(robot);
  for (const Configuration& configuration : request.configurations) joints.check(configuration);
  const HeldJoints held = heldJoints(joints, request.joints, request.at);
  if (!held.empty() && !request.configurations.empty())
    throw Error(ErrorCode::kBadOption, "configurations say where each joint is, so joint '" + held.begin()->first +
                                           "' cannot be held; omit " + (request.joints.empty() ? "" : "joints '" + request.joints + "'") +
                                           (request.joints.empty() || request.at.empty() ? "" : " and ") +
                                           (request.at.empty() ? "" : "at") + ", or the configurations");
  Stopwatch clock;
  refuseLosingCache(options, output);
  for (const std::string& file : request.files) refuseLosingInput(file, output);
  RobotResult result = emptyResult(robot, options, control);
  const std::vector<MeshUse> uses = meshUses(robot, decisions);
  refuseLosingOriginals(robot, uses, output, find_package, control);
  if (decomposedUses(uses) == 0) throw Error(ErrorCode::kBadOption, notesOnUses(robot, decisions.front(), options).front());
  std::vector<std::string> notes = request.notes;
  for (const std::string& note : joints.notes()) notes.push_back(note);
  if (const std::string note = noteOnUnknownPairs(request.disabled, robot); !note.empty()) notes.push_back(note);
  for (const std::string& note : notesOnFarScene(request.scene, request.clearance, robot)) notes.push_back(note);
  std::vector<DisabledPair> disabled;
  runStages({uses, resolverFor(robot, find_package, control), kTreesEnd, control, step}, result,
            [&](Run& run) { disabled = fitAll(robot, decisions.front(), find_package, request, held, fit_options, notes, run); });
  std::optional<FitReport>& scene = result.report.scene;
  if (scene) {
    result.scene = surfaceOf(request.scene);
    result.extra_files["config/" + robotFileName(robot.name) + "_disabled.srdf"] = srdfFragment(robot.name, disabled);
    for (const std::string& note : notesOnFit(*scene, options)) notes.push_back(note);
    if (const std::string note = noteOnSpeed(*scene, request.scene); !note.empty()) notes.push_back(note);
  }
  rewriteDescription(robot, decisions, find_package, output, notes, result, control);
  result.report.seconds = clock.lap();
  if (scene) scene->seconds = result.report.seconds;
  return result;
}

}  // namespace collision_hulls
