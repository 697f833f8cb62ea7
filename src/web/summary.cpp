// The totals in words. "Never miss" is what covering the surface proves, "at most" that the protrusion is proved; how much quicker queries
// was measured, by the validation for single meshes and by the fit for the robot in its scene, and is left out where it was not.
#include "web/summary.h"

#include <algorithm>

#include "base/figure.h"
#include "collision_hulls/report/totals.h"
#include "report/check_text.h"
#include "web/html_text.h"

namespace collision_hulls {
namespace {

std::string many(std::size_t number, const std::string& noun, const std::string& plural = "") {
  return grouped(number) + " " + (number == 1 ? noun : plural.empty() ? noun + "s" : plural);
}

/// "6.6 times quicker", "1.3 times slower"
std::string ratio(double original_us, double model_us) {
  const bool quicker = original_us >= model_us;
  const double times = quicker ? original_us / model_us : model_us / original_us;
  return figure(times) + " times " + (quicker ? "quicker" : "slower");
}

/// "They answer collision queries 8.1 times, ...": of what was measured. Empty if nothing was.
std::string speed(const ModelReport& model, const Report& report) {
  const Validation& v = model.validation;
  const auto measured = [](double one, double other) { return one > 0 && other > 0; };
  std::vector<std::string> parts;
  if (report.scene && measured(report.scene->original_query_us, report.scene->query_us))
    parts.push_back("collision queries " + ratio(report.scene->original_query_us, report.scene->query_us));
  if (report.scene && measured(report.scene->original_distance_us, report.scene->distance_us))
    parts.push_back("distance queries " + ratio(report.scene->original_distance_us, report.scene->distance_us));
  if (!report.scene && report.options.validate && measured(v.mesh_query_us, v.hull_query_us))
    parts.push_back("distance queries " + ratio(v.mesh_query_us, v.hull_query_us));
  if (parts.empty()) return "";
  return "answer " + parts.front() + (parts.size() > 1 ? " and " + parts.back() : "") + " than the " +
         (totals(model).meshes == 1 ? "mesh" : "meshes");
}

double largestBound(const ModelReport& model) {
  double bound = 0;
  for (const ElementReport& row : model.links)
    if (row.status != Status::kFailed) bound = std::max(bound, row.protrusion);
  return bound;
}

/// "190 hulls", "14 hulls and 5 primitives"
std::string bodies(const ModelReport& model) {
  std::size_t primitives = 0;
  for (const ElementReport& row : model.links) primitives += row.primitives;
  const std::size_t hulls = totals(model).hulls;
  if (primitives == 0) return many(hulls, "hull");
  return (hulls > 0 ? many(hulls, "hull") + " and " : "") + many(primitives, "primitive");
}

std::string totalsSentence(const ModelReport& model, const Report& report) {
  const Totals sum = totals(model);
  const std::string before = many(sum.triangles, "triangle") + " in " + many(sum.meshes, "mesh", "meshes");
  if (sum.meshes == sum.failed) return before + ": no hulls.";
  const bool of_all = sum.failed + sum.kept + sum.removed == 0;
  std::vector<std::string> claims{of_all ? "never miss a collision" : "never miss a collision with the surface that they cover",
                                  "protrude by at most " + figure(1000 * largestBound(model)) + " mm"};
  const std::string quick = speed(model, report);
  if (!quick.empty()) claims.push_back(quick);
  std::string text = before + " \xE2\x86\x92 " + bodies(model) + ". They ";
  for (std::size_t i = 0; i < claims.size(); ++i)
    text += (i == 0 ? "" : i + 1 < claims.size() ? ", " : claims.size() > 2 ? ", and " : " and ") + claims[i];
  return text + ".";
}

/// What the configuration leaves out, whatever collides there.
std::string linksSentence(const ModelReport& model) {
  const Totals sum = totals(model);
  const auto links = [](std::size_t n, const std::string& done) { return many(n, "link") + (n == 1 ? " is " : " are ") + done; };
  if (sum.kept + sum.removed == 0) return "";
  return (sum.kept > 0 ? links(sum.kept, "kept as described") : "") + (sum.kept > 0 && sum.removed > 0 ? ", and " : "") +
         (sum.removed > 0 ? links(sum.removed, "left without collision elements") : "") + ", as configured.";
}

std::string checkSentence(const ModelReport& model, const Report& report) {
  const Validation& v = model.validation;
  if (totals(model).meshes == totals(model).failed) return "";
  if (!report.options.validate) return "Not compared by collision queries (--no-validate).";
  if (v.queries == 0) return "";
  return checkText(v, kindOfBodies(model), many) + ".";
}

std::string sceneSentence(const Report& report) {
  if (!report.scene) return "";
  const FitReport& fit = *report.scene;
  std::string text = "Fitted to the scene " + fit.scene + " with a clearance of " + figure(1000 * fit.clearance) + " mm: in " +
                     many(fit.samples, fit.given ? "given configuration" : "random configuration") +
                     (fit.held.empty() ? "" : " with " + many(fit.held.size(), "joint") + " held") + ", " +
                     verdictText(fit.missed, fit.phantom, "clearance", many);
  if (!fit.given)
    text += " (at 95 % confidence in at most " + figure(100 * fit.phantom_rate_bound) + " % of all " + (fit.held.empty() ? "" : "such ") +
            "configurations)";
  return text + ".";
}

}  // namespace

std::vector<std::string> summary(const ModelReport& model, const Report& report) {
  std::vector<std::string> sentences;
  for (const std::string& sentence :
       {totalsSentence(model, report), linksSentence(model), sceneSentence(report), checkSentence(model, report)})
    if (!sentence.empty()) sentences.push_back(sentence);
  return sentences;
}

std::vector<std::string> warnings(const ModelReport& model, const Report& report) {
  const Totals sum = totals(model);
  const Validation checked = report.options.validate ? model.validation : Validation();
  const std::size_t missed = checked.missed + (report.scene ? report.scene->missed : 0);
  const auto of = [&](std::size_t part) { return grouped(part) + " of " + many(sum.meshes, "mesh", "meshes"); };
  std::vector<std::string> sentences;
  if (sum.failed > 0)
    sentences.push_back(of(sum.failed) + " failed: no hulls, and a link with one keeps the collision elements that it has.");
  if (sum.degraded > 0)
    sentences.push_back(of(sum.degraded) + (sum.degraded == 1 ? " protrudes" : " protrude") + " further than the tolerance.");
  if (missed > 0)
    sentences.push_back(many(missed, "collision") + " missed in the check: please report this as a fault of collision_hulls.");
  if (checked.phantom > 0)
    sentences.push_back(many(checked.phantom, "false collision") +
                        " beyond the protrusion: please report this as a fault of collision_hulls.");
  return sentences;
}

}  // namespace collision_hulls
