// report.json. Field names are a contract with other tools: add fields, but never rename or remove one.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/looks.h"
#include "collision_hulls/report/report.h"
#include "collision_hulls/report/totals.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

json toJson(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// The values as the command line has them, most under its names.
json toJson(const Options& options) {
  return {{"tolerance", toString(options.tolerance)},
          {"method", name(options.method)},
          {"effort", name(options.effort)},
          {"fill", options.fill},
          {"padding", options.padding},
          {"close_openings", options.close_openings},
          {"shapes", name(options.shapes)},
          {"tree", options.tree ? toString(*options.tree) : ""},
          {"segments", options.segments},
          {"max-hulls", options.max_hulls},
          {"max-vertices", options.max_vertices},
          {"links", options.links},
          {"source", name(options.source)},
          {"scale", options.scale},
          {"format", extension(options.format) + 1},
          {"uri", name(options.uri)},
          {"rebase", options.rebase},
          {"package-name", options.package_name},
          {"jobs", options.jobs},
          {"reader-memory", options.reader_memory},
          {"reader-time", options.reader_time},
          {"time-limit", options.time_limit},
          {"no-validate", !options.validate},
          {"no-cache", !options.cache},
          {"no-html", !options.html},
          {"replace-complete", options.replace_complete}};
}

json toJson(const RepairCounts& counts) {
  return {{"welded", counts.welded},
          {"degenerate", counts.degenerate},
          {"duplicate", counts.duplicate},
          {"flipped", counts.flipped},
          {"components", counts.components},
          {"open_edges", counts.open_edges},
          {"nonmanifold_edges", counts.nonmanifold_edges},
          {"weld_distance", counts.weld_distance}};
}

json toJson(const StageSeconds& seconds) {
  return {{"read", seconds.read},
          {"repair", seconds.repair},
          {"decompose", seconds.decompose},
          {"certify", seconds.certify},
          {"write", seconds.write}};
}

json regionsToJson(const ElementReport& row) {
  json regions = json::array();
  for (std::size_t i = 0; i < std::min(row.regions.size(), row.regions_given.size()); ++i)
    regions.push_back({{"region", row.regions_given[i].name},
                       {"tolerance", row.regions_given[i].tolerance},
                       {"protrusion", row.regions[i].bound},
                       {"protrusion_found", row.regions[i].found}});
  return regions;
}

json toJson(const ElementReport& row) {
  const bool has_hulls = row.status == Status::kOk || row.status == Status::kDegraded;
  const bool was_read = row.diagonal > 0;
  const auto of_hulls = [&](auto value) { return has_hulls ? json(value) : json(); };
  return {{"link", row.link},
          {"element", row.element},
          {"source", row.visual ? "visual" : "collision"},
          {"uri", row.uri},
          {"sha256", row.sha256},
          {"scale", toJson(row.scale)},
          {"triangles", row.triangles},
          {"skipped_primitives", row.skipped_primitives},
          {"status", name(row.status)},
          {"reason", row.reason},
          {"error", row.error},
          {"untried", row.untried},
          {"openings", {{"closed", row.closed_openings}, {"left", row.openings}, {"widest_left", row.widest_opening}}},
          {"repair", toJson(row.repair)},
          {"method", row.status == Status::kKept || row.status == Status::kRemoved ? "" : name(row.method)},
          {"tolerance", row.tolerance > 0 ? json(row.tolerance) : json()},
          {"padding", row.padding},
          {"close_openings", row.close_openings},
          {"shapes", name(row.shapes)},
          {"hulls", row.hulls},
          {"least_hulls", row.least_hulls},
          {"hull_vertices", row.hull_vertices},
          {"primitives", row.primitives},
          {"uncovered", of_hulls(row.uncovered)},
          {"protrusion", of_hulls(row.protrusion)},
          {"protrusion_found", of_hulls(row.protrusion_found)},
          {"worst", of_hulls(json{{"point", toJson(row.worst)}, {"nearest", toJson(row.worst_nearest)}})},
          {"regions", regionsToJson(row)},
          {"interior", row.interior},
          {"volume", was_read ? json(row.volume) : json()},
          {"hull_volume", of_hulls(row.hull_volume)},
          {"covered_share", of_hulls(row.covered_share)},
          {"diagonal", was_read ? json(row.diagonal) : json()},
          {"nudge", of_hulls(row.nudge)},
          {"thickness", of_hulls(row.thickness)},
          {"cached", row.cached},
          {"seconds", toJson(row.seconds)},
          {"files", row.files}};
}

json toJson(const Validation& v, bool cached) {
  return {{"cached", cached},
          {"queries", v.queries},
          {"missed", v.missed},
          {"phantom", v.phantom},
          {"max_underestimate", v.max_underestimate},
          {"exceptions", v.exceptions},
          {"timeouts", v.timeouts},
          {"nan", v.nan},
          {"disagreements", v.disagreements},
          {"mesh_query_us", v.mesh_query_us},
          {"hull_query_us", v.hull_query_us},
          {"remarks", v.remarks}};
}

json toJson(const FittedLink& link) {
  return {{"link", link.link}, {"hulls", link.hulls}, {"primitive", link.primitive}, {"reason", link.reason}, {"proved", link.proved}};
}

json toJson(const LeftOutPair& pair) {
  return {{"first", pair.first}, {"second", pair.second}, {"reason", pair.reason}, {"known", pair.known}};
}

json toJson(const PairHits& pair) {
  return {{"first", pair.first}, {"second", pair.second}, {"original", pair.original}, {"before", pair.before}, {"after", pair.after}};
}

template <typename Value>
json toJson(const std::vector<Value>& values) {
  json result = json::array();
  for (const Value& value : values) result.push_back(toJson(value));
  return result;
}

json toJson(const FitReport& fit) {
  return {{"name", fit.scene},
          {"clearance", fit.clearance},
          {"samples", fit.samples},
          {"given", fit.given},
          {"held", fit.held},
          {"asked", fit.asked},
          {"counterexamples", fit.counterexamples},
          {"original_hits", fit.original_hits},
          {"model_hits", fit.model_hits},
          {"missed", fit.missed},
          {"phantom", fit.phantom},
          {"phantom_rate_bound", fit.phantom_rate_bound},
          {"clear", fit.clear},
          {"clear_of", fit.clear_of},
          {"leaf_contacts", fit.leaf_contacts},
          {"pairs", fit.pairs},
          {"proved_pairs", fit.proved_pairs},
          {"far_bodies", fit.far_bodies},
          {"query_us", fit.query_us},
          {"original_query_us", fit.original_query_us},
          {"distance_us", fit.distance_us},
          {"original_distance_us", fit.original_distance_us},
          {"hulls", fit.hulls},
          {"full_hulls", fit.full_hulls},
          {"primitives", fit.primitives},
          {"scene_hits", fit.scene_hits},
          {"scene_contact", fit.scene_contact},
          {"seconds", fit.seconds},
          {"links", toJson(fit.links)},
          {"left_out", toJson(fit.left_out)},
          {"self_phantoms", toJson(fit.self)}};
}

json totalsToJson(const ModelReport& report, double seconds) {
  const Totals sum = totals(report);
  return {{"links", sum.links},
          {"meshes", sum.meshes},
          {"triangles", sum.triangles},
          {"hulls", sum.hulls},
          {"primitives", sum.primitives},
          {"least_hulls", sum.least_hulls},
          {"hull_vertices", sum.hull_vertices},
          {"seconds", seconds},
          {"failed", sum.failed},
          {"degraded", sum.degraded},
          {"kept", sum.kept},
          {"removed", sum.removed}};
}

json validationToJson(const ModelReport& report, const Options& options) {
  return options.validate ? toJson(report.validation, report.validation_cached) : json();
}

/// The models beside the one that the report's own rows describe.
json modelsToJson(const Report& report) {
  json models = json::array();
  for (const ModelReport& model : report.models) {
    models.push_back({{"model", model.model},
                      {"urdf", model.urdf},
                      {"links", json::array()},
                      {"validation", validationToJson(model, report.options)},
                      {"totals", totalsToJson(model, report.seconds)}});
  }
  return models;
}

/// Names in a description may be no UTF-8, which JSON cannot hold: such bytes are shown as U+FFFD. Non-finite numbers become null.
std::string text(const json& value) {
  return value.dump(1, ' ', false, json::error_handler_t::replace);
}

/// Writes the rows where the text has an empty list of links at this depth, from `place` on; then place is behind them. They become text
/// one by one: those of a large robot take ten times as much memory as a document.
void writeRows(const std::vector<ElementReport>& rows, std::size_t depth, const RunControl& control, std::string& document,
               std::size_t& place) {
  const std::string line = "\n" + std::string(depth, ' '), list = line + "\"links\": [";  // no string holds a line's end
  place = document.find(list + "]", place) + list.size();
  if (rows.empty()) return;
  Looks look(control, kLargeItemsBetweenLooks);
  std::string all;
  for (const ElementReport& row : rows) {
    look();
    all += all.empty() ? "\n" : ",\n";
    all += text(toJson(row));
  }
  std::string indented;
  for (const char c : all) c == '\n' ? indented += line + " " : indented += c;
  indented += line;
  document.insert(place, indented);
  place += indented.size();
}

json inputToJson(const Report& report) {
  json input = {{"path", report.input_path}, {"sha256", report.input_sha256}};
  if (!report.xacro_arguments.empty()) input["xacro_arguments"] = report.xacro_arguments;
  return input;
}

}  // namespace

std::string toJson(const Report& report, const RunControl& control) {
  json document = {{"collision_hulls", version()},
                   {"input", inputToJson(report)},
                   {"options", toJson(report.options)},
                   {"seed", report.options.seed},
                   {"links", json::array()},
                   {"files", report.files},
                   {"validation", validationToJson(report, report.options)},
                   {"notes", report.notes},
                   {"totals", totalsToJson(report, report.seconds)}};
  if (!report.models.empty()) {
    document["model"] = report.model;
    document["urdf"] = report.urdf;
    document["models"] = modelsToJson(report);
  }
  if (report.scene) document["scene"] = toJson(*report.scene);
  std::string result = text(document);
  std::size_t place = 0;
  writeRows(report.links, 1, control, result, place);
  place = 0;
  for (const ModelReport& model : report.models) writeRows(model.links, 3, control, result, place);
  return result + "\n";
}

}  // namespace collision_hulls
