// The report may be anything by now, so only what is asked for is kept of it: JSON takes many times its text's memory.
#include "report/earlier_report.h"

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "storage/files.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

using nlohmann::json;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;  // some half a million hulls

/// Keeps {"collision_hulls": _, "files": [_], "input": {"sha256": _}, "options": {"source": _},
/// "links": [{"link": _, "source": _, "status": _, "files": [_]}]}.
bool isOfUse(int depth, json::parse_event_t event, const json& parsed) {
  constexpr int kDeepest = 5;
  if (event != json::parse_event_t::key) return depth <= kDeepest;
  static const std::map<int, std::set<json>> keys = {{1, {"collision_hulls", "files", "input", "options", "links"}},
                                                     {2, {"sha256", "source"}},
                                                     {3, {"link", "source", "status", "files"}}};
  const auto here = keys.find(depth);
  return here != keys.end() && here->second.count(parsed) > 0;
}

/// What `read` makes of the report; nullopt if there is none, or if it has not what is asked for.
template <typename Read>
auto reported(const fs::path& folder, const Read& read) -> std::optional<decltype(read(json()))> {
  const std::optional<std::string> text = contentOf(folder / kReportFile, kMostBytes);
  if (!text) return std::nullopt;
  try {
    const json report = json::parse(*text, isOfUse);
    if (report.count("collision_hulls") == 0) return std::nullopt;
    return read(report);
  } catch (const json::exception&) {
    return std::nullopt;
  }
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
  return reported(folder, [](const json& report) {
    EarlierOutput output{{kReportFile}, true};
    addFiles(report.at("files"), output.files);
    for (const json& row : report.at("links")) {
      addFiles(row.at("files"), output.files);
      if (row.value("status", "") == "failed") output.complete = false;
    }
    return output;
  });
}

std::optional<EarlierSource> earlierSource(const fs::path& folder) {
  return reported(folder, [](const json& report) {
    EarlierSource source;
    source.input_sha256 = report.at("input").at("sha256").get<std::string>();
    source.source = sourceNamed(report.at("options").at("source").get<std::string>()).value_or(Source::kAuto);
    for (const json& row : report.at("links")) {
      const bool visual = row.at("source").get<std::string>() == "visual";
      source.of_link[row.at("link").get<std::string>()] = visual ? Source::kVisual : Source::kCollision;
    }
    return source;
  });
}

}  // namespace collision_hulls
