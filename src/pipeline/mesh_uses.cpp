// Lists the meshes of a robot and joins equal ones, so that a mesh that many links share is worked on once.
#include "pipeline/mesh_uses.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <tuple>
#include <utility>

#include "base/nearest_name.h"
#include "base/read_file.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "storage/sha256.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kNamesShown = 12;

std::string linkNames(const RobotDescription& robot) {
  std::string text;
  const std::size_t shown = std::min(robot.links.size(), kNamesShown);
  for (std::size_t i = 0; i < shown; ++i) text += (i ? ", " : "") + robot.links[i].name;
  if (shown < robot.links.size()) text += " and " + std::to_string(robot.links.size() - shown) + " more";
  return text;
}

bool isMesh(const GeometryElement& element) {
  return element.kind == GeometryElement::Kind::kMesh;
}

/// On collision meshes that --source visual skips in links without a visual element.
std::vector<std::string> notesOnLeftOut(const RobotDescription& robot, const LinkChoice& chosen, const Options& options) {
  if (options.source != Source::kVisual) return {};
  std::string links;
  for (const LinkDescription& link : robot.links)
    if (chosen(link.name) && link.visuals.empty() && std::any_of(link.collisions.begin(), link.collisions.end(), isMesh))
      links += (links.empty() ? "" : ", ") + link.name;
  if (links.empty()) return {};
  return {"links without a visual element keep their collision meshes as they are: " + links + "; --source auto decomposes them"};
}

/// Tasks with equal values are the same work. The extension counts because it says how to read the content.
using Sameness = std::tuple<std::string, std::string, double, double, double>;

Sameness sameness(const MeshTask& task) {
  return {task.sha256, std::filesystem::path(task.file).extension().string(), task.scale.x(), task.scale.y(), task.scale.z()};
}

/// The files that were looked at so far: each is read once for all its uses.
class KnownFiles {
 public:
  explicit KnownFiles(const RunControl& control) : control_(control) {}

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
    const std::string content = readFile(file, "mesh", MeshLimits().max_bytes, control_);
    return {sha256(content, control_), content.size()};
  }

  const RunControl& control_;
  std::map<std::string, File> files_;
};

}  // namespace

LinkChoice::LinkChoice(const std::string& expression, const RobotDescription& robot) {
  if (expression.empty()) {
    matches_ = [](const std::string&) { return true; };
    return;
  }
  matches_ = [regex = std::regex(expression)](const std::string& link) { return std::regex_match(link, regex); };
  const auto chosen = [this](const LinkDescription& link) { return matches_(link.name); };
  if (std::any_of(robot.links.begin(), robot.links.end(), chosen)) return;
  std::vector<std::string> names;
  for (const LinkDescription& link : robot.links) names.push_back(link.name);
  throw Error(ErrorCode::kBadOption, "links '" + expression + "' matches no link of robot '" + robot.name +
                                         "' (the expression has to match the whole name). Its links are " + linkNames(robot) +
                                         didYouMean(expression, names));
}

std::vector<MeshUse> meshUses(const RobotDescription& robot, const Options& options) {
  const LinkChoice chosen(options.links, robot);
  std::vector<MeshUse> uses;
  for (const LinkDescription& link : robot.links) {
    if (!chosen(link.name)) continue;
    const SourceElements source = sourceElements(link, options.source);
    for (std::size_t i = 0; i < source.elements.size(); ++i) {
      const GeometryElement& element = source.elements[i];
      if (isMesh(element)) uses.push_back({link.name, static_cast<int>(i), source.visual, element, link.pose * element.origin});
    }
  }
  return uses;
}

std::vector<std::string> notesOnUses(const RobotDescription& robot, const std::vector<MeshUse>& uses, const Options& options) {
  const LinkChoice chosen(options.links, robot);
  if (!uses.empty()) return notesOnLeftOut(robot, chosen, options);
  std::ptrdiff_t visuals = 0, collisions = 0;
  for (const LinkDescription& link : robot.links) {
    if (!chosen(link.name)) continue;
    visuals += std::count_if(link.visuals.begin(), link.visuals.end(), isMesh);
    collisions += std::count_if(link.collisions.begin(), link.collisions.end(), isMesh);
  }
  const auto others = [](std::ptrdiff_t count, const std::string& kind) {
    return count == 0 ? ""
                      : "; the <" + kind + "> elements have " + std::to_string(count) + " meshes, which --source " + kind + " decomposes";
  };
  const char* const none = visuals + collisions > 0 ? "there is no mesh to decompose"
                           : options.links.empty()  ? "the robot has no meshes"
                                                    : "the chosen links have no meshes";
  return {none + std::string("; boxes, spheres and cylinders stay as they are") + others(visuals, "visual") +
          others(collisions, "collision")};
}

MeshTasks meshTasks(const std::vector<MeshUse>& uses, const UriResolver& resolve, const RunControl& control) {
  MeshTasks result;
  result.failed.resize(uses.size());
  KnownFiles files(control);
  std::map<Sameness, std::size_t> known;  // index of the task
  for (std::size_t i = 0; i < uses.size(); ++i) {
    try {
      MeshTask task = files.taskFor(uses[i].source, resolve);
      const auto [place, is_new] = known.emplace(sameness(task), result.tasks.size());
      if (is_new) result.tasks.push_back(std::move(task));
      result.tasks[place->second].uses.push_back(i);
    } catch (...) {
      MeshResult failed;
      fail(failed);
      result.failed[i] = std::make_shared<const MeshResult>(std::move(failed));
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

std::string contentOf(const MeshTask& task, const RunControl& control) {
  std::string content = readFile(task.file, "mesh", MeshLimits().max_bytes, control);
  if (sha256(content, control) == task.sha256) return content;
  throw Error(ErrorCode::kFileNotFound, "'" + task.file + "' changed while it was being read; run again when it is complete");
}

}  // namespace collision_hulls
