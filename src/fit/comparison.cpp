// Measures other models on the samples that verified the fitted one, against the same truth from the original meshes. The coarsest adequate
// uniform cut is found by bisection of the tolerance on a logarithmic scale.
#include "fit/comparison.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/parallel.h"
#include "fit/planner_model.h"

namespace collision_hulls {
namespace {

constexpr double kShares[] = {8, 4, 2, 1};  // tolerances of uniform cuts, in clearances
constexpr double kProvedShare = 0.5;        // of the clearance: if both bodies protrude by at most this, clear originals stay apart
constexpr int kHalvings = 12;               // in the search for the coarsest adequate uniform cut

/// What the original does in each sample.
struct Truth {
  std::vector<char> hit, clear;
};

Truth truthOf(const FittedModel& model, const RunControl& control) {
  const std::size_t first = model.fitting.verifiedFrom(), count = model.samples();
  Truth truth{hits(
                  model.assembly, [&] { return PlannerModel(model.assembly, model.rules, model.originals); }, first, count, control),
              std::vector<char>(count)};
  forEach(count, [&](std::size_t i) {
    control.check();
    if (!truth.hit[i]) truth.clear[i] = isClear(model.originals, model.fitting.pairs(), model.assembly.places(first + i));
  });
  return truth;
}

class Comparing {
 public:
  Comparing(const FittedModel& model, const RunControl& control)
      : model_(model),
        control_(control),
        truth_(truthOf(model, control)),
        timed_(withSrdf(model.rules, model.near.problem, model.assembly)) {}

  ModelRow original() const {
    ModelRow row = rowOf("original", truth_.hit);
    time(model_.originals, row);
    return row;
  }

  ModelRow cut(const std::string& name, const Cuts& cuts) const {
    ModelRow row = rowOf(name, hitsOf(cuts));
    row.hulls = model_.assembly.hulls(cuts);
    for (std::size_t i = 0; i < model_.near.problem.elements.size(); ++i)
      for (const int node : cuts[i]) row.vertices += model_.assembly.pieces()[i].tree->body(node).corners();
    time(cuts, row);
    return row;
  }

  ModelRow uniform(const std::string& name, double tolerance) const {
    ModelRow row = cut(name, cutsAt(tolerance));
    row.tolerance = tolerance;
    return row;
  }

  /// The largest tolerance whose uniform cut no sample refutes; 0: samples refute even the leaves.
  double adequateTolerance() const {
    double low = 0, high = 0;
    for (const FitElement& element : model_.near.problem.elements) high = std::max(high, element.mesh->tree.nodes.back().protrusion);
    if (adequate(high)) return high;
    for (const FitElement& element : model_.near.problem.elements) low = std::max(low, element.mesh->tree.tolerance);
    if (!adequate(low)) return 0;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = std::sqrt(low * high);
      (adequate(middle) ? low : high) = middle;
    }
    return low;
  }

 private:
  Cuts cutsAt(double tolerance) const {
    Cuts cuts = model_.assembly.roots();
    for (std::size_t i = 0; i < model_.near.problem.elements.size(); ++i)
      cuts[i] = model_.near.problem.elements[i].mesh->tree.cutAt(tolerance);
    return cuts;
  }

  std::vector<char> hitsOf(const Cuts& cuts) const {
    return hits(
        model_.assembly, [&] { return PlannerModel(model_.assembly, model_.rules, cuts); }, model_.fitting.verifiedFrom(), model_.samples(),
        control_);
  }

  /// Neither the verification samples nor the fit's counterexamples refute it.
  bool adequate(double tolerance) const {
    const Cuts cuts = cutsAt(tolerance);
    std::set<std::size_t> samples;
    for (const Contact& contact : model_.fitting.seen()) samples.insert(contact.sample);
    const bool refuted = std::any_of(samples.begin(), samples.end(), [&](std::size_t i) {
      return inContact(model_.assembly, cuts, model_.fitting.pairs(), model_.assembly.places(i));
    });
    return !refuted && rowOf("", hitsOf(cuts)).phantom == 0;
  }

  ModelRow rowOf(const std::string& name, const std::vector<char>& hit) const {
    ModelRow row;
    row.model = name;
    for (std::size_t i = 0; i < hit.size(); ++i) {
      row.clear += truth_.clear[i];
      row.phantom += truth_.clear[i] && hit[i];
      row.free += !truth_.hit[i];
      row.false_hits += !truth_.hit[i] && hit[i];
      row.missed += truth_.hit[i] && !hit[i];
    }
    return row;
  }

  template <typename Bodies>
  void time(const Bodies& bodies, ModelRow& row) const {
    PlannerModel planner(model_.assembly, timed_, bodies);
    TreeModel trees(model_.assembly, timed_, bodies);
    std::vector<std::size_t> all, close;
    for (std::size_t i = 0; i < model_.samples(); ++i) {
      all.push_back(model_.fitting.verifiedFrom() + i);
      if (!truth_.hit[i] && !truth_.clear[i]) close.push_back(all.back());
    }
    row.collision_us = collisionTime(model_.assembly, planner, all, control_);
    row.tree_us = collisionTime(model_.assembly, trees, all, control_);
    row.close_us = collisionTime(model_.assembly, planner, close, control_);
    row.distance_us = distanceTime(model_.assembly, planner, all, control_);
  }

  const FittedModel& model_;
  const RunControl& control_;
  const Truth truth_;
  const PairRules timed_;
};

}  // namespace

std::vector<ModelRow> comparison(const FittedModel& model, const RunControl& control) {
  const Comparing comparing(model, control);
  const double clearance = model.options.clearance;
  std::vector<ModelRow> rows{comparing.original(), comparing.cut("single_hull", model.assembly.roots())};
  for (const double share : kShares) rows.push_back(comparing.uniform("uniform", share * clearance));
  rows.push_back(comparing.uniform("uniform_proved", kProvedShare * clearance));
  rows.push_back(comparing.uniform("uniform_adequate", comparing.adequateTolerance()));
  rows.push_back(comparing.cut("fitted", model.fitting.cuts()));
  if (model.options.primitives) rows.push_back(comparing.cut("fitted_hulls", model.fitting.hullCuts()));
  rows.push_back(comparing.uniform("finest", 0));
  return rows;
}

}  // namespace collision_hulls
