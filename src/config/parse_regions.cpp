// Regions between YAML and rules. What is written repeats the run: every value, also defaults, as the shortest text that reads back
// exactly.
#include "config/parse_regions.h"

#include <map>
#include <optional>
#include <utility>

#include "base/counted.h"
#include "base/in_context.h"
#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/error.h"
#include "config/quoted.h"
#include "geometry/pi.h"
#include "report/link_pattern.h"
#include "robot/number_text.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostRegions = 1000;
constexpr const char* kMetres = "a finite number of metres, as in 0.1";
constexpr char kExample[] = "{link: hand, box: {center: [0, 0, 0.1], size: [0.1, 0.2, 0.05]}, keep_clear: true}";

/// `entry_name`, `entry_expected`: what one of its entries is called in a message, and what it should be.
void readVector(const ConfigItem& item, const std::string& entry_name, const std::string& entry_expected, Eigen::Vector3d& vector) {
  const std::string expected = "a list of three numbers, as in [0, 0, 0.1]";
  if (!item.value.isSequence()) item.refuse(expected);
  const std::size_t entries = item.value.items().size();
  if (entries != 3) item.value.fail(item.name + " has " + counted(entries, "entry", "entries") + ": use " + expected);
  int i = 0;
  for (const YamlValue& entry : item.value.items()) vector[i++] = ConfigItem{entry, entry_name}.number(entry_expected);
}

/// 0 means clear.
void readTolerance(const ConfigItem& item, double& tolerance) {
  const std::string text = item.text("a length, as in 1mm, or 0 to keep the region clear");
  inContext(item.place(), [&] {
    tolerance = parsePadding(text, item.key);
    if (tolerance == 0) tolerance = kRegionSlack;
  });
}

std::string entriesText(const Eigen::Vector3d& v) {
  return "[" + numberText(v.x()) + ", " + numberText(v.y()) + ", " + numberText(v.z()) + "]";
}

std::string yaml(const RegionBox& box) {
  return "box: {center: " + entriesText(box.center) + ", size: " + entriesText(box.size) + ", rpy: " + entriesText(box.rpy) + "}";
}

std::string yaml(const RegionHalfSpace& half_space) {
  return "half_space: {normal: " + entriesText(half_space.normal) + ", offset: " + numberText(half_space.offset) + "}";
}

/// One entry of the list.
class RegionReader {
 public:
  RegionRule read(const ConfigItem& item) {
    name_ = item.name;
    readMap(item,
            {{"link", [this](const ConfigItem& of) { readLink(of); }},
             {"name", [this](const ConfigItem& of) { rule_.name = of.text("a name, for the report"); }},
             {"box", [this](const ConfigItem& of) { readBox(of); }},
             {"half_space", [this](const ConfigItem& of) { readHalfSpace(of); }},
             {"keep_clear", [this](const ConfigItem& of) { readClear(of); }},
             {"tolerance", [this](const ConfigItem& of) { readTolerance(of, tolerance_.emplace()); }}},
            std::string("a map such as ") + kExample);
    if (shapes_ != 1)
      item.value.fail(item.name + (shapes_ == 0 ? " has neither box nor half_space" : " has both box and half_space") +
                      ": give one of them, as in " + kExample);
    if (clear_ == tolerance_.has_value())
      item.value.fail(item.name + (clear_ ? " has both keep_clear and tolerance" : " has neither keep_clear: true nor tolerance") +
                      ": give one of them, as in " + kExample);
    rule_.tolerance = tolerance_.value_or(kRegionSlack);
    rule_.place = item.value.where();
    inContext(rule_.place + ": " + item.name, [&] { regionOf(rule_); });
    return std::move(rule_);
  }

 private:
  void readLink(const ConfigItem& item) {
    rule_.pattern = item.text("a link's name, or a regular expression");
    inContext(item.value.where(), [&] { LinkPattern(rule_.pattern, name_ + ": its link"); });
  }

  void readBox(const ConfigItem& item) {
    RegionBox box;
    const auto take = [this](const char* expected, Eigen::Vector3d& vector) {
      return [this, expected, &vector](const ConfigItem& of) {
        readVector(of, name_ + ": an entry of its box's " + of.key, expected, vector);
      };
    };
    readMap(item,
            {{"center", take(kMetres, box.center)},
             {"size", take(kMetres, box.size)},
             {"rpy", take("a number of radians, as in 1.57", box.rpy)}},
            "a map such as {center: [0, 0, 0.1], size: [0.1, 0.2, 0.05]}");
    if (box.rpy.cwiseAbs().maxCoeff() > 2 * kPi)
      item.value.fail("rpy of " + item.name + " is " + entriesText(box.rpy) + ", more than a whole turn: give radians, as in [0, 0, 1.57]");
    if (!item.value.has("size")) item.value.fail(item.name + " has no size: add one, as in size: [0.1, 0.2, 0.05]");
    rule_.shape = box;
    ++shapes_;
  }

  void readHalfSpace(const ConfigItem& item) {
    RegionHalfSpace half_space;
    readMap(item,
            {{"normal",
              [&](const ConfigItem& of) {
                readVector(of, name_ + ": an entry of its half-space's normal", "a finite number, as in 0.1", half_space.normal);
              }},
             {"offset", [&](const ConfigItem& of) { half_space.offset = of.number(kMetres); }}},
            "a map such as {normal: [0, 0, -1], offset: 0}, which points into the region");
    if (!item.value.has("normal")) item.value.fail(item.name + " has no normal: add one that points into the region, as in [0, 0, -1]");
    rule_.shape = half_space;
    ++shapes_;
  }

  void readClear(const ConfigItem& item) {
    readFlag(item, clear_);
    if (!clear_) item.refuse("true, or a tolerance in its place");
  }

  RegionRule rule_;
  std::string name_;  // in messages
  int shapes_ = 0;
  bool clear_ = false;
  std::optional<double> tolerance_;
};

}  // namespace

std::vector<RegionRule> readRegions(const ConfigItem& list, const RunControl& control) {
  if (!list.value.isSequence()) list.refuse(std::string("a list of entries such as ") + kExample);
  const std::vector<YamlValue> items = list.value.items();
  if (items.size() > kMostRegions)
    list.value.fail("there are " + std::to_string(items.size()) + " regions; at most " + std::to_string(kMostRegions) + " are allowed");
  std::vector<RegionRule> rules;
  std::map<std::string, std::string> places;
  for (const YamlValue& item : items) {
    control.check();
    const std::string number = std::to_string(rules.size() + 1);
    RegionRule rule = RegionReader().read({item, "region " + number});
    if (rule.name.empty()) rule.name = number;
    const auto [first, is_new] = places.emplace(rule.name, rule.place);
    if (!is_new)
      item.fail("region " + number + " has the name " + shortQuoted(rule.name) + " of the one in " + first->second + "; rename one");
    rules.push_back(std::move(rule));
  }
  return rules;
}

std::string yaml(const RegionRule& rule) {
  const std::string shape = std::visit([](const auto& of) { return yaml(of); }, rule.shape);
  return "- {" + (rule.pattern.empty() ? "" : "link: " + quoted(rule.pattern) + ", ") + "name: " + quoted(rule.name) + ", " + shape +
         ", tolerance: " + toString(lengthOf(rule.tolerance)) + "}";
}

}  // namespace collision_hulls
