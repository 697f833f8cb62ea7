// Puts models into the two broad phases of the room query.
#include "planning/checker.h"

#include "query/query_model.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

QueryBody bodyOf(const TriangleMesh& mesh, CheckerKind /*kind*/) {
  return QueryBody(mesh);
}

QueryBody bodyOf(const ConvexHull& hull, CheckerKind kind) {
  return kind == CheckerKind::kMoveIt ? QueryBody(surface(hull)) : QueryBody(hull);
}

QueryBody bodyOf(const GeometryElement& primitive, CheckerKind /*kind*/) {
  QueryShape shape;
  shape.kind = primitive.kind == Kind::kBox      ? QueryShape::Kind::kBox
               : primitive.kind == Kind::kSphere ? QueryShape::Kind::kSphere
                                                 : QueryShape::Kind::kCylinder;
  shape.size = primitive.size;
  return QueryBody(shape, primitive.origin);
}

template <typename Model>
void addRobot(const RobotModel& robot, CheckerKind kind, Model& model) {
  for (const ModelBody& body : robot.bodies)
    std::visit([&](const auto& shape) { model.add(body.link, bodyOf(shape, kind), body.origin); }, body.shape);
}

/// Bodies of the scene are numbered after the links. MoveIt's are boxes and cylinders, so the hulls around them stay convex.
template <typename Model>
void addScene(const Scene& scene, std::size_t links, Model& model) {
  std::vector<Eigen::Isometry3d> places(links, Eigen::Isometry3d::Identity());
  for (const SceneBody& body : scene.bodies) {
    std::visit([&](const auto& shape) { model.add(places.size(), QueryBody(shape)); }, body.shape);
    places.push_back(body.pose);
  }
  model.place(places);
}

class BoxesChecker : public Checker {
 public:
  BoxesChecker(const RobotModel& robot, std::size_t links, const Scene& scene, const IgnoredPairs& ignored) : robot_(ignored) {
    addRobot(robot, CheckerKind::kBoxes, robot_);
    addScene(scene, links, scene_);
  }
  bool collides(const std::vector<Eigen::Isometry3d>& links) override {
    robot_.place(links);
    return robot_.collides(scene_) || robot_.collides();
  }

 private:
  BoxedModel robot_, scene_;
};

class TreesChecker : public Checker {
 public:
  TreesChecker(CheckerKind kind, const RobotModel& robot, std::size_t links, const Scene& scene, IgnoredPairs ignored)
      : ignored_(std::move(ignored)) {
    addRobot(robot, kind, robot_);
    addScene(scene, links, scene_);
  }
  bool collides(const std::vector<Eigen::Isometry3d>& links) override {
    robot_.place(links);
    return robot_.collides(scene_, ignored_) || robot_.collides(ignored_);
  }

 private:
  QueryModel robot_, scene_;
  const IgnoredPairs ignored_;
};

}  // namespace

const char* name(CheckerKind kind) {
  switch (kind) {
    case CheckerKind::kBoxes: return "boxes";
    case CheckerKind::kTrees: return "trees";
    case CheckerKind::kMoveIt: return "moveit";
  }
  return "";
}

std::optional<CheckerKind> checkerNamed(const std::string& name) {
  for (const CheckerKind kind : {CheckerKind::kBoxes, CheckerKind::kTrees, CheckerKind::kMoveIt})
    if (name == collision_hulls::name(kind)) return kind;
  return std::nullopt;
}

std::unique_ptr<Checker> makeChecker(CheckerKind kind, const RobotModel& robot, std::size_t links, const Scene& scene,
                                     const IgnoredPairs& ignored) {
  if (kind == CheckerKind::kBoxes) return std::make_unique<BoxesChecker>(robot, links, scene, ignored);
  return std::make_unique<TreesChecker>(kind, robot, links, scene, ignored);
}

std::vector<std::pair<std::size_t, std::size_t>> touchingLinks(const RobotModel& robot, const IgnoredPairs& ignored,
                                                               const std::vector<Eigen::Isometry3d>& links) {
  QueryModel model;
  addRobot(robot, CheckerKind::kTrees, model);
  model.place(links);
  return model.touching(ignored);
}

}  // namespace collision_hulls
