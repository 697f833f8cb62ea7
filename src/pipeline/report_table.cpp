#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "collision_hulls/pipeline/report.h"
#include "collision_hulls/pipeline/totals.h"

namespace collision_hulls {
namespace {

using Cells = std::vector<std::string>;
constexpr std::size_t kTextColumns = 2;  // link and mesh stand left, numbers right

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string millimetres(double metres) {
  return number("%.4g", 1000 * metres);
}

std::string lastPart(const std::string& uri) {
  return uri.substr(uri.find_last_of('/') + 1);
}

/// Bytes that start a character: what a terminal gives a column to, near enough.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

Cells cells(const ElementReport& row) {
  const StageSeconds& s = row.seconds;
  Cells result = {row.link, lastPart(row.uri)};
  if (row.status == Status::kFailed) {
    result.insert(result.end(), {row.triangles ? std::to_string(row.triangles) : "-", "-", "-", "-", "-", "-"});
  } else {
    result.insert(result.end(), {std::to_string(row.triangles), std::to_string(row.hulls), std::to_string(row.hull_vertices),
                                 millimetres(row.uncovered), millimetres(row.protrusion), millimetres(row.tolerance)});
  }
  result.push_back(number("%.2f", s.read + s.repair + s.decompose + s.certify + s.write));
  result.push_back(name(row.status));
  return result;
}

std::string aligned(const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string text;
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - width(row[i]), ' ');
      const bool last = i + 1 == row.size();
      text += i < kTextColumns ? row[i] + padding : last ? row[i] : padding + row[i];
      text += last ? "\n" : "  ";
    }
  }
  return text;
}

/// The reason of the first degraded row: the others are of its kind, and in the report.
std::string degradedLine(const Report& report) {
  const auto degraded = [](const ElementReport& row) { return row.status == Status::kDegraded; };
  const auto row = std::find_if(report.links.begin(), report.links.end(), degraded);
  if (row == report.links.end()) return "";
  return "degraded: " + row->link + ", " + lastPart(row->uri) + ": " + row->reason + "\n";
}

std::string sums(const Report& report) {
  const Totals sum = totals(report);
  return std::to_string(sum.meshes) + " meshes of " + std::to_string(sum.links) + " links, " + std::to_string(sum.triangles) +
         " triangles -> " + std::to_string(sum.hulls) + " hulls with " + std::to_string(sum.hull_vertices) + " vertices; " +
         std::to_string(sum.degraded) + " degraded, " + std::to_string(sum.failed) + " failed; " + number("%.1f", report.seconds) + " s\n";
}

std::string validationLine(const Report& report) {
  if (!report.options.validate) return "validation: not done\n";
  const Validation& v = report.validation;
  if (v.queries == 0) return "validation: nothing to ask\n";
  std::string text = "validation: " + std::to_string(v.queries) + " queries, " + std::to_string(v.missed) + " missed, " +
                     std::to_string(v.phantom) + " phantom, distance underestimated by at most " + millimetres(v.max_underestimate) +
                     " mm; FCL: " + std::to_string(v.exceptions) + " exceptions, " + std::to_string(v.disagreements) + " disagreements; " +
                     number("%.1f", v.mesh_query_us) + " us a query to the meshes, " + number("%.1f", v.hull_query_us) +
                     " us to the hulls\n";
  for (const std::string& remark : v.remarks) text += "  " + remark + "\n";
  return text;
}

std::string share(std::size_t part, std::size_t whole) {
  return std::to_string(part) + " of " + std::to_string(whole);
}

/// How often the hulls of two links hit where the links do not.
std::string selfTable(const FitReport& fit) {
  if (fit.self.empty()) return "";
  std::vector<Cells> rows = {{"link", "link", "hit", "single hulls alone", "fitted hulls alone"}};
  for (const PairHits& pair : fit.self)
    rows.push_back({pair.first, pair.second, std::to_string(pair.original), std::to_string(pair.before), std::to_string(pair.after)});
  return "self-collisions in " + std::to_string(fit.samples) + " samples:\n" + aligned(rows);
}

/// "19 of 549 hulls", "14 hulls and 5 primitives in place of 549 hulls", "2 primitives in place of 3 hulls".
std::string bodies(const FitReport& fit) {
  if (fit.primitives == 0) return share(fit.hulls, fit.full_hulls) + " hulls";
  const auto counted = [](std::size_t n, const std::string& noun) { return std::to_string(n) + " " + noun + (n == 1 ? "" : "s"); };
  const std::size_t hulls = fit.hulls - fit.primitives;
  return (hulls > 0 ? counted(hulls, "hull") + " and " : "") + counted(fit.primitives, "primitive") + " in place of " +
         counted(fit.full_hulls, "hull");
}

std::string sceneLines(const Report& report) {
  if (!report.scene) return "";
  const FitReport& fit = *report.scene;
  std::string text;
  for (const FittedLink& link : fit.links) text += "  " + link.link + ": " + link.reason + "\n";
  text += selfTable(fit);
  text += "scene '" + fit.scene + "': " + bodies(fit) + " for a clearance of " + millimetres(fit.clearance) + " mm; " +
          std::to_string(fit.samples) + (fit.given ? " given configurations: " : " fresh samples: ") + std::to_string(fit.missed) +
          " missed, " + std::to_string(fit.phantom) + " phantom";
  if (!fit.given)
    text += " (of all configurations no more than " + number("%.2g", 100 * fit.phantom_rate_bound) + " %, at 95 % confidence)";
  text += "; " + share(fit.proved_pairs, fit.pairs) + " pairs proved apart\n";
  return text + "FCL: " + number("%.3g", fit.query_us) + " us a collision query (meshes " + number("%.3g", fit.original_query_us) + "), " +
         number("%.3g", fit.distance_us) + " us a distance (meshes " + number("%.0f", fit.original_distance_us) + ")\n";
}

std::string noteLines(const Report& report) {
  std::string text;
  for (const std::string& note : report.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace

std::string toTable(const Report& report) {
  std::vector<Cells> rows = {
      {"link", "mesh", "triangles", "hulls", "vertices", "uncovered/mm", "protrusion/mm", "tolerance/mm", "seconds", "status"}};
  for (const ElementReport& row : report.links) rows.push_back(cells(row));
  return aligned(rows) + degradedLine(report) + sums(report) + validationLine(report) + sceneLines(report) + noteLines(report);
}

}  // namespace collision_hulls
