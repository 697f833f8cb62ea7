// Lists the meshes of a robot and joins equal ones, so that a mesh that many links share is worked on once.
#include "pipeline/mesh_uses.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "base/counted.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "mesh/mesh_bytes.h"
#include "report/link_pattern.h"
#include "storage/sha256.h"

namespace collision_hulls {
namespace {

bool isMesh(const GeometryElement& element) {
  return element.kind == GeometryElement::Kind::kMesh;
}

bool hasGeometry(const LinkDescription& link) {
  const auto is_some = [](const GeometryElement& element) {
    return element.kind != GeometryElement::Kind::kNone || !element.fault.empty();
  };
  return std::any_of(link.visuals.begin(), link.visuals.end(), is_some) ||
         std::any_of(link.collisions.begin(), link.collisions.end(), is_some);
}

constexpr std::size_t kMostNames = 5;  // in a note

bool isDecomposed(const LinkOptions* options) {
  return options && options->action == Action::kDecompose;
}

/// On collision meshes that --source visual skips in links without a visual element.
std::vector<std::string> notesOnLeftOut(const RobotDescription& robot, const LinkDecisions& decisions) {
  std::vector<std::string> links;
  for (const LinkDescription& link : robot.links) {
    const LinkOptions* const options = decisions.of(link.name);
    if (isDecomposed(options) && options->source == Source::kVisual && link.visuals.empty() &&
        std::any_of(link.collisions.begin(), link.collisions.end(), isMesh))
      links.push_back(shortened(link.name));
  }
  if (links.empty()) return {};
  return {"links without a visual element keep their collision meshes as they are: " + listedFirst(links, kMostNames) +
          "; --source auto decomposes them"};
}

/// Whether a link keeps the primitives of its <collision> elements though it has a visual mesh.
bool keepsPrimitives(const LinkDescription& link, const LinkOptions* options) {
  return isDecomposed(options) && std::any_of(link.visuals.begin(), link.visuals.end(), isMesh) &&
         collisionFate(link, options) == CollisionFate::kStay && !sourceElements(link, options->source).visual &&
         std::any_of(link.collisions.begin(), link.collisions.end(), isSolidPrimitive);
}

/// On links with primitives beside those with meshes.
std::vector<std::string> notesOnPrimitives(const RobotDescription& robot, const LinkDecisions& decisions) {
  std::vector<std::string> names;
  for (const LinkDescription& link : robot.links)
    if (keepsPrimitives(link, decisions.of(link.name))) names.push_back(shortened(link.name));
  if (names.empty()) return {};
  const bool one = names.size() == 1;
  return {counted(names.size(), "link keeps", "links keep") + " the primitives of " + (one ? "its" : "their") +
          " <collision> elements, as they are: " + listedFirst(names, kMostNames) + "; 'source: visual' in a configuration decomposes " +
          (one ? "its" : "their") + " visual meshes"};
}

/// Links that collide with nothing in the input, beside others that collide.
std::vector<std::string> notesOnNew(const RobotDescription& robot, const LinkDecisions& decisions) {
  const auto collides = [](const LinkDescription& link) { return !link.collisions.empty(); };
  if (std::none_of(robot.links.begin(), robot.links.end(), collides)) return {};
  std::vector<std::string> names;
  for (const LinkDescription& link : robot.links) {
    const LinkOptions* const options = decisions.of(link.name);
    if (collides(link) || !isDecomposed(options) || options->source != Source::kAuto) continue;
    if (std::any_of(link.visuals.begin(), link.visuals.end(), isMesh)) names.push_back(shortened(link.name));
  }
  if (names.empty()) return {};
  const bool one = names.size() == 1;
  return {counted(names.size(), "link has", "links have") + " no <collision> elements, and " + (one ? "gets" : "get") + " hulls of " +
          (one ? "its" : "their") + " visual meshes: " + listedFirst(names, kMostNames) + "; --source collision leaves " +
          (one ? "it" : "them") + " without collision geometry"};
}

/// The uses of one link in one model.
void addUses(const LinkDescription& link, const LinkOptions& options, std::size_t model, std::vector<MeshUse>& uses) {
  const bool decomposed = options.action == Action::kDecompose;
  const SourceElements source = decomposed ? sourceElements(link, options.source) : SourceElements{false, link.collisions};
  const std::size_t before = uses.size();
  for (std::size_t i = 0; i < source.elements.size(); ++i) {
    const GeometryElement& element = source.elements[i];
    if (!isMesh(element)) continue;
    uses.push_back({model, link.name, options, static_cast<int>(i), source.visual, element, link.pose * element.origin});
    for (Region& region : uses.back().options.regions) region = transformed(region, element.origin.inverse());
  }
  if (!decomposed && uses.size() == before) uses.push_back({model, link.name, options, 0, false, GeometryElement(), link.pose});
}

/// What is known at once of a link that gets no hulls.
MeshResult undecomposed(const MeshUse& use) {
  MeshResult result;
  result.status = use.options.action == Action::kKeep ? Status::kKept : Status::kRemoved;
  if (use.source.uri.empty()) result.reason = "the link has no collision mesh";
  return result;
}

/// Whether the same mesh becomes the same hulls. The action, the source and the openings to close chose the mesh.
bool equalWork(const LinkOptions& a, const LinkOptions& b) {
  const auto values = [](const LinkOptions& options) {
    const auto& [action, tolerance, method, effort, tree, fill, max_hulls, max_vertices, source, padding, close_openings, shapes, regions] =
        options;
    return std::make_tuple(tolerance, method, effort, tree, fill, max_hulls, max_vertices, padding, shapes);
  };
  return values(a) == values(b) && equal(a.regions, b.regions);
}

void addVariant(const LinkOptions& options, std::size_t use, std::vector<MeshVariant>& variants) {
  const auto known =
      std::find_if(variants.begin(), variants.end(), [&](const MeshVariant& variant) { return equalWork(variant.options, options); });
  if (known != variants.end()) {
    known->uses.push_back(use);
  } else {
    variants.push_back({options, {use}});
  }
}

/// Tasks with equal values are the same work. The extension counts because it says how to read the content.
using Sameness = std::tuple<std::string, std::string, double, double, double, double>;

Sameness sameness(const MeshTask& task) {
  return {task.sha256,        std::filesystem::path(task.file).extension().string(), task.scale.x(), task.scale.y(), task.scale.z(),
          task.close_openings};
}

/// The files that were looked at so far: each is read once for all its uses.
class KnownFiles {
 public:
  KnownFiles(const MeshLimits& limits, const RunControl& control) : limits_(limits), control_(control) {}

  /// The task of one use, without its index. Throws Error.
  MeshTask taskFor(const GeometryElement& source, const UriResolver& resolve) {
    if (!source.fault.empty()) throw Error(ErrorCode::kBadGeometry, source.fault);
    MeshTask task;
    task.file = resolve(source.uri);
    task.uri = source.uri;
    task.scale = source.scale;
    const auto known = files_.find(task.file);
    const File& file = known != files_.end() ? known->second : files_[task.file] = look(task.file);
    task.sha256 = file.sha256;
    task.bytes = file.bytes;
    return task;
  }

 private:
  struct File {
    std::string sha256;
    std::uintmax_t bytes = 0;
  };

  File look(const std::string& file) const {
    const std::string content = readMeshBytes(file, limits_, control_);
    return {sha256(content, control_), content.size()};
  }

  const MeshLimits& limits_;
  const RunControl& control_;
  std::map<std::string, File> files_;
};

/// A mesh that cannot be read, for what is being thrown.
std::shared_ptr<const MeshResult> failedMesh() {
  MeshResult failed;
  fail(failed);
  return std::make_shared<const MeshResult>(std::move(failed));
}

/// Whether an expression matches one of these links. Names are looked up: a program writes a rule for each link.
bool matchesAny(const LinkPattern& pattern, const std::set<std::string>& links, const RunControl& control) {
  const auto any = [](const std::set<std::string>& names, const auto& is_so) { return std::any_of(names.begin(), names.end(), is_so); };
  if (pattern.names()) return any(*pattern.names(), [&](const std::string& name) { return links.count(name) > 0; });
  return any(links, [&](const std::string& link) {
    control.check();
    return pattern.matches(link);
  });
}

}  // namespace

std::vector<MeshUse> meshUses(const RobotDescription& robot, const std::vector<LinkDecisions>& decisions) {
  std::vector<MeshUse> uses;
  for (std::size_t model = 0; model < decisions.size(); ++model) {
    for (const LinkDescription& link : robot.links)
      if (const LinkOptions* const options = decisions[model].of(link.name)) addUses(link, *options, model, uses);
  }
  return uses;
}

std::size_t decomposedUses(const std::vector<MeshUse>& uses) {
  const auto decomposed = [](const MeshUse& use) { return isDecomposed(&use.options); };
  return static_cast<std::size_t>(std::count_if(uses.begin(), uses.end(), decomposed));
}

std::vector<std::string> notesOnUses(const RobotDescription& robot, const LinkDecisions& decisions, const Options& options) {
  if (decomposedUses(meshUses(robot, {decisions})) > 0) {
    std::vector<std::string> notes = notesOnLeftOut(robot, decisions);
    for (std::string& note : notesOnPrimitives(robot, decisions)) notes.push_back(std::move(note));
    if (options.links.empty())
      for (std::string& note : notesOnNew(robot, decisions)) notes.push_back(std::move(note));
    return notes;
  }
  if (std::none_of(robot.links.begin(), robot.links.end(), hasGeometry)) return {"the robot has no geometry: nothing of it can collide"};
  std::ptrdiff_t visuals = 0, collisions = 0, chosen = 0;
  std::size_t is_new = 0;  // links whose visual primitives become collision elements
  for (const LinkDescription& link : robot.links) {
    if (!isDecomposed(decisions.of(link.name))) continue;
    ++chosen;
    visuals += std::count_if(link.visuals.begin(), link.visuals.end(), isMesh);
    collisions += std::count_if(link.collisions.begin(), link.collisions.end(), isMesh);
    const SourceElements source = sourceElements(link, decisions.of(link.name)->source);
    is_new += source.visual && std::any_of(source.elements.begin(), source.elements.end(), isSolidPrimitive);
  }
  if (chosen == 0) return {"there is no mesh to decompose: all links are kept or removed"};
  const auto others = [](std::ptrdiff_t count, const std::string& kind) {
    return count == 0 ? ""
                      : "; the <" + kind + "> elements have " + counted(static_cast<std::size_t>(count), "mesh", "meshes") +
                            ", which --source " + kind + " decomposes";
  };
  const char* const none = visuals + collisions > 0                         ? "there is no mesh to decompose"
                           : options.links.empty() && options.rules.empty() ? "the robot has no meshes"
                                                                            : "the chosen links have no meshes";
  const std::string stays =
      is_new == 0 ? ", and the output's collision model is the input's"
                  : ", and those of the <visual> elements become <collision> elements of " + counted(is_new, "link") + " without any";
  const std::string how_well = visuals > 0 && collisions == 0 && is_new == 0
                                   ? "; 'rosrun collision_hulls verify INPUT INPUT' tells how far they are from the primitives"
                                   : "";
  return {none + std::string("; boxes, spheres and cylinders stay as they are") + stays + others(visuals, "visual") +
          others(collisions, "collision") + how_well};
}

CollisionFate collisionFate(const LinkDescription& link, const LinkOptions* options, bool failed) {
  if (!options || options->action == Action::kKeep) return CollisionFate::kStay;
  if (options->action == Action::kRemove) return CollisionFate::kGo;
  if (failed && !link.collisions.empty()) return CollisionFate::kStay;
  const SourceElements source = sourceElements(link, options->source);
  const auto any = [&](const auto& is_so) { return std::any_of(source.elements.begin(), source.elements.end(), is_so); };
  return any(isMesh) || (source.visual && any(isSolidPrimitive)) ? CollisionFate::kReplaced : CollisionFate::kStay;
}

std::size_t primitiveLinks(const RobotDescription& robot, const LinkDecisions& decisions) {
  return static_cast<std::size_t>(std::count_if(robot.links.begin(), robot.links.end(), [&](const LinkDescription& link) {
    const LinkOptions* const options = decisions.of(link.name);
    if (!isDecomposed(options)) return false;
    const std::vector<GeometryElement> elements = sourceElements(link, options->source).elements;
    return std::none_of(elements.begin(), elements.end(), isMesh) && std::any_of(elements.begin(), elements.end(), isSolidPrimitive);
  }));
}

std::vector<std::string> notesOnConvex(const RobotDescription& robot, const std::vector<ElementReport>& rows) {
  std::set<std::string> uris, links;
  for (const ElementReport& row : rows) {
    if (row.status == Status::kKept || row.status == Status::kRemoved) continue;
    const bool is_near = row.protrusion <= LinkOptions().tolerance.metres(row.diagonal);
    if (row.visual || row.status != Status::kOk || row.hulls != 1 || !is_near) return {};
    uris.insert(row.uri), links.insert(row.link);
  }
  const bool has_others = std::any_of(robot.links.begin(), robot.links.end(), [&](const LinkDescription& link) {
    const auto is_other = [&](const GeometryElement& element) { return isMesh(element) && uris.count(element.uri) == 0; };
    return links.count(link.name) > 0 && std::any_of(link.visuals.begin(), link.visuals.end(), is_other);
  });
  if (!has_others) return {};
  return {
      "each collision mesh became a single hull: all are nearly convex, so the model is about as coarse as the input's. "
      "'rosrun collision_hulls verify INPUT INPUT' tells how far they are from the visual meshes, which --source visual decomposes"};
}

std::vector<std::string> notesOnBare(const RobotDescription& robot, const LinkDecisions& decisions) {
  std::vector<std::string> links;
  for (const LinkDescription& link : robot.links) {
    const LinkOptions* const options = decisions.of(link.name);
    if (options && options->action == Action::kKeep && link.collisions.empty() && !link.visuals.empty()) links.push_back(link.name);
  }
  if (links.empty()) return {};
  const std::string others = links.size() > 1 ? " and " + counted(links.size() - 1, "more link") : "";
  return {"link '" + shortened(links.front()) + "'" + others + (links.size() > 1 ? " are" : " is") +
          " kept, but without <collision> elements: nothing collides there. Decompose " + (links.size() > 1 ? "them" : "it") +
          ", or add some"};
}

std::vector<std::string> notesOnFlat(const RobotDescription& robot, const LinkDecisions& decisions) {
  std::vector<std::string> links;
  for (const LinkDescription& link : robot.links) {
    const LinkOptions* const options = decisions.of(link.name);
    if (!isDecomposed(options)) continue;
    const SourceElements source = sourceElements(link, options->source);
    const auto is_flat = [](const GeometryElement& element) {
      return !isMesh(element) && element.kind != GeometryElement::Kind::kNone && !isSolidPrimitive(element);
    };
    if (source.visual && std::any_of(source.elements.begin(), source.elements.end(), is_flat)) links.push_back(shortened(link.name));
  }
  if (links.empty()) return {};
  return {"visual boxes, spheres and cylinders with a size of 0 become no collision elements, in links: " + listedFirst(links, kMostNames)};
}

std::vector<std::string> notesOnIdle(const RobotDescription& robot, const LinkDecisions& decisions, const Options& options,
                                     const RunControl& control) {
  if (!options.links.empty()) return {};  // then whatever is told of other links changes nothing, as was asked for
  std::set<std::string> decomposed, with_geometry, keep_primitives;
  for (const MeshUse& use : meshUses(robot, {decisions}))
    if (isDecomposed(&use.options)) decomposed.insert(use.link);
  for (const LinkDescription& link : robot.links) {
    if (!link.visuals.empty() || !link.collisions.empty()) with_geometry.insert(link.name);
    if (keepsPrimitives(link, decisions.of(link.name))) keep_primitives.insert(link.name);
  }
  std::vector<std::string> notes;
  const auto look = [&](const std::string& what, const std::string& expression, const std::string& place, bool decomposes) {
    control.check();
    const LinkPattern pattern(expression, what);
    if (matchesAny(pattern, decomposes ? decomposed : with_geometry, control)) return;
    notes.push_back((place.empty() ? "" : place + ": ") + what + " '" + expression + "' changes nothing: no link that it matches has " +
                    (decomposes ? "a mesh to decompose" : "geometry") +
                    (matchesAny(pattern, keep_primitives, control) ? "; 'source: visual' uses their visual meshes" : ""));
  };
  for (const LinkRule& rule : options.rules)
    look("links", rule.pattern, rule.place, rule.settings.action.value_or(Action::kDecompose) == Action::kDecompose);
  for (const RegionRule& rule : options.region_rules) look("region '" + rule.name + "' of link", rule.pattern, rule.place, true);
  return notes;
}

UriResolver resolverFor(const RobotDescription& robot, const PackageFinder& find_package, const RunControl& control) {
  return [&](const std::string& uri) {
    control.check();
    return resolveUri(uri, robot.path, find_package);
  };
}

MeshTasks meshTasks(const std::vector<MeshUse>& uses, const UriResolver& resolve, const MeshLimits& limits, const RunControl& control) {
  MeshTasks result;
  result.done.resize(uses.size());
  KnownFiles files(limits, control);
  std::map<Sameness, std::size_t> known;  // index of the task
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (!isDecomposed(&uses[i].options)) {
      result.done[i] = std::make_shared<const MeshResult>(undecomposed(uses[i]));
      continue;
    }
    try {
      MeshTask task = files.taskFor(uses[i].source, resolve);
      task.close_openings = uses[i].options.close_openings;
      const auto [place, is_new] = known.emplace(sameness(task), result.tasks.size());
      if (is_new) result.tasks.push_back(std::move(task));
      addVariant(uses[i].options, i, result.tasks[place->second].variants);
    } catch (...) {
      result.done[i] = failedMesh();
    }
  }
  for (std::size_t i = 0; i < uses.size(); ++i) {  // again: by now a folder may stand in for the package
    if (!result.done[i] || result.done[i]->error != name(ErrorCode::kPackageNotFound)) continue;
    try {
      resolve(uses[i].source.uri);
    } catch (...) {
      result.done[i] = failedMesh();
    }
  }
  std::stable_sort(result.tasks.begin(), result.tasks.end(), [](const MeshTask& a, const MeshTask& b) { return a.bytes > b.bytes; });
  return result;
}

std::vector<double> expectedCosts(const std::vector<MeshTask>& tasks) {
  std::vector<double> costs;
  for (const MeshTask& task : tasks) costs.push_back(std::sqrt(static_cast<double>(task.bytes)));
  return costs;
}

std::string contentOf(const MeshTask& task, const MeshLimits& limits, const RunControl& control) {
  std::string content = readMeshBytes(task.file, limits, control);
  if (sha256(content, control) == task.sha256) return content;
  throw Error(ErrorCode::kFileNotFound, "'" + task.file + "' changed while it was being read; run again when it is complete");
}

}  // namespace collision_hulls
