// The steps of a fit in order: pair rules, refinement (see fitting.cpp), counting hits, and what becomes of each element. The report is
// measured on the cuts' bodies, before hulls are completed to cover their meshes.
#include "collision_hulls/fit/fit.h"

#include <algorithm>
#include <cmath>

#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "collision_hulls/scene/configurations.h"
#include "fit/comparison.h"
#include "fit/enclosing.h"
#include "fit/fit_report.h"
#include "fit/near_problem.h"

namespace collision_hulls {
namespace {

/// Turns nodes into hulls as written and primitives around them. Writing hulls together may complete them, so each primitive is built anew.
FittedElement fittedElement(const FitMesh& mesh, const DetailTree& tree, std::vector<int> nodes, const RunControl& control) {
  std::sort(nodes.begin(), nodes.end(), [&](int a, int b) {
    return std::pair(tree.primitive(a) != nullptr, tree.hull(a)) < std::pair(tree.primitive(b) != nullptr, tree.hull(b));
  });
  FittedElement element;
  for (const int node : nodes) element.cut.push_back(tree.hull(node));
  element.hulls = writtenHulls(mesh, element.cut, control);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const GeometryElement* primitive = tree.primitive(nodes[i]);
    if (!primitive) continue;
    element.primitives.push_back(enclosingPrimitive(primitive->kind, element.hulls[i]));
    element.hulls[i] = hullAbout(element.primitives.back());
  }
  return element;
}

std::vector<FittedElement> fittedElements(const FitProblem& problem, const Assembly& assembly, const Cuts& cuts,
                                          const RunControl& control) {
  std::vector<FittedElement> elements;
  for (std::size_t i = 0; i < problem.elements.size(); ++i)
    elements.push_back(fittedElement(*problem.elements[i].mesh, *assembly.pieces()[i].tree, cuts[i], control));
  return elements;
}

}  // namespace

void check(const FitOptions& options) {
  if (!(options.clearance > 0 && std::isfinite(options.clearance)))
    throw Error(ErrorCode::kBadOption, "clearance is " + decimal(options.clearance) + " m; it must be a positive length");
  const std::size_t most = ConfigurationOptions().most;  // memory grows with either
  if (options.samples == 0 || options.samples > most)
    throw Error(ErrorCode::kBadOption, "samples is " + std::to_string(options.samples) + "; give 1 to " + std::to_string(most));
}

SceneFit fitScene(const FitProblem& whole, const FitOptions& options, const RunControl& control) {
  check(options);
  if (whole.elements.empty()) throw Error(ErrorCode::kBadOption, "the robot has no mesh to fit hulls to; select links that have one");
  const NearProblem near = nearProblem(whole, options.clearance, control);
  const FitProblem& problem = near.problem;
  const Assembly assembly(problem, options.seed, control);
  const Originals originals(problem, assembly, control);
  const PairRules rules = pairRules(problem, assembly, originals, options.clearance, control);
  Fitting fitting(problem, options, assembly, originals, rules, control);
  fitting.run();

  const FittedModel model{near, options, assembly, originals, rules, fitting};
  const Hits hits = countHits(model, control);
  SceneFit fit;
  fit.elements = fittedElements(problem, assembly, fitting.cuts(), control);
  fit.disabled = disabledPairs(model, hits);
  fit.report = fitReport(model, hits, control);
  if (options.compare) fit.report.models = comparison(model, control);
  return fit;
}

}  // namespace collision_hulls
