// Builds the report of a fit from the verification samples: hits per pair, phantoms and their rate bound, query times, and a reason for
// each link's bodies. The rate bound is the exact Poisson upper limit, 3.7/N without a phantom in the first batch, which needs independent
// samples.
#include "fit/fit_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "base/counted.h"
#include "base/parallel.h"
#include "base/string_parts.h"
#include "fit/planner_model.h"
#include "scene/text.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostMeasured = 100;       // contacts per link among which the nearest is sought
constexpr std::size_t kMostNamed = 3;            // parts that a link may touch, in a message
constexpr std::size_t kLookedAt = 1000;          // samples: enough to tell a hundredth that keeps the clearance from none
constexpr std::size_t kEnoughForNever = 10'000;  // samples without contact, as many as MoveIt's Setup Assistant takes

std::size_t partOf(const FittedModel& model, int piece) {
  return model.assembly.pieces()[static_cast<std::size_t>(piece)].part;
}

double distanceIn(const FittedModel& model, const Contact& contact) {
  return model.originals.distanceBelow(std::numeric_limits<double>::max(), partOf(model, contact.piece[0]), partOf(model, contact.piece[1]),
                                       model.assembly.places(contact.sample));
}

/// The hardest case for a link's hulls: what the link comes near without touching, and how near.
struct Tightest {
  std::size_t other = 0;
  double distance = std::numeric_limits<double>::infinity();
};

std::map<std::size_t, Tightest> tightestOf(const FittedModel& model) {
  std::map<std::size_t, Tightest> tightest;
  std::map<std::size_t, std::size_t> measured;
  for (const Contact& contact : model.fitting.seen()) {
    const std::size_t a = partOf(model, contact.piece[0]), b = partOf(model, contact.piece[1]);
    const std::size_t of_a = ++measured[a], of_b = ++measured[b];
    if (of_a > kMostMeasured && of_b > kMostMeasured) continue;
    const double distance = distanceIn(model, contact);
    for (const auto& [link, other] : {PartIndices{a, b}, PartIndices{b, a}})
      if (distance < tightest[link].distance) tightest[link] = {other, distance};
  }
  return tightest;
}

/// The least proved distance of a link to anything that is not left out; nullopt if some pair with this link is checked.
std::optional<double> provedDistance(const FittedModel& model, std::size_t link) {
  for (const PartPair& pair : model.rules.pairs)
    if (pair.a == link || pair.b == link) return std::nullopt;
  double least = model.near.far[link];
  for (const ProvedPair& pair : model.rules.proved)
    if (pair.a == link || pair.b == link) least = std::min(least, pair.bound);
  return least;
}

/// What a link may touch because the pair is left out, other than its neighbours across a joint.
std::string leftOut(const FittedModel& model, std::size_t link) {
  const std::string& name = model.assembly.name(link);
  std::vector<std::string> names;
  for (const LeftOutPair& pair : model.rules.left_out) {
    if (pair.reason == "Adjacent" || (pair.first != name && !(pair.links && pair.second == name))) continue;
    names.push_back(pair.first == name ? pair.second : pair.first);
  }
  return listedFirst(names, kMostNamed);
}

/// The bodies of a link, by kind.
struct Bodies {
  std::size_t hulls = 0, all = 0;
  std::map<std::string, std::size_t> primitives;  // by kind

  /// "3 hulls, 2 boxes, 1 sphere"; or only the primitives.
  std::string text(bool with_hulls) const {
    std::string result = with_hulls && hulls > 0 ? counted(hulls, "hull") : "";
    for (const auto& [kind, count] : primitives)
      result += (result.empty() ? "" : ", ") + counted(count, kind, kind == "box" ? "boxes" : "");
    return result;
  }
};

std::string nameOf(GeometryElement::Kind kind) {
  return kind == GeometryElement::Kind::kBox ? "box" : kind == GeometryElement::Kind::kSphere ? "sphere" : "cylinder";
}

Bodies bodiesOf(const FittedModel& model, std::size_t link) {
  Bodies bodies;
  for (const int piece : model.assembly.piecesOf(link)) {
    const auto i = static_cast<std::size_t>(piece);
    if (i >= model.near.problem.elements.size()) continue;
    for (const int node : model.fitting.cuts()[i]) {
      const GeometryElement* primitive = model.assembly.pieces()[i].tree->primitive(node);
      ++bodies.all;
      ++(primitive ? bodies.primitives[nameOf(primitive->kind)] : bodies.hulls);
    }
  }
  return bodies;
}

std::string reasonOf(const FittedModel& model, const Bodies& bodies, std::size_t index, const std::map<std::size_t, Tightest>& tightest) {
  const std::string what = bodies.text(true) + ": ";
  if (const std::optional<double> proved = provedDistance(model, index)) {
    if (std::isinf(*proved)) return what + "no pair with this link is checked";
    const std::string except = leftOut(model, index);
    return what + "never within " + leastLengthText(*proved) + " of anything" + (except.empty() ? "" : " but " + except) + ", proved";
  }
  const auto found = tightest.find(index);
  if (found == tightest.end()) return what + "no false collision in " + counted(model.fitting.asked(), "sample");
  return what + "against " + model.assembly.name(found->second.other) + " at " + lengthText(found->second.distance);
}

std::vector<FittedLink> fittedLinks(const FittedModel& model) {
  const std::map<std::size_t, Tightest> tightest = tightestOf(model);
  std::vector<FittedLink> links;
  for (std::size_t link = 0; link < model.assembly.links(); ++link) {
    const Bodies bodies = bodiesOf(model, link);
    if (bodies.all == 0) continue;
    FittedLink fitted;
    fitted.link = model.assembly.name(link);
    fitted.hulls = bodies.hulls;
    fitted.primitive = bodies.all == 1 && bodies.hulls == 0 ? bodies.primitives.begin()->first : bodies.text(false);
    const std::optional<double> proved = provedDistance(model, link);
    fitted.proved = proved && leftOut(model, link).empty();
    fitted.reason = reasonOf(model, bodies, link, tightest);
    links.push_back(fitted);
  }
  return links;
}

std::string described(const FittedModel& model, const Contact& contact) {
  return model.assembly.name(partOf(model, contact.piece[0])) + " against " + model.assembly.name(partOf(model, contact.piece[1])) +
         " at " + lengthText(distanceIn(model, contact));
}

/// Where the original touches the scene at rest or, if it does not, which body lies inside a link; empty: nowhere.
std::string contactAtRest(const FittedModel& model) {
  const Assembly& assembly = model.assembly;
  const Places places = assembly.places(assembly.rest());
  std::string inside;
  for (std::size_t link = 0; link < assembly.links(); ++link) {
    for (std::size_t body = assembly.links(); body < assembly.parts(); ++body) {
      if (model.originals.touch(link, body, places)) return assembly.name(link) + " against " + assembly.name(body);
      if (inside.empty()) inside = nesting(assembly, model.originals, link, body, places);
    }
  }
  return inside;
}

/// Pairs of links whose hulls collide where the links do not, the worst first.
std::vector<PairHits> selfPhantoms(const std::map<PartIndices, PairHits>& of_pairs) {
  std::vector<PairHits> hits;
  for (const auto& [parts, pair] : of_pairs)
    if (pair.links && pair.before + pair.after > 0) hits.push_back(pair);
  std::stable_sort(hits.begin(), hits.end(), [](const PairHits& a, const PairHits& b) { return a.before > b.before; });
  return hits;
}

/// Of a link and a body of the scene: the pair whose originals collide in most samples, and in how many; empty: none do.
std::string mostSceneHits(const std::map<PartIndices, PairHits>& of_pairs) {
  const PairHits* most = nullptr;
  for (const auto& each : of_pairs)
    if (const PairHits& pair = each.second; !pair.links && pair.original > (most ? most->original : 0)) most = &pair;
  return most ? most->first + " against " + most->second + ", in " + std::to_string(most->original) : "";
}

std::size_t primitives(const FittedModel& model) {
  std::size_t count = 0;
  for (std::size_t link = 0; link < model.assembly.links(); ++link) {
    const Bodies bodies = bodiesOf(model, link);
    count += bodies.all - bodies.hulls;
  }
  return count;
}

/// Of the verification samples that are marked, in how many the original keeps its clearance.
std::size_t clearOnes(const FittedModel& model, const std::vector<char>& marked, const RunControl& control) {
  std::vector<char> clear(marked.size());
  forEach(marked.size(), [&](std::size_t i) {
    control.check();
    if (marked[i]) clear[i] = isClear(model.originals, model.fitting.pairs(), model.assembly.places(model.fitting.verifiedFrom() + i));
  });
  return static_cast<std::size_t>(std::count(clear.begin(), clear.end(), 1));
}

/// The pairs with most contacts between leaves, and how near their originals are in one of these.
std::string worstLeafContacts(const FittedModel& model) {
  std::map<PartIndices, std::vector<const Contact*>> by_pair;
  for (const Contact& contact : model.fitting.leafContacts())
    by_pair[{partOf(model, contact.piece[0]), partOf(model, contact.piece[1])}].push_back(&contact);
  std::vector<std::vector<const Contact*>> worst;
  for (const auto& [pair, contacts] : by_pair) worst.push_back(contacts);
  std::stable_sort(worst.begin(), worst.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  std::vector<std::string> texts;
  for (const auto& contacts : worst)
    texts.push_back(described(model, *contacts.front()) +
                    (contacts.size() > 1 ? " and in " + std::to_string(contacts.size() - 1) + " more" : ""));
  return listedFirst(texts, kMostNamed);
}

}  // namespace

double upperBound(std::size_t found, double risk) {
  // The mean at which a Poisson variable is at most `found` with this probability. The terms are summed from the last one down, as shares
  // of it: the first, exp(-mean), is no number above a mean of 745.
  const auto most = static_cast<double>(found);
  const auto logarithm = [&](double mean) {
    double term = 1, sum = 1;
    for (double i = most; i > 0 && term > 1e-17 * sum; --i) sum += term *= i / mean;
    return std::log(sum) + most * std::log(mean) - mean - std::lgamma(most + 1);
  };
  double low = 0, high = 10 + 3 * most - 2 * std::log(risk);
  for (int i = 0; i < 60; ++i) (logarithm((low + high) / 2) > std::log(risk) ? low : high) = (low + high) / 2;
  return high;
}

double rateBound(std::size_t found, std::size_t samples, std::size_t batch) {
  constexpr double kRisk = 0.05;  // of all batches: a half of it, a quarter, ...
  return std::min(1.0, upperBound(found, std::ldexp(kRisk, -static_cast<int>(batch))) / static_cast<double>(samples));
}

Hits countHits(const FittedModel& model, const RunControl& control) {
  const CheckedPairs pairs(model.assembly, lookedAtAndProved(model.rules, model.options.clearance));
  const Cuts roots = model.assembly.roots();
  struct Sample {
    std::set<PartIndices> original, before, after;
  };
  std::vector<Sample> samples(model.samples());
  forEach(samples.size(), [&](std::size_t i) {
    control.check();
    const std::size_t index = model.fitting.verifiedFrom() + i;
    const Places places = model.assembly.places(index);
    Sample& sample = samples[i];
    for (const PartIndices& pair : partsOf(model.assembly, contacts(model.assembly, roots, pairs, places, index)))
      (model.originals.touch(pair.first, pair.second, places) ? sample.original : sample.before).insert(pair);
    for (const PartIndices& pair : partsOf(model.assembly, contacts(model.assembly, model.fitting.cuts(), pairs, places, index)))
      if (!sample.original.count(pair)) sample.after.insert(pair);
  });
  Hits result;
  std::map<PartIndices, PairHits>& hits = result.pairs;
  for (const PartPair& pair : pairs.all())
    hits[{pair.a, pair.b}] = {model.assembly.name(pair.a), model.assembly.name(pair.b), model.assembly.isLink(pair.b)};
  for (const Sample& sample : samples) {
    for (const PartIndices& pair : sample.original) ++hits.at(pair).original;
    for (const PartIndices& pair : sample.before) ++hits.at(pair).before;
    for (const PartIndices& pair : sample.after) ++hits.at(pair).after;
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& touching = samples[i].original;
    const auto pair =
        std::find_if(touching.begin(), touching.end(), [&](const PartIndices& p) { return !model.assembly.isLink(p.second); });
    if (pair == touching.end()) continue;
    if (++result.scene == 1)
      result.first_in_scene =
          "number " + std::to_string(i + 1) + ", " + model.assembly.name(pair->first) + " against " + model.assembly.name(pair->second);
  }
  return result;
}

FitReport fitReport(const FittedModel& model, const Hits& counted, const RunControl& control) {
  const Assembly& assembly = model.assembly;
  const Cuts& cuts = model.fitting.cuts();
  const std::size_t first = model.fitting.verifiedFrom(), count = model.samples();
  const auto fitted = [&] { return PlannerModel(assembly, model.rules, cuts); };
  const auto original = [&] { return PlannerModel(assembly, model.rules, model.originals); };

  FitReport report;
  report.scene = model.near.problem.scene.name;
  report.clearance = model.options.clearance;
  report.samples = count;
  report.given = !model.near.problem.configurations.empty();
  report.asked = model.fitting.asked();
  report.counterexamples = model.fitting.cured();
  const std::vector<char> hit = hits(assembly, fitted, first, count, control), true_hit = hits(assembly, original, first, count, control);
  for (std::size_t i = 0; i < count; ++i) {
    report.model_hits += hit[i] != 0;
    report.original_hits += true_hit[i] != 0;
    report.missed += true_hit[i] && !hit[i];
  }
  report.clear_of = std::min(count, kLookedAt);
  std::vector<char> may_be_clear(report.clear_of), may_be_phantom(count);
  for (std::size_t i = 0; i < count; ++i) {
    may_be_phantom[i] = hit[i] && !true_hit[i];
    if (i < report.clear_of) may_be_clear[i] = !true_hit[i];
  }
  report.phantom = clearOnes(model, may_be_phantom, control);
  report.clear = clearOnes(model, may_be_clear, control);
  report.phantom_rate_bound = report.given ? 0 : rateBound(report.phantom, count, model.fitting.verifyingBatches());
  report.far_bodies = model.near.far_bodies;
  report.proved_pairs = model.rules.proved.size() + model.near.links * model.near.far_bodies;
  report.pairs = model.rules.pairs.size() + report.proved_pairs;
  const PairRules asked = withSrdf(model.rules, model.near.problem, assembly);
  std::vector<std::size_t> samples(count);
  std::iota(samples.begin(), samples.end(), first);
  PlannerModel timed(assembly, asked, cuts), timed_original(assembly, asked, model.originals);
  report.query_us = collisionTime(assembly, timed, samples, control);
  report.original_query_us = collisionTime(assembly, timed_original, samples, control);
  report.distance_us = distanceTime(assembly, timed, samples, control);
  report.original_distance_us = distanceTime(assembly, timed_original, samples, control);
  report.hulls = assembly.hulls(cuts);
  report.primitives = primitives(model);
  for (std::size_t i = 0; i < model.near.problem.elements.size(); ++i) report.full_hulls += assembly.pieces()[i].tree->leaves();
  report.links = fittedLinks(model);
  report.leaf_contacts = model.fitting.leafContacts().size();
  report.leaf_contact = worstLeafContacts(model);
  report.scene_hits = counted.scene;
  report.first_scene_hit = counted.first_in_scene;
  report.most_scene_hits = mostSceneHits(counted.pairs);
  report.scene_contact = contactAtRest(model);
  report.self = selfPhantoms(counted.pairs);
  report.left_out = model.rules.left_out;
  report.notes = model.rules.notes;
  return report;
}

std::vector<DisabledPair> disabledPairs(const FittedModel& model, const Hits& hits) {
  const FitProblem& problem = model.near.problem;
  const bool held = !problem.rest_unheld.empty();
  const bool all_over = problem.configurations.empty() && !held;  // samples cover the joints' whole ranges
  std::vector<DisabledPair> disabled;
  for (const LeftOutPair& pair : model.rules.left_out) {
    if (!pair.links || (pair.reason == "Always" && !all_over)) continue;
    disabled.push_back({pair.first, pair.second, pair.reason == "Disabled" ? "User" : pair.reason, pair.known});
  }
  std::map<PartIndices, double> proved;
  for (const ProvedPair& pair : model.rules.proved) proved[{pair.a, pair.b}] = pair.bound;
  const bool enough = all_over && model.samples() >= kEnoughForNever;
  for (const auto& [parts, pair] : hits.pairs) {
    if (pair.original > 0 || !pair.links) continue;
    const auto bound = proved.find(parts);
    const bool is_proved = bound != proved.end() && !held;
    if (!is_proved && !(enough && model.assembly.kinematics().settled(parts.first, parts.second))) continue;
    disabled.push_back({pair.first, pair.second, "Never",
                        is_proved ? "never within " + leastLengthText(bound->second) + ", proved"
                                  : "in none of " + std::to_string(model.samples()) + " samples"});
  }
  return disabled;
}

}  // namespace collision_hulls
