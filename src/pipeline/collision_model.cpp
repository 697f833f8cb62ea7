#include "pipeline/collision_model.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "pipeline/elements.h"
#include "pipeline/names.h"

namespace collision_hulls {
namespace {

/// The elements of a link by their index among its source elements.
using LinkElements = std::map<int, const ElementResult*>;

std::string uriPrefix(const std::string& robot_name, UriStyle style, const std::string& output) {
  switch (style) {
    case UriStyle::kPackage: return "package://" + outputPackage(robot_name) + "/";
    case UriStyle::kFile: return fileUri(std::filesystem::absolute(output).lexically_normal().string()) + "/";
    case UriStyle::kRelative: return "../";  // the description lies in urdf/
  }
  return "";
}

/// A collision element keeps its name, with a number for each hull.
std::string baseName(const std::string& link, int index, const SourceElements& source) {
  const std::string& given = source.elements[static_cast<std::size_t>(index)].name;
  return source.visual || given.empty() ? link + "_" + std::to_string(index) : given;
}

LinkCollisions linkCollisions(const std::string& link, const SourceElements& source, const LinkElements& meshes, const std::string& prefix,
                              UniqueNames& names) {
  LinkCollisions result;
  result.keep_primitives = !source.visual;
  for (std::size_t i = 0; i < source.elements.size(); ++i) {
    const int index = static_cast<int>(i);
    const std::string base = baseName(link, index, source);
    const auto mesh = meshes.find(index);
    if (mesh == meshes.end()) {
      const bool is_primitive = source.elements[i].kind != GeometryElement::Kind::kNone;
      if (source.visual && is_primitive) result.elements.push_back({names.take(base), source.elements[i]});
      continue;
    }
    const std::vector<std::string>& files = mesh->second->report.files;
    for (std::size_t m = 0; m < files.size(); ++m) {
      GeometryElement hull;
      hull.uri = prefix + files[m];
      hull.origin = source.elements[i].origin;
      result.elements.push_back({names.take(base + "_" + std::to_string(m)), hull});
    }
    for (std::size_t k = 0; k < mesh->second->primitives.size(); ++k) {
      GeometryElement primitive = mesh->second->primitives[k];
      primitive.origin = source.elements[i].origin * primitive.origin;
      const bool alone = mesh->second->hulls.size() == 1;
      result.elements.push_back({names.take(alone ? base : base + "_" + std::to_string(files.size() + k)), primitive});
    }
  }
  return result;
}

/// A link with a failed mesh keeps what it has.
std::string rewrittenDescription(const RobotDescription& robot, const RobotResult& result, const std::string& output) {
  const Options& options = result.report.options;
  std::map<std::string, LinkElements> meshes;
  std::set<std::string> failed;
  for (const ElementResult& element : result.elements) {
    meshes[element.report.link][element.report.element] = &element;
    if (element.report.status == Status::kFailed) failed.insert(element.report.link);
  }

  const std::string prefix = uriPrefix(robot.name, options.uri, output);
  const LinkChoice chosen(options.links, robot);
  UniqueNames names;
  std::map<std::string, LinkCollisions> links;
  for (const LinkDescription& link : robot.links) {
    const SourceElements source = sourceElements(link, options.source);
    const bool has_new_ones = meshes.count(link.name) || (source.visual && !source.elements.empty());
    if (!has_new_ones || !chosen(link.name) || failed.count(link.name)) continue;
    links[link.name] = linkCollisions(link.name, source, meshes[link.name], prefix, names);
  }
  return rewriteCollisions(robot, links);
}

/// On links whose hulls are written though the description does not name them.
std::vector<std::string> notesOnKept(const RobotResult& result) {
  std::set<std::string> failed, kept;
  for (const ElementResult& element : result.elements)
    if (element.report.status == Status::kFailed) failed.insert(element.report.link);
  for (const ElementResult& element : result.elements)
    if (!element.hulls.empty() && failed.count(element.report.link)) kept.insert(element.report.link);
  std::vector<std::string> notes;
  for (const std::string& link : kept)
    notes.push_back("link '" + link + "' keeps its collision elements, as a mesh of it failed; the hulls of its other meshes are written");
  return notes;
}

/// On meshes that the new description still names relative to the old one's place.
std::vector<std::string> notesOnRewritten(const RobotResult& result, const std::string& output) {
  const std::string prefix = uriPrefix(result.robot_name, result.report.options.uri, output);
  std::set<std::string> hulls, kept;
  for (const ElementResult& element : result.elements) {
    for (const std::string& file : element.report.files) hulls.insert(prefix + file);
  }
  for (const LinkDescription& link : parseRobotDescription(result.urdf).links) {
    for (const auto* elements : {&link.visuals, &link.collisions}) {
      for (const GeometryElement& element : *elements) {
        if (element.kind == GeometryElement::Kind::kMesh && element.fault.empty() && isRelativeUri(element.uri) &&
            !hulls.count(element.uri))
          kept.insert(element.uri);
      }
    }
  }
  if (kept.empty()) return {};
  return {std::to_string(kept.size()) + " mesh URIs are relative to the folder of the description that was read, such as '" +
          *kept.begin() + "'; they stay as written and mean other places from '" +
          (std::filesystem::path(output) / urdfFile(result.robot_name)).string() +
          "'. Use package:// URIs in the description, or copy the new one beside the old one (its hulls by --uri package or file)"};
}

void nameHullFiles(RobotResult& result) {
  const std::string suffix = extension(result.report.options.format);
  UniqueNames names;
  std::map<std::string, std::string> folders;
  for (ElementResult& element : result.elements) {
    ElementReport& row = element.report;
    std::string stem = "hull_";
    if (!result.single_mesh) {
      std::string& folder = folders[row.link];
      if (folder.empty()) folder = names.take(fileName(row.link));
      stem = "meshes/" + folder + "/" + std::to_string(row.element) + "_";
    } else if (!element.hulls.empty()) {
      row.files.push_back(fileName(result.robot_name) + "_hulls.obj");
    }
    for (std::size_t m = 0; m + element.primitives.size() < element.hulls.size(); ++m)
      row.files.push_back(stem + std::to_string(m) + suffix);
  }
}

/// Meshes in millimetres are taken to be in metres where nothing says otherwise.
void noteHugeMeshes(Report& report) {
  constexpr double kHuge = 20;  // [m]
  const auto is_huge = [](const ElementReport& row) { return row.status != Status::kFailed && row.diagonal > kHuge; };
  const auto first = std::find_if(report.links.begin(), report.links.end(), is_huge);
  if (first == report.links.end()) return;
  const auto others = std::count_if(first, report.links.end(), is_huge) - 1;
  report.notes.push_back("'" + first->uri + "' is " + std::to_string(std::lround(first->diagonal)) + " m across" +
                         (others > 0 ? ", and " + std::to_string(others) + " others are over 20 m" : "") +
                         ": if its numbers are millimetres, scale it by 0.001 (scale=\"0.001 0.001 0.001\" in a description)");
}

}  // namespace

void reportElements(RobotResult& result) {
  nameHullFiles(result);
  for (const ElementResult& element : result.elements) result.report.links.push_back(element.report);
  noteHugeMeshes(result.report);
}

std::string outputPackage(const std::string& robot_name) {
  return packageName(robot_name) + "_collision";
}

std::string urdfFile(const std::string& robot_name) {
  return "urdf/" + fileName(robot_name) + ".urdf";
}

void rewriteDescription(const RobotDescription& robot, const std::string& output, const std::vector<std::string>& notes,
                        RobotResult& result) {
  result.urdf = rewrittenDescription(robot, result, output);
  std::vector<std::string>& all = result.report.notes;
  for (const auto& more : {robot.notes, notesOnElements(robot, result.elements, result.report.options), notes, notesOnKept(result),
                           notesOnRewritten(result, output)})
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace collision_hulls
