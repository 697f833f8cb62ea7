// Turns hulls into a robot's collision model. The description's text is rewritten in its <collision> elements alone (src/robot does that);
// here is decided which links change, what their new elements are called, and where their files go.
#include "pipeline/collision_model.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "base/counted.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/pipeline/fit_scene.h"
#include "pipeline/earlier_output.h"
#include "pipeline/package/rebase.h"
#include "pipeline/run.h"
#include "report/earlier_report.h"
#include "robot/contact_sensors.h"
#include "storage/names.h"
#include "storage/replace_folder.h"
#include "xml/xml_spans.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostLinks = 5;  // in a note

/// A mesh with new hulls: its files, and the primitives in place of others.
struct Model {
  const std::vector<std::string>& files;
  const ElementResult& element;
};

/// The meshes of a link by their index among its source elements.
using LinkModels = std::map<int, Model>;

std::string uriPrefix(const Options& options, const std::string& output) {
  switch (options.uri) {
    case UriStyle::kPackage: return "package://" + outputPackage(options, output) + "/";
    case UriStyle::kFile: return fileUri(replacedFolder(output).string()) + "/";  // where links lead now
    case UriStyle::kRelative: return "../";                                       // the description lies in urdf/
  }
  return "";
}

/// A collision element keeps its name, with a number for each hull.
std::string baseName(const std::string& link, int index, const SourceElements& source) {
  const std::string& given = source.elements[static_cast<std::size_t>(index)].name;
  return source.visual || given.empty() ? link + "_" + std::to_string(index) : given;
}

/// Names of <collision> elements, with their links.
using ElementNames = std::set<std::pair<std::string, std::string>>;

/// Adds the primitives that stand in place of hulls to `in_place`.
LinkCollisions linkCollisions(const std::string& link, const SourceElements& source, const LinkModels& models, const std::string& prefix,
                              UniqueNames& names, ElementNames& in_place) {
  LinkCollisions result;
  result.keep_primitives = !source.visual;
  for (std::size_t i = 0; i < source.elements.size(); ++i) {
    const int index = static_cast<int>(i);
    const std::string base = baseName(link, index, source);
    const auto model = models.find(index);
    if (model == models.end()) {
      if (source.visual && isSolidPrimitive(source.elements[i])) result.elements.push_back({names.take(base), source.elements[i]});
      continue;
    }
    const auto& [files, mesh] = model->second;
    for (std::size_t m = 0; m < files.size(); ++m) {
      GeometryElement hull;
      hull.uri = prefix + files[m];
      hull.origin = source.elements[i].origin;
      result.elements.push_back({names.take(base + "_" + std::to_string(m)), hull});
    }
    for (std::size_t k = 0; k < mesh.primitives.size(); ++k) {
      GeometryElement primitive = mesh.primitives[k];
      primitive.origin = source.elements[i].origin * primitive.origin;
      const bool alone = mesh.hulls.size() == 1;
      const std::string name = names.take(alone ? base : base + "_" + std::to_string(files.size() + k));
      result.elements.push_back({name, primitive});
      in_place.emplace(link, name);
    }
  }
  return result;
}

std::set<std::string> failedLinks(const ModelReport& report) {
  std::set<std::string> failed;
  for (const ElementReport& row : report.links)
    if (row.status == Status::kFailed) failed.insert(row.link);
  return failed;
}

using NewCollisions = std::map<std::string, LinkCollisions>;

/// The links that get new <collision> elements, or lose theirs: not those with a failed mesh, which keep what they have. Those that have
/// nothing get the hulls of their other meshes.
NewCollisions newCollisions(const RobotDescription& robot, const LinkDecisions& decisions, const ModelReport& report,
                            const std::vector<ElementResult>& elements, const std::string& prefix, ElementNames& in_place) {
  std::map<std::string, LinkModels> models;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const ElementReport& row = report.links[i];
    models[row.link].emplace(row.element, Model{row.files, elements[i]});
  }
  const std::set<std::string> failed = failedLinks(report);
  UniqueNames names;
  NewCollisions links;
  for (const LinkDescription& link : robot.links) {
    const LinkOptions* const options = decisions.of(link.name);
    const CollisionFate fate = collisionFate(link, options, failed.count(link.name) > 0);
    if (fate == CollisionFate::kStay) continue;
    LinkCollisions& collisions = links[link.name];
    if (fate == CollisionFate::kReplaced)
      collisions = linkCollisions(link.name, sourceElements(link, options->source), models[link.name], prefix, names, in_place);
  }
  return links;
}

/// The links that have new elements in every model.
std::set<std::string> replacedLinks(const std::vector<NewCollisions>& models) {
  std::set<std::string> replaced;
  for (const auto& [link, by] : models.front()) {
    if (std::all_of(models.begin(), models.end(), [&name = link](const NewCollisions& model) { return model.count(name) > 0; }))
      replaced.insert(link);
  }
  return replaced;
}

/// The hulls of earlier outputs that stay in use come along; their URIs lead to their new place.
std::map<std::string, std::string> carryHulls(const RobotDescription& robot, const std::vector<NewCollisions>& models,
                                              const PackageFinder& find_package, const std::string& output, const std::string& prefix,
                                              RobotResult& result, const RunControl& control) {
  std::vector<std::string> taken;
  for (std::size_t model = 0; model < models.size(); ++model) {
    for (const ElementReport& row : reportOf(model, result.report).links) taken.insert(taken.end(), row.files.begin(), row.files.end());
  }
  KeptHulls kept = keptHulls(robot, replacedLinks(models), taken, output, find_package, control);
  result.kept_files = std::move(kept.contents);
  std::map<std::string, std::string> moved;
  for (const auto& [uri, place] : kept.places) moved[uri] = prefix + place;
  return moved;
}

std::vector<std::string> notesOnCarried(const RobotResult& result) {
  if (result.kept_files.empty()) return {};
  return {counted(result.kept_files.size(), "hull") + " of an earlier run that the description keeps " +
          (result.kept_files.size() == 1 ? "was" : "were") + " copied into the output, such as '" + result.kept_files.begin()->first + "'"};
}

/// "link 'a' has", or "links a, b, c, d, e and 2 more have"; `one` and `more` are the verbs.
std::string linksThat(const std::vector<std::string>& links, const std::string& one, const std::string& more) {
  if (links.size() == 1) return "link '" + links.front() + "' " + one;
  return "links " + listedFirst(links, kMostLinks) + " " + more;
}

std::string noteOnBareFailed(const std::vector<std::string>& links, bool has_others) {
  const bool one = links.size() == 1;
  return linksThat(links, "has", "have") + " no <collision> elements to keep in place of " + (one ? "a mesh" : "meshes") +
         " that failed: " +
         (has_others ? "only " + std::string(one ? "its" : "their") + " other elements collide" : "nothing collides there") +
         "; mend the " + (one ? "mesh, or add a <collision> element" : "meshes, or add <collision> elements");
}

std::string noteOnUnusedHulls(const std::vector<std::string>& links) {
  const std::string its = links.size() == 1 ? "its" : "their";
  return linksThat(links, "keeps", "keep") + " " + its + " collision elements because " +
         (links.size() == 1 ? "one of its meshes" : "a mesh of each") + " failed; hulls of " + its +
         " other meshes are written, but not used";
}

/// On links with a mesh that failed: hulls that are written though no element of the description names them, and links without other
/// elements to keep.
std::vector<std::string> notesOnFailed(const RobotDescription& robot, const RobotResult& result) {
  if (allFailed(result.report)) return {};  // nothing is written
  const std::set<std::string> failed = failedLinks(result.report);
  std::set<std::string> have_others;
  for (const ElementResult& element : result.elements)
    if (!element.hulls.empty()) have_others.insert(element.link);
  std::vector<std::string> bare, partly_bare, keeping;
  for (const LinkDescription& link : robot.links) {
    if (!failed.count(link.name)) continue;
    const bool is_bare = link.collisions.empty();  // so its visual primitives become collision elements
    const bool has_others =
        have_others.count(link.name) > 0 || (is_bare && std::any_of(link.visuals.begin(), link.visuals.end(), isSolidPrimitive));
    if (is_bare) (has_others ? partly_bare : bare).push_back(shortened(link.name));
    if (!is_bare && has_others) keeping.push_back(shortened(link.name));
  }
  std::vector<std::string> notes;
  if (!bare.empty()) notes.push_back(noteOnBareFailed(bare, false));
  if (!partly_bare.empty()) notes.push_back(noteOnBareFailed(partly_bare, true));
  if (!keeping.empty()) notes.push_back(noteOnUnusedHulls(keeping));
  return notes;
}

/// On hulls that were decomposed as if they were the robot. Where a text came without its file, or with another one, the places of its
/// meshes tell.
std::vector<std::string> notesOnAgain(const RobotDescription& robot, const Report& report, const PackageFinder& find_package,
                                      const std::string& output, const RunControl& control) {
  std::set<std::string> uris;
  for (const ElementReport& row : report.links)
    if (!row.visual && (row.status == Status::kOk || row.status == Status::kDegraded)) uris.insert(row.uri);
  if (uris.empty()) return {};
  std::string earlier;
  if (!robot.path.empty() && earlierSource(std::filesystem::path(robot.path).parent_path().parent_path(), control))
    earlier = "'" + robot.path + "' is";
  else if (const std::string folder = outputWithOneOf(uris, robot, output, find_package, control); !folder.empty())
    earlier = "the description has <collision> meshes in '" + folder + "',";
  if (earlier.empty()) return {};
  return {earlier + " the output of an earlier run: bounds are measured from its hulls, not from the meshes that these stand for; " +
          "decompose the description that it was made from"};
}

std::string newDescription(const RobotResult& result, const std::string& output) {
  return (replacedFolder(output) / urdfFile(result.robot_name)).string();
}

/// Whether a mesh of the input is where its URI says.
bool leadsSomewhere(const std::string& uri, const RobotDescription& robot, const PackageFinder& find_package) try {
  return !resolveUri(uri, robot.path, find_package).empty();
} catch (const Error&) {
  return false;
}

/// On meshes that the new description still names relative to the old one's folder; `rebased`: URIs that are relative to the new one's.
std::vector<std::string> notesOnRewritten(const RobotDescription& robot, const PackageFinder& find_package, const RobotResult& result,
                                          const std::string& output, const std::set<std::string>& rebased, const RunControl& control) {
  if (allFailed(result.report)) return {};  // nothing is written
  const Options& options = result.report.options;
  const std::string prefix = uriPrefix(options, output);
  std::set<std::string> hulls = rebased, kept, lost;
  for (const auto& [file, content] : result.kept_files) hulls.insert(prefix + file);
  for (const ElementReport& row : result.report.links) {
    for (const std::string& file : row.files) hulls.insert(prefix + file);
  }
  for (const LinkDescription& link : parseRobotDescription(result.urdf, "", control).links) {
    for (const auto* elements : {&link.visuals, &link.collisions}) {
      for (const GeometryElement& element : *elements) {
        if (element.kind == GeometryElement::Kind::kMesh && element.fault.empty() && !element.uri.empty() && isRelativeUri(element.uri) &&
            !hulls.count(element.uri))
          kept.insert(element.uri);
      }
    }
  }
  for (auto uri = kept.begin(); uri != kept.end();) {
    control.check();
    const auto next = std::next(uri);
    if (options.rebase || !leadsSomewhere(*uri, robot, find_package)) lost.insert(kept.extract(uri));
    uri = next;
  }
  std::vector<std::string> notes;
  const auto note = [&](const std::set<std::string>& uris, const std::string& what) {
    if (uris.empty()) return;
    notes.push_back(counted(uris.size(), "mesh URI") + (uris.size() == 1 ? " is" : " are") +
                    " relative to the folder of the input, such as '" + *uris.begin() + "', and " + what);
  };
  note(kept, "will not be found from '" + newDescription(result, output) + "': add --rebase");
  note(lost, "stayed so, as no file that may be read was found there: correct the input");
  return notes;
}

/// The URIs of all meshes.
std::set<std::string> meshUris(const RobotDescription& robot) {
  std::set<std::string> uris;
  for (const LinkDescription& link : robot.links)
    for (const auto* elements : {&link.visuals, &link.collisions})
      for (const GeometryElement& element : *elements)
        if (element.kind == GeometryElement::Kind::kMesh) uris.insert(element.uri);
  return uris;
}

/// On meshes that the new description still names by a package that was not found, though a folder stood in for it here.
std::vector<std::string> notesOnStandIns(const RobotDescription& robot, const PackageFinder& find_package, const RobotResult& result,
                                         const RunControl& control) {
  if (result.report.options.rebase || allFailed(result.report)) return {};
  std::set<std::string> kept = meshUris(parseRobotDescription(result.urdf, "", control));
  const std::set<std::string> given = meshUris(robot);
  for (auto uri = kept.begin(); uri != kept.end();)
    uri = given.count(*uri) > 0 && leadsToStandIn(*uri, robot.path, find_package) ? std::next(uri) : kept.erase(uri);
  if (kept.empty()) return {};
  return {counted(kept.size(), "mesh URI") + " of the new description " + (kept.size() == 1 ? "names" : "name") +
          " a package that was not found, such as '" + *kept.begin() +
          "', and viewers will not find it either: add --rebase for names that lead to the files"};
}

/// On what Gazebo called the collision of a link, where hulls with other names have taken its place.
std::vector<std::string> notesOnContacts(const RobotResult& result) {
  std::set<std::string> replaced;
  for (const ElementReport& row : result.report.links)
    if (!row.files.empty()) replaced.insert(row.link);
  std::string note;
  std::size_t more = 0;
  for (const std::string& name : unnamedContacts(result.urdf)) {
    const std::vector<std::string> links = linksOfCollision(name);
    const auto link = std::find_if(links.begin(), links.end(), [&](const std::string& one) { return replaced.count(one) > 0; });
    if (link == links.end()) continue;
    if (!note.empty())
      ++more;
    else
      note = "a <gazebo> element names the collision '" + name +
             "', which hulls have replaced, so its contact sensor would find nothing: name the hulls' collisions of link '" + *link +
             "' there";
  }
  if (note.empty()) return {};
  return {note + (more > 0 ? "; " + counted(more, "other collision is", "other collisions are") + " like it" : "")};
}

/// MuJoCo reads URDF, and looks for meshes by their bare names in one folder, where those of hulls are alike, unless it is told not to.
std::vector<std::string> notesOnMujoco(const RobotResult& result) {
  bool is_for_mujoco = false;
  for (const XmlElement& element : scanXml(result.urdf).elements) {
    is_for_mujoco = is_for_mujoco || element.name == "mujoco";
    const auto strips = element.name == "compiler" ? attributeValue(result.urdf, element, "strippath") : std::nullopt;
    if (strips && result.urdf.compare(strips->begin, strips->end - strips->begin, "false") == 0) return {};
  }
  const bool has_hulls = std::any_of(result.report.links.begin(), result.report.links.end(), [](const auto& row) { return row.hulls > 0; });
  if (!is_for_mujoco || !has_hulls) return {};
  return {
      "the description has a <mujoco> element, but MuJoCo does not find the hulls of a URDF: --for mujoco writes a model that it loads, "
      "without the settings of that element"};
}

/// The surface of a mesh, for a page: empty where it cannot be read. `base`: the file that its URI is in.
TriangleMesh surfaceOf(const GeometryElement& mesh, const std::string& base, const PackageFinder& find_package, const Options& options,
                       const RunControl& control) {
  try {
    const std::string file = resolveUri(mesh.uri, base, find_package);
    return scaled(readMesh(file, meshLimits(options), control).mesh, mesh.scale);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::kCancelled) throw;
    return {};
  }
}

/// The primitives that stay, and the meshes of links that are kept.
std::vector<KeptElement> keptElements(const std::string& base, const PackageFinder& find_package, const ModelReport& report,
                                      const ModelResult& model, const ElementNames& in_place, const Options& options,
                                      const RunControl& control) {
  std::set<std::string> kept_links;
  for (const ElementReport& row : report.links)
    if (row.status == Status::kKept) kept_links.insert(row.link);
  std::vector<KeptElement> kept;
  for (const LinkDescription& link : parseRobotDescription(model.urdf, "", control).links) {
    for (const GeometryElement& element : link.collisions) {
      const bool is_mesh = element.kind == GeometryElement::Kind::kMesh, is_empty = element.kind == GeometryElement::Kind::kNone;
      if (is_mesh ? !kept_links.count(link.name) : is_empty || in_place.count({link.name, element.name})) continue;
      kept.push_back({element, {}, link.pose * element.origin});
      if (is_mesh) kept.back().surface = surfaceOf(element, base, find_package, options, control);
    }
  }
  return kept;
}

}  // namespace

std::string outputPackage(const Options& options, const std::string& output) {
  if (!options.package_name.empty()) return options.package_name;
  std::filesystem::path folder = std::filesystem::absolute(output).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  return packageName(folder.filename().string());
}

std::string placeOfUris(const Options& options, const std::string& output) {
  return options.uri == UriStyle::kPackage ? outputPackage(options, output) : replacedFolder(output).string();
}

std::string urdfFile(const std::string& robot_name, const std::string& model) {
  return "urdf/" + robotFileName(robot_name) + (model.empty() ? "" : "_" + model) + ".urdf";
}

void rewriteDescription(const RobotDescription& robot, const std::vector<LinkDecisions>& decisions, const PackageFinder& find_package,
                        const std::string& output, const std::vector<std::string>& notes, RobotResult& result, const RunControl& control) {
  const Options& options = result.report.options;
  const std::string prefix = uriPrefix(options, output);
  result.place = placeOfUris(options, output);
  std::vector<NewCollisions> links;
  std::vector<ElementNames> in_place(decisions.size());
  for (std::size_t model = 0; model < decisions.size(); ++model) {
    const std::vector<ElementResult>& elements = modelOf(model, result).elements;
    links.push_back(newCollisions(robot, decisions[model], reportOf(model, result.report), elements, prefix, in_place[model]));
  }
  const std::map<std::string, std::string> moved = carryHulls(robot, links, find_package, output, prefix, result, control);
  const RebasedDescription source = rebased(robot, find_package, options, newDescription(result, output), moved, control);
  for (std::size_t model = 0; model < links.size(); ++model)
    modelOf(model, result).urdf = rewriteCollisions(source.robot, links[model], moved, control);
  for (std::size_t model = 0; options.html && model < links.size(); ++model) {
    ModelResult& of = modelOf(model, result);
    of.kept = keptElements(source.base, find_package, reportOf(model, result.report), of, in_place[model], options, control);
  }
  std::vector<std::string>& all = result.report.notes;
  for (const auto& more :
       {robot.notes, find_package.notes(), notesOnUses(robot, decisions.front(), options), notesOnBare(robot, decisions.front()),
        notesOnFlat(robot, decisions.front()), notesOnIdle(robot, decisions.front(), options, control), notes,
        notesOnAgain(robot, result.report, find_package, output, control), notesOnFailed(robot, result), notesOnCarried(result),
        notesOnRewritten(robot, find_package, result, output, source.uris, control), notesOnStandIns(robot, find_package, result, control),
        notesOnContacts(result), notesOnMujoco(result)})
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace collision_hulls
