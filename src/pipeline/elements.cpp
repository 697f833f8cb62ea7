// Lists the meshes of a robot and joins equal ones, so that a mesh that many links share is worked on once.
#include "pipeline/elements.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <tuple>

#include "base/nearest_name.h"
#include "collision_hulls/error.h"
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

ElementResult meshElement(const LinkDescription& link, const SourceElements& source, std::size_t index, const Options& options) {
  ElementResult result;
  result.source = source.elements[index];
  result.pose = link.pose * result.source.origin;
  result.report.link = link.name;
  result.report.element = static_cast<int>(index);
  result.report.visual = source.visual;
  result.report.uri = result.source.uri;
  result.report.scale = result.source.scale;
  result.report.method = options.method;
  return result;
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

/// Elements with equal values are the same work. The extension counts because it says how to read the content.
using Sameness = std::tuple<std::string, std::string, double, double, double>;

Sameness sameness(const ElementReport& row, const std::string& file) {
  return {row.sha256, std::filesystem::path(file).extension().string(), row.scale.x(), row.scale.y(), row.scale.z()};
}

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

RobotResult robotResult(const RobotDescription& robot, const Options& options) {
  const LinkChoice chosen(options.links, robot);
  RobotResult result;
  result.robot_name = robot.name;
  result.report.input_path = robot.path;
  result.report.input_sha256 = sha256(robot.text);
  result.report.options = options;
  for (const LinkDescription& link : robot.links) {
    if (!chosen(link.name)) continue;
    const SourceElements source = sourceElements(link, options.source);
    for (std::size_t i = 0; i < source.elements.size(); ++i) {
      if (isMesh(source.elements[i])) result.elements.push_back(meshElement(link, source, i, options));
    }
  }
  return result;
}

std::vector<std::string> notesOnElements(const RobotDescription& robot, const std::vector<ElementResult>& elements,
                                         const Options& options) {
  const LinkChoice chosen(options.links, robot);
  if (!elements.empty()) return notesOnLeftOut(robot, chosen, options);
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

std::vector<MeshTask> meshTasks(std::vector<ElementResult>& elements, const std::function<std::string(const std::string& uri)>& resolve) {
  std::vector<MeshTask> tasks;
  std::map<std::string, std::string> hashes;  // by file
  std::map<std::string, std::filesystem::file_time_type> times;
  std::map<Sameness, std::size_t> known;  // index of the task
  for (std::size_t i = 0; i < elements.size(); ++i) {
    ElementReport& row = elements[i].report;
    try {
      if (!elements[i].source.fault.empty()) throw Error(ErrorCode::kBadGeometry, elements[i].source.fault);
      const std::string file = resolve(row.uri);
      if (hashes.count(file) == 0) {
        std::error_code unreadable;  // as the next line finds, too
        times[file] = std::filesystem::last_write_time(file, unreadable);
        hashes[file] = sha256OfFile(file);
      }
      row.sha256 = hashes[file];
      const auto [place, is_new] = known.emplace(sameness(row, file), tasks.size());
      if (is_new) tasks.push_back({file, std::filesystem::file_size(file), {}, times[file]});
      tasks[place->second].elements.push_back(i);
    } catch (...) {
      fail(elements[i]);
    }
  }
  std::stable_sort(tasks.begin(), tasks.end(), [](const MeshTask& a, const MeshTask& b) { return a.bytes > b.bytes; });
  return tasks;
}

std::vector<double> expectedCosts(const std::vector<MeshTask>& tasks) {
  std::vector<double> costs;
  for (const MeshTask& task : tasks) costs.push_back(std::sqrt(static_cast<double>(task.bytes)));
  return costs;
}

void expectUnchanged(const MeshTask& task) {
  std::error_code error;
  if (std::filesystem::last_write_time(task.file, error) == task.changed && !error) return;
  throw Error(ErrorCode::kFileNotFound,
              "'" + task.file + "' changed or disappeared while it was being read; run again when it is complete");
}

void fail(ElementResult& element, const std::string& error, const std::string& reason) {
  element.hulls.clear();
  element.primitives.clear();
  element.unneeded.clear();
  ElementReport& row = element.report;
  row.status = Status::kFailed;
  row.error = error;
  row.reason = reason;
  row.hulls = row.hull_vertices = row.primitives = 0;  // nothing is written
}

void fail(ElementResult& element) {
  try {
    throw;
  } catch (const Error& e) {
    if (e.code() == ErrorCode::kCancelled) throw;
    fail(element, name(e.code()), e.what());
  } catch (const std::bad_alloc&) {
    fail(element, name(ErrorCode::kInternal),
         "out of memory for a mesh of " + std::to_string(element.report.triangles) +
             " triangles; use fewer jobs, a larger tolerance or a coarser mesh");
  } catch (const std::exception& e) {
    fail(element, name(ErrorCode::kInternal), e.what());
  }
}

}  // namespace collision_hulls
