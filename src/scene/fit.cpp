#include "collision_hulls/scene/fit.h"

#include <algorithm>
#include <cmath>

#include "collision_hulls/error.h"
#include "scene/comparison.h"
#include "scene/fit_report.h"

namespace collision_hulls {
namespace {

void check(const FitProblem& problem, const FitOptions& options) {
  if (!(options.clearance > 0 && std::isfinite(options.clearance)))
    throw Error(ErrorCode::kBadOption, "clearance is " + std::to_string(options.clearance) + " m; it must be a positive length");
  if (options.samples == 0) throw Error(ErrorCode::kBadOption, "samples is 0; at least one is needed to know anything");
  if (problem.elements.empty()) throw Error(ErrorCode::kBadOption, "the robot has no mesh that hulls could be fitted to");
}

std::vector<FittedElement> fittedElements(const FitProblem& problem, const Assembly& assembly, const Cuts& cuts,
                                          const RunControl& control) {
  std::vector<FittedElement> elements;
  for (std::size_t i = 0; i < problem.elements.size(); ++i) {
    FittedElement element;
    element.box = assembly.pieces()[i].tree->isBox(cuts[i].front());
    const FitMesh& mesh = *problem.elements[i].mesh;
    if (element.box) {
      element.hulls.push_back(hullOf(*mesh.box));
    } else {
      element.cut = cuts[i];
      std::sort(element.cut.begin(), element.cut.end());
      element.hulls = writtenHulls(mesh, element.cut, control);
    }
    elements.push_back(std::move(element));
  }
  return elements;
}

}  // namespace

SceneFit fitScene(const FitProblem& problem, const FitOptions& options, const RunControl& control) {
  check(problem, options);
  const Assembly assembly(problem, options.seed);
  const Originals originals(problem, assembly);
  const PairRules rules = pairRules(problem, assembly, originals, options.clearance, control);
  Fitting fitting(problem, options, assembly, originals, rules, control);
  fitting.run();

  const FittedModel model{problem, options, assembly, originals, rules, fitting};
  const Hits hits = countHits(model, control);
  SceneFit fit;
  fit.elements = fittedElements(problem, assembly, fitting.cuts(), control);
  fit.disabled = disabledPairs(model, hits);
  fit.report = fitReport(model, hits, control);
  if (options.compare) fit.report.models = comparison(model, control);
  return fit;
}

}  // namespace collision_hulls
