// What the report in an output folder says of it.
#pragma once

#include <filesystem>
#include <optional>
#include <set>

namespace collision_hulls {

constexpr const char* kReportFile = "report.json";

/// The output of an earlier run.
struct EarlierOutput {
  std::set<std::filesystem::path> files;  ///< relative to its folder, none outside of it; the report is one
  bool complete = true;                   ///< no row of it failed
};

/// nullopt if the folder is no earlier output: if its report is missing, of another program, above 16 MiB, or no regular file.
std::optional<EarlierOutput> earlierOutput(const std::filesystem::path& folder);

}  // namespace collision_hulls
