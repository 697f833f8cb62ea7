// A body is judged by the box around it, a mesh triangle by triangle. Twice a link's reach is far enough for what may replace its meshes:
// hulls lie in its ball, with fewer vertices in a box around it, and primitives are at most 1.25 times as large as the hulls in them.
#include "fit/near_problem.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include "base/looks.h"
#include "fit/assembly.h"
#include "reach/reach_ball.h"

namespace collision_hulls {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// [m] For each link, how far its geometry gets from the origin of its frame; negative: it has none.
std::vector<double> radii(const FitProblem& problem) {
  std::vector<double> result(problem.robot.links.size(), -1);
  const auto extend = [&](std::size_t link, const Eigen::Vector3d& p) { result[link] = std::max(result[link], p.norm()); };
  for (const FitElement& element : problem.elements)
    for (const Eigen::Vector3d& v : element.mesh->original.vertices) extend(element.link, element.origin * v);
  for (const KeptBody& kept : problem.kept)
    for (const Eigen::Vector3d& v : verticesOf(kept)) extend(kept.link, v);
  return result;
}

/// The robot's variables, whose limits also hold the configurations that are given.
std::vector<JointVariable> variablesOf(const Kinematics& kinematics, const std::vector<Configuration>& configurations) {
  std::vector<JointVariable> variables = kinematics.variables();
  for (const Configuration& configuration : configurations) {
    kinematics.check(configuration);
    for (std::size_t v = 0; v < variables.size(); ++v) {
      variables[v].lower = std::min(variables[v].lower, configuration[v]);
      variables[v].upper = std::max(variables[v].upper, configuration[v]);
    }
  }
  return variables;
}

/// Without an end where the joints' ranges do not tell how far a link gets.
ReachBall ballOf(const Kinematics& kinematics, const std::vector<JointVariable>& variables, std::size_t link, double radius) {
  ReachBall ball = reachBall(kinematics.chain(link), variables, radius);
  if (!kinematics.settled(link)) ball.radius = kInfinity;
  return ball;
}

class NearAndFar {
 public:
  NearAndFar(const FitProblem& problem, double clearance, const RunControl& control)
      : clearance_(clearance), look_(control), far_(problem.robot.links.size(), kInfinity) {
    const Kinematics kinematics(problem.robot);
    const std::vector<JointVariable> variables = variablesOf(kinematics, problem.configurations);
    const std::vector<double> radius = radii(problem);
    for (std::size_t link = 0; link < radius.size(); ++link)
      if (radius[link] >= 0) balls_.emplace_back(link, ballOf(kinematics, variables, link, radius[link]));
  }

  std::size_t links() const { return balls_.size(); }
  std::vector<double> takeFar() { return std::move(far_); }

  bool isFar(const Eigen::AlignedBox3d& box) {
    look_();
    for (const auto& [link, ball] : balls_)
      if (box.exteriorDistance(ball.centre) <= ball.radius + std::max(ball.radius, clearance_)) return false;
    for (const auto& [link, ball] : balls_) far_[link] = std::min(far_[link], box.exteriorDistance(ball.centre) - ball.radius);
    return true;
  }

  bool isFar(const ConvexHull& hull, const Eigen::Isometry3d& pose) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : hull.vertices) box.extend(pose * v);
    return isFar(box);
  }

  /// The triangles that are not far.
  TriangleMesh near(const TriangleMesh& mesh, const Eigen::Isometry3d& pose) {
    TriangleMesh result;
    std::vector<int> renamed(mesh.vertices.size(), -1);
    for (const Triangle& triangle : mesh.triangles) {
      Eigen::AlignedBox3d box;
      for (const int v : triangle) box.extend(pose * mesh.vertices[static_cast<std::size_t>(v)]);
      if (isFar(box)) continue;
      Triangle& kept = result.triangles.emplace_back(triangle);
      for (int& v : kept) {
        int& name = renamed[static_cast<std::size_t>(v)];
        if (name < 0) {
          name = static_cast<int>(result.vertices.size());
          result.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
        }
        v = name;
      }
    }
    return result;
  }

 private:
  const double clearance_;
  Looks look_;
  std::vector<std::pair<std::size_t, ReachBall>> balls_;
  std::vector<double> far_;
};

}  // namespace

NearProblem nearProblem(const FitProblem& problem, double clearance, const RunControl& control) {
  NearAndFar judge(problem, clearance, control);
  NearProblem result;
  result.problem = {problem.robot, problem.elements, problem.kept, {}, problem.disabled, problem.configurations, problem.rest_unheld};
  Scene& scene = result.problem.scene;
  scene.name = problem.scene.name;
  for (const SceneBody& body : problem.scene.bodies) {
    SceneBody kept{body.name, {}, body.pose};
    if (const auto* hull = std::get_if<ConvexHull>(&body.shape)) {
      if (judge.isFar(*hull, body.pose)) continue;
      kept.shape = *hull;
    } else {
      TriangleMesh near = judge.near(std::get<TriangleMesh>(body.shape), body.pose);
      if (near.triangles.empty()) continue;
      kept.shape = std::move(near);
    }
    scene.bodies.push_back(std::move(kept));
  }
  result.far_bodies = problem.scene.bodies.size() - scene.bodies.size();
  result.links = judge.links();
  result.far = judge.takeFar();
  return result;
}

}  // namespace collision_hulls
