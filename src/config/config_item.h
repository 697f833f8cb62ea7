// Values of a configuration, and messages about them: what a reader of any part of it needs.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "scene/yaml_node.h"

namespace collision_hulls {

/// In quotes, cut where it is long.
std::string shortQuoted(const std::string& text);

/// A text that messages may quote: a terminal would obey control characters. Throws at one.
std::string plainText(const YamlValue& value, const std::string& item);

/// Throws where a key is rather the second half of a value: {tolerance: 1cm,5%}. `place`: the name of its map, for the message.
void refuseRestOfValue(const YamlValue& key, const YamlValue& value, const std::string& place);

/// A value with what it is, as messages say it: "max_hulls of links 'arm_.*'".
struct ConfigItem {
  const YamlValue& value;
  std::string name;
  std::string key = name, owner = "";  ///< in the map that it stands in: "max_hulls", "links 'arm_.*'"

  /// In front of a message that begins with the key: "'f.yaml', line 2: links 'arm_.*'".
  std::string place() const { return value.where() + (owner.empty() ? "" : ": " + owner); }

  /// "tolerance of links 'arm' is 'x': use a length".
  [[noreturn]] void refuse(const std::string& expected) const;

  /// Of a single value that is there.
  std::string text(const std::string& expected) const;

  /// The same, where it is a finite number.
  double number(const std::string& expected) const;
};

/// What may stand in a map, by key.
using ConfigReaders = std::vector<std::pair<std::string, std::function<void(const ConfigItem&)>>>;

/// Each key at most once. `place`: the map's name, empty for the whole file.
void expectDifferentKeys(const YamlValue& map, const std::string& place);

/// What a message adds on a key that is not known, such as where it belongs; empty: nothing.
using KeyHint = std::function<std::string(const std::string& key)>;

/// Each entry by the reader of its key. `expected`: of the value, for messages.
void readMap(const ConfigItem& item, const ConfigReaders& readers, const std::string& expected, const KeyHint& hint = {});

void readFlag(const ConfigItem& item, bool& flag);

}  // namespace collision_hulls
