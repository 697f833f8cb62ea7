// The jobs of the program `physics`, which it runs in processes of their own: finding poses, dropping a body, closing the gripper.
#include "bench/jobs.h"

#include <nlohmann/json.hpp>

#include "bench/hull_objects.h"
#include "bench/json_file.h"
#include "bench/original.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/pipeline/output.h"
#include "physics/physics.h"
#include "physics/robot.h"
#include "storage/files.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

struct Subject {
  TriangleMesh mesh;
  ConvexHull hull;
  MassProperties mass;
  std::vector<RestingPose> poses;
};

Subject readSubject(const json& job) {
  Subject subject;
  subject.mesh = meshOf(job);
  subject.hull = convexHull(subject.mesh.vertices);
  subject.mass = massProperties(subject.hull);
  subject.poses = restingPoses(subject.hull, subject.mass.center, job["most"]);
  return subject;
}

json poses(const json& job) {
  const Subject subject = readSubject(job);
  json stabilities = json::array();
  for (const RestingPose& pose : subject.poses) stabilities.push_back(pose.stability);
  return {{"diagonal", diagonal(subject.mesh)}, {"stabilities", stabilities}};
}

/// Transforms points from the mesh's frame to the body's: the origin is the centre of mass, and D is kBodySize.
std::vector<Eigen::Vector3d> inBody(const Subject& subject, std::vector<Eigen::Vector3d> points) {
  const double size = kBodySize / diagonal(subject.mesh);
  for (Eigen::Vector3d& p : points) p = size * (p - subject.mass.center);
  return points;
}

/// The body to drop. Without hulls it is the original mesh, as a file; as a convex body the original would be its single hull, which is a
/// method.
DropBody bodyOf(const Subject& subject, const json& job) {
  const std::string hulls = job["hulls"], work = job["work"];
  const bool as_mesh = job["way"] == name(Way::kMesh);
  DropBody body;
  body.original = convexHull(inBody(subject, subject.hull.vertices));
  if (hulls.empty()) {
    body.files.push_back(work + "/original.obj");
    writeText(body.files.back(), toObj(TriangleMesh{inBody(subject, subject.mesh.vertices), subject.mesh.triangles}));
    return body;
  }
  for (const auto& object : readHullObjects(hulls)) {
    const ConvexHull hull = convexHull(inBody(subject, object));
    if (as_mesh) {
      body.files.push_back(work + "/body_" + std::to_string(body.files.size()) + ".stl");
      writeText(body.files.back(), encodeHull(hull, MeshFormat::kStl, "hull"));
    } else {
      body.hulls.push_back(hull.vertices);
    }
  }
  return body;
}

json dropJob(const json& job) {
  const Subject subject = readSubject(job);
  const DropResult result = drop(bodyOf(subject, job), *wayNamed(job["way"]), subject.poses.at(job["pose"]));
  return {{"outcome", result.outcome}, {"tilt", result.tilt},        {"height", result.height}, {"penetration", result.penetration},
          {"drift", result.drift},     {"slide", result.slide},      {"energy", result.energy}, {"settle_seconds", result.settle_seconds},
          {"step_us", result.step_us}, {"contacts", result.contacts}};
}

/// Only the fingers get hulls; the collision models of other links do not matter here.
json gripJob(const json& job) {
  const Input input = openInput(job["robot"]);
  Options options;
  options.method = *methodNamed(job["method"]);
  options.tolerance = parseLength(job["tolerance"]);
  options.links = "(left|right)_finger_link";
  options.uri = UriStyle::kFile;
  options.seed = job["seed"];
  options.validate = options.cache = false;
  const std::string output = job["work"].get<std::string>() + "/robot";
  RobotResult robot = decompose(input, options, output);
  writeOutput(robot, output);
  const GripResult result = grip(loadRobot(robot.urdf, input.robot.path, input.find_package));
  return {{"outcome", result.outcome}, {"hulls", result.hulls},     {"slip", result.slip},
          {"turn", result.turn},       {"opening", result.opening}, {"step_us", result.step_us}};
}

}  // namespace

void doPhysicsJob(const std::string& job_file, const std::string& result_file) {
  const json job = readJson(job_file);
  const std::string kind = job["job"];
  if (kind != "poses" && kind != "drop" && kind != "grip") return doJob(job_file, result_file);
  const json result = kind == "poses" ? poses(job) : kind == "drop" ? dropJob(job) : gripJob(job);
  writeText(result_file, result.dump());
}

}  // namespace collision_hulls
