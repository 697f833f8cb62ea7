// Bullet's URDF importer takes the description itself, so there are only notes. It looks for each mesh, visual ones too, as a file of the
// name that it is given, without package:// or model:// before it, in the folders above the URDF, and in the current one and two above
// that. So a package has to be a folder of its name there, as ROS is not asked; and file:// is to it a part of the name. For one mesh that
// it does not find it refuses the whole description (UrdfFindMeshFile.h, UrdfParser.cpp).
#include <filesystem>
#include <functional>
#include <set>

#include "base/counted.h"
#include "base/roots.h"
#include "collision_hulls/error.h"
#include "consumers/written_model.h"
#include "storage/replace_folder.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

/// The meshes of which that is so, whatever made them.
std::set<std::string> meshesThat(const RobotDescription& robot, const std::function<bool(const std::string& uri)>& is_so) {
  std::set<std::string> uris;
  for (const LinkDescription& link : robot.links) {
    for (const auto* elements : {&link.visuals, &link.collisions})
      for (const GeometryElement& element : *elements)
        if (element.kind == GeometryElement::Kind::kMesh && is_so(element.uri)) uris.insert(element.uri);
  }
  return uris;
}

bool startsWithFile(const std::string& uri) {
  return uri.rfind("file:", 0) == 0;
}

/// Whether a file may be there: a confined process does not look everywhere.
bool mayExist(const fs::path& file) try {
  checkRead(file.string());
  std::error_code error;
  return fs::exists(file, error);
} catch (const Error&) {
  return true;
}

/// Whether a mesh of another package than the output's is in no folder of its package's name above the output. The importer decodes no '%'.
bool isOutOfReach(const std::string& uri, const std::string& package, const fs::path& output) {
  const std::string scheme = "://";
  const auto named = packageOf(uri);
  if (!named || *named == package) return false;
  const std::string path = uri.substr(uri.find(scheme) + scheme.size());
  for (fs::path folder = output;; folder = folder.parent_path()) {
    if (mayExist(folder / path)) return false;
    if (!folder.has_relative_path()) return true;
  }
}

/// "refuses the description for 2 meshes, such as 'file:///robots/skin.obj'"
std::string refusesFor(const std::set<std::string>& uris) {
  return "refuses the description for " + counted(uris.size(), "mesh", "meshes") + ", such as '" + *uris.begin() + "'";
}

std::string noteOnFiles(const std::set<std::string>& uris, const Options& options) {
  const bool may_be_ours = options.rebase && options.uri != UriStyle::kRelative;
  return "--for bullet: the importer does not know file://, and " + refusesFor(uris) + ": " +
         (may_be_ours ? "add --uri relative, by which --rebase names the files without it"
                      : "name the files in the input relative to its folder, and add --rebase --uri relative");
}

std::string noteOnPackages(const std::set<std::string>& uris, const fs::path& output) {
  std::set<std::string> packages;
  for (const std::string& uri : uris) packages.insert(*packageOf(uri));
  const std::string others = packages.size() > 1 ? " and " + counted(packages.size() - 1, "more package") : "";
  return "--for bullet: the importer looks for a package as a folder of its name above the description, not where ROS has it, and " +
         refusesFor(uris) + ": link the folder of package '" + *packages.begin() + "'" + others + ", under its name, into '" +
         output.parent_path().string() + "'";
}

}  // namespace

std::vector<std::string> bulletNotes(const WrittenModel& model, const std::string& output) {
  std::vector<std::string> notes{
      "--for bullet: Bullet's URDF importer takes the description as it is, each hull as a convex shape; no other file is written"};
  const fs::path folder = replacedFolder(output);
  const std::set<std::string> files = meshesThat(model.robot(), startsWithFile);
  const std::set<std::string> elsewhere =
      meshesThat(model.robot(), [&](const std::string& uri) { return isOutOfReach(uri, model.package(), folder); });
  if (!files.empty()) notes.push_back(noteOnFiles(files, model.result().report.options));
  if (!elsewhere.empty()) notes.push_back(noteOnPackages(elsewhere, folder));
  return notes;
}

}  // namespace collision_hulls
