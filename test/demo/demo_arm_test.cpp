// The demo robot: closed parts in the right units, every kind of element that it is there to show, room between its links.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <set>

#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/mesh/repair.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {
namespace {

const std::filesystem::path kMeshes = DEMO_ROBOT "/meshes";

const RobotDescription& robot() {
  static const RobotDescription description = readRobotDescription(DEMO_ROBOT "/urdf/demo_arm.urdf");
  return description;
}

const LinkDescription& link(const std::string& name) {
  for (const LinkDescription& each : robot().links) {
    if (each.name == name) return each;
  }
  throw std::runtime_error("no link " + name);
}

/// A mesh element in its link's frame.
TriangleMesh meshOf(const GeometryElement& element) {
  static const PackageFinder find_package = defaultPackageFinder(robot().path);
  return transformed(scaled(readMesh(resolveUri(element.uri, robot().path, find_package)).mesh, element.scale), element.origin);
}

void forEachMesh(const std::function<void(const LinkDescription&, const GeometryElement&)>& visit) {
  for (const LinkDescription& each : robot().links) {
    for (const auto* elements : {&each.visuals, &each.collisions}) {
      for (const GeometryElement& element : *elements) {
        if (element.kind == GeometryElement::Kind::kMesh) visit(each, element);
      }
    }
  }
}

TEST(DemoArm, PartsAreClosedAndOutward) {
  forEachMesh([](const LinkDescription& part, const GeometryElement& element) {
    SCOPED_TRACE(part.name + " " + element.uri);
    const TriangleMesh mesh = meshOf(element);
    const RepairedMesh repaired = repair(mesh);
    EXPECT_EQ(repaired.counts.open_edges, 0u);
    EXPECT_EQ(repaired.counts.nonmanifold_edges, 0u);
    EXPECT_EQ(repaired.counts.flipped, 0u);
    EXPECT_EQ(repaired.counts.degenerate, 0u);
    EXPECT_GT(signedVolume(mesh), 0);
    EXPECT_GE(mesh.triangles.size(), 100u);
    EXPECT_LE(mesh.triangles.size(), 8000u);
  });
}

void expectBox(const std::string& name, std::size_t visual, const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  const double rounding = 1e-6;  // [m]: the files hold seven digits
  const Eigen::AlignedBox3d box = boundingBox(meshOf(link(name).visuals[visual]));
  EXPECT_LT((box.min() - min).norm(), rounding) << name << ": " << box.min().transpose();
  EXPECT_LT((box.max() - max).norm(), rounding) << name << ": " << box.max().transpose();
}

TEST(DemoArm, UnitsAxesAndScalesAgree) {
  expectBox("base_link", 0, {-0.095, -0.095, 0}, {0.095, 0.095, 0.09});                // Collada, metres, z up
  expectBox("gripper_link", 0, {0, -0.058, -0.03}, {0.046, 0.058, 0.03});              // Collada, centimetres, y up
  expectBox("shoulder_link", 0, {-0.072, -0.072, 0}, {0.072, 0.072, 0.15});            // OBJ, millimetres
  expectBox("elbow_link", 0, {-0.034, -0.04, -0.034}, {0.085, 0.049, 0.096});          // OBJ, metres
  expectBox("shoulder_link", 1, {-0.04, -0.11725, 0.07}, {0.04, -0.056, 0.15});        // STL, metres, stretched
  expectBox("left_finger_link", 0, {-0.011, -0.011, -0.022}, {0.094, 0.010, 0.022});   // STL, millimetres
  expectBox("right_finger_link", 0, {-0.011, -0.010, -0.022}, {0.094, 0.011, 0.022});  // the same, mirrored
  EXPECT_EQ(readMesh((kMeshes / "gripper.dae").string()).submeshes, 3);
}

TEST(DemoArm, ShowsEveryKindOfElement) {
  std::set<std::string> seen;
  forEachMesh([&](const LinkDescription&, const GeometryElement& element) {
    const Eigen::Vector3d& scale = element.scale;
    seen.insert(std::filesystem::path(element.uri).extension().string());
    if (scale.prod() < 0) seen.insert("mirrored");
    if (scale.cwiseAbs().minCoeff() != scale.cwiseAbs().maxCoeff()) seen.insert("stretched");
    seen.insert(scale.cwiseAbs().minCoeff() < 0.01 ? "millimetres" : "metres");
  });
  for (const LinkDescription& each : robot().links) {
    const bool visual = !each.visuals.empty(), collision = !each.collisions.empty();
    if (!visual && !collision) seen.insert("no geometry");
    if (each.visuals.size() > 1) seen.insert("several visuals");
    if (visual && collision && each.visuals[0].uri != each.collisions[0].uri) {
      seen.insert(each.collisions[0].uri.empty() ? "primitive collision" : "collision mesh of its own");
    }
  }
  EXPECT_EQ(seen, (std::set<std::string>{".dae", ".obj", ".stl", "collision mesh of its own", "metres", "millimetres", "mirrored",
                                         "no geometry", "primitive collision", "several visuals", "stretched"}));
  for (const char* text : {"<!--", "<transmission", "<gazebo"}) EXPECT_NE(robot().text.find(text), std::string::npos) << text;
}

TEST(DemoArm, EveryMeshFileIsUsedAndAllAreSmall) {
  std::set<std::string> used{"demo_arm.mtl"}, present;
  forEachMesh(
      [&](const LinkDescription&, const GeometryElement& element) { used.insert(std::filesystem::path(element.uri).filename().string()); });
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kMeshes)) {
    if (!entry.is_regular_file()) continue;
    present.insert(entry.path().filename().string());
    bytes += entry.file_size();
  }
  EXPECT_EQ(used, present);
  EXPECT_LT(bytes, 2'000'000u);
}

/// Whether the triangle keeps clear of the surface: distance changes by no more than the way to the point that is asked.
bool clear(const TriangleBvh& surface, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double smallest = 1e-3;  // [m] where it gives up: links that are to be apart are so by millimetres
  const Eigen::Vector3d centre = (a + b + c) / 3;
  const double radius = std::sqrt(std::max({(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()}));
  if (surface.nearest(centre, 2 * radius).distance > radius) return true;
  if (radius < smallest) return false;
  const Eigen::Vector3d ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  return clear(surface, a, ab, ca) && clear(surface, ab, b, bc) && clear(surface, ca, bc, c) && clear(surface, ab, bc, ca);
}

bool clear(const TriangleMesh& mesh, const TriangleBvh& other) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int triangle = static_cast<int>(t);
    if (!clear(other, mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2))) return false;
  }
  return true;
}

TEST(DemoArm, LinksThatAreNoNeighboursKeepClearAtTheZeroPose) {
  struct Part {
    const LinkDescription& of;
    TriangleMesh mesh;
    TriangleBvh tree;
  };
  std::vector<Part> parts;
  for (const LinkDescription& each : robot().links) {
    for (const GeometryElement& element : each.visuals) {
      if (element.kind != GeometryElement::Kind::kMesh) continue;
      const TriangleMesh mesh = transformed(meshOf(element), each.pose);
      parts.push_back({each, mesh, TriangleBvh(mesh)});
    }
  }
  int pairs = 0;
  for (const Part& a : parts) {
    for (const Part& b : parts) {
      if (a.of.name == b.of.name || a.of.parent == b.of.name || b.of.parent == a.of.name) continue;
      EXPECT_TRUE(clear(a.mesh, b.tree)) << a.of.name << " touches " << b.of.name;
      EXPECT_LT(b.tree.windingNumber(a.mesh.vertices[0]), 0.5) << a.of.name << " is inside " << b.of.name;
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 50);
}

}  // namespace
}  // namespace collision_hulls
