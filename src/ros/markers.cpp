// Draws robots for rviz. Each link has a hue, each of its hulls a shade of it. The original is drawn a hair inside its surface, so that it
// shows through translucent hulls without flickering where faces coincide.
#include "markers.h"

#include <algorithm>
#include <map>
#include <utility>

#include "annotations.h"
#include "collision_hulls/decompose/segments.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

using visualization_msgs::Marker;

constexpr double kInset = 2e-4;         // of a mesh's diagonal: how far inside the original is drawn
constexpr double kSceneOpacity = 0.45;  // the robot is behind the scene from somewhere

constexpr double kEdgeWidth = 0.0015;  // of the robot's radius
constexpr double kFlat = 1 - 1e-6;     // faces whose normals have a larger product are in one plane

std_msgs::ColorRGBA originalColour() {
  return colour(0.85, 0.85, 0.86, 1);
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

/// The links of a result that have something to draw.
std::vector<Link> linksOf(const RobotResult& result, const RobotDescription& rewritten) {
  std::vector<Link> links;
  for (std::size_t place = 0; place < rewritten.links.size(); ++place) {
    const LinkDescription& description = rewritten.links[place];
    Link link{description.name, linkHue(place), {}, 0, 0};
    for (std::size_t i = 0; i < result.elements.size(); ++i) {
      if (result.elements[i].link == link.name) link.meshes.push_back({result.elements[i], result.report.links[i]});
    }
    const bool has_primitives = std::any_of(description.collisions.begin(), description.collisions.end(), isPrimitive);
    if (!link.meshes.empty() || has_primitives) links.push_back(std::move(link));
  }
  return links;
}

/// The hulls that a primitive does not stand in for.
void drawHulls(Link& link, double opacity, Pen& pen, MarkerList& list) {
  for (const auto& [element, row] : link.meshes) {
    for (std::size_t i = 0; i + element.primitives.size() < element.hulls.size(); ++i) {
      const ConvexHull& hull = element.hulls[i];
      Marker& marker = pen.add(list, "hulls", link.name, Marker::TRIANGLE_LIST, element.source.origin);
      addTriangles(hull.vertices, hull.triangles, marker);
      marker.color = shade(link.hue, link.hulls++, opacity);
    }
  }
}

void drawUnneeded(const Link& link, Pen& pen, MarkerList& list) {
  for (const auto& [element, row] : link.meshes) {
    for (const ConvexHull& hull : element.unneeded) {
      Marker& marker = pen.add(list, "unneeded", link.name, Marker::TRIANGLE_LIST, element.source.origin);
      addTriangles(hull.vertices, hull.triangles, marker);
      marker.color = colour(0.5, 0.5, 0.5, 0.35);
    }
  }
}

/// A mesh in the colours of its clusters.
void drawSegments(const Link& link, Pen& pen, MarkerList& list) {
  for (const auto& [element, row] : link.meshes) {
    if (!element.segments) continue;
    Marker& marker = pen.add(list, "segments", link.name, Marker::TRIANGLE_LIST, element.source.origin);
    const TriangleMesh& mesh = element.segments->mesh;
    const std::vector<std::vector<int>>& clusters = element.segments->segmentation.clusters;
    for (std::size_t k = 0; k < clusters.size(); ++k) {
      const Rgb rgb = clusterColour(k);
      std::vector<Triangle> triangles;
      for (const int t : clusters[k]) triangles.push_back(mesh.triangles[static_cast<std::size_t>(t)]);
      addTriangles(mesh.vertices, triangles, marker);
      marker.colors.resize(marker.points.size(), colour(rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0, 1));
    }
    marker.color = colour(1, 1, 1, 1);
  }
}

void drawPrimitives(Link& link, const LinkDescription& description, double opacity, Pen& pen, MarkerList& list) {
  for (const GeometryElement& element : description.collisions) {
    if (!isPrimitive(element)) continue;
    addPrimitive(element, "primitives", link.name, pen, list).color = shade(link.hue, link.hulls + link.primitives++, opacity);
  }
}

void drawOriginals(const Link& link, Pen& pen, MarkerList& list) {
  for (const auto& [element, row] : link.meshes) {
    if (element.original.triangles.empty()) continue;
    Marker& marker = pen.add(list, "original", link.name, Marker::TRIANGLE_LIST, element.source.origin);
    addInset(element.original, marker);
    marker.color = originalColour();
  }
}

/// All hulls in the root link's frame.
std::vector<ConvexHull> placedHulls(const RobotResult& result) {
  std::vector<ConvexHull> placed;
  for (const ElementResult& element : result.elements)
    for (const ConvexHull& hull : element.hulls) placed.push_back(transformed(hull, element.pose));
  return placed;
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

std::size_t triangleCount(const Scene& scene) {
  std::size_t triangles = 0;
  for (const SceneBody& body : scene.bodies) triangles += std::visit([](const auto& shape) { return shape.triangles.size(); }, body.shape);
  return triangles;
}

/// One marker for all bodies: an octree has tens of thousands. Nothing above kMostSceneTriangles.
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

/// The edges between faces that are not in one plane.
void drawEdges(const Link& link, double width, Pen& pen, MarkerList& list) {
  for (const auto& [element, row] : link.meshes) {
    for (const ConvexHull& hull : element.hulls) {
      Marker& marker = pen.add(list, "chosen", link.name, Marker::LINE_LIST, element.source.origin);
      marker.scale.x = width;
      marker.color = colour(0.05, 0.05, 0.1, 1);
      std::map<std::pair<int, int>, Eigen::Vector3d> normals;  // by edge, as the first of its triangles has it
      for (const Triangle& t : hull.triangles) {
        const auto at = [&](int corner) -> const Eigen::Vector3d& { return hull.vertices[static_cast<std::size_t>(corner)]; };
        const Eigen::Vector3d normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).stableNormalized();
        for (std::size_t k = 0; k < 3; ++k) {
          const int a = t[k], b = t[(k + 1) % 3];
          const auto [edge, is_first] = normals.emplace(std::minmax(a, b), normal);
          if (!is_first && edge->second.dot(normal) < kFlat) marker.points.insert(marker.points.end(), {toPoint(at(a)), toPoint(at(b))});
        }
      }
    }
  }
}

}  // namespace

Drawing drawLink(const ShownLink& shown, double radius, double opacity) {
  Drawing drawing;
  Pen pen;
  Link link{shown.link.name, shown.hue, {}, 0, 0};
  std::vector<ConvexHull> placed;
  for (std::size_t i = 0; i < shown.elements.size(); ++i) {
    link.meshes.push_back({shown.elements[i], shown.rows[i]});
    for (const ConvexHull& hull : shown.elements[i].hulls) placed.push_back(transformed(hull, shown.elements[i].pose));
  }
  drawHulls(link, opacity, pen, drawing.hulls);
  drawPrimitives(link, shown.link, opacity, pen, drawing.hulls);
  drawEdges(link, kEdgeWidth * radius, pen, drawing.chosen);
  drawWorst(link, radius, placed, pen, drawing.protrusion);
  return drawing;
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
  const RobotBounds size = robotBounds(result);
  const std::vector<ConvexHull> hulls = placedHulls(result);
  Pen pen;
  std::vector<Link> links = linksOf(result, robot);
  std::vector<Label> labels;
  for (Link& link : links) {
    const LinkDescription& description = *descriptions.at(link.name);
    drawHulls(link, opacity, pen, drawing.hulls);
    drawPrimitives(link, description, opacity, pen, drawing.hulls);
    drawUnneeded(link, pen, drawing.unneeded);
    drawSegments(link, pen, drawing.segments);
    drawOriginals(link, pen, drawing.original);
    drawWorst(link, size.radius, hulls, pen, drawing.protrusion);
    labels.push_back(labelOf(link, description));
  }
  for (const LinkDescription& link : original.links) drawOriginalPrimitives(link, result.report.options.source, pen, drawing.original);
  drawLabels(labels, size, pen, drawing.labels);
  if (scene) drawing.scene = drawScene(*scene, rootLink(robot));
  return drawing;
}

}  // namespace collision_hulls
