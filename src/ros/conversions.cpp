// Field by field: the messages repeat the core's types.
#include "conversions.h"

#include "base/counted.h"
#include "base/figure.h"
#include "collision_hulls/pipeline/progress_text.h"
#include "collision_hulls/report/totals.h"
#include "pen.h"

namespace collision_hulls {
namespace {

/// "7 hulls", "7 hulls and 2 primitives", "2 primitives"
std::string bodiesOf(const Report& report) {
  const Totals sums = totals(report);
  if (sums.primitives == 0) return counted(sums.hulls, "hull");
  return (sums.hulls > 0 ? counted(sums.hulls, "hull") + " and " : "") + counted(sums.primitives, "primitive");
}

}  // namespace

LinkReport toMessage(const ElementReport& row, const Eigen::Isometry3d& origin) {
  LinkReport message;
  message.link = row.link;
  message.element = row.element;
  message.uri = row.uri;
  message.status = name(row.status);
  message.reason = row.reason;
  message.triangles = static_cast<std::uint32_t>(row.triangles);
  message.hulls = static_cast<std::uint32_t>(row.hulls);
  message.hull_vertices = static_cast<std::uint32_t>(row.hull_vertices);
  message.tolerance = row.tolerance;
  message.uncovered = row.uncovered;
  message.protrusion = row.protrusion;
  message.protrusion_found = row.protrusion_found;
  if (row.status == Status::kOk || row.status == Status::kDegraded) {
    message.worst = toPoint(origin * row.worst);
    message.worst_nearest = toPoint(origin * row.worst_nearest);
  }
  const StageSeconds& s = row.seconds;
  message.seconds = s.read + s.repair + s.decompose + s.certify + s.write;
  return message;
}

std::vector<LinkReport> toMessages(const RobotResult& result) {
  std::vector<LinkReport> messages;
  for (std::size_t i = 0; i < result.elements.size(); ++i)
    messages.push_back(toMessage(result.report.links[i], result.elements[i].source.origin));
  return messages;
}

RunTotals toTotals(const Report& report) {
  const Totals sums = totals(report);
  RunTotals message;
  message.links = static_cast<std::uint32_t>(sums.links);
  message.meshes = static_cast<std::uint32_t>(sums.meshes);
  message.triangles = static_cast<std::uint32_t>(sums.triangles);
  message.hulls = static_cast<std::uint32_t>(sums.hulls);
  message.hull_vertices = static_cast<std::uint32_t>(sums.hull_vertices);
  message.degraded = static_cast<std::uint32_t>(sums.degraded);
  message.failed = static_cast<std::uint32_t>(sums.failed);
  for (const ElementReport& row : report.links) {
    if (row.protrusion <= message.protrusion) continue;
    message.protrusion = row.protrusion;
    message.worst_link = row.link;
  }
  message.seconds = report.seconds;
  return message;
}

DecomposeFeedback toMessage(const Step& step) {
  DecomposeFeedback feedback;
  feedback.stage = step.stage;
  feedback.link = step.item;
  feedback.done = static_cast<std::uint32_t>(step.done);
  feedback.total = static_cast<std::uint32_t>(step.total);
  feedback.hulls = static_cast<std::uint32_t>(step.hulls);
  feedback.fraction = step.fraction;
  feedback.seconds_left = step.seconds_left < 0 ? -1 : step.seconds_left;
  feedback.text = stepText(step);
  return feedback;
}

std::string summary(const std::string& robot, const Report& report) {
  const RunTotals sums = toTotals(report);
  std::string text;
  for (const std::string& failure : failures(report)) text += failure + "\n";
  text += "robot '" + robot + "': " + bodiesOf(report) + " for " + counted(sums.meshes - sums.failed, "mesh", "meshes");
  if (sums.failed > 0) text += ", " + std::to_string(sums.failed) + " failed";
  if (!sums.worst_link.empty()) text += "; largest protrusion " + figure(1000 * sums.protrusion) + " mm (" + sums.worst_link + ")";
  return text;
}

}  // namespace collision_hulls
