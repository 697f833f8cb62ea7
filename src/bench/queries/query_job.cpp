// States are seeded samples, so every model answers the same queries. Rates are states per second, over as many rounds as fit into
// kLeastTime; errors are differences from the answers of the original meshes.
#include "bench/queries/query_job.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/stopwatch.h"
#include "bench/hull_objects.h"
#include "bench/json_file.h"
#include "bench/original.h"
#include "bench/queries/query_scene.h"
#include "collision_hulls/query/boxed_model.h"
#include "collision_hulls/robot/kinematics.h"
#include "geometry/random_stream.h"
#include "query/query_model.h"
#include "storage/files.h"

namespace collision_hulls {
namespace {

using nlohmann::json;
using State = std::vector<Eigen::Isometry3d>;  // a pose per link

constexpr double kLeastTime = 0.2;          // [s] per measurement: as many rounds over the states as needed
constexpr std::uint64_t kSampleStream = 3;  // of random numbers
constexpr std::size_t kDistanceStates = 100;
constexpr std::size_t kReachStates = 20;  // from which the reach is estimated

struct Part {
  std::size_t link = 0;
  TriangleMesh mesh;  // in the link's frame
};

Eigen::Isometry3d toPose(const json& rows) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 12; ++i) pose.matrix()(i / 4, i % 4) = rows[static_cast<std::size_t>(i)];
  return pose;
}

/// A body of the model to query, in its link's frame.
struct LinkBody {
  std::size_t link = 0;
  QueryBody body;
};

std::vector<LinkBody> bodiesOf(const json& job, const std::vector<Part>& parts) {
  std::vector<LinkBody> bodies;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const json& part = job["parts"][i];
    if (job["original"].get<bool>()) {
      bodies.push_back({parts[i].link, QueryBody(parts[i].mesh)});
      continue;
    }
    const Eigen::Isometry3d origin = toPose(part["origin"]);
    for (std::vector<Eigen::Vector3d> points : readHullObjects(part["hulls"])) {
      for (Eigen::Vector3d& p : points) p = origin * p;
      bodies.push_back({parts[i].link, QueryBody(convexHull(points))});
    }
  }
  return bodies;
}

/// How far the parts reach in these states.
Surroundings reachOf(const std::vector<Part>& parts, const std::vector<State>& states) {
  Surroundings reach{0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Part& part : parts) {
    const Eigen::AlignedBox3d box = boundingBox(part.mesh);
    for (std::size_t s = 0; s < std::min(states.size(), kReachStates); ++s) {
      for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d p = states[s][part.link] * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        reach.radius = std::max(reach.radius, p.head<2>().norm());
        reach.low = std::min(reach.low, p.z());
        reach.high = std::max(reach.high, p.z());
      }
    }
  }
  return reach;
}

/// A part that moves freely gets a scene a few times its own size.
Surroundings roomFor(const std::vector<Part>& parts) {
  const double size = 1.5 * diagonal(parts.front().mesh);
  return {size, -size, size};
}

std::vector<State> sampledStates(const Kinematics& kinematics, std::size_t count, std::uint64_t seed) {
  std::vector<State> states;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, kSampleStream, i);
    states.push_back(kinematics.poses(kinematics.sample([&] { return random.uniform(0, 1); })));
  }
  return states;
}

struct Answers {
  std::vector<char> hit;
  std::vector<double> distance;  // [m]
  double collisions_per_second = 0, tree_collisions_per_second = 0, distances_per_second = 0;
};

/// States per second; every round fills the answers.
template <typename Model, typename Ask>
double timed(Model& model, const std::vector<State>& states, const Ask& ask) {
  Stopwatch clock;
  double seconds = 0;
  std::size_t asked = 0;
  for (; seconds < kLeastTime; asked += states.size()) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      model.place(states[i]);
      ask(i);
    }
    seconds += clock.lap();
  }
  return static_cast<double>(asked) / seconds;
}

/// Distances take longer and use only the first states. `against` is the scene; without it, the model is checked against itself.
template <typename... Against>
void askAll(BoxedModel& model, const std::vector<State>& states, Answers& answers, Against&... against) {
  const std::vector<State> first(states.begin(), states.begin() + static_cast<std::ptrdiff_t>(std::min(states.size(), kDistanceStates)));
  answers.hit.resize(states.size());
  answers.distance.resize(first.size());
  answers.collisions_per_second = timed(model, states, [&](std::size_t i) { answers.hit[i] = model.collides(against...); });
  answers.distances_per_second = timed(model, first, [&](std::size_t i) { answers.distance[i] = model.distance(against...); });
}

/// The same with FCL's dynamic trees.
template <typename Against>
void askTrees(const std::vector<LinkBody>& bodies, const std::vector<State>& states, const Against& against, Answers& answers) {
  QueryModel model;
  for (const LinkBody& body : bodies) model.add(body.link, body.body);
  answers.tree_collisions_per_second = timed(model, states, [&](std::size_t) { model.collides(against); });
}

json ratio(std::size_t part, std::size_t whole) {
  return whole ? json(static_cast<double>(part) / static_cast<double>(whole)) : json();
}

void compare(const Answers& answers, const json& original, json& result) {
  std::size_t free = 0, phantom = 0, missed = 0;
  std::vector<double> errors;
  for (std::size_t i = 0; i < answers.hit.size(); ++i) {
    if (original["hit"][i].get<int>()) {
      missed += !answers.hit[i];
      continue;
    }
    ++free;
    phantom += answers.hit[i];
    if (i >= answers.distance.size()) continue;
    const json& distance = original["distance"][i];  // null: there is nothing to measure to
    if (distance.is_number()) errors.push_back(std::max(0.0, distance.get<double>() - answers.distance[i]));
  }
  result["phantom_rate"] = ratio(phantom, free);
  result["missed"] = missed;
  if (errors.empty()) return;
  result["distance_error_mean"] = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
  result["distance_error_max"] = *std::max_element(errors.begin(), errors.end());
}

/// Pairs of links whose meshes touch at rest; users disable these.
json touchingAtRest(const std::vector<Part>& parts, const Kinematics& kinematics, const IgnoredPairs& adjacent) {
  QueryModel meshes;
  for (const Part& part : parts) meshes.add(part.link, part.mesh);
  meshes.place(kinematics.poses(kinematics.rest()));
  return meshes.touching(adjacent);
}

IgnoredPairs adjacentPairs(const Kinematics& kinematics, std::size_t links) {
  IgnoredPairs ignored(links);
  for (std::size_t a = 0; a < links; ++a)
    for (std::size_t b = 0; b <= a; ++b)
      if (kinematics.adjacent(a, b)) ignored.ignore(a, b);
  return ignored;
}

Answers askItself(const std::vector<LinkBody>& bodies, const std::vector<Part>& parts, const RobotDescription& robot,
                  const std::vector<State>& states, const json& pairs_at_rest, json& pairs) {
  const Kinematics kinematics(robot);
  IgnoredPairs ignored = adjacentPairs(kinematics, robot.links.size());
  pairs = pairs_at_rest.is_null() ? touchingAtRest(parts, kinematics, ignored) : pairs_at_rest;
  for (const json& pair : pairs) ignored.ignore(pair[0], pair[1]);
  BoxedModel model(ignored);
  for (const LinkBody& body : bodies) model.add(body.link, body.body);
  Answers answers;
  askAll(model, states, answers);
  askTrees(bodies, states, ignored, answers);
  return answers;
}

Answers askScene(const std::vector<LinkBody>& bodies, const Surroundings& reach, const std::vector<State>& states, std::uint64_t seed) {
  const std::vector<ConvexHull> things = clutteredScene(reach, seed);
  const State places(things.size(), Eigen::Isometry3d::Identity());
  BoxedModel model, scene;
  QueryModel tree;
  for (std::size_t i = 0; i < things.size(); ++i) {
    scene.add(i, QueryBody(things[i]));
    tree.add(i, things[i]);
  }
  scene.place(places);
  tree.place(places);
  for (const LinkBody& body : bodies) model.add(body.link, body.body);
  Answers answers;
  askAll(model, states, answers, scene);
  askTrees(bodies, states, tree, answers);
  return answers;
}

}  // namespace

json query(const json& job) {
  const std::uint64_t seed = job["seed"];
  const bool original = job["original"], single = job["urdf"].get<std::string>().empty();
  std::vector<Part> parts;
  for (const json& part : job["parts"]) parts.push_back({part["link"], transformed(meshOf(part), toPose(part["origin"]))});
  const std::vector<LinkBody> bodies = bodiesOf(job, parts);

  const RobotDescription robot = single ? RobotDescription() : readRobotDescription(job["urdf"]);
  std::vector<State> states;
  if (!single) states = sampledStates(Kinematics(robot), job["states"], seed);
  if (single)
    for (const Eigen::Isometry3d& pose : freePoses(roomFor(parts), job["states"], seed)) states.push_back({pose});

  const json known = original ? json() : readJson(job["answers"].get<std::string>());
  json pairs;
  const Answers answers = job["workload"] == "self" ? askItself(bodies, parts, robot, states, original ? json() : known["pairs"], pairs)
                                                    : askScene(bodies, single ? roomFor(parts) : reachOf(parts, states), states, seed);

  const auto hits = static_cast<std::size_t>(std::count(answers.hit.begin(), answers.hit.end(), 1));
  json result = {{"collisions_per_second", answers.collisions_per_second},
                 {"tree_collisions_per_second", answers.tree_collisions_per_second},
                 {"distances_per_second", answers.distances_per_second},
                 {"bodies", bodies.size()},
                 {"hit_rate", ratio(hits, states.size())}};
  if (original) {
    const std::vector<int> hit(answers.hit.begin(), answers.hit.end());
    writeText(job["answers"].get<std::string>(), json{{"hit", hit}, {"distance", answers.distance}, {"pairs", pairs}}.dump());
  } else {
    compare(answers, known, result);
  }
  return result;
}

}  // namespace collision_hulls
