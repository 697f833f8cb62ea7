// Bullet's URDF importer takes the description itself, so there are only notes. It looks for each mesh, visual ones too, as a file of the
// name that it is given, without package:// or model:// before it, in the URDF's folder and those above. To it, file:// is a part of the
// name: it does not find the mesh, and refuses the whole description (UrdfFindMeshFile.h, UrdfParser.cpp).
#include <set>

#include "base/counted.h"
#include "consumers/written_model.h"

namespace collision_hulls {
namespace {

/// The meshes that are named by a file:// URI, whatever made it.
std::set<std::string> fileUris(const RobotDescription& robot) {
  std::set<std::string> uris;
  for (const LinkDescription& link : robot.links) {
    for (const auto* elements : {&link.visuals, &link.collisions})
      for (const GeometryElement& element : *elements)
        if (element.kind == GeometryElement::Kind::kMesh && element.uri.rfind("file:", 0) == 0) uris.insert(element.uri);
  }
  return uris;
}

}  // namespace

std::vector<std::string> bulletNotes(const WrittenModel& model) {
  std::vector<std::string> notes{
      "--for bullet: Bullet's URDF importer takes the description as it is, each hull as a convex shape; no other file is written"};
  const std::set<std::string> uris = fileUris(model.robot());
  if (uris.empty()) return notes;
  const Options& options = model.result().report.options;
  const bool may_be_ours = options.rebase && options.uri != UriStyle::kRelative;
  notes.push_back("--for bullet: the importer does not know file://, and refuses the description for " +
                  counted(uris.size(), "mesh", "meshes") + ", such as '" + *uris.begin() + "': " +
                  (may_be_ours ? "add --uri relative, by which --rebase names the files without it"
                               : "name the files in the input relative to its folder, and add --rebase --uri relative"));
  return notes;
}

}  // namespace collision_hulls
