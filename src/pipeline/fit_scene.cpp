// The flow of decomposeRobot() with the whole robot fitted at once: read, repair and build a tree for each mesh; fit all trees to the
// scene; certify the hulls of each cut; validate. Equal meshes are read once, and certified once per cut.
#include "collision_hulls/pipeline/fit_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "fit/enclosing.h"
#include "pipeline/cache.h"
#include "pipeline/cached_tree.h"
#include "pipeline/collision_model.h"
#include "pipeline/earlier_output.h"
#include "pipeline/element_stages.h"
#include "pipeline/elements.h"
#include "pipeline/progress.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

// Shares of the whole time at which stages end, approximately.
constexpr double kTreesEnd = 0.4, kFitEnd = 0.8, kCertifyEnd = 0.9;
constexpr double kFittedGap = 0.01;  // of the tolerance, or of the protrusion that the tree states if that is larger

/// 1 to 3 of a mesh: read, repair, and its hull tree. Fills the first of its elements.
std::shared_ptr<const FitMesh> fitMesh(const MeshTask& task, std::size_t index, const Options& options, Cache& cache, Progress& progress,
                                       ElementResult& element) {
  RunControl control;
  progress.follow(control, index);
  const ReadMesh read = readElement(task, options, control, element);
  Stopwatch stage;
  const auto mesh = std::make_shared<FitMesh>();
  CachedTree cached = cachedTree(task.file, element.report, read.repaired, options, element.report.tolerance, cache, control);
  if (cached.found) progress.skip(index);
  mesh->tree = std::move(cached.tree);
  mesh->original = element.original;
  mesh->solid = element.solid;
  mesh->margin = read.margin;
  mesh->max_vertices = options.max_vertices;
  mesh->max_hulls = options.max_hulls;
  element.report.seconds.decompose = stage.lap();
  return mesh;
}

using FitMeshes = std::vector<std::shared_ptr<const FitMesh>>;  // one per element; null: failed

FitMeshes fitMeshes(const std::vector<MeshTask>& tasks, const Options& options, Cache& cache, Progress& progress,
                    std::vector<ElementResult>& elements) {
  FitMeshes meshes(elements.size());
  forEachInTurn(tasks.size(), [&](std::size_t i) {
    const std::size_t first = tasks[i].elements.front();
    try {
      meshes[first] = fitMesh(tasks[i], i, options, cache, progress, elements[first]);
    } catch (...) {
      fail(elements[first]);
    }
    progress.finish(i);
    for (const std::size_t element : tasks[i].elements) {
      meshes[element] = meshes[first];
      if (element != first) copyResult(elements[first], elements[element]);
      progress.finishElement(elements[element].report.link, meshes[element] ? (meshes[element]->tree.nodes.size() + 1) / 2 : 0);
    }
  });
  return meshes;
}

/// A link is fitted as a whole, so one failed mesh also fails the other meshes of its link.
void failSiblings(FitMeshes& meshes, std::vector<ElementResult>& elements) {
  std::map<std::string, const ElementReport*> failed;  // by link: the first such mesh
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (!meshes[i]) failed.emplace(elements[i].report.link, &elements[i].report);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto sibling = failed.find(elements[i].report.link);
    if (!meshes[i] || sibling == failed.end()) continue;
    meshes[i] = nullptr;
    fail(elements[i], sibling->second->error,
         "'" + sibling->second->uri + "' on the same link failed, and a link is fitted as a whole; fix that mesh");
  }
}

/// The primitives of all selected links except absent ones. Primitives without a valid size, such as dummies, only give a note.
std::vector<KeptBody> keptBodies(const RobotDescription& robot, const Options& options, const std::set<std::string>& absent,
                                 std::vector<std::string>& notes) {
  const LinkChoice chosen(options.links, robot);
  std::vector<KeptBody> kept;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    if (!chosen(robot.links[link].name) || absent.count(robot.links[link].name)) continue;
    for (const GeometryElement& element : sourceElements(robot.links[link], options.source).elements) {
      if (element.kind == GeometryElement::Kind::kMesh || element.kind == GeometryElement::Kind::kNone) continue;
      try {
        kept.push_back({link, hullAbout(element)});
      } catch (const Error& error) {
        notes.push_back("link '" + robot.links[link].name + "': " + error.what() + "; this primitive is ignored");
      }
    }
  }
  return kept;
}

/// The problem of fitting all elements of links without a failed mesh; `indices` tells which of all elements these are.
FitProblem problemOf(const RobotDescription& robot, const SceneRequest& request, const Options& options,
                     const std::vector<ElementResult>& elements, const FitMeshes& meshes, std::vector<std::size_t>& indices,
                     std::vector<std::string>& notes) {
  FitProblem problem{robot, {}, {}, request.scene, request.disabled, request.configurations};
  std::map<std::string, std::size_t> link_index;
  for (std::size_t i = 0; i < robot.links.size(); ++i) link_index[robot.links[i].name] = i;
  std::set<std::string> failed;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (!meshes[i]) failed.insert(elements[i].report.link);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const ElementResult& element = elements[i];
    if (failed.count(element.report.link)) continue;
    problem.elements.push_back({element.report.link + "/" + std::to_string(element.report.element), link_index[element.report.link],
                                element.source.origin, meshes[i]});
    indices.push_back(i);
  }
  problem.kept = keptBodies(robot, options, failed, notes);
  return problem;
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
void tellOfPrimitive(const ElementResult& element, Protrusion& found) {
  const auto of_primitive = found.hull - static_cast<int>(element.hulls.size() - element.primitives.size());
  if (of_primitive < 0) return;
  found.where = nearestPoint(element.primitives[static_cast<std::size_t>(of_primitive)], found.where);
  found.found = element.solid->distance(found.where);
  found.nearest = found.found > 0 ? element.solid->surface().nearest(found.where).point : found.where;
}

/// Step 4: certify the hulls as written.
void certify(const FitMesh& mesh, const FittedElement& fitted, const RunControl& control, ElementResult& element) {
  Stopwatch stage;
  ElementReport& row = element.report;
  double told = row.tolerance;
  for (const int node : fitted.cut) told = std::max(told, mesh.tree.nodes[static_cast<std::size_t>(node)].protrusion);
  element.hulls = fitted.hulls;
  element.primitives = fitted.primitives;
  element.unneeded = leavesBelow(mesh.tree, fitted.cut);
  row.uncovered = uncovered(element.original, element.hulls, control);
  if (row.uncovered > 0)
    throw Error(ErrorCode::kInternal, "the hulls leave the surface uncovered by up to " + millimetres(row.uncovered) +
                                          "; the limit is 0. Please report the mesh '" + row.uri + "'");
  Protrusion found = protrusion(element.hulls, *element.solid, kFittedGap * told, control);
  tellOfPrimitive(element, found);
  row.protrusion = found.bound + mesh.margin;
  row.protrusion_found = found.found;
  row.worst = found.where;
  row.worst_nearest = found.nearest;
  describe(element);
  row.seconds.certify = stage.lap();
}

/// Identifies a fitted element: its cut, followed by negative numbers for the kinds of its primitives.
std::vector<int> cutOf(const FittedElement& fitted) {
  std::vector<int> cut = fitted.cut;
  for (const GeometryElement& primitive : fitted.primitives) cut.push_back(-1 - static_cast<int>(primitive.kind));
  return cut;
}

using MeshCut = std::pair<const FitMesh*, std::vector<int>>;

/// Certifies elements with the same mesh and cut once.
void certifyAll(const FitMeshes& meshes, const SceneFit& fit, const std::vector<std::size_t>& indices, Progress& progress,
                std::vector<ElementResult>& elements) {
  std::map<MeshCut, std::vector<std::size_t>> same;
  for (std::size_t i = 0; i < indices.size(); ++i) same[{meshes[indices[i]].get(), cutOf(fit.elements[i])}].push_back(i);
  std::vector<std::vector<std::size_t>> groups;
  for (const auto& [what, members] : same) groups.push_back(members);
  progress.begin("certify", kCertifyEnd, std::vector<double>(groups.size(), 1));
  forEachInTurn(groups.size(), [&](std::size_t g) {
    RunControl control;
    progress.follow(control, g);
    ElementResult& first = elements[indices[groups[g].front()]];
    try {
      certify(*meshes[indices[groups[g].front()]], fit.elements[groups[g].front()], control, first);
    } catch (...) {
      fail(first);
    }
    progress.finish(g);
    for (const std::size_t i : groups[g])
      if (i != groups[g].front()) copyResult(first, elements[indices[i]]);
  });
}

void validateAll(RobotResult& result, Progress& progress) {
  const Options& options = result.report.options;
  if (!options.validate) return;
  RunControl control;
  progress.begin("validate", 1);
  progress.follow(control, 0);
  result.report.validation = validateElements(result.elements, options.seed, control);
}

std::vector<std::string> notesOnFit(const FitReport& fit, const Options& options) {
  std::vector<std::string> notes = fit.notes;
  if (!options.links.empty()) notes.push_back("links that '" + options.links + "' does not match were left out of the fit");
  if (!fit.scene_contact.empty()) notes.push_back("the original touches the scene at rest: " + fit.scene_contact);
  if (fit.scene_hits > 0 && fit.given) {
    notes.push_back("the original touches the scene in " + std::to_string(fit.scene_hits) + " of " + std::to_string(fit.samples) +
                    " given configurations");
  }
  if (fit.leaf_contacts > 0) {
    notes.push_back(std::to_string(fit.leaf_contacts) + " counterexamples remain even with the finest hulls, such as " + fit.leaf_contact +
                    "; use a smaller tolerance");
  }
  return notes;
}

/// [m] How far from the root the joints can take a link's frame, all stretched out.
double reachOf(const RobotDescription& robot) {
  std::map<std::string, double> reach;  // by link
  double largest = 0;
  for (const JointDescription& joint : robot.joints) {  // parents before children
    const bool slides = joint.kind == JointDescription::Kind::kPrismatic;
    const double way = slides ? std::max(std::abs(joint.lower), std::abs(joint.upper)) : 0;
    reach[joint.child] = reach[joint.parent] + joint.origin.translation().norm() + way;
    largest = std::max(largest, reach[joint.child]);
  }
  return largest;
}

/// A robot never keeps such a distance from itself: the model would not have to be free anywhere.
void checkClearance(double clearance, const RobotDescription& robot) {
  constexpr double kAlwaysAllowed = 1;  // [m] for robots without joints, too
  const double reach = reachOf(robot);
  if (clearance <= std::max(kAlwaysAllowed, reach)) return;
  throw Error(ErrorCode::kBadOption, "clearance '" + toString(lengthOf(clearance)) + "' is more than robot '" + robot.name + "' reaches (" +
                                         millimetres(reach) + "): a number without a unit is in metres, did you mean " +
                                         toString(lengthOf(clearance / 1000)) + "?");
}

void refuseOtherWays(const Options& options) {
  if (options.tree)
    throw Error(ErrorCode::kBadOption, "tree '" + toString(*options.tree) +
                                           "' does not apply to fit_scene, whose trees always have leaves for the tolerance; omit it");
  if (options.method == Method::kCertified) return;
  throw Error(ErrorCode::kBadOption,
              std::string("method '") + name(options.method) + "' builds no hull tree, which fitting to a scene needs; use certified");
}

}  // namespace

SceneRequest readSceneRequest(const Input& input, const SceneSources& sources) {
  if (sources.max_step != 0 && sources.configurations.empty())
    throw Error(ErrorCode::kBadOption,
                "max-step '" + std::to_string(sources.max_step) + "' interpolates between given configurations; give some, or omit it");
  SceneRequest request;
  if (!sources.scene.empty()) request.scene = readScene(sources.scene, input.find_package);
  if (!sources.srdf.empty() || !sources.srdf_file.empty()) {
    DisabledPairs disabled = parseDisabledPairs(sources.srdf, input.robot, sources.srdf_file);
    request.disabled = std::move(disabled.pairs);
    request.notes = std::move(disabled.notes);
  }
  if (!sources.configurations.empty()) {
    const ConfigurationOptions options = givenConfigurations(sources.max_step);
    giveConfigurations(readConfigurations(sources.configurations, Kinematics(input.robot), options), request);
  }
  return request;
}

ConfigurationOptions givenConfigurations(double max_step) {
  ConfigurationOptions options;
  options.max_step = max_step;
  options.refuse_beyond_limits = true;
  return options;
}

void giveConfigurations(ConfigurationSet given, SceneRequest& request) {
  request.configurations = std::move(given.configurations);
  request.notes.insert(request.notes.end(), given.notes.begin(), given.notes.end());
}

RobotResult fitRobotToScene(const RobotDescription& robot, const PackageFinder& find_package, const SceneRequest& request,
                            const Options& options, const std::string& output, const RunControl& control, const StepCallback& step) {
  check(options);
  checkForRobot(options);
  refuseOtherWays(options);
  const FitOptions fit_options{request.clearance, request.samples, options.seed, request.compare, request.primitives};
  check(fit_options);
  checkClearance(request.clearance, robot);
  const Kinematics joints(robot);
  Stopwatch run;
  refuseLosingVisuals(robot, output, find_package);
  RobotResult result = robotResult(robot, options);
  if (result.elements.empty()) throw Error(ErrorCode::kBadOption, notesOnElements(robot, {}, options).front());
  std::vector<ElementResult>& elements = result.elements;
  std::vector<std::string> notes = request.notes;
  for (const std::string& note : joints.notes()) notes.push_back(note);
  Cache cache(options.cache ? cacheFolder() : std::filesystem::path());
  Progress progress(control, step, elements.size());
  withJobs(options.jobs, [&] {
    const std::vector<MeshTask> tasks =
        meshTasks(elements, [&](const std::string& uri) { return resolveUri(uri, robot.path, find_package); });
    progress.begin("decompose", kTreesEnd, expectedCosts(tasks));
    for (const ElementResult& element : elements) {
      if (element.report.status == Status::kFailed) progress.finishElement(element.report.link, 0);
    }
    FitMeshes meshes = fitMeshes(tasks, options, cache, progress, elements);
    failSiblings(meshes, elements);
    std::vector<std::size_t> indices;
    const FitProblem problem = problemOf(robot, request, options, elements, meshes, indices, notes);
    if (problem.elements.empty()) return;  // every link has a failed mesh
    RunControl fitting;
    progress.begin("fit", kFitEnd);
    progress.follow(fitting, 0);
    const SceneFit fit = fitScene(problem, fit_options, fitting);
    certifyAll(meshes, fit, indices, progress, elements);
    validateAll(result, progress);
    result.report.scene = fit.report;
    result.extra_files["config/" + fileName(robot.name) + "_disabled.srdf"] = srdfFragment(robot.name, fit.disabled);
  });
  progress.end();
  cache.trim();
  result.report.notes = cache.notes();
  for (ElementResult& element : elements) element.solid = nullptr;
  reportElements(result);
  noteSmallMeshes(result.report);
  if (result.report.scene)
    for (const std::string& note : notesOnFit(*result.report.scene, options)) notes.push_back(note);
  rewriteDescription(robot, find_package, output, notes, result);
  result.report.seconds = run.lap();
  if (result.report.scene) result.report.scene->seconds = result.report.seconds;
  return result;
}

}  // namespace collision_hulls
