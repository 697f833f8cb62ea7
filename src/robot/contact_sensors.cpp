// URDF's own <collision> elements hold elements; those of a sensor hold a name. So the text tells them apart, and nothing has to be parsed.
#include "robot/contact_sensors.h"

#include <cstddef>
#include <string_view>

namespace collision_hulls {
namespace {

constexpr std::size_t kLongest = 3000;  // [bytes]: names of two links, which have a thousand at most, and what is between and behind them
constexpr std::string_view kBlanks = " \t\r\n";

/// Calls `use` with what follows each mark, up to the first `end`: the end must be within what a name takes.
template <typename Use>
void forEachBetween(std::string_view text, std::string_view mark, char end, const Use& use) {
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at)) {
    at += mark.size();
    const std::string_view rest = text.substr(at, kLongest);
    const std::size_t size = rest.find(end);
    if (size != std::string_view::npos) use(rest.substr(0, size), text.substr(at + size));
  }
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

}  // namespace

std::set<std::string> unnamedContacts(const std::string& urdf) {
  constexpr std::string_view kClose = "</collision>";
  std::set<std::string> names;
  forEachBetween(urdf, "<collision>", '<', [&](std::string_view name, std::string_view rest) {
    name = trimmed(name);
    if (!name.empty() && rest.substr(0, kClose.size()) == kClose) names.emplace(name);
  });
  if (names.empty()) return names;
  const auto drop = [&names](std::string_view name, std::string_view) { names.erase(std::string(name)); };
  forEachBetween(urdf, "name=\"", '"', drop);
  forEachBetween(urdf, "name='", '\'', drop);
  return names;
}

std::vector<std::string> linksOfCollision(const std::string& name) {
  constexpr std::string_view kCollision = "_collision", kLump = "_fixed_joint_lump__";
  std::vector<std::string> links;
  for (std::size_t at = name.find(kCollision); at != std::string::npos; at = name.find(kCollision, at + 1)) {
    const std::string link = name.substr(0, at);
    links.push_back(link);
    const std::size_t lump = link.rfind(kLump);
    if (lump != std::string::npos) links.push_back(link.substr(lump + kLump.size()));
  }
  return links;
}

}  // namespace collision_hulls
