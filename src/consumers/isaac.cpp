// A USD layer for Isaac Sim and other readers of UsdPhysics: a prim a link, at its rest pose, and in it a mesh a hull that says how it is
// to be collided: physics:approximation = "convexHull". Without that word a mesh on a moving body gets an approximation of the reader's
// choice. Bodies and joints stay with the reader's own URDF importer: reference the prim of a link under the importer's.
//
// USD writes transforms for row vectors, the translation in the last row, and takes letters, digits and underscores alone in a prim's name.
#include <algorithm>
#include <initializer_list>

#include "collision_hulls/robot/kinematics.h"
#include "consumers/written_model.h"
#include "robot/number_text.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

std::string primName(const std::string& text) {
  std::string name = text;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')); }, '_');
  return name.empty() || (name[0] >= '0' && name[0] <= '9') ? "_" + name : name;
}

std::string tuple(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + numberText(number);
  return "(" + text + ")";
}

std::string pointText(const Eigen::Vector3d& v) {
  return tuple({v.x(), v.y(), v.z()});
}

std::string transformText(const std::string& indent, const Eigen::Isometry3d& pose) {
  std::string rows;
  for (int column = 0; column < 4; ++column)
    rows += (column ? ", " : "") + tuple({pose(0, column), pose(1, column), pose(2, column), column == 3 ? 1.0 : 0.0});
  return indent + "matrix4d xformOp:transform = (" + rows + ")\n" + indent + "uniform token[] xformOpOrder = [\"xformOp:transform\"]\n";
}

template <typename T, typename Text>
std::string list(const std::vector<T>& values, const Text& text) {
  std::string all;
  for (const T& value : values) all += (all.empty() ? "" : ", ") + text(value);
  return "[" + all + "]";
}

std::string meshText(const std::string& indent, const ConvexHull& hull) {
  const auto indices = [](const Triangle& t) { return std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " + std::to_string(t[2]); };
  return indent + "uniform token physics:approximation = \"convexHull\"\n" + indent + "uniform token subdivisionScheme = \"none\"\n" +
         indent + "point3f[] points = " + list(hull.vertices, pointText) + "\n" + indent +
         "int[] faceVertexCounts = " + list(hull.triangles, [](const Triangle&) { return std::string("3"); }) + "\n" + indent +
         "int[] faceVertexIndices = " + list(hull.triangles, indices) + "\n";
}

class UsdWriter {
 public:
  explicit UsdWriter(const WrittenModel& model) : model_(model), kinematics_(model.robot()) {}

  std::string text() {
    const std::string name = primName(model_.robot().name);
    std::string text =
        "#usda 1.0\n(\n    defaultPrim = \"" + name + "\"\n    metersPerUnit = 1\n    upAxis = \"Z\"\n)\n\ndef Xform \"" + name + "\"\n{\n";
    const std::vector<Eigen::Isometry3d> poses = kinematics_.poses(kinematics_.rest());
    for (std::size_t i = 0; i < model_.robot().links.size(); ++i) text += linkText(model_.robot().links[i], poses[i]);
    return text + "}\n";
  }

 private:
  std::string linkText(const LinkDescription& link, const Eigen::Isometry3d& pose) {
    std::string text = "    def Xform \"" + links_.take(primName(link.name)) + "\"\n    {\n" + transformText("        ", pose);
    UniqueNames names;
    for (const GeometryElement& element : link.collisions) text += elementText(element, names);
    return text + "    }\n";
  }

  /// Empty for what is no body, and for a mesh that is not of this output.
  std::string elementText(const GeometryElement& element, UniqueNames& names) const {
    const std::string indent = "            ";
    const ConvexHull* const hull = element.kind == Kind::kMesh ? model_.hullOf(element) : nullptr;
    std::string type, inside;
    switch (element.kind) {
      case Kind::kBox: type = "Cube", inside = indent + "double size = 1\n"; break;
      case Kind::kSphere: type = "Sphere", inside = indent + "double radius = " + numberText(element.size.x()) + "\n"; break;
      case Kind::kCylinder:
        type = "Cylinder", inside = indent + "uniform token axis = \"Z\"\n" + indent + "double radius = " + numberText(element.size.x()) +
                                    "\n" + indent + "double height = " + numberText(element.size.y()) + "\n";
        break;
      case Kind::kMesh:
        if (hull) type = "Mesh", inside = meshText(indent, *hull);
        break;
      case Kind::kNone: break;
    }
    if (type.empty()) return "";
    Eigen::Isometry3d pose = element.origin;
    if (element.kind == Kind::kBox) pose.linear() *= element.size.asDiagonal();  // a cube of side 1, stretched
    const std::string schemas = std::string("\"PhysicsCollisionAPI\"") + (hull ? ", \"PhysicsMeshCollisionAPI\"" : "");
    return "        def " + type + " \"" + names.take(primName(element.name)) + "\" (\n            prepend apiSchemas = [" + schemas +
           "]\n        )\n        {\n" + indent + "uniform token purpose = \"guide\"\n" + transformText(indent, pose) + inside +
           "        }\n";
  }

  const WrittenModel& model_;
  const Kinematics kinematics_;
  UniqueNames links_;
};

}  // namespace

ConsumerFiles isaacFiles(const WrittenModel& model) {
  return {{"usd/" + robotFileName(model.robot().name) + ".usda", UsdWriter(model).text()}};
}

std::vector<std::string> isaacNotes(const WrittenModel& model) {
  std::vector<std::string> notes;
  noteLeftOut(model, "isaac", "the reader would choose an approximation of it", notes);
  return notes;
}

}  // namespace collision_hulls
