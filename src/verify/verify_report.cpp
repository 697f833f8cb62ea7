// What was verified, for people and for programs. Field names are a contract with other tools: add fields, but never rename or remove one.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/report/report.h"
#include "collision_hulls/verify/verify.h"
#include "report/text_table.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

constexpr std::size_t kTextColumns = 1;             // link
constexpr std::size_t kMostLines = 10;              // of pairs of links, for each kind of difference
constexpr const char* kFalse = "false collisions";  // what JSON calls phantom

json toJson(const Largest& largest) {
  return {{"bound", largest.bound}, {"found", largest.found}, {"where", {largest.where.x(), largest.where.y(), largest.where.z()}}};
}

/// What was not measured is null, which JSON also makes of infinite numbers.
json toJson(const LinkVerification& row) {
  const bool failed = row.status == LinkStatus::kFailed;
  json object = {{"link", row.link},       {"status", name(row.status)}, {"reason", row.reason},         {"triangles", row.triangles},
                 {"hulls", row.hulls},     {"meshes", row.meshes},       {"primitives", row.primitives}, {"diagonal", row.diagonal},
                 {"queries", row.queries}, {"hits", row.hits},           {"missed", row.missed},         {"phantom", row.phantom},
                 {"seconds", row.seconds}};
  object["uncovered"] = failed || row.status == LinkStatus::kAdded ? json() : toJson(row.uncovered);
  object["uncovered_share"] = failed || row.status == LinkStatus::kAdded ? json() : json(row.uncovered_share);
  object["protrusion"] = failed || row.status == LinkStatus::kMissing ? json() : toJson(row.protrusion);
  return object;
}

json toJson(const PairVerification& pair) {
  return {{"first", pair.first}, {"second", pair.second}, {"queries", pair.queries},
          {"hits", pair.hits},   {"missed", pair.missed}, {"phantom", pair.phantom}};
}

std::string lengthCell(double metres) {
  return std::isfinite(metres) ? figureInMillimetres(metres) : "all";
}

Cells cells(const LinkVerification& row) {
  const bool failed = row.status == LinkStatus::kFailed, added = row.status == LinkStatus::kAdded,
             missing = row.status == LinkStatus::kMissing;
  std::string bodies = missing || failed ? "-" : counted(row.hulls, "hull");
  if (row.meshes > 0) bodies += ", " + counted(row.meshes, "mesh", "meshes");
  if (row.primitives > 0) bodies += ", " + counted(row.primitives, "primitive");
  const auto shown = [](bool is_known, const std::string& text) { return is_known ? text : std::string("-"); };
  const bool both = !failed && !added && !missing;
  return {row.link,
          bodies,
          shown(!failed && !added, lengthCell(row.uncovered.bound)),
          shown(both, lengthCell(row.uncovered.found)),
          shown(!failed && !added, figure(100 * row.uncovered_share)),
          shown(!failed && !missing, lengthCell(row.protrusion.bound)),
          shown(both, lengthCell(row.protrusion.found)),
          shown(both, std::to_string(row.missed) + " of " + std::to_string(row.hits)),
          shown(both, std::to_string(row.phantom) + " of " + std::to_string(row.queries - row.hits)),
          std::string(name(row.status)) + (row.status == LinkStatus::kOk && row.missed > 0 ? ", but misses" : "")};
}

/// A line for each of the pairs with the most missed or false collisions, those with most first. `line`: of a pair, after its names.
template <typename Line>
std::string pairLines(std::vector<PairVerification> pairs, const std::string& kind, std::size_t PairVerification::*number,
                      const Line& line) {
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), [&](const PairVerification& pair) { return pair.*number == 0; }), pairs.end());
  std::stable_sort(pairs.begin(), pairs.end(), [&](const PairVerification& a, const PairVerification& b) { return a.*number > b.*number; });
  std::string text;
  for (std::size_t i = 0; i < std::min(pairs.size(), kMostLines); ++i)
    text += kind + ": '" + pairs[i].first + "' and '" + pairs[i].second + "' " + line(pairs[i]) + "\n";
  if (pairs.size() > kMostLines) text += kind + ": " + counted(pairs.size() - kMostLines, "more pair") + " of links, which --json lists\n";
  return text;
}

/// The pairs of links that differ most, and what to do about them.
std::string pairLines(const Verification& verification) {
  const std::string missed = pairLines(verification.pairs, "missed", &PairVerification::missed, [](const PairVerification& pair) {
    return "do not collide in RESULT in " + std::to_string(pair.missed) + " of the " + counted(pair.hits, "configuration") +
           " in which they collide in ORIGINAL";
  });
  const std::string phantom = pairLines(verification.pairs, kFalse, &PairVerification::phantom, [](const PairVerification& pair) {
    return "collide in RESULT in " + std::to_string(pair.phantom) + " of the " + counted(pair.queries - pair.hits, "configuration") +
           " in which they do not collide in ORIGINAL";
  });
  if (phantom.empty()) return missed;
  return missed + phantom + kFalse +
         ": give these links a tighter model (decompose: a lower tolerance; fit_scene: a smaller clearance); or disable a pair, if it "
         "never collides in ORIGINAL\n";
}

/// On links that no query asks for.
std::string unqueried(const Verification& verification) {
  const auto is_one_sided = [](const LinkVerification& row) {
    return row.status == LinkStatus::kMissing || row.status == LinkStatus::kAdded;
  };
  const auto count = static_cast<std::size_t>(std::count_if(verification.links.begin(), verification.links.end(), is_one_sided));
  if (count == 0) return "";
  return "Not queried: " + counted(count, "link") + " with geometry on one side alone.\n";
}

/// Why rows are not ok, one a line.
std::string reasons(const Verification& verification) {
  std::string text;
  for (const LinkVerification& row : verification.links)
    if (!row.reason.empty()) text += std::string(name(row.status)) + ": " + row.link + ": " + row.reason + "\n";
  for (const std::string& note : verification.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace

std::string toTable(const Verification& verification) {
  std::vector<Cells> rows = {
      {"link", "RESULT", "uncovered [mm]", "found", "of area [%]", "protrusion [mm]", "found", "missed", kFalse, "status"}};
  for (const LinkVerification& row : verification.links) rows.push_back(cells(row));
  return aligned(rows, kTextColumns) + counted(verification.configurations, "configuration") + ", " +
         counted(verification.queries, "query", "queries") + ": RESULT missed " + std::to_string(verification.missed) + " of " +
         counted(verification.hits, "collision") + ", and has " + std::to_string(verification.phantom) + " that ORIGINAL does not have.\n" +
         unqueried(verification) +
         "Uncovered: the furthest that ORIGINAL's surface is from RESULT. Protrusion: the furthest that RESULT is from ORIGINAL's solid. "
         "Both "
         "are proved upper bounds; \"found\" is the largest seen.\n" +
         pairLines(verification) + reasons(verification);
}

std::string toJson(const Verification& verification, const VerifyOptions& options, const std::string& original, const std::string& result) {
  const auto gate = [](const std::optional<double>& value) { return value ? json(*value) : json(); };
  json links = json::array();
  for (const LinkVerification& row : verification.links) links.push_back(toJson(row));
  json pairs = json::array();
  for (const PairVerification& pair : verification.pairs) pairs.push_back(toJson(pair));
  const json document = {{"collision_hulls", version()},
                         {"original", original},
                         {"result", result},
                         {"options",
                          {{"links", options.links},
                           {"source", name(options.source)},
                           {"made-from", options.made_from ? json(options.made_from->report) : json()},
                           {"close-openings", options.close_openings},
                           {"max-uncovered", gate(options.max_uncovered)},
                           {"max-protrusion", gate(options.max_protrusion)},
                           {"configurations", options.configurations}}},
                         {"seed", options.seed},
                         {"links", links},
                         {"pairs", pairs},
                         {"queries",
                          {{"configurations", verification.configurations},
                           {"queries", verification.queries},
                           {"hits", verification.hits},
                           {"missed", verification.missed},
                           {"phantom", verification.phantom},
                           {"contradictions", verification.contradictions}}},
                         {"notes", verification.notes},
                         {"seconds", verification.seconds},
                         {"passed", passed(verification, options)}};
  // As in report.json: names that are no UTF-8 are shown as U+FFFD.
  return document.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace collision_hulls
