// A configuration applied to options, and options written as a configuration. Every value is written, whether it is a default or not: the
// file still means the same when a later version has other defaults.
#include "collision_hulls/config/config.h"

#include <algorithm>
#include <cstdio>

#include "base/string_parts.h"
#include "config/link_fields.h"
#include "config/parse_regions.h"
#include "config/quoted.h"

namespace collision_hulls {
namespace {

std::string yaml(bool value) {
  return value ? "true" : "false";
}

std::string yaml(int value) {
  return std::to_string(value);
}

/// Of a padding or an opening.
std::string yaml(double metres) {
  return metres > 0 ? toString(lengthOf(metres)) : "0";
}

/// A comma would end the value within braces.
std::string yaml(const Length& length) {
  const std::string text = toString(length);
  return text.find(',') == std::string::npos ? text : quoted(text);
}

template <typename T>
std::string yaml(T named) {
  return name(named);
}

std::string braced(const std::vector<std::string>& entries) {
  return "{" + listed(entries) + "}";
}

std::vector<std::string> entriesOf(const LinkSettings& settings) {
  std::vector<std::string> entries;
  forEachLinkField([&](const char* name, auto option, auto setting) {
    (void)option;
    if (settings.*setting) entries.push_back(std::string(name) + ": " + yaml(*(settings.*setting)));
  });
  return entries;
}

std::string yaml(const LinkSettings& settings) {
  const std::vector<std::string> entries = entriesOf(settings);
  return entries.size() == 1 && settings.action ? name(*settings.action) : braced(entries);
}

/// All but the action, which is no default of a robot.
std::string yamlDefaults(const Options& options) {
  LinkSettings all;
  forEachLinkField([&](const char*, auto option, auto setting) { all.*setting = options.*option; });
  all.action.reset();
  std::vector<std::string> entries = entriesOf(all);
  entries.push_back("tree: " + (options.tree ? yaml(*options.tree) : "none"));
  return braced(entries);
}

template <typename T, typename Text>
std::string section(const std::string& name, const std::vector<T>& entries, const Text& text) {
  std::string result = name + ":" + (entries.empty() ? " {}" : "") + "\n";
  for (const T& entry : entries) result += "  " + text(entry) + "\n";
  return result;
}

std::string regionsText(const std::vector<RegionRule>& rules) {
  std::string text = rules.empty() ? "regions: []\n" : "regions:\n";
  for (const RegionRule& rule : rules) text += "  " + yaml(rule) + "\n";
  return text;
}

template <typename T>
void set(const std::optional<T>& value, T& option) {
  if (value) option = *value;
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    char code[8];
    if (static_cast<unsigned char>(c) < 0x20) {
      std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(c));
      result += code;
    } else {
      result += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    }
  }
  return result + "\"";
}

void apply(const LinkSettings& settings, LinkOptions& options) {
  forEachLinkField([&](const char*, auto option, auto setting) { set(settings.*setting, options.*option); });
}

void apply(const Config& config, Options& options) {
  apply(config.defaults, options);
  set(config.tree, options.tree);
  options.rules = config.rules;
  options.region_rules = config.regions;
  options.models = config.models;
  if (config.only) {
    options.links = *config.only;
    options.links_place = config.only_place;
  }
  set(config.format, options.format);
  set(config.uri, options.uri);
  set(config.rebase, options.rebase);
  set(config.segments, options.segments);
  set(config.package_name, options.package_name);
  set(config.seed, options.seed);
}

std::string configText(const Options& options) {
  return "# Settings of the run that wrote this file: --config repeats it, with the same program (and scene).\n"
         "default: " +
         yamlDefaults(options) + "\nonly: " + quoted(options.links.empty() ? ".*" : options.links) + "\n" +
         section("links", options.rules, [](const LinkRule& rule) { return quoted(rule.pattern) + ": " + yaml(rule.settings); }) +
         regionsText(options.region_rules) +
         section("models", options.models, [](const ModelOptions& model) { return quoted(model.name) + ": " + yaml(model.tolerance); }) +
         "output: " +
         braced({"format: " + std::string(extension(options.format) + 1), "uri: " + yaml(options.uri), "rebase: " + yaml(options.rebase),
                 "segments: " + yaml(options.segments), "package_name: " + quoted(options.package_name)}) +
         "\nseed: " + std::to_string(options.seed) + "\n";
}

std::vector<std::string> overridingNotes(const Config& config, const std::set<std::string>& given) {
  std::vector<std::string> notes;
  const auto note = [&](const std::string& option, const std::string& named) {
    if (!given.count(option) || !config.named.count(named)) return;
    std::string key = named == "links" ? "only" : named == "model" ? "models" : named;
    std::replace(key.begin(), key.end(), '-', '_');
    notes.push_back("--" + option + " counts in place of '" + key + "' in '" + config.file + "'");
  };
  for (const std::string& option : given) {
    const bool is_unused = option == "tolerance" && !config.models.empty();  // each model has its own, and another note says so
    if (!is_unused) note(option, option);
  }
  for (const char* const option : {"shapes", "spheres"}) {  // of a link's settings, too
    note(option, "shape");
    if (option != std::string("shapes") && !given.count("shapes")) note(option, "shapes");
  }
  for (const char* const cap : {"max-hulls", "max-vertices"})
    if (!given.count(cap)) note("profile", cap);
  return notes;
}

}  // namespace collision_hulls
