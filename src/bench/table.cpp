// CSV as in RFC 4180. Column names and their order are read by the chart scripts and by users' own tools.
#include "bench/table.h"

#include <cstdio>

namespace collision_hulls {
namespace {

std::string csvCount(const std::optional<std::size_t>& value) {
  return value ? std::to_string(*value) : "";
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string csvLine(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) line += (i ? "," : "") + csvField(fields[i]);
  return line + "\n";
}

std::string csvNumber(const std::optional<double>& value) {
  if (!value) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", *value);
  return text;
}

std::string benchmarkHeader() {
  return "mesh,triangles,method,tolerance,status,hulls,hull_vertices,uncovered,protrusion,protrusion_found,volume_ratio,"
         "cpu_seconds,wall_seconds,peak_mb,hash,diagonal,seed,effort,requested,message\n";
}

std::string toCsv(const BenchmarkRow& row) {
  return csvLine({row.mesh,
                  csvCount(row.triangles),
                  row.method,
                  csvNumber(row.tolerance),
                  row.status,
                  csvCount(row.hulls),
                  csvCount(row.hull_vertices),
                  csvNumber(row.uncovered),
                  csvNumber(row.protrusion),
                  csvNumber(row.protrusion_found),
                  csvNumber(row.volume_ratio),
                  csvNumber(row.cpu_seconds),
                  csvNumber(row.wall_seconds),
                  csvNumber(row.peak_mb),
                  row.hash,
                  csvNumber(row.diagonal),
                  std::to_string(row.seed),
                  row.effort,
                  row.requested,
                  row.message});
}

}  // namespace collision_hulls
