// What the report in an output folder says of it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

constexpr const char* kReportFile = "report.json";

/// The output of an earlier run.
struct EarlierOutput {
  std::set<std::filesystem::path> files;  ///< relative to its folder, none outside of it; the report is one
  bool complete = true;                   ///< no row of any model failed
};

/// nullopt if the folder is no earlier output: if its report is missing, of another program, above 256 MiB, no regular file, or may not be
/// read (base/roots.h). Time is near-linear. Throws kCancelled.
std::optional<EarlierOutput> earlierOutput(const std::filesystem::path& folder, const RunControl& control = {});

/// What an earlier run made its model from.
struct EarlierSource {
  std::string input_sha256;               ///< of the description's text
  Source source = Source::kAuto;          ///< the run's option
  double close_openings = 0;              ///< [m] the largest of the rows', see LinkOptions
  bool fitted = false;                    ///< to a scene
  std::map<std::string, Source> of_link;  ///< kVisual or kCollision, of links with a row: their settings may differ from the run's
};

/// nullopt as above.
std::optional<EarlierSource> earlierSource(const std::filesystem::path& folder, const RunControl& control = {});

}  // namespace collision_hulls
