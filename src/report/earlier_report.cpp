// The report may be anything by now, so only what is asked for is kept of it: JSON takes many times its text's memory.
#include "report/earlier_report.h"

#include <nlohmann/json.hpp>
#include <string>

#include "storage/files.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

using nlohmann::json;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;  // some half a million hulls

/// Keeps {"collision_hulls": _, "files": [_], "links": [{"status": _, "files": [_]}]}.
bool isOfUse(int depth, json::parse_event_t event, const json& parsed) {
  constexpr int kOfReport = 1, kOfRow = 3, kDeepest = 5;
  if (event != json::parse_event_t::key) return depth <= kDeepest;
  const std::set<json> in_report = {"collision_hulls", "files", "links"}, in_row = {"status", "files"};
  return (depth == kOfReport && in_report.count(parsed) > 0) || (depth == kOfRow && in_row.count(parsed) > 0);
}

/// Adds the files that an output has; a report that was written by hand may name others.
void addFiles(const json& names, std::set<fs::path>& files) {
  for (const json& name : names) {
    const fs::path file = fs::path(name.get<std::string>()).lexically_normal();
    if (file.is_relative() && !file.empty() && *file.begin() != "..") files.insert(file);
  }
}

}  // namespace

std::optional<EarlierOutput> earlierOutput(const fs::path& folder) {
  const std::optional<std::string> text = contentOf(folder / kReportFile, kMostBytes);
  if (!text) return std::nullopt;
  try {
    const json report = json::parse(*text, isOfUse);
    if (report.count("collision_hulls") == 0) return std::nullopt;
    EarlierOutput output{{kReportFile}, true};
    addFiles(report.at("files"), output.files);
    for (const json& row : report.at("links")) {
      addFiles(row.at("files"), output.files);
      if (row.value("status", "") == "failed") output.complete = false;
    }
    return output;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace collision_hulls
