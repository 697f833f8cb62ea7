// Keys are either known or errors, so that a typing error never goes unnoticed. The text may be hostile: what it repeats by aliases is
// never followed beyond the levels that the format has.
#include "config/config_item.h"

#include <algorithm>
#include <map>

#include "base/finite_number.h"
#include "base/nearest_name.h"
#include "base/string_parts.h"
#include "base/uri_text.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kShown = 60;  // characters of a value in a message

[[noreturn]] void refuseKey(const YamlValue& key, const YamlValue& value, const ConfigReaders& readers, const std::string& place,
                            const KeyHint& hint) {
  std::vector<std::string> known;
  for (const auto& [of, reader] : readers) known.push_back(of);
  const std::string name = plainText(key, "a key");
  refuseRestOfValue(key, value, place);
  const std::string hinted = hint ? hint(name) : "";
  key.fail(shortQuoted(name) + " is not known" + (place.empty() ? "" : " in " + place) + ": use one of " + listed(known) +
           (hinted.empty() ? didYouMean(name, known) : hinted));
}

}  // namespace

std::string shortQuoted(const std::string& text) {
  return "'" + (text.size() > kShown ? text.substr(0, kShown) + "..." : text) + "'";
}

std::string plainText(const YamlValue& value, const std::string& item) {
  const bool is_list = value.isSequence();
  if (is_list || value.isMap())
    value.fail(item + " is a " + (is_list ? "list" : "map") + ": use a single word, in quotes if it has brackets");
  if (value.isNull()) value.fail(item + " is nothing: use a single word");
  std::string text = value.text();
  if (std::any_of(text.begin(), text.end(), isControl)) value.fail(item + " holds a control character; leave it out");
  return text;
}

void refuseRestOfValue(const YamlValue& key, const YamlValue& value, const std::string& place) {
  const std::string name = plainText(key, "a key");
  if (value.isNull() && !name.empty() && name.front() >= '0' && name.front() <= '9')
    key.fail(shortQuoted(name) + " stands alone" + (place.empty() ? "" : " in " + place) +
             ": put a value with a comma into quotes, as in {tolerance: '1cm,5%'}");
}

void ConfigItem::refuse(const std::string& expected) const {
  const std::string found = value.isMap()        ? "a map"
                            : value.isSequence() ? "a list"
                            : value.isNull()     ? "nothing"
                                                 : shortQuoted(plainText(value, name));
  value.fail(name + " is " + found + ": use " + expected);
}

std::string ConfigItem::text(const std::string& expected) const {
  if (value.isMap() || value.isSequence() || value.isNull()) refuse(expected);
  return plainText(value, name);
}

double ConfigItem::number(const std::string& expected) const {
  double result = 0;
  if (!parseFinite(text(expected), result)) refuse(expected);
  return result;
}

void expectDifferentKeys(const YamlValue& map, const std::string& place) {
  std::map<std::string, std::size_t> lines;
  for (const auto& [key, value] : map.entries()) {
    const std::string of_place = place.empty() ? "" : " of " + place;
    const auto [first, is_new] = lines.emplace(plainText(key, "a key" + of_place), key.line());
    if (!is_new)
      key.fail(shortQuoted(first->first) + of_place + " is already in line " + std::to_string(first->second) + "; remove one of them");
  }
}

void readMap(const ConfigItem& item, const ConfigReaders& readers, const std::string& expected, const KeyHint& hint) {
  if (!item.value.isMap()) item.refuse(expected);
  expectDifferentKeys(item.value, item.name);
  for (const auto& [key, value] : item.value.entries()) {
    const std::string name = plainText(key, "a key");
    const auto reader = std::find_if(readers.begin(), readers.end(), [&](const auto& r) { return r.first == name; });
    if (reader == readers.end()) refuseKey(key, value, readers, item.name, hint);
    reader->second({value, item.name.empty() ? name : name + " of " + item.name, name, item.name});
  }
}

void readFlag(const ConfigItem& item, bool& flag) {
  const std::string text = item.text("true or false");
  if (item.value.isQuoted() || (text != "true" && text != "false")) item.refuse("true or false, without quotes");
  flag = text == "true";
}

}  // namespace collision_hulls
