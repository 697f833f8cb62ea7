// Draws robots for rviz. Each link has a hue, each of its hulls a shade of it. The original is drawn a hair inside its surface, so that it
// shows through translucent hulls without flickering where faces coincide. Sizes of texts and arrows follow the robot's own size.
#include "markers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {
namespace {

using visualization_msgs::Marker;

constexpr double kInset = 2e-4;         // of a mesh's diagonal: how far inside the original is drawn
constexpr double kTextHeight = 0.035;   // of the robot's radius
constexpr double kLineSpacing = 1.7;    // of labels, in their height
constexpr double kColumn = 0.75;        // of the robot's radius: from its middle to the labels
constexpr double kArrowLength = 0.16;   // of the robot's radius
constexpr double kSceneOpacity = 0.45;  // the robot is behind the scene from somewhere
constexpr std::size_t kMostSceneTriangles = 1'000'000;

geometry_msgs::Point toPoint(const Eigen::Vector3d& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

geometry_msgs::Pose toPose(const Eigen::Isometry3d& transform) {
  const Eigen::Quaterniond rotation(transform.rotation());
  geometry_msgs::Pose pose;
  pose.position = toPoint(transform.translation());
  pose.orientation.x = rotation.x();
  pose.orientation.y = rotation.y();
  pose.orientation.z = rotation.z();
  pose.orientation.w = rotation.w();
  return pose;
}

geometry_msgs::Vector3 toScale(const Eigen::Vector3d& v) {
  geometry_msgs::Vector3 scale;
  scale.x = v.x();
  scale.y = v.y();
  scale.z = v.z();
  return scale;
}

std_msgs::ColorRGBA colour(double r, double g, double b, double a) {
  std_msgs::ColorRGBA result;
  result.r = static_cast<float>(r);
  result.g = static_cast<float>(g);
  result.b = static_cast<float>(b);
  result.a = static_cast<float>(a);
  return result;
}

/// Hue, saturation and value, each in [0, 1].
std_msgs::ColorRGBA fromHsv(double hue, double saturation, double value, double opacity) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + 6.0 * hue, 6.0);
    return value - value * saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  };
  return colour(channel(5), channel(3), channel(1), opacity);
}

std_msgs::ColorRGBA originalColour() {
  return colour(0.85, 0.85, 0.86, 1);
}

/// The text of a length: "4.8 mm", three digits at most.
std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g mm", 1000 * metres);
  return text;
}

std::string count(std::size_t number, const std::string& thing) {
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

/// Appends markers and numbers those of a namespace from 0.
class Pen {
 public:
  Marker& add(MarkerList& list, const std::string& kind, const std::string& link, int type, const Eigen::Isometry3d& pose) {
    Marker marker;
    marker.header.frame_id = link;
    marker.ns = kind + "/" + link;
    marker.id = next_id_[marker.ns]++;
    marker.type = type;
    marker.action = Marker::ADD;
    marker.pose = toPose(pose);
    marker.scale = toScale(Eigen::Vector3d::Ones());
    marker.frame_locked = true;
    list.push_back(marker);
    return list.back();
  }

 private:
  std::map<std::string, int> next_id_;
};

void addTriangles(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles, Marker& marker) {
  marker.points.reserve(marker.points.size() + 3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    for (const int corner : triangle) marker.points.push_back(toPoint(vertices[static_cast<std::size_t>(corner)]));
  }
}

/// Triangles moved inward, each along its own normal: the gaps between them are too narrow to be seen.
void addInset(const TriangleMesh& mesh, Marker& marker) {
  const double inset = kInset * diagonal(mesh);
  marker.points.reserve(3 * mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3d &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    const Eigen::Vector3d normal = (b - a).cross(c - a).stableNormalized();
    for (const Eigen::Vector3d* corner : {&a, &b, &c}) marker.points.push_back(toPoint(*corner - inset * normal));
  }
}

bool isPrimitive(const GeometryElement& element) {
  return element.fault.empty() && element.kind != GeometryElement::Kind::kMesh && element.kind != GeometryElement::Kind::kNone;
}

/// A primitive of a description as the marker of its kind.
Marker& addPrimitive(const GeometryElement& element, const std::string& kind, const std::string& link, Pen& pen, MarkerList& list) {
  using Kind = GeometryElement::Kind;
  const int type = element.kind == Kind::kBox ? Marker::CUBE : element.kind == Kind::kSphere ? Marker::SPHERE : Marker::CYLINDER;
  Marker& marker = pen.add(list, kind, link, type, element.origin);
  const double diameter = 2 * element.size.x();
  if (element.kind == Kind::kBox) marker.scale = toScale(element.size);
  if (element.kind == Kind::kSphere) marker.scale = toScale({diameter, diameter, diameter});
  if (element.kind == Kind::kCylinder) marker.scale = toScale({diameter, diameter, element.size.y()});
  return marker;
}

Marker& addText(const std::string& text, double height, const std::string& kind, const std::string& link, const Eigen::Isometry3d& pose,
                Pen& pen, MarkerList& list) {
  Marker& marker = pen.add(list, kind, link, Marker::TEXT_VIEW_FACING, pose);
  marker.scale = toScale({0, 0, height});
  marker.color = colour(0.05, 0.05, 0.1, 1);
  marker.text = text;
  return marker;
}

RobotBounds toBounds(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) return {Eigen::Vector3d::Zero(), 0.5, 0.5};
  constexpr double kLeast = 1e-3;  // [m], of a robot that is a point
  return {box.center(), std::max(0.5 * box.diagonal().norm(), kLeast), box.max().z()};
}

/// The box about a primitive, in its own frame.
Eigen::AlignedBox3d localBox(const GeometryElement& element) {
  using Kind = GeometryElement::Kind;
  const double r = element.size.x();
  Eigen::Vector3d half = 0.5 * element.size;
  if (element.kind == Kind::kSphere) half = {r, r, r};
  if (element.kind == Kind::kCylinder) half = {r, r, 0.5 * element.size.y()};
  return {-half, half};
}

/// The box of a mesh or a primitive, in its own frame; its origin alone where the mesh cannot be read.
Eigen::AlignedBox3d readBox(const GeometryElement& element, const MeshFile& file) {
  const Eigen::AlignedBox3d point(Eigen::Vector3d::Zero());
  if (isPrimitive(element)) return localBox(element);
  if (element.kind == GeometryElement::Kind::kNone || !element.fault.empty()) return point;
  try {
    return boundingBox(scaled(readMesh(file(element.uri)).mesh, element.scale));
  } catch (const Error&) {
    return point;  // the run itself reports what is wrong with the mesh
  }
}

Eigen::AlignedBox3d moved(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& pose) {
  Eigen::AlignedBox3d result;
  if (box.isEmpty()) return result;
  for (int corner = 0; corner < 8; ++corner) result.extend(pose * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  return result;
}

/// The box of an element's original in the root link's frame.
Eigen::AlignedBox3d rootBox(const ElementResult& element) {
  return moved(boundingBox(element.original), element.pose);
}

RobotBounds bounds(const RobotResult& result) {
  Eigen::AlignedBox3d box;
  for (const ElementResult& element : result.elements) box.extend(rootBox(element));
  return toBounds(box);
}

/// What a link is drawn from. `elements` is in the order of the result.
struct Link {
  std::string name;
  double hue = 0;
  std::vector<const ElementResult*> elements;
  std::size_t hulls = 0, primitives = 0;
};

/// The links of a result that have something to draw, with the hues of their order in the description.
std::vector<Link> linksOf(const RobotResult& result, const RobotDescription& rewritten) {
  std::vector<Link> links;
  for (const LinkDescription& description : rewritten.links) {
    Link link{description.name, linkHue(links.size()), {}, 0, 0};
    for (const ElementResult& element : result.elements) {
      if (element.report.link == link.name) link.elements.push_back(&element);
    }
    const bool has_primitives = std::any_of(description.collisions.begin(), description.collisions.end(), isPrimitive);
    if (!link.elements.empty() || has_primitives) links.push_back(std::move(link));
  }
  return links;
}

/// The hulls that a primitive does not stand in for.
void drawHulls(Link& link, double opacity, Pen& pen, MarkerList& list) {
  for (const ElementResult* element : link.elements) {
    for (std::size_t i = 0; i + element->primitives.size() < element->hulls.size(); ++i) {
      const ConvexHull& hull = element->hulls[i];
      Marker& marker = pen.add(list, "hulls", link.name, Marker::TRIANGLE_LIST, element->source.origin);
      addTriangles(hull.vertices, hull.triangles, marker);
      marker.color = shade(link.hue, link.hulls++, opacity);
    }
  }
}

void drawUnneeded(const Link& link, Pen& pen, MarkerList& list) {
  for (const ElementResult* element : link.elements) {
    for (const ConvexHull& hull : element->unneeded) {
      Marker& marker = pen.add(list, "unneeded", link.name, Marker::TRIANGLE_LIST, element->source.origin);
      addTriangles(hull.vertices, hull.triangles, marker);
      marker.color = colour(0.5, 0.5, 0.5, 0.35);
    }
  }
}

void drawPrimitives(Link& link, const LinkDescription& description, double opacity, Pen& pen, MarkerList& list) {
  for (const GeometryElement& element : description.collisions) {
    if (!isPrimitive(element)) continue;
    addPrimitive(element, "primitives", link.name, pen, list).color = shade(link.hue, link.hulls + link.primitives++, opacity);
  }
}

void drawOriginals(const Link& link, Pen& pen, MarkerList& list) {
  for (const ElementResult* element : link.elements) {
    if (element->original.triangles.empty()) continue;
    Marker& marker = pen.add(list, "original", link.name, Marker::TRIANGLE_LIST, element->source.origin);
    addInset(element->original, marker);
    marker.color = originalColour();
  }
}

/// Whether an arrow that ends at `tip` would be in the open, with its text. All in the root link's frame.
bool isInTheOpen(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction, double length, const std::vector<ConvexHull>& hulls) {
  for (const double share : {0.4, 0.7, 1.0, 1.25}) {
    const Eigen::Vector3d p = tip + share * length * direction;
    if (std::any_of(hulls.begin(), hulls.end(), [&](const ConvexHull& hull) { return planeDistance(hull, p) < 0; })) return false;
  }
  return true;
}

/// Where an arrow to `tip` comes from: as near to `outward` as is in the open; `outward` where nothing is.
Eigen::Vector3d openDirection(const Eigen::Vector3d& tip, const Eigen::Vector3d& outward, double length,
                              const std::vector<ConvexHull>& hulls) {
  std::vector<Eigen::Vector3d> directions{outward};
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) directions.push_back(Eigen::Vector3d(x, y, z).normalized());
  std::stable_sort(directions.begin(), directions.end(), [&](const auto& a, const auto& b) { return a.dot(outward) > b.dot(outward); });
  const auto open = std::find_if(directions.begin(), directions.end(),
                                 [&](const Eigen::Vector3d& direction) { return isInTheOpen(tip, direction, length, hulls); });
  return open == directions.end() ? outward : *open;
}

/// All hulls in the root link's frame.
std::vector<ConvexHull> placedHulls(const RobotResult& result) {
  std::vector<ConvexHull> placed;
  for (const ElementResult& element : result.elements)
    for (const ConvexHull& hull : element.hulls) placed.push_back(transformed(hull, element.pose));
  return placed;
}

/// The arrow comes from outside and ends at the place; it is as long as the robot's size says, since the protrusion itself is millimetres.
void drawWorst(const Link& link, double radius, const std::vector<ConvexHull>& hulls, Pen& pen, MarkerList& list) {
  const auto less = [](const auto* a, const auto* b) { return a->report.protrusion_found < b->report.protrusion_found; };
  const auto worst = std::max_element(link.elements.begin(), link.elements.end(), less);
  if (worst == link.elements.end() || !((*worst)->report.protrusion_found > 0)) return;
  const ElementReport& report = (*worst)->report;
  const Eigen::Isometry3d& origin = (*worst)->source.origin;
  const double most = kArrowLength * radius;
  const double length = std::clamp(0.5 * report.diagonal, 0.4 * most, most);
  const auto red = colour(0.85, 0, 0.1, 1);

  Marker& sphere = pen.add(list, "worst", link.name, Marker::SPHERE, origin * Eigen::Translation3d(report.worst));
  sphere.scale = toScale(Eigen::Vector3d::Constant(0.12 * length));
  sphere.color = red;
  const Eigen::Isometry3d& pose = (*worst)->pose;
  const Eigen::Vector3d outward = pose.linear() * (report.worst - report.worst_nearest).stableNormalized();
  const Eigen::Vector3d away = pose.linear().transpose() * openDirection(pose * report.worst, outward, length, hulls);
  Marker& arrow = pen.add(list, "worst", link.name, Marker::ARROW, origin);
  arrow.scale = toScale({0.05 * length, 0.14 * length, 0.3 * length});
  arrow.points = {toPoint(report.worst + length * away), toPoint(report.worst)};
  arrow.color = red;
  const Eigen::Isometry3d end(origin * Eigen::Translation3d(report.worst + 1.25 * length * away));
  addText(millimetres(report.protrusion_found), kTextHeight * radius * std::max(length / most, 0.7), "worst", link.name, end, pen, list).color = red;
}

/// Made smaller by as much as the meshes are.
void drawOriginalPrimitives(const LinkDescription& link, Source source, Pen& pen, MarkerList& list) {
  for (const GeometryElement& element : sourceElements(link, source).elements) {
    if (!isPrimitive(element)) continue;
    Marker& marker = addPrimitive(element, "original", link.name, pen, list);
    const double inset = 2 * kInset * localBox(element).diagonal().norm();
    marker.scale.x -= inset;
    marker.scale.y -= inset;
    marker.scale.z -= inset;
    marker.color = originalColour();
  }
}

std::string labelText(const Link& link) {
  double protrusion = 0;
  for (const ElementResult* element : link.elements) protrusion = std::max(protrusion, element->report.protrusion);
  std::string text = link.name + ": ";
  if (link.hulls > 0 || link.primitives == 0) text += count(link.hulls, "hull");
  if (link.primitives > 0) text += (link.hulls > 0 ? ", " : "") + count(link.primitives, "primitive");
  if (protrusion > 0) text += ", " + millimetres(protrusion);
  return text;
}

/// A link's label and what it belongs to, in the root link's frame.
struct Label {
  const Link* link = nullptr;
  Eigen::Isometry3d link_pose = Eigen::Isometry3d::Identity();
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero(), place = Eigen::Vector3d::Zero();
};

/// Places labels in a column to the left or right of the robot (side -1 or 1), in the order of their links' heights. Returns their spacing.
double placeColumn(std::vector<Label*> column, int side, const RobotBounds& robot) {
  std::stable_sort(column.begin(), column.end(), [](const Label* a, const Label* b) { return a->anchor.z() < b->anchor.z(); });
  const double lines = static_cast<double>(column.size());
  const double spacing = robot.radius * std::min(kLineSpacing * kTextHeight, 2 / std::max(lines, 1.0));
  for (std::size_t i = 0; i < column.size(); ++i)
    column[i]->place =
        robot.centre + Eigen::Vector3d(0, side * kColumn * robot.radius, (static_cast<double>(i) - 0.5 * (lines - 1)) * spacing);
  return spacing;
}

/// A text in its link's colour, and a line from there to the link: text within the robot would be hidden.
void drawLabel(const Label& label, double spacing, Pen& pen, MarkerList& list) {
  const Link& link = *label.link;
  const Eigen::Isometry3d to_link = label.link_pose.inverse();
  const auto dark = fromHsv(link.hue, 0.9, 0.5, 1);
  const double height = spacing / kLineSpacing;
  const Eigen::Isometry3d place(Eigen::Translation3d(to_link * label.place));
  addText(labelText(link), height, "labels", link.name, place, pen, list).color = dark;
  Marker& line = pen.add(list, "labels", link.name, Marker::LINE_LIST, to_link);
  line.scale = toScale({0.08 * height, 0, 0});
  line.points = {toPoint(label.place - Eigen::Vector3d(0, 0, 0.6 * height)), toPoint(label.anchor)};
  line.color = dark;
}

Label labelOf(const Link& link, const LinkDescription& description) {
  Eigen::AlignedBox3d box;
  for (const ElementResult* element : link.elements) box.extend(rootBox(*element));
  for (const GeometryElement& element : description.collisions) {
    if (isPrimitive(element)) box.extend(moved(localBox(element), description.pose * element.origin));
  }
  const Eigen::Vector3d anchor = box.isEmpty() ? Eigen::Vector3d(description.pose.translation()) : Eigen::Vector3d(box.center());
  return {&link, description.pose, anchor, anchor};
}

void drawLabels(std::vector<Label> labels, const RobotBounds& robot, Pen& pen, MarkerList& list) {
  std::vector<Label*> columns[2];
  for (Label& label : labels) {
    const double y = label.anchor.y() - robot.centre.y();
    const bool is_central = std::abs(y) < 0.1 * robot.radius;
    columns[is_central ? columns[0].size() > columns[1].size() : y > 0].push_back(&label);
  }
  for (int i = 0; i < 2; ++i) {
    const double spacing = placeColumn(columns[i], 2 * i - 1, robot);
    for (const Label* label : columns[i]) drawLabel(*label, spacing, pen, list);
  }
}

std::string rootLink(const RobotDescription& robot) {
  const auto root = std::find_if(robot.links.begin(), robot.links.end(), [](const LinkDescription& l) { return l.parent.empty(); });
  return root == robot.links.end() ? "" : root->name;
}

std::size_t triangleCount(const Scene& scene) {
  std::size_t triangles = 0;
  for (const SceneBody& body : scene.bodies) triangles += std::visit([](const auto& shape) { return shape.triangles.size(); }, body.shape);
  return triangles;
}

/// One marker for all bodies: an octree has tens of thousands. Nothing where rviz could not cope with it.
MarkerList drawScene(const Scene& scene, const std::string& root) {
  const std::size_t triangles = triangleCount(scene);
  if (triangles == 0 || triangles > kMostSceneTriangles) return {};
  Marker marker;
  marker.header.frame_id = root;
  marker.ns = "scene";
  marker.type = Marker::TRIANGLE_LIST;
  marker.action = Marker::ADD;
  marker.pose = toPose(Eigen::Isometry3d::Identity());
  marker.scale = toScale(Eigen::Vector3d::Ones());
  marker.frame_locked = true;
  marker.color = colour(0.85, 0.8, 0.7, kSceneOpacity);
  for (const SceneBody& body : scene.bodies) {
    const auto add = [&](const auto& shape) {
      const auto placed = transformed(shape, body.pose);
      addTriangles(placed.vertices, placed.triangles, marker);
    };
    std::visit(add, body.shape);
  }
  return {marker};
}

}  // namespace

double linkHue(std::size_t link) {
  constexpr double kGoldenRatio = 0.6180339887498949, kFirst = 0.58;  // a blue; red is for the arrows
  const double turns = kFirst + kGoldenRatio * static_cast<double>(link);
  return turns - std::floor(turns);
}

std_msgs::ColorRGBA shade(double hue, std::size_t hull, double opacity) {
  constexpr double kSaturation[] = {0.75, 0.6, 0.9, 0.65, 0.8, 0.55, 0.95}, kValue[] = {0.95, 0.75, 0.85, 1.0, 0.65, 0.9, 0.7};
  return fromHsv(hue, kSaturation[hull % 7], kValue[hull % 7], opacity);
}

RobotBounds robotBounds(const RobotDescription& robot, Source source, const MeshFile& file) {
  std::map<std::pair<std::string, std::vector<double>>, Eigen::AlignedBox3d> known;  // by mesh and scale
  Eigen::AlignedBox3d box;
  for (const LinkDescription& link : robot.links) {
    for (const GeometryElement& element : sourceElements(link, source).elements) {
      std::vector<double> numbers(element.scale.data(), element.scale.data() + 3);
      numbers.insert(numbers.end(), element.size.data(), element.size.data() + 3);
      numbers.push_back(static_cast<double>(element.kind));
      const auto [entry, is_new] = known.try_emplace({element.uri, numbers});
      if (is_new) entry->second = readBox(element, file);
      box.extend(moved(entry->second, link.pose * element.origin));
    }
  }
  return toBounds(box);
}

Drawing drawOriginal(const RobotDescription& robot, Source source, const MeshFile& file) {
  Drawing drawing;
  Pen pen;
  for (const LinkDescription& link : robot.links) {
    for (const GeometryElement& element : sourceElements(link, source).elements) {
      if (isPrimitive(element)) {
        addPrimitive(element, "original", link.name, pen, drawing.original).color = originalColour();
      } else if (element.kind == GeometryElement::Kind::kMesh && element.fault.empty()) {
        try {
          const std::string resource = fileUri(file(element.uri));
          Marker& marker = pen.add(drawing.original, "original", link.name, Marker::MESH_RESOURCE, element.origin);
          marker.mesh_resource = resource;
          marker.scale = toScale(element.scale);
          marker.color = originalColour();
        } catch (const Error&) {  // the run itself reports it
        }
      }
    }
  }
  return drawing;
}

Drawing drawResult(const RobotResult& result, const RobotDescription& original, const Scene* scene, double opacity) {
  Drawing drawing;
  if (result.elements.empty() && result.urdf.empty()) return drawing;
  const RobotDescription robot = parseRobotDescription(result.urdf);
  std::map<std::string, const LinkDescription*> descriptions;
  for (const LinkDescription& link : robot.links) descriptions[link.name] = &link;
  const RobotBounds size = bounds(result);
  const std::vector<ConvexHull> hulls = placedHulls(result);
  Pen pen;
  std::vector<Link> links = linksOf(result, robot);
  std::vector<Label> labels;
  for (Link& link : links) {
    const LinkDescription& description = *descriptions.at(link.name);
    drawHulls(link, opacity, pen, drawing.hulls);
    drawPrimitives(link, description, opacity, pen, drawing.hulls);
    drawUnneeded(link, pen, drawing.unneeded);
    drawOriginals(link, pen, drawing.original);
    drawWorst(link, size.radius, hulls, pen, drawing.protrusion);
    labels.push_back(labelOf(link, description));
  }
  for (const LinkDescription& link : original.links) drawOriginalPrimitives(link, result.report.options.source, pen, drawing.original);
  drawLabels(labels, size, pen, drawing.labels);
  if (scene) drawing.scene = drawScene(*scene, rootLink(robot));
  return drawing;
}

Marker drawProgress(const std::string& text, const std::string& frame, const RobotBounds& bounds) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = "progress";
  marker.type = Marker::TEXT_VIEW_FACING;
  marker.action = Marker::ADD;
  const Eigen::Vector3d place(bounds.centre.x(), bounds.centre.y(), bounds.top + 0.15 * bounds.radius);
  marker.pose = toPose(Eigen::Isometry3d(Eigen::Translation3d(place)));
  marker.scale = toScale({0, 0, 0.08 * bounds.radius});
  marker.color = colour(0.05, 0.05, 0.1, 1);
  marker.frame_locked = true;
  marker.text = text;
  return marker;
}

}  // namespace collision_hulls
