// Proofs against closed-form distances of small arms, and against samples of a whole robot.
#include "collision_hulls/reach/reach.h"

#include <cmath>
#include <random>

#include "reach/convex_gap.h"
#include "scene/scene_tests.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Outcome = Reach::Outcome;

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A chain of links l0, l1, ...; each joint is `length` further along x than the one before.
class Arm {
 public:
  Arm& add(const std::string& type, const std::string& axis, double lower, double upper, double length = 1, const std::string& more = "") {
    const std::string n = std::to_string(joints_), m = std::to_string(++joints_);
    text_ += "<link name='l" + m + "'/><joint name='j" + m + "' type='" + type + "'><parent link='l" + n + "'/><child link='l" + m +
             "'/><origin xyz='" + std::to_string(joints_ == 1 ? 0 : length) + " 0 0'/><axis xyz='" + axis + "'/><limit lower='" +
             std::to_string(lower) + "' upper='" + std::to_string(upper) + "' effort='1' velocity='1'/>" + more + "</joint>";
    return *this;
  }
  Kinematics kinematics() const { return Kinematics(parseRobotDescription(text_ + "</robot>")); }

 private:
  std::string text_ = "<robot name='r'><link name='l0'/>";
  int joints_ = 0;
};

/// Side of a cube that is almost a point: 1 cm.
constexpr double kCube = 0.01;

ConvexHull cubeAt(const Eigen::Vector3d& place) {
  ConvexHull cube = boxShape(Eigen::Vector3d::Constant(kCube));
  for (Eigen::Vector3d& v : cube.vertices) v += place;
  return convexHull(cube.vertices);
}

Scene sceneWith(const ConvexHull& hull, const Eigen::Vector3d& place) {
  Scene scene;
  addBody(scene, {"body", hull, Eigen::Isometry3d(Eigen::Translation3d(place))});
  return scene;
}

/// The last link of an arm against the only body of a scene.
Reach reachOf(const Kinematics& kinematics, const ConvexHull& link, const Scene& scene, double clearance,
              const ReachOptions& options = {}) {
  const std::size_t last = kinematics.joints().size();
  std::vector<ConvexHull> links(last + 1);
  links[last] = link;
  return ReachProver(kinematics, links, scene).betweenLinkAndBody(last, 0, clearance, options);
}

/// Expects a proof for a clearance just below `distance`, which is the true minimum, and a witness just above it.
void expectReach(double distance, const Kinematics& kinematics, const ConvexHull& link, const Scene& scene) {
  const Reach apart = reachOf(kinematics, link, scene, 0.98 * distance);
  EXPECT_EQ(apart.outcome, Outcome::kProved);
  EXPECT_GT(apart.bound, 0.98 * distance);
  EXPECT_LE(apart.bound, distance * (1 + 1e-6));
  EXPECT_GE(apart.found, distance * (1 - 1e-6));
  const Reach touched = reachOf(kinematics, link, scene, 1.02 * distance);
  ASSERT_EQ(touched.outcome, Outcome::kTouched);
  EXPECT_LE(touched.found, 1.02 * distance);
  EXPECT_LE(touched.bound, distance * (1 + 1e-6));
}

TEST(Reach, LinksWithoutGeometryAreFarFromEverything) {
  const Kinematics kinematics = Arm().add("revolute", "0 0 1", -1, 1).kinematics();
  const ReachProver prover(kinematics, {ConvexHull(), cubeAt({0, 0, 0})}, {});
  const Reach reach = prover.betweenLinks(0, 1, 1);
  EXPECT_EQ(reach.outcome, Outcome::kProved);
  EXPECT_EQ(reach.bound, kInfinity);
  EXPECT_EQ(reach.evaluations, 0u);
}

TEST(Reach, LinksFixedToEachOther) {
  const Kinematics kinematics = Arm().add("revolute", "0 0 1", -1, 1).add("fixed", "0 0 1", 0, 0).kinematics();
  const ReachProver prover(kinematics, {ConvexHull(), cubeAt({0, 0, 0}), cubeAt({0, 0, 0})}, {});
  const double apart = 1 - kCube;
  EXPECT_EQ(prover.betweenLinks(1, 2, 0.98).outcome, Outcome::kProved);
  EXPECT_NEAR(prover.betweenLinks(2, 1, 0.98).bound, apart, 1e-5);
  EXPECT_EQ(prover.betweenLinks(1, 2, 0.995).outcome, Outcome::kTouched);
  EXPECT_EQ(prover.betweenLinks(1, 1, 0).outcome, Outcome::kTouched) << "a link and itself";
}

TEST(Reach, OneRevoluteJoint) {
  const Kinematics kinematics = Arm().add("revolute", "0 0 1", -0.5, 0.5).kinematics();
  const double furthest = std::hypot(1 + kCube / 2, kCube / 2);
  expectReach(2 - kCube / 2 - furthest, kinematics, cubeAt({1, 0, 0}), sceneWith(cubeAt({0, 0, 0}), {2, 0, 0}));
  // A body beyond the upper limit, 1 m from the axis: the cubes' corners move on circles about it.
  const double angle = 1.5, place = 1;
  const Eigen::Rotation2Dd turn(0.5);
  double least = kInfinity;
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      const Eigen::Vector2d corner = turn * Eigen::Vector2d(1 + x * kCube / 2, y * kCube / 2);
      const Eigen::Vector2d middle(place * std::cos(angle), place * std::sin(angle));
      least = std::min(least, ((corner - middle).cwiseAbs() - Eigen::Vector2d::Constant(kCube / 2)).cwiseMax(0).norm());
    }
  }
  expectReach(least, kinematics, cubeAt({1, 0, 0}), sceneWith(cubeAt({0, 0, 0}), {std::cos(angle), std::sin(angle), 0}));
}

TEST(Reach, OnePrismaticJoint) {
  const Kinematics kinematics = Arm().add("prismatic", "0 0 1", 0, 2).kinematics();
  expectReach(0.3 - kCube, kinematics, cubeAt({0, 0, 0}), sceneWith(cubeAt({0, 0, 0}), {0, 0, 2.3}));
  expectReach(0.3 - kCube, kinematics, cubeAt({0, 0, 0}), sceneWith(cubeAt({0, 0, 0}), {0.3, 0, 1.7}));
}

TEST(Reach, TwoJointsReachAsFarAsTheirLinks) {
  const Kinematics kinematics = Arm().add("continuous", "0 0 1", 0, 0).add("revolute", "0 0 1", -2, 2, 0.7).kinematics();
  const double furthest = 0.7 + std::hypot(0.5 + kCube / 2, kCube / 2);
  const Scene scene = sceneWith(boxShape({0.1, 5, 5}), {1.5, 0, 0});
  expectReach(1.45 - furthest, kinematics, cubeAt({0.5, 0, 0}), scene);
}

TEST(Reach, FoldedArmStaysAwayFromItsBase) {
  // At the elbow's limit the distance is the third side of a triangle with sides of 1 m and 0.5 m and the angle pi - 2 between them.
  const Kinematics kinematics = Arm().add("continuous", "0 0 1", 0, 0).add("revolute", "0 0 1", -2, 2).kinematics();
  const double nearest = std::sqrt(1 + 0.25 - std::cos(kPi - 2)), round = kCube / std::sqrt(2);
  const Reach reach = reachOf(kinematics, cubeAt({0.5, 0, 0}), sceneWith(cubeAt({0, 0, 0}), {0, 0, 0}), nearest - 2 * round - 0.01);
  EXPECT_EQ(reach.outcome, Outcome::kProved);
  EXPECT_LE(reach.bound, nearest);
  EXPECT_EQ(reachOf(kinematics, cubeAt({0.5, 0, 0}), sceneWith(cubeAt({0, 0, 0}), {0, 0, 0}), nearest).outcome, Outcome::kTouched);
}

TEST(Reach, MimicJointsFollowTheirMasters) {
  // Two fingers side by side, 0.1 m apart, that slide together; if they were independent, they would meet.
  const auto finger = [](const std::string& n, const std::string& y, const std::string& mimic) {
    return "<link name='f" + n + "'/><joint name='j" + n + "' type='prismatic'><parent link='palm'/><child link='f" + n +
           "'/><origin xyz='0 " + y + " 0'/><axis xyz='0 1 0'/><limit lower='0' upper='1' effort='1' velocity='1'/>" + mimic + "</joint>";
  };
  const auto prove = [&](const std::string& mimic) {
    const Kinematics kinematics(
        parseRobotDescription("<robot name='r'><link name='palm'/>" + finger("1", "0", "") + finger("2", "0.1", mimic) + "</robot>"));
    return ReachProver(kinematics, {ConvexHull(), cubeAt({0, 0, 0}), cubeAt({0, 0, 0})}, {}).betweenLinks(1, 2, 0.08);
  };
  const Reach together = prove("<mimic joint='j1'/>");
  EXPECT_EQ(together.outcome, Outcome::kProved);
  EXPECT_LE(together.bound, 0.1 - kCube + 1e-6);
  EXPECT_EQ(prove("").outcome, Outcome::kTouched);
  EXPECT_EQ(prove("<mimic joint='j1' multiplier='-1' offset='0.5'/>").outcome, Outcome::kTouched);
}

/// Where a point 1 m from its hinge is at this angle.
Eigen::Vector3d onArc(double angle) {
  return {std::cos(angle), std::sin(angle), 0};
}

/// [m] Between cubes, one of which turns with the arc.
double apartAt(double angle, const Eigen::Vector3d& other) {
  const auto pointsOf = [](const ConvexHull& hull, const Eigen::Isometry3d& pose) {
    PointMatrix points(3, static_cast<Eigen::Index>(hull.vertices.size()));
    for (std::size_t i = 0; i < hull.vertices.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = pose * hull.vertices[i];
    return points;
  };
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
  return convexGap(pointsOf(cubeAt({1, 0, 0}), turn), pointsOf(cubeAt(other), Eigen::Isometry3d::Identity())).at_most;
}

/// A body within the hull of an arc of more than half a turn, so that sweeping proves nothing, beside an end of it, from which the arc
/// leads away: the bound is that of the last box of angles, of which the end is as near as its movement allows.
TEST(Reach, NoBoundExceedsTheDistanceAtTheEndOfAnArc) {
  const Eigen::Vector3d place = onArc(4) + 0.06 * (onArc(0) - onArc(4)).normalized();
  const double distance = apartAt(4, place);
  for (const double share : {0.9, 0.98, 0.99}) {
    const Kinematics kinematics = Arm().add("revolute", "0 0 1", 0, 4).kinematics();
    const Reach reach = reachOf(kinematics, cubeAt({1, 0, 0}), sceneWith(cubeAt({0, 0, 0}), place), share * distance);
    EXPECT_EQ(reach.outcome, Outcome::kProved);
    EXPECT_LE(reach.bound, distance * (1 + 1e-6)) << share;
  }
}

/// The same with a joint that turns by twice the way of the one that it follows, in the same sense or against it.
TEST(Reach, AJointThatFollowsMovesByItsOwnWay) {
  const Eigen::Vector3d place = onArc(4) + 0.06 * (onArc(0) - onArc(4)).normalized();
  const double distance = apartAt(4, place);
  for (const std::string follows : {"multiplier='2'", "multiplier='-2' offset='4'"}) {
    const std::string mimic = "<mimic joint='j1' " + follows + "/>";
    const Kinematics kinematics = Arm().add("prismatic", "0 0 1", 0, 2).add("revolute", "0 0 1", -9, 9, 0, mimic).kinematics();
    const Reach reach = reachOf(kinematics, cubeAt({1, 0, 0}), sceneWith(boxShape({kCube, kCube, 9}), place), 0.9 * distance);
    EXPECT_EQ(reach.outcome, Outcome::kProved) << follows;
    EXPECT_LE(reach.bound, distance * (1 + 1e-6)) << follows;
    EXPECT_GE(reach.found, distance * (1 - 1e-6)) << follows;
  }
}

/// A mesh has no plane that tells towards which side movement counts, so all of it does. The cube in the middle of the arc is beside the
/// point, but makes the swept body prove nothing. The other one lies beyond the arc's end, towards which the point moves from the middle of
/// the upper half: its distance at that end is its distance there less the whole chord.
TEST(Reach, AllMovementCountsNearAMesh) {
  const Eigen::Vector3d place = onArc(4) + 0.1 * (onArc(4) - onArc(3)).normalized();
  Scene scene;
  addBody(scene, {"mesh", test_shapes::merged({surface(cubeAt({0, 0, 0})), surface(cubeAt(place))})});
  const Kinematics kinematics = Arm().add("revolute", "0 0 1", 0, 4).kinematics();
  const Reach reach = reachOf(kinematics, cubeAt({1, 0, 0}), scene, 0.01);
  EXPECT_EQ(reach.outcome, Outcome::kProved);
  EXPECT_LE(reach.bound, apartAt(4, place) * (1 + 1e-6));
}

/// In the middle of its range the point is furthest from the body: either way leads towards it, across the direction of its movement.
TEST(Reach, AnArcLeadsTowardsWhatIsBehindItsHinge) {
  const Kinematics kinematics = Arm().add("revolute", "0 0 1", -1.9, 1.9).kinematics();
  const Eigen::Vector3d place(-0.2, 0, 0);
  const double distance = apartAt(1.9, place);
  const Reach reach = reachOf(kinematics, cubeAt({1, 0, 0}), sceneWith(cubeAt({0, 0, 0}), place), 0.9 * distance);
  EXPECT_EQ(reach.outcome, Outcome::kProved);
  EXPECT_LE(reach.bound, distance * (1 + 1e-6));
}

/// An arc of more than half a turn, as above, and a link that does not move: all of the approach is by the first or by the second link of
/// the pair.
TEST(Reach, TheSecondLinkMovesAsTheFirst) {
  const Eigen::Vector3d place = onArc(4) + 0.06 * (onArc(0) - onArc(4)).normalized();
  const double distance = apartAt(4, place);
  const Kinematics kinematics = Arm().add("revolute", "0 0 1", 0, 4).kinematics();
  const ReachProver prover(kinematics, {cubeAt(place), cubeAt({1, 0, 0})}, {});
  for (const std::size_t second : {0u, 1u}) {
    const Reach reach = prover.betweenLinks(1 - second, second, 0.98 * distance);
    EXPECT_EQ(reach.outcome, Outcome::kProved) << second;
    EXPECT_LE(reach.bound, distance * (1 + 1e-6)) << second;
  }
}

/// Two arcs through one another like links of a chain, so that neither may be swept. They are nearest where the first one begins and the
/// second has made half a turn. A box that holds this configuration must not be given up because one of them is far away at its middle,
/// from where the other hardly moves.
TEST(Reach, BothLinksMove) {
  const auto hinged = [](const std::string& name, double x, const std::string& axis) {
    return "<link name='" + name + "'/><joint name='to_" + name + "' type='revolute'><parent link='base'/><child link='" + name +
           "'/><origin xyz='" + std::to_string(x) + " 0 0'/><axis xyz='" + axis +
           "'/><limit lower='0' upper='4' effort='1' velocity='1'/></joint>";
  };
  for (const double nearest : {0.7, 0.98}) {
    const Kinematics kinematics(parseRobotDescription("<robot name='r'><link name='base'/>" + hinged("a", 0, "0 0 1") +
                                                      hinged("b", nearest + 0.5, "0 1 0") + "</robot>"));
    const double distance = apartAt(0, {nearest, 0, 0});
    const ReachProver prover(kinematics, {ConvexHull(), cubeAt({1, 0, 0}), cubeAt({0.5, 0, 0})}, {});
    for (const std::size_t first : {1u, 2u}) {
      const Reach reach = prover.betweenLinks(first, 3 - first, 0.5 * distance);
      EXPECT_EQ(reach.outcome, Outcome::kProved) << nearest;
      EXPECT_LE(reach.bound, distance * (1 + 1e-6)) << first << " at " << nearest;
    }
  }
}

TEST(Reach, MeshHasNoInterior) {
  Scene room;
  addBody(room, {"room", surface(boxShape({6, 6, 6}))});
  const Kinematics kinematics = Arm().add("revolute", "0 1 0", -1, 1).add("continuous", "0 0 1", 0, 0).kinematics();
  EXPECT_EQ(reachOf(kinematics, cubeAt({0.5, 0, 0}), room, 1.4).outcome, Outcome::kProved);
  EXPECT_EQ(reachOf(kinematics, cubeAt({0.5, 0, 0}), room, 1.6).outcome, Outcome::kTouched);
}

TEST(Reach, IsUnknownWhenEvaluationsRunOut) {
  const Kinematics kinematics = Arm().add("revolute", "0 0 1", -0.5, 0.5).kinematics();
  ReachOptions options;
  options.evaluations = 1;
  const Scene scene = sceneWith(cubeAt({0, 0, 0}), {1.02, 0, 0});
  const Reach reach = reachOf(kinematics, cubeAt({1, 0, 0}), scene, 0.009, options);
  EXPECT_EQ(reach.outcome, Outcome::kUnknown);
  EXPECT_LE(reach.bound, 0.009);
  EXPECT_LE(reach.evaluations, 3u);
}

TEST(Reach, RejectsInvalidArguments) {
  const Kinematics kinematics = Arm().add("revolute", "0 0 1", -1, 1).kinematics();
  const ReachProver prover(kinematics, {cubeAt({0, 0, 0}), cubeAt({0, 0, 0})}, {});
  expectError(ErrorCode::kBadOption, {"-1"}, [&] { prover.betweenLinks(0, 1, -1); });
  expectError(ErrorCode::kBadOption, {"nan"}, [&] { prover.betweenLinks(0, 1, std::nan("")); });
  expectError(ErrorCode::kBadOption, {"tightness"}, [&] { prover.betweenLinks(0, 1, 0, {100, 1}); });
  expectError(ErrorCode::kBadOption, {"evaluation"}, [&] { prover.betweenLinks(0, 1, 0, {0, 0.5}); });
  expectError(ErrorCode::kIndexOutOfRange, {"no link 2: there are 2"}, [&] { prover.betweenLinks(0, 2, 0); });
  expectError(ErrorCode::kIndexOutOfRange, {"no body of the scene 0: there are 0"}, [&] { prover.betweenLinkAndBody(2, 0, 0); });
  expectError(ErrorCode::kIndexOutOfRange, {"hulls of 1 link,", "has 2"}, [&] { ReachProver(kinematics, {cubeAt({0, 0, 0})}, {}); });
}

TEST(Reach, CanBeCancelled) {
  const Kinematics kinematics = Arm().add("revolute", "0 0 1", -0.5, 0.5).kinematics();
  RunControl control;
  control.cancel();
  const ReachProver prover(kinematics, {ConvexHull(), cubeAt({1, 0, 0})}, sceneWith(cubeAt({0, 0, 0}), {1.02, 0, 0}));
  expectError(ErrorCode::kCancelled, {}, [&] { prover.betweenLinkAndBody(1, 0, 0.009, {}, control); });
}

PointMatrix placed(const ConvexHull& hull, const Eigen::Isometry3d& pose) {
  PointMatrix points(3, static_cast<Eigen::Index>(hull.vertices.size()));
  for (std::size_t i = 0; i < hull.vertices.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = pose * hull.vertices[i];
  return points;
}

TEST(Reach, NoSampleOfARobotContradictsAProof) {
  const RobotDescription robot = readRobotDescription(DEMO_ROBOT "/urdf/demo_arm.urdf");
  const Kinematics kinematics(robot);
  std::vector<ConvexHull> links(robot.links.size(), boxShape({0.08, 0.1, 0.12}));
  const ReachProver prover(kinematics, links, {});
  std::mt19937_64 engine(5);
  std::vector<std::vector<Eigen::Isometry3d>> poses;
  for (int i = 0; i < 300; ++i)
    poses.push_back(kinematics.poses(kinematics.sample([&] { return static_cast<double>(engine() >> 11) * 0x1p-53; })));
  int proved = 0;
  for (std::size_t a = 0; a < links.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Reach reach = prover.betweenLinks(b, a, 0.01, {500, 0.8});
      proved += reach.outcome == Outcome::kProved;
      for (const std::vector<Eigen::Isometry3d>& pose : poses) {
        const Gap gap = convexGap(placed(links[a], pose[a]), placed(links[b], pose[b]));
        ASSERT_GE(gap.at_most, reach.bound) << robot.links[a].name << " " << robot.links[b].name;
      }
      const std::vector<Eigen::Isometry3d> witness = kinematics.poses(reach.witness);
      const Gap gap = convexGap(placed(links[a], witness[a]), placed(links[b], witness[b]));
      EXPECT_LE(gap.at_least, reach.found + 1e-9);
    }
  }
  EXPECT_GT(proved, 10);
}

using Exact = long double;
using ExactVector = Eigen::Matrix<Exact, 3, 1>;

/// A link fixed to the base, turned about z by `yaw`.
Kinematics turnedLink(const std::string& yaw) {
  return Kinematics(
      parseRobotDescription("<robot name='r'><link name='base'/><link name='turned'/><joint name='j' type='fixed'><parent link='base'/>"
                            "<child link='turned'/><origin xyz='0 0 0' rpy='0 0 " +
                            yaw + "'/></joint></robot>"));
}

/// A point of such a link, in the base's frame.
ExactVector turned(const Eigen::Vector3d& p, double yaw) {
  const Exact c = std::cos(Exact{yaw}), s = std::sin(Exact{yaw});
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
}

/// Links 100 km from their origin, as a hull in map coordinates may be. The bound may not exceed the distance of any two points.
TEST(Reach, TheBoundBetweenLinksAllowsForTheRoundingOfCoordinates) {
  const ConvexHull link = cubeAt({1e5, 2e4, 3e4});
  for (int i = 0; i < 20; ++i) {
    const double yaw = 0.1 + 0.14 * i;
    ExactVector first(-1e9, 0, 0);
    for (const Eigen::Vector3d& v : link.vertices)
      if (const ExactVector p = turned(v, yaw); p.x() > first.x()) first = p;
    ConvexHull wall = boxShape({0.1, 0.1, 0.1});
    for (Eigen::Vector3d& v : wall.vertices) v += first.cast<double>() + Eigen::Vector3d(0.1, 0, 0);
    wall = convexHull(wall.vertices);
    const Exact side = boundingBox(wall).min().x();  // beyond which the corner of the link is 5 cm away
    const Reach reach = ReachProver(turnedLink(std::to_string(yaw)), {wall, link}, {}).betweenLinks(0, 1, 0.01);
    EXPECT_EQ(reach.outcome, Outcome::kProved);
    EXPECT_LE(static_cast<Exact>(reach.bound), side - first.x()) << yaw;
  }
}

/// A small link at the origin, and a body 1,000 km away, which is turned about its own origin beside the link: corner against corner.
TEST(Reach, TheBoundToABodyAllowsForTheRoundingOfItsCoordinates) {
  const ConvexHull speck = boxShape({1e-3, 1e-3, 1e-3});
  const ConvexHull far = [&] {
    ConvexHull result = speck;
    for (Eigen::Vector3d& v : result.vertices) v += Eigen::Vector3d(5e5, 4e5, 3e5);
    return convexHull(result.vertices);
  }();
  for (int i = 0; i < 20; ++i) {
    const double yaw = 0.05 * i;
    Exact nearest = 1e9;
    for (const Eigen::Vector3d& v : far.vertices)
      for (const Eigen::Vector3d& own : speck.vertices) nearest = std::min(nearest, (turned(v, yaw) - own.cast<Exact>()).norm());
    Scene scene;
    addBody(scene, {"far", far, Eigen::Isometry3d(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()))});
    const Reach reach = ReachProver(turnedLink("0"), {ConvexHull(), speck}, scene).betweenLinkAndBody(1, 0, 1);
    EXPECT_EQ(reach.outcome, Outcome::kProved);
    EXPECT_LE(static_cast<Exact>(reach.bound), nearest) << yaw;
  }
}

TEST(Reach, IsRepeatable) {
  const Kinematics kinematics =
      Arm().add("revolute", "0 1 0", -2, 2).add("revolute", "0 0 1", -2, 2).add("revolute", "1 0 1", -2, 2).kinematics();
  const Scene scene = sceneWith(boxShape({0.3, 0.3, 0.3}), {1.5, 1.5, 0.4});
  const Reach first = reachOf(kinematics, boxShape({0.5, 0.1, 0.1}), scene, 0.01),
              second = reachOf(kinematics, boxShape({0.5, 0.1, 0.1}), scene, 0.01);
  EXPECT_EQ(first.bound, second.bound);
  EXPECT_EQ(first.found, second.found);
  EXPECT_EQ(first.witness, second.witness);
  EXPECT_EQ(first.evaluations, second.evaluations);
}

}  // namespace
}  // namespace collision_hulls
