// Field by field: the messages repeat the core's types.
#include "conversions.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>

#include "base/counted.h"
#include "base/figure.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/progress_text.h"
#include "collision_hulls/report/totals.h"
#include "collision_hulls/robot/robot_description.h"
#include "pen.h"
#include "report/check_text.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

std::string bodiesOf(const Report& report) {
  const Totals sums = totals(report);
  return countedBodies(sums.hulls, sums.primitives);
}

/// Where the quotation or the indented line ends that begins at `at`; `at` if none does.
std::size_t endOfQuotation(const std::string& text, std::size_t at) {
  const auto isLetter = [&](std::size_t i) { return std::isalnum(static_cast<unsigned char>(text[i])) != 0; };
  std::size_t end = at;
  if (text.compare(at, 3, "\n  ") == 0) end = std::min(text.find('\n', at + 1), text.size());
  if (text[at] == '\'' && (at == 0 || !isLetter(at - 1))) end = text.find('\'', at + 1) + 1;  // 0 without an end
  return std::max(end, at);
}

/// Where the option's name ends that begins at `at`: "--jobs", or "jobs" before its value at the start; `at` if none does.
std::size_t endOfOption(const std::string& text, std::size_t at) {
  const bool has_dashes = text.compare(at, 2, "--") == 0 && (at == 0 || std::string(" (\n").find(text[at - 1]) != std::string::npos);
  if (!has_dashes && at > 0) return at;
  const std::size_t name = has_dashes ? at + 2 : at;
  if (name == text.size() || std::islower(static_cast<unsigned char>(text[name])) == 0) return at;
  const std::size_t end = std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", name), text.size());
  return has_dashes || text.compare(end, 2, " '") == 0 ? end : at;
}

std::string parameterOf(const std::string& option) {
  for (const char* alone : {"--for", "--json", "--quiet", "--replace-complete", "--root", "--scale"})
    if (option == alone) return option;  // the program's, and no parameter
  std::string name = option.substr(option.find_first_not_of('-')), value;
  if (name.compare(0, 3, "no-") == 0) name.erase(0, 3), value = " false";
  std::replace(name.begin(), name.end(), '-', '_');
  if (option[0] != '-') return name;  // a field of the request, or a parameter
  return (name == "package_path" ? "the start-up parameter ~" : "~") + name + value;
}

}  // namespace

LinkReport toMessage(const ElementReport& row, const Eigen::Isometry3d& origin) {
  LinkReport message;
  message.link = row.link;
  message.element = row.element;
  message.uri = row.uri;
  message.status = name(row.status);
  message.reason = inNodeWords(row.reason);
  message.triangles = static_cast<std::uint32_t>(row.triangles);
  message.hulls = static_cast<std::uint32_t>(row.hulls);
  message.hull_vertices = static_cast<std::uint32_t>(row.hull_vertices);
  message.tolerance = row.tolerance;
  message.uncovered = message.protrusion = message.protrusion_found = std::numeric_limits<double>::quiet_NaN();
  if (row.status == Status::kOk || row.status == Status::kDegraded) {
    message.uncovered = row.uncovered;
    message.protrusion = row.protrusion;
    message.protrusion_found = row.protrusion_found;
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
  feedback.primitives = static_cast<std::uint32_t>(step.primitives);
  feedback.fraction = step.fraction;
  feedback.seconds_left = step.seconds_left < 0 ? -1 : step.seconds_left;
  feedback.text = stepText(step);
  return feedback;
}

std::string summary(const std::string& robot, const Report& report) {
  const RunTotals sums = toTotals(report);
  std::string text;
  for (const std::string& failure : failures(report)) text += failure + "\n";
  text += degradedLine(report, "the table") + "robot '" + robot + "': ";
  if (sums.failed > 0 && sums.failed == sums.meshes)
    return inNodeWords(text + (sums.failed == 1 ? "its mesh could not" : "none of its " + std::to_string(sums.failed) + " meshes could") +
                       " be decomposed");
  text += bodiesOf(report) + " for " + counted(sums.meshes - sums.failed, "mesh", "meshes");
  if (sums.degraded > 0) text += ", " + std::to_string(sums.degraded) + " degraded";
  if (sums.failed > 0) text += ", " + std::to_string(sums.failed) + " failed";
  if (!sums.worst_link.empty()) text += "; largest protrusion " + figure(1000 * sums.protrusion) + " mm (" + sums.worst_link + ")";
  return inNodeWords(text);
}

std::string inNodeWords(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t quotation = endOfQuotation(text, at), option = endOfOption(text, at);
    const std::size_t end = std::max({quotation, option, at + 1});
    const std::string part = text.substr(at, end - at);
    result += option > at ? parameterOf(part) : part;
    at = end;
  }
  return result;
}

void checkBase(const std::string& base) {
  if (base.empty() || fs::path(base).is_absolute()) return;
  const std::size_t scheme = base.find("://");
  if (scheme == std::string::npos) throw Error(ErrorCode::kBadOption, "base '" + base + "' is relative; give an absolute path");
  const std::string rest = base.substr(scheme + 3);
  std::string path = "the file's absolute path";
  if (base.rfind("file:///", 0) == 0) path = "'" + percentDecoded(rest) + "'";
  if (packageOf(base))
    path += ": what 'rospack find " + *packageOf(base) + "' prints, and '" + rest.substr(std::min(rest.find('/'), rest.size())) + "'";
  throw Error(ErrorCode::kBadOption, "base '" + base + "' is a URI, and a request's base is a path; give " + path);
}

}  // namespace collision_hulls
