// The file with the decisions on a robot, link by link: read, applied to options, written.
//
// For example:
//
//     #include "collision_hulls/pipeline/decompose_robot.h"
//
//     Options options;
//     apply(readConfig("panda.yaml"), options);
//     const RobotResult result = decompose(openInput("panda.urdf"), options, "panda_collision");
//
// doc/configuration.md describes the format, schema/config.json defines its form.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/report/options.h"

namespace collision_hulls {

/// What a configuration says. It leaves the rest of the options as they are.
struct Config {
  std::string file;  ///< that it was read from, for messages
  std::string text;  ///< as it was read
  LinkSettings defaults;
  /// nullopt: as the options say. Holding nullopt: no tree (`tree: none`).
  std::optional<std::optional<Length>> tree;
  std::vector<LinkRule> rules;
  std::vector<RegionRule> regions;
  std::optional<std::string> only;  ///< Options::links
  std::string only_place;           ///< Options::links_place
  std::vector<ModelOptions> models;
  std::optional<MeshFormat> format;
  std::optional<UriStyle> uri;
  std::optional<bool> rebase, segments;
  std::optional<std::string> package_name;
  std::optional<std::uint64_t> seed;
  /// The options that it sets, named as in doc/options.md: "tolerance", "max-hulls".
  std::set<std::string> named;
};

/// Reads a YAML text of at most 1 MiB. `file`: what messages call it. Throws kBadOption; the
/// message has the file, the line, the item, its value and the remedy. Whether its rules suit a
/// robot, LinkDecisions finds out. YAML is parsed in another process, as meshes are: also throws
/// kReaderFailed, kOutOfMemory, kOutOfTime, kCancelled.
Config parseConfig(const std::string& text, const std::string& file,
                   const RunControl& control = {});

/// Reads a file. Throws kFileNotFound, kTooLarge, and as parseConfig().
Config readConfig(const std::string& file, const RunControl& control = {});

/// Sets what the configuration says. Its rules, regions and models take the place of those there.
void apply(const Config& config, Options& options);
/// The same for one link.
void apply(const LinkSettings& settings, LinkOptions& options);

/// The configuration that repeats a run with these options, with every default. Reading it back
/// gives the same options, and the same text, for all options that a run accepts.
std::string configText(const Options& options);

/// For programs with options of their own, which count instead of those of the configuration: a
/// note for each of `given`, named as in Config::named, that the configuration sets as well.
std::vector<std::string> overridingNotes(const Config& config, const std::set<std::string>& given);

}  // namespace collision_hulls
