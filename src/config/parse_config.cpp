// From YAML to a Config.
#include <algorithm>
#include <charconv>
#include <utility>

#include "base/in_context.h"
#include "base/nearest_name.h"
#include "base/read_file.h"
#include "base/string_parts.h"
#include "collision_hulls/config/config.h"
#include "collision_hulls/error.h"
#include "config/config_item.h"
#include "config/link_fields.h"
#include "config/parse_regions.h"
#include "report/link_pattern.h"
#include "scene/yaml_node.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;

void read(const ConfigItem& item, bool& flag) {
  readFlag(item, flag);
}

template <typename Number>
void readWhole(const ConfigItem& item, const std::string& most, Number& number) {
  const std::string expected = "a whole number from 0 to " + most + ", without quotes";
  const std::string text = item.text(expected);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_plain = text == "0" || (!text.empty() && text[0] >= '1' && text[0] <= '9');
  if (item.value.isQuoted() || !is_plain || error != std::errc() || end != text.data() + text.size()) item.refuse(expected);
}

void read(const ConfigItem& item, int& number) {
  readWhole(item, "1000000", number);
}

void read(const ConfigItem& item, Length& length) {
  const std::string text = item.text("a length, as in 5mm");
  inContext(item.place(), [&] { length = parseTolerance(text, item.key); });
}

/// A padding, or the width of openings.
void read(const ConfigItem& item, double& metres) {
  const std::string text = item.text("a length, as in 2cm, or 0");
  inContext(item.place(), [&] { metres = parsePadding(text, item.key); });
}

template <typename T>
void readChoice(const ConfigItem& item, std::optional<T> (*parse)(const std::string&), const std::vector<std::string>& choices, T& value) {
  const std::string expected = "one of " + listed(choices);
  const std::string text = item.text(expected);
  const std::optional<T> found = parse(text);
  if (!found) item.refuse(expected + didYouMean(text, choices));
  value = *found;
}

template <typename T>
std::vector<std::string> namesOf(const std::vector<T>& all) {
  std::vector<std::string> names;
  for (const T& one : all) names.push_back(name(one));
  return names;
}

void read(const ConfigItem& item, Action& action) {
  readChoice(item, actionNamed, {"decompose", "keep", "remove"}, action);
}

void read(const ConfigItem& item, Method& method) {
  readChoice(item, methodNamed, namesOf(allMethods()), method);
}

void read(const ConfigItem& item, Effort& effort) {
  readChoice(item, effortNamed, namesOf(allEfforts()), effort);
}

void read(const ConfigItem& item, Shapes& shapes) {
  readChoice(item, shapesNamed, namesOf(allShapes()), shapes);
}

/// A single one.
void readShape(const ConfigItem& item, Shapes& shape) {
  std::vector<Shapes> single = allShapes();
  single.erase(std::remove_if(single.begin(), single.end(), [](Shapes each) { return !isSingle(each); }), single.end());
  const std::string expected = "one of " + listed(namesOf(single));
  const std::string text = item.text(expected);
  const std::optional<Shapes> found = shapesNamed(text);
  if (!found || !isSingle(*found)) item.refuse(expected + didYouMean(text, namesOf(single)));
  shape = *found;
}

void read(const ConfigItem& item, Source& source) {
  readChoice(item, sourceNamed, {"auto", "visual", "collision"}, source);
}

void read(const ConfigItem& item, MeshFormat& format) {
  readChoice(item, meshFormatNamed, {"stl", "obj", "dae"}, format);
}

void read(const ConfigItem& item, UriStyle& uri) {
  readChoice(item, uriStyleNamed, {"package", "file", "relative"}, uri);
}

/// What cannot hold together within one map. The rules of a robot's links are compared in LinkDecisions.
void refuseContradictions(const ConfigItem& item, const LinkSettings& settings) {
  const bool stays = settings.action.value_or(Action::kDecompose) != Action::kDecompose;
  const bool other_method = settings.method.value_or(Method::kCertified) != Method::kCertified;
  bool has_shapes = false;
  for (const auto& [key, value] : item.value.entries()) {
    const std::string name = plainText(key, "a key");
    const bool of_shapes = name == "shape" || name == "shapes";
    if (of_shapes && has_shapes) key.fail("shape and shapes of " + item.name + " mean the same; remove one of them");
    has_shapes = has_shapes || of_shapes;
    if (stays && name != "action")
      key.fail(name + " of " + item.name + " contradicts '" + collision_hulls::name(*settings.action) +
               "', with which the link gets no hulls; remove one of them");
    const bool only_certified =
        (name == "effort" && settings.effort && needsCertified(*settings.effort)) || (name == "fill" && settings.fill == true);
    if (other_method && only_certified)
      key.fail(name + " '" + value.text() + "' of " + item.name + " needs method 'certified', not '" +
               collision_hulls::name(*settings.method) + "'; remove one of them");
  }
}

ConfigReaders settingReaders(LinkSettings& settings) {
  ConfigReaders readers;
  forEachLinkField([&](const char* name, auto option, auto setting) {
    (void)option;
    readers.emplace_back(name, [&settings, setting](const ConfigItem& item) { read(item, (settings.*setting).emplace()); });
  });
  readers.emplace_back("shape", [&settings](const ConfigItem& item) { readShape(item, settings.shapes.emplace()); });
  return readers;
}

/// Many programs have their settings at the top. `key` may be spelled as on the command line: max-hulls.
std::string placeOfSetting(std::string key) {
  std::replace(key.begin(), key.end(), '-', '_');
  LinkSettings unused;
  const ConfigReaders settings = settingReaders(unused);
  const bool is_setting = std::any_of(settings.begin(), settings.end(), [&](const auto& each) { return each.first == key; });
  if (key == "action") return "; action is a setting of single links: put it under links:";
  return is_setting || key == "tree" ? "; " + key + " is a setting of links: put it under default:" : "";
}

/// Values out of range, and shapes that contradict another setting of the same map.
void checkValues(const ConfigItem& item, const LinkSettings& settings) {
  LinkOptions applied;
  apply(settings, applied);
  inContext(item.value.where() + ": " + item.name, [&] {
    checkLimits(applied);
    checkShapes(applied);
  });
}

/// {tolerance: 2mm}, or one word: keep.
LinkSettings readRule(const ConfigItem& item) {
  LinkSettings settings;
  const std::string expected = "keep, remove, or a map of settings such as {tolerance: 2mm}";
  if (!item.value.isMap()) {
    const std::string word = item.text(expected);
    settings.action = actionNamed(word);
    if (!settings.action) item.refuse(expected + didYouMean(word, {"keep", "remove", "decompose"}));
    return settings;
  }
  readMap(item, settingReaders(settings), expected);
  if (item.value.entries().empty()) item.refuse(expected);
  checkValues(item, settings);
  refuseContradictions(item, settings);
  return settings;
}

class Reader {
 public:
  Reader(const std::string& file, const RunControl& control) : control_(control) { result_.file = file; }

  Config read(const YamlValue& root) {
    if (root.isNull()) return result_;
    const ConfigReaders readers = {{"default", [this](const ConfigItem& item) { readDefault(item); }},
                                   {"only", [this](const ConfigItem& item) { readOnly(item); }},
                                   {"links", [this](const ConfigItem& item) { readLinks(item); }},
                                   {"models", [this](const ConfigItem& item) { readModels(item); }},
                                   {"output", [this](const ConfigItem& item) { readOutput(item); }},
                                   {"seed", [this](const ConfigItem& item) { readSeed(item); }},
                                   {"regions", [this](const ConfigItem& item) { result_.regions = readRegions(item, control_); }}};
    if (!root.isMap()) root.fail("a configuration is a map: use keys such as default: and links:");
    readMap({root, ""}, readers, "", placeOfSetting);
    return result_;
  }

 private:
  void readDefault(const ConfigItem& item) {
    const std::string expected = "a map such as {tolerance: 5mm}; to leave links alone, name the others with only:";
    ConfigReaders readers = settingReaders(result_.defaults);
    const auto is_action = [](const auto& reader) { return reader.first == "action"; };
    readers.erase(std::remove_if(readers.begin(), readers.end(), is_action), readers.end());
    readers.emplace_back("tree", [this](const ConfigItem& tree) { readTree(tree); });
    readMap(item, readers, expected);
    checkValues(item, result_.defaults);
    refuseContradictions(item, result_.defaults);
    for (const auto& [key, value] : item.value.entries()) {
      std::string option = plainText(key, "a key");
      std::replace(option.begin(), option.end(), '_', '-');
      result_.named.insert(option);
    }
  }

  void readTree(const ConfigItem& item) {
    const std::string expected = "a length, as in 2mm, or none";
    Length length;
    if (item.text(expected) == "none") {
      result_.tree.emplace();
      return;
    }
    collision_hulls::read(item, length);
    result_.tree.emplace(length);
  }

  void readOnly(const ConfigItem& item) {
    const std::string expression = item.text("a regular expression");
    inContext(item.value.where(), [&] { LinkPattern(expression, "only"); });
    result_.only = expression == ".*" ? "" : expression;
    result_.only_place = item.value.where();
    result_.named.insert("links");
  }

  void readLinks(const ConfigItem& item) {
    if (!item.value.isMap()) item.refuse("a map from regular expressions to settings, as in {arm_.*: {tolerance: 2mm}}");
    expectDifferentKeys(item.value, "links");
    for (const auto& [key, value] : item.value.entries()) {
      control_.check();  // an expression may take milliseconds
      const std::string pattern = plainText(key, "a key");
      inContext(key.where(), [&] { LinkPattern(pattern, "links"); });
      result_.rules.push_back({pattern, readRule({value, "links " + shortQuoted(pattern)}), key.where()});
    }
  }

  void readModels(const ConfigItem& item) {
    const std::string expected = "a map from names to tolerances, as in {planning: 1cm, contact: 2mm}";
    if (!item.value.isMap()) item.refuse(expected);
    expectDifferentKeys(item.value, "models");
    for (const auto& [key, value] : item.value.entries()) {
      control_.check();
      refuseRestOfValue(key, value, "models");
      ModelOptions model{plainText(key, "a key"), {}};
      const std::string name = "model " + shortQuoted(model.name);
      collision_hulls::read({value, "tolerance of " + name, "tolerance", name}, model.tolerance);
      result_.models.push_back(model);
      Options alone;
      alone.models = {model};
      inContext(key.where(), [&] { check(alone); });
    }
    Options all;
    all.models = result_.models;
    inContext(item.value.where(), [&] { check(all); });
    result_.named.insert("model");
  }

  void readOutput(const ConfigItem& item) {
    const auto take = [this](const std::string& option, auto& value) {
      return [this, option, &value](const ConfigItem& of) {
        collision_hulls::read(of, value.emplace());
        result_.named.insert(option);
      };
    };
    const auto readName = [this](const ConfigItem& of) {
      Options alone;
      alone.package_name = of.text("the name of a package, or \"\" for that of the output folder");
      inContext(of.value.where(), [&] { check(alone); });
      result_.package_name = alone.package_name;
      result_.named.insert("package-name");
    };
    readMap(item,
            {{"format", take("format", result_.format)},
             {"uri", take("uri", result_.uri)},
             {"rebase", take("rebase", result_.rebase)},
             {"segments", take("segments", result_.segments)},
             {"package_name", readName}},
            "a map such as {format: obj}");
  }

  void readSeed(const ConfigItem& item) {
    std::uint64_t seed = 0;
    readWhole(item, "18446744073709551615", seed);
    result_.seed = seed;
    result_.named.insert("seed");
  }

  const RunControl& control_;
  Config result_;
};

}  // namespace

Config parseConfig(const std::string& text, const std::string& file, const RunControl& control) {
  if (text.size() > kMostBytes)
    throw Error(ErrorCode::kBadOption, "'" + file + "' has " + std::to_string(text.size()) + " bytes; a configuration has at most " +
                                           std::to_string(kMostBytes) + ": use one expression for many links");
  Config config = Reader(file, control).read(YamlValue::parse(text, file, ErrorCode::kBadOption, 1, control));
  config.text = text;
  return config;
}

Config readConfig(const std::string& file, const RunControl& control) {
  return parseConfig(readFile(file, "configuration", kMostBytes, control), file, control);
}

}  // namespace collision_hulls
