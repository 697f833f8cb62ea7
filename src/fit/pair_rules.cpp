// Decides about each pair in three passes, the cheap ones first: adjacency and the SRDF; a survey of the originals at rest and in some
// samples; and branch and bound for pairs that the survey never saw near. Pairs that the survey saw near are not worth a proof attempt.
#include "fit/pair_rules.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <set>
#include <utility>

#include "base/counted.h"
#include "base/median.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/reach/reach.h"
#include "fit/checked_pairs.h"
#include "scene/text.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kSurveyed = 400;  // samples
constexpr double kNearlyAll = 0.95;     // of them; MoveIt's Setup Assistant uses the same share
constexpr std::size_t kEvaluations = 300;
constexpr double kNeverSeen = 0.5;      // added to the samples in which a pair is not clear: none of a few hundred is not never
constexpr double kLeastSeconds = 1e-6;  // of a pair's survey
constexpr std::size_t kMostListed = 3;  // in a note
constexpr std::size_t kMostPairs = 2'000'000;

/// What the survey saw of a pair.
struct Sighting {
  std::size_t a = 0, b = 0;
  bool links = false, moves = true;
  double at_rest = 0;                               // [m] distance, capped at the clearance
  std::size_t samples = 0, touching = 0, near = 0;  // all; at distance 0; nearer than the clearance
  double own = 0;                                   // [m] the pair's clearance
  std::size_t unclear = 0;                          // see PartPair
  double seconds = 0;
};

bool nearlyAll(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) >= kNearlyAll * static_cast<double>(whole);
}

/// All pairs of parts with pieces, except two bodies of the scene. Throws kTooLarge.
std::vector<Sighting> allPairs(const Assembly& assembly) {
  std::vector<Sighting> pairs;
  for (std::size_t a = 0; a < assembly.links(); ++a) {
    const bool moves = !assembly.kinematics().chain(a).joints.empty();
    for (std::size_t b = a + 1; b < assembly.parts(); ++b) {
      const bool links = assembly.isLink(b);
      if (!assembly.piecesOf(a).empty() && !assembly.piecesOf(b).empty()) pairs.push_back({a, b, links, links || moves});
      if (pairs.size() > kMostPairs)
        throw Error(ErrorCode::kTooLarge,
                    "links with geometry and bodies of the scene form more than " + std::to_string(kMostPairs) +
                        " pairs; leave out bodies that the robot cannot reach, join some into meshes, or remove links");
    }
  }
  return pairs;
}

/// Poses at rest, then in the samples.
std::vector<Places> surveyed(const FitProblem& problem, const Assembly& assembly) {
  const std::size_t given = problem.configurations.size(), count = given ? std::min(given, kSurveyed) : kSurveyed;
  std::vector<Places> places{assembly.places(assembly.rest())};
  for (std::size_t i = 0; i < count; ++i) places.push_back(assembly.places(given ? i * given / count : i));
  return places;
}

/// The pair's clearance; for parts that are hardly ever that far apart, half of their usual distance. `usual`: 0 if they always touch.
double ownClearance(const Sighting& pair, double usual, double clearance) {
  if (usual == 0 || !nearlyAll(pair.near, pair.samples)) return clearance;
  return std::min(clearance, usual / 2);
}

/// For a pair that is never near in any of the places.
void surveyFar(std::size_t places, double clearance, Sighting& pair) {
  pair.at_rest = pair.own = clearance;
  pair.samples = places - 1;
}

/// Whether each pair is near in one of the places, by boxes.
std::vector<char> everNear(const std::vector<Places>& places, const Assembly& assembly, const Originals& originals, double clearance,
                           const std::vector<Sighting>& sightings, const RunControl& control) {
  std::vector<PartPair> pairs;
  for (const Sighting& pair : sightings) pairs.push_back({pair.a, pair.b, clearance});
  const CheckedPairs checked(assembly, std::move(pairs));
  std::vector<std::atomic<char>> ever(sightings.size());
  forEach(places.size(), [&](std::size_t i) {
    control.check();
    for (const std::size_t index : checked.near(originals.boxesOfLinks(places[i]), clearance)) ever[index] = 1;
  });
  return {ever.begin(), ever.end()};
}

void survey(const std::vector<Places>& places, const Originals& originals, double clearance, Sighting& pair) {
  std::vector<double> apart;  // distances, but for contact
  Stopwatch stopwatch;
  for (const Places& at : places) {
    const double distance = originals.distanceBelow(clearance, pair.a, pair.b, at);
    if (distance > 0) apart.push_back(distance);
    if (&at == &places.front()) {
      pair.at_rest = distance;
      continue;
    }
    ++pair.samples;
    pair.touching += distance == 0;
    pair.near += distance < clearance;
  }
  pair.seconds = stopwatch.lap();
  pair.own = ownClearance(pair, median(apart), clearance);
  pair.unclear = static_cast<std::size_t>(std::count_if(apart.begin(), apart.end(), [&](double distance) { return distance < pair.own; }));
}

/// Why a pair is left out, judging by the original; an empty reason: it is not.
LeftOutPair verdict(const Sighting& pair, const FitProblem& problem) {
  const bool given = !problem.configurations.empty(), held = !problem.rest_unheld.empty();
  const auto said = [&](const char* reason, const std::string& known) {
    return LeftOutPair{"", "", reason, known, pair.links, pair.at_rest <= 0};
  };
  if (!pair.moves && pair.at_rest <= 0) return said("Fixed", "always in contact");
  const bool by_default = pair.links && pair.at_rest <= 0;
  if (by_default && held) return said("Default", "in contact at rest");  // which holds of all configurations, unlike "Always" then
  if (pair.touching > 0 && nearlyAll(pair.touching, pair.samples))
    return said("Always", "in contact in " + std::to_string(pair.touching) + " of " + std::to_string(pair.samples) +
                              (given ? " given configurations" : " samples"));
  if (by_default) return said("Default", "in contact at rest");
  return {};
}

/// A hull around everything that a link may become.
ConvexHull hullOfLink(const FitProblem& problem, const Assembly& assembly, std::size_t link, const std::vector<ConvexHull>& roots) {
  std::vector<Eigen::Vector3d> points;
  for (const int piece : assembly.piecesOf(link)) {
    const auto i = static_cast<std::size_t>(piece);
    for (const Eigen::Vector3d& v : i < roots.size() ? roots[i].vertices : verticesOf(problem.kept[i - roots.size()]))
      points.push_back(assembly.pieces()[i].origin * v);
  }
  return points.empty() ? ConvexHull() : convexHull(points);
}

ReachProver proverFor(const FitProblem& problem, const Assembly& assembly, const RunControl& control) {
  std::map<const FitMesh*, ConvexHull> of_mesh;
  std::vector<ConvexHull> roots;
  for (const FitElement& element : problem.elements) {
    const FitMesh& mesh = *element.mesh;
    if (!of_mesh.count(&mesh)) of_mesh[&mesh] = writtenHulls(mesh, {static_cast<int>(mesh.tree.nodes.size()) - 1}, control).front();
    roots.push_back(of_mesh[&mesh]);
  }
  std::vector<ConvexHull> links;
  for (std::size_t link = 0; link < assembly.links(); ++link) links.push_back(hullOfLink(problem, assembly, link, roots));
  return ReachProver(assembly.kinematics(), links, problem.scene);
}

/// Moves the pairs that provably never come within the clearance from `pairs` to `proved`.
void prove(const FitProblem& problem, const Assembly& assembly, const std::vector<char>& may_be_proved, double clearance,
           const RunControl& control, PairRules& rules) {
  const ReachProver prover = proverFor(problem, assembly, control);
  ReachOptions options;
  options.evaluations = kEvaluations;
  std::vector<Reach> reach(rules.pairs.size());
  forEach(rules.pairs.size(), [&](std::size_t i) {
    const PartPair& pair = rules.pairs[i];
    if (!may_be_proved[i]) return;
    reach[i] = assembly.isLink(pair.b) ? prover.betweenLinks(pair.a, pair.b, clearance, options, control)
                                       : prover.betweenLinkAndBody(pair.a, pair.b - assembly.links(), clearance, options, control);
  });
  std::vector<PartPair> open;
  for (std::size_t i = 0; i < rules.pairs.size(); ++i) {
    if (reach[i].outcome == Reach::Outcome::kProved)
      rules.proved.push_back({rules.pairs[i].a, rules.pairs[i].b, reach[i].bound});
    else
      open.push_back(rules.pairs[i]);
  }
  rules.pairs = open;
}

using NamePair = std::pair<std::string, std::string>;

std::map<NamePair, const DisabledPair*> byName(const std::vector<DisabledPair>& disabled) {
  std::map<NamePair, const DisabledPair*> result;
  for (const DisabledPair& pair : disabled) result[std::minmax(pair.link1, pair.link2)] = &pair;
  return result;
}

/// Why a pair is left out, judging by the robot description and the user's SRDF; an empty reason: it is not.
LeftOutPair saidBefore(const Assembly& assembly, const std::map<NamePair, const DisabledPair*>& disabled, const Sighting& pair) {
  if (!pair.links) return {};
  const auto found = disabled.find(std::minmax(assembly.name(pair.a), assembly.name(pair.b)));
  if (assembly.kinematics().adjacent(pair.a, pair.b)) return {"", "", "Adjacent", "joined, or fixed to each other", true};
  if (found != disabled.end()) return {"", "", "Disabled", "by the SRDF: " + found->second->reason, true};
  return {};
}

/// On bodies of the scene that lie inside links, one at least.
std::string noteOnNested(const std::vector<std::string>& nested) {
  const std::size_t more = nested.size() - 1;
  return nested.front() + (more > 0 ? ", and " + counted(more, "more pair") + " like it" : "") +
         ": a check that takes meshes for surfaces, as FCL does, sees no contact there, and one that takes hulls for solids does; " +
         "correct the scene, or leave the body out of the planner's scene, too";
}

/// On pairs that count as clear from half of their usual distance on, one at least.
std::string noteOnClose(const std::vector<std::string>& close, double clearance) {
  const bool is_one = close.size() == 1;
  return counted(close.size(), "pair") + (is_one ? " is" : " are") + " hardly ever " + lengthText(clearance) + " apart, and " +
         (is_one ? "counts" : "each counts") + " as clear from half of its usual distance on: " + listedFirst(close, kMostListed);
}

}  // namespace

std::string nesting(const Assembly& assembly, const Originals& originals, std::size_t link, std::size_t body, const Places& places) {
  return originals.contains(link, body, places) ? assembly.name(body) + " inside " + assembly.name(link) : "";
}

double urgency(const PartPair& pair) {
  return (static_cast<double>(pair.unclear) + kNeverSeen) / std::max(pair.seconds, kLeastSeconds);
}

std::vector<PartPair> lookedAtAndProved(const PairRules& rules, double clearance) {
  std::vector<PartPair> pairs = rules.pairs;
  for (const ProvedPair& pair : rules.proved) pairs.push_back({pair.a, pair.b, clearance});
  return pairs;
}

PairRules withSrdf(PairRules rules, const FitProblem& problem, const Assembly& assembly) {
  if (!problem.rest_unheld.empty()) return rules;
  for (const ProvedPair& pair : rules.proved)
    if (assembly.isLink(pair.b)) rules.ignored.emplace_back(pair.a, pair.b);
  return rules;
}

PairRules pairRules(const FitProblem& problem, const Assembly& assembly, const Originals& originals, double clearance,
                    const RunControl& control) {
  PairRules rules;
  const auto leaveOut = [&](const Sighting& pair, LeftOutPair why) {
    why.first = assembly.name(pair.a);
    why.second = assembly.name(pair.b);
    rules.left_out.push_back(why);
    rules.ignored.emplace_back(pair.a, pair.b);
  };
  const std::map<NamePair, const DisabledPair*> disabled = byName(problem.disabled);
  std::vector<Sighting> pairs;
  for (const Sighting& pair : allPairs(assembly)) {
    const LeftOutPair why = saidBefore(assembly, disabled, pair);
    if (why.reason.empty())
      pairs.push_back(pair);
    else
      leaveOut(pair, why);
  }
  const std::vector<Places> places = surveyed(problem, assembly);
  const std::vector<char> near = everNear(places, assembly, originals, clearance, pairs, control);
  forEach(pairs.size(), [&](std::size_t i) {
    control.check();
    if (near[i])
      survey(places, originals, clearance, pairs[i]);
    else
      surveyFar(places.size(), clearance, pairs[i]);
  });
  std::vector<char> may_be_proved;
  std::vector<std::string> nested, close;
  for (const Sighting& pair : pairs) {
    LeftOutPair why = verdict(pair, problem);
    if (!why.reason.empty()) {
      const bool apart = !pair.links && !originals.touch(pair.a, pair.b, places.front());
      const std::string at_rest = apart ? nesting(assembly, originals, pair.a, pair.b, places.front()) : "";
      if (!at_rest.empty()) nested.push_back(at_rest);
      if (!at_rest.empty() && why.reason == "Fixed") why.known = "always " + at_rest;
      leaveOut(pair, why);
      continue;
    }
    if (pair.own < clearance) close.push_back(assembly.name(pair.a) + " and " + assembly.name(pair.b) + " (" + lengthText(pair.own) + ")");
    rules.pairs.push_back({pair.a, pair.b, pair.own, pair.unclear, pair.seconds});
    const Kinematics& kinematics = assembly.kinematics();
    const bool settled = pair.links ? kinematics.settled(pair.a, pair.b) : kinematics.settled(pair.a);
    may_be_proved.push_back(settled && pair.near == 0 && pair.at_rest >= clearance);
  }
  if (!nested.empty()) rules.notes.push_back(noteOnNested(nested));
  if (!close.empty()) rules.notes.push_back(noteOnClose(close, clearance));
  prove(problem, assembly, may_be_proved, clearance, control, rules);
  return rules;
}

}  // namespace collision_hulls
