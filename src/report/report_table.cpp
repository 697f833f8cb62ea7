// The report as text for a person: one table, then what holds for all of it. decompose and fit_scene print it, and the node hands it on,
// so that all three show the same. Whoever needs more than three digits reads report.json.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/counted.h"
#include "base/failure_cause.h"
#include "base/string_parts.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "collision_hulls/report/report.h"
#include "collision_hulls/report/totals.h"
#include "report/check_text.h"
#include "report/text_table.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kTextColumns = 2;  // link and mesh, or two links
constexpr std::ptrdiff_t kLeastColumn = 4;

/// The name of a row's mesh; a terminal would obey control characters in it.
std::string fileOf(const ElementReport& row) {
  return shown(lastPart(row.uri));
}

/// The bound holds for covers within the tolerance: degraded rows may have fewer hulls.
std::optional<std::size_t> leastShown(const ElementReport& row) {
  return row.status == Status::kOk ? std::optional(row.least_hulls) : std::nullopt;
}

Cells cells(const ElementReport& row) {
  const StageSeconds& s = row.seconds;
  const std::string seconds = figure(s.read + s.repair + s.decompose + s.certify + s.write);
  if (row.status == Status::kKept || row.status == Status::kRemoved)
    return {row.link, row.uri.empty() ? "-" : fileOf(row), "-", "-", "-", "-", "-", "-", "-", name(row.status)};
  if (row.status == Status::kFailed)
    return {row.link, fileOf(row), row.triangles ? std::to_string(row.triangles) : "-", "-", "-", "-", "-", "-", seconds, name(row.status)};
  return {row.link,
          fileOf(row),
          std::to_string(row.triangles),
          bodiesInColumn(row.hulls, row.primitives),
          leastShown(row) ? std::to_string(*leastShown(row)) : "-",
          row.hulls > 0 ? std::to_string(row.hull_vertices) : "-",
          figureInMillimetres(row.protrusion),
          figureInMillimetres(row.tolerance),
          seconds,
          name(row.status)};
}

/// "9 ok, 1 degraded, 1 failed"
std::string statusCounts(const Totals& sum) {
  std::string text;
  const auto add = [&](std::size_t n, Status status) {
    if (n > 0) text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + name(status);
  };
  add(sum.meshes - sum.degraded - sum.failed, Status::kOk);
  add(sum.degraded, Status::kDegraded);
  add(sum.failed, Status::kFailed);
  add(sum.kept, Status::kKept);
  add(sum.removed, Status::kRemoved);
  return text;
}

Cells totalCells(const Report& report) {
  const Totals sum = totals(report);
  double protrusion = 0;
  std::optional<std::size_t> least;
  for (const ElementReport& row : report.links) {
    protrusion = std::max(protrusion, row.protrusion);
    if (const auto shown = leastShown(row)) least = least.value_or(0) + *shown;
  }
  return {"total",
          counted(sum.meshes, "mesh", "meshes") + " of " + counted(sum.links, "link"),
          std::to_string(sum.triangles),
          bodiesInColumn(sum.hulls, sum.primitives),
          least ? std::to_string(*least) : "-",
          std::to_string(sum.hull_vertices),
          sum.meshes > sum.failed ? figureInMillimetres(protrusion) : "-",
          "",
          figure(report.seconds),
          statusCounts(sum)};
}

std::string meshTable(const Report& report) {
  if (report.links.empty()) return "";
  std::vector<Cells> rows = {{"link", "mesh", "triangles", kindOfBodies(report), "at least", "vertices", "protrusion [mm]",
                              "tolerance [mm]", "time [s]", "status"}};
  for (const ElementReport& row : report.links) rows.push_back(cells(row));
  rows.push_back(totalCells(report));
  if (report.scene)  // a fit's hulls need not keep the tolerance, so no bound on their number is sought
    for (Cells& row : rows) row.erase(row.begin() + kLeastColumn);
  return aligned(rows, kTextColumns);
}

/// Of one model of several.
std::string modelHeading(const Report& report) {
  return report.models.empty() ? "" : "model '" + report.model + "', " + report.urdf + "\n";
}

/// What the columns mean. A row whose hulls left surface uncovered would have failed.
std::string legend(const Report& report) {
  const Totals sums = totals(report);
  if (sums.meshes == sums.failed) return "";
  const auto cached = std::count_if(report.links.begin(), report.links.end(), [](const ElementReport& row) { return row.cached; });
  const bool some_needed =
      std::any_of(report.links.begin(), report.links.end(), [](const ElementReport& row) { return leastShown(row).value_or(0) > 1; });
  std::string text = "The " + kindOfBodies(report) + " cover the whole surface of each mesh" +
                     (sums.failed > 0 ? " that has not failed" : "") +
                     ", and no point of them is further from its solid than the protrusion.\n";
  if (report.scene) text += "The tolerance is that of the finest hulls: coarser ones, where the scene allows them, protrude further.\n";
  if (some_needed && !report.scene)
    text += "\"at least\": proved, no cover within the tolerance has fewer hulls; 1 where no more is known.\n";
  if (report.links.size() > 1) text += "Meshes run in parallel; the total time is wall-clock time.\n";
  if (cached > 0) text += counted(static_cast<std::size_t>(cached), "mesh", "meshes") + " came from the cache.\n";
  return text;
}

/// What is proved of each mesh's regions.
std::string regionLines(const Report& report) {
  std::string text;
  for (const ElementReport& row : report.links) {
    for (std::size_t i = 0; i < std::min(row.regions.size(), row.regions_given.size()); ++i)
      text += "region '" + row.regions_given[i].name + "': in it, the hulls of " + row.link + ", " + fileOf(row) + " protrude by at most " +
              figureInMillimetres(row.regions[i].bound) + " mm; its tolerance is " + figureInMillimetres(row.regions_given[i].tolerance) +
              " mm\n";
  }
  return text;
}

/// FCL's own faults are rare and never ours: a line only if there are some.
std::string troubleLine(const Validation& v) {
  if (v.exceptions + v.disagreements + v.timeouts + v.nan == 0) return "";
  return "  FCL failed in " + counted(v.exceptions, "query", "queries") + ", disagreed with our own computation in " +
         std::to_string(v.disagreements) + ", took over a second in " + std::to_string(v.timeouts) + ", and returned NaN in " +
         std::to_string(v.nan) + "\n";
}

std::string validationLines(const Report& report) {
  if (totals(report).meshes == totals(report).failed) return "";
  const std::string of_what = report.scene ? " of single meshes: " : ": ";
  if (!report.options.validate) return "check" + of_what + "skipped (--no-validate)\n";
  const Validation& v = report.validation;
  if (v.queries == 0) return "check" + of_what + "nothing to compare\n";
  std::string text = "check" + of_what + checkText(v, kindOfBodies(report)) + "\n" + troubleLine(v);
  for (const std::string& remark : v.remarks) text += "  " + remark + "\n";
  return text + "speed" + of_what + "a distance query between a test body and a mesh takes " + figure(v.hull_query_us) +
         " us with the mesh's " + kindOfBodies(report) + ", " + figure(v.mesh_query_us) + " us with the mesh itself\n";
}

std::string share(std::size_t part, std::size_t whole) {
  return std::to_string(part) + " of " + std::to_string(whole);
}

/// How often the hulls of two links hit each other where the links do not, however near these are to each other.
std::string selfTable(const FitReport& fit) {
  if (fit.self.empty()) return "";
  std::vector<Cells> rows = {{"link", "link", "collisions", "false with single hulls", "false with fitted hulls"}};
  for (const PairHits& pair : fit.self)
    rows.push_back({pair.first, pair.second, std::to_string(pair.original), std::to_string(pair.before), std::to_string(pair.after)});
  return "self-collisions in " + counted(fit.samples, "configuration") +
         "; false ones count at any distance, also within the clearance:\n" + aligned(rows, kTextColumns);
}

/// "19 of 549 hulls", "14 hulls and 5 primitives in place of 549 hulls", "2 primitives in place of 3 hulls".
std::string bodies(const FitReport& fit) {
  if (fit.primitives == 0) return share(fit.hulls, fit.full_hulls) + " hulls";
  return countedBodies(fit.hulls - fit.primitives, fit.primitives) + " in place of " + counted(fit.full_hulls, "hull");
}

std::string sceneLines(const Report& report) {
  if (!report.scene) return "";
  const FitReport& fit = *report.scene;
  std::string text;
  for (const FittedLink& link : fit.links) text += "  " + link.link + ": " + link.reason + "\n";
  text += selfTable(fit);
  text += "scene '" + fit.scene + "': " + bodies(fit) + " for a clearance of " + figureInMillimetres(fit.clearance) + " mm\n";
  text += "check in the scene: " + counted(fit.samples, fit.given ? "given configuration" : "random configuration") +
          (fit.held.empty() ? "" : " with " + counted(fit.held.size(), "joint") + " held") + ": " +
          verdictText(fit.missed, fit.phantom, "clearance");
  if (!fit.given)
    text += " (at 95 % confidence in at most " + figure(100 * fit.phantom_rate_bound) + " % of all " + (fit.held.empty() ? "" : "such ") +
            "configurations)";
  if (fit.clear_of > 0) text += "; the meshes keep the clearance in " + share(fit.clear, fit.clear_of);
  text += "; " + share(fit.proved_pairs, fit.pairs) + " pairs proved to stay clear of each other";
  const auto left_out = std::count_if(fit.left_out.begin(), fit.left_out.end(), [](const LeftOutPair& pair) { return !pair.links; });
  if (left_out > 0) text += "; " + counted(static_cast<std::size_t>(left_out), "pair") + " with the scene left out";
  return text + "\nspeed in the scene: a collision query takes " + figure(fit.query_us) + " us with the model, " +
         figure(fit.original_query_us) + " us with the meshes; a distance query takes " + figure(fit.distance_us) + " us with the model, " +
         figure(fit.original_distance_us) + " us with the meshes\n";
}

std::string noteLines(const Report& report) {
  std::string text;
  for (const std::string& note : report.notes) text += "note: " + note + "\n";
  return text;
}

/// Names the link, unless the input is a single mesh, and the mesh, unless the reason does.
std::string failure(const Report& report, const ElementReport& row) {
  const bool single_mesh = row.uri == report.input_path;
  const bool named = row.reason.find(fileOf(row)) != std::string::npos;
  return (single_mesh ? "" : "link " + row.link + ": ") + (named ? "" : shown(row.uri) + ": ") + row.reason;
}

/// Files are missing, and out of bounds, folder by folder.
std::string cause(const ElementReport& row) {
  const Folder folder =
      row.error == name(ErrorCode::kFileNotFound) || row.error == name(ErrorCode::kOutsideRoots) ? Folder::kKept : Folder::kLeftOut;
  return row.error + "\n" + failureCause(row.reason, row.uri, row.link, folder);
}

/// Lines for failures with the same cause: one for all of them, if they are many.
std::vector<std::string> linesFor(const Report& report, const std::vector<const ElementReport*>& rows) {
  constexpr std::size_t kFew = 3;
  std::vector<std::string> lines;
  for (const ElementReport* row : rows) lines.push_back(failure(report, *row));
  if (rows.size() <= kFew) return lines;
  std::set<std::string> links;
  for (const ElementReport* row : rows) links.insert(row->link);
  return {lines.front() + theSameFor(rows.size() - 1, links.size())};
}

/// A mesh that fails for the same reason in several models is named once.
std::vector<const ElementReport*> failedRows(const Report& report) {
  std::vector<const ElementReport*> failed;
  std::set<std::tuple<std::string, int, std::string>> known;
  const auto add = [&](const ModelReport& model) {
    for (const ElementReport& row : model.links) {
      const bool is_new = known.emplace(row.link, row.element, row.reason).second;
      if (row.status == Status::kFailed && (is_new || &model == &report)) failed.push_back(&row);
    }
  };
  add(report);
  for (const ModelReport& model : report.models) add(model);
  return failed;
}

/// The links and meshes that miss a package.
struct Missing {
  std::size_t meshes = 0;
  std::set<std::string> links;
};

std::string line(const std::string& package, const Missing& missing) {
  return "package '" + package + "' was not found (" + counted(missing.meshes, "mesh", "meshes") + " of " +
         counted(missing.links.size(), "link") + "): install it and source its workspace, or say where it is with --package-path " +
         package + "=DIR";
}

}  // namespace

/// The others are of its kind.
std::string degradedLine(const Report& report, const std::string& where) {
  const auto degraded = [](const ElementReport& row) { return row.status == Status::kDegraded; };
  const auto row = std::find_if(report.links.begin(), report.links.end(), degraded);
  if (row == report.links.end()) return "";
  const auto others = static_cast<std::size_t>(std::count_if(row + 1, report.links.end(), degraded));
  return "degraded: " + row->link + ", " + fileOf(*row) + ": " + row->reason +
         (others > 0 ? " (" + counted(others, "more mesh", "more meshes") + ": see " + where + ")" : "") + "\n";
}

std::string toTable(const Report& report) {
  std::string text =
      modelHeading(report) + meshTable(report) + legend(report) + regionLines(report) + degradedLine(report) + validationLines(report);
  for (const ModelReport& model : report.models) {
    Report other = report;
    static_cast<ModelReport&>(other) = model;
    text += "\n" + modelHeading(other) + meshTable(other) + regionLines(other) + degradedLine(other) + validationLines(other);
  }
  return text + sceneLines(report) + noteLines(report);
}

std::vector<std::string> failures(const Report& report) {
  std::map<std::string, Missing> packages;
  std::vector<std::vector<const ElementReport*>> others;  // with the same cause
  std::map<std::string, std::size_t> known;               // by cause
  for (const ElementReport* row : failedRows(report)) {
    const std::optional<std::string> package = row->error == name(ErrorCode::kPackageNotFound) ? packageOf(row->uri) : std::nullopt;
    if (package) {
      ++packages[*package].meshes;
      packages[*package].links.insert(row->link);
    } else {
      const auto [place, is_new] = known.emplace(cause(*row), others.size());
      if (is_new) others.emplace_back();
      others[place->second].push_back(row);
    }
  }
  std::vector<std::string> all;
  for (const auto& [package, missing] : packages) all.push_back(line(package, missing));
  for (const auto& rows : others) {
    const std::vector<std::string> lines = linesFor(report, rows);
    all.insert(all.end(), lines.begin(), lines.end());
  }
  if (isRefuted(report))
    all.push_back(
        "the check contradicts the proof: do not trust these hulls, and please report the mesh; "
        "report.json has details under \"remarks\"");
  return all;
}

}  // namespace collision_hulls
