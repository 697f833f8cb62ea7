// Builds models for queries and times them. A time is the quickest of several rounds over the same samples, which other load on the machine
// disturbs least.
#include "fit/planner_model.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/parallel.h"

namespace collision_hulls {
namespace {

// Rounds go on until kLeastTime is used, and there are at least kLeastRounds unless kMostTime is reached first.
constexpr double kLeastTime = 0.1, kMostTime = 2;  // [s]
constexpr int kLeastRounds = 3;
constexpr std::size_t kMostTimed = 500;      // samples
constexpr std::size_t kMostDistances = 100;  // samples; distances take longer

std::vector<Places> placesOf(const Assembly& assembly, const std::vector<std::size_t>& samples, std::size_t most) {
  std::vector<Places> places;
  for (std::size_t i = 0; i < std::min(samples.size(), most); ++i) places.push_back(assembly.places(samples[i]));
  return places;
}

IgnoredPairs ignoredPairs(const Assembly& assembly, const PairRules& rules) {
  IgnoredPairs ignored(assembly.parts());
  for (const auto& [a, b] : rules.ignored) ignored.ignore(a, b);
  return ignored;
}

template <typename Model>
void addBodies(const Assembly& assembly, const Cuts& cuts, Model& robot, Model& scene) {
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Piece& piece = assembly.pieces()[i];
    for (const int node : cuts[i]) (assembly.isLink(piece.part) ? robot : scene).add(piece.part, piece.tree->body(node), piece.origin);
  }
}

template <typename Model>
void addBodies(const Assembly& assembly, const Originals& originals, Model& robot, Model& scene) {
  for (std::size_t part = 0; part < assembly.parts(); ++part)
    for (const Originals::Body& body : originals.bodies(part)) (assembly.isLink(part) ? robot : scene).add(part, body.body, body.origin);
}

/// [us] per query, in the quickest of several rounds.
double microseconds(const std::vector<Places>& all, const RunControl& control, const std::function<void(const Places&)>& ask) {
  using Clock = std::chrono::steady_clock;
  if (all.empty()) return 0;
  double best = std::numeric_limits<double>::infinity(), sum = 0;
  for (int round = 0; (round < kLeastRounds && sum < kMostTime) || sum < kLeastTime; ++round) {
    const Clock::time_point start = Clock::now();
    for (const Places& places : all) {
      control.check();
      ask(places);
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    best = std::min(best, seconds);
    sum += seconds;
  }
  return 1e6 * best / static_cast<double>(all.size());
}

}  // namespace

PlannerModel::PlannerModel(const Assembly& assembly, const PairRules& rules, const Cuts& cuts) : robot_(ignoredPairs(assembly, rules)) {
  addBodies(assembly, cuts, robot_, scene_);
}

PlannerModel::PlannerModel(const Assembly& assembly, const PairRules& rules, const Originals& originals)
    : robot_(ignoredPairs(assembly, rules)) {
  addBodies(assembly, originals, robot_, scene_);
}

void PlannerModel::place(const Places& places) {
  if (!scene_placed_) scene_.place(places.all());
  scene_placed_ = true;
  robot_.place(places.links());
}

bool PlannerModel::hit(const Places& places) {
  place(places);
  return robot_.collides(scene_) || robot_.collides();
}

double PlannerModel::distance(const Places& places) {
  place(places);
  return robot_.distance(scene_, robot_.distance());
}

TreeModel::TreeModel(const Assembly& assembly, const PairRules& rules, const Cuts& cuts) : ignored_(ignoredPairs(assembly, rules)) {
  addBodies(assembly, cuts, robot_, scene_);
}

TreeModel::TreeModel(const Assembly& assembly, const PairRules& rules, const Originals& originals)
    : ignored_(ignoredPairs(assembly, rules)) {
  addBodies(assembly, originals, robot_, scene_);
}

bool TreeModel::hit(const Places& places) {
  if (!scene_placed_) scene_.place(places.all());
  scene_placed_ = true;
  robot_.place(places.links());
  return robot_.collides(scene_, ignored_) || robot_.collides(ignored_);
}

std::vector<char> hits(const Assembly& assembly, const std::function<PlannerModel()>& make, std::size_t first, std::size_t count,
                       const RunControl& control) {
  std::vector<PlannerModel> models;
  const auto threads = mostThreads();
  for (std::size_t i = 0; i < threads; ++i) models.push_back(make());
  std::vector<char> result(count);
  forEach(threads, [&](std::size_t t) {
    for (std::size_t i = t; i < count; i += threads) {
      control.check();
      result[i] = models[t].hit(assembly.places(first + i));
    }
  });
  return result;
}

double collisionTime(const Assembly& assembly, PlannerModel& model, const std::vector<std::size_t>& samples, const RunControl& control) {
  return microseconds(placesOf(assembly, samples, kMostTimed), control, [&](const Places& places) { model.hit(places); });
}

double collisionTime(const Assembly& assembly, TreeModel& model, const std::vector<std::size_t>& samples, const RunControl& control) {
  return microseconds(placesOf(assembly, samples, kMostTimed), control, [&](const Places& places) { model.hit(places); });
}

double distanceTime(const Assembly& assembly, PlannerModel& model, const std::vector<std::size_t>& samples, const RunControl& control) {
  return microseconds(placesOf(assembly, samples, kMostDistances), control, [&](const Places& places) { model.distance(places); });
}

}  // namespace collision_hulls
