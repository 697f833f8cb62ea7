// Field by field; an empty text keeps the default.
#include "settings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/in_context.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

/// Sets an option that has names; `item`: "link 'arm': method".
template <typename T>
void readNamed(const std::string& item, const std::string& text, std::optional<T> (*parse)(const std::string&), const std::string& choices,
               T& option) {
  if (text.empty()) return;
  const std::optional<T> value = parse(text);
  if (!value) throw Error(ErrorCode::kBadOption, item + " '" + text + "' is unknown: use one of " + choices);
  option = *value;
}

LinkRegion toMessage(const Region& region) {
  LinkRegion message;
  message.name = region.name;
  message.tolerance = region.tolerance;
  for (const HalfSpace& side : region.sides)
    message.sides.insert(message.sides.end(), {side.normal.x(), side.normal.y(), side.normal.z(), side.offset});
  return message;
}

/// `item`: "link 'arm': ".
Region toRegion(const std::string& item, const LinkRegion& message) {
  const std::string region = item + "region '" + message.name + "'";
  const bool is_finite = std::all_of(message.sides.begin(), message.sides.end(), [](double number) { return std::isfinite(number); });
  if (message.sides.empty() || message.sides.size() % 4 != 0 || !is_finite)
    throw Error(ErrorCode::kBadOption, region + " has " + std::to_string(message.sides.size()) +
                                           " numbers for its sides: give four finite ones for each, a normal and an offset");
  checkTolerance(lengthOf(message.tolerance), region + ": tolerance");
  Region result;
  result.name = message.name;
  result.tolerance = message.tolerance;
  for (std::size_t i = 0; i < message.sides.size(); i += 4)
    result.sides.push_back({Eigen::Vector3d(message.sides[i], message.sides[i + 1], message.sides[i + 2]), message.sides[i + 3]});
  return result;
}

}  // namespace

LinkChoice toMessage(const std::string& link, const LinkOptions& options) {
  LinkChoice message;
  message.link = link;
  message.action = name(options.action);
  message.tolerance = toString(options.tolerance);
  message.method = name(options.method);
  message.effort = name(options.effort);
  message.fill = options.fill;
  message.max_hulls = options.max_hulls;
  message.max_vertices = options.max_vertices;
  if (options.padding > 0) message.padding = toString(lengthOf(options.padding));
  if (options.close_openings > 0) message.close_openings = toString(lengthOf(options.close_openings));
  message.shapes = name(options.shapes);
  message.source = name(options.source);
  for (const Region& region : options.regions) message.regions.push_back(toMessage(region));
  return message;
}

LinkOptions toOptions(const LinkChoice& settings) {
  const std::string link = "link '" + settings.link + "': ";
  LinkOptions options;
  readNamed(link + "action", settings.action, actionNamed, "decompose, keep, remove", options.action);
  if (!settings.tolerance.empty()) options.tolerance = parseTolerance(settings.tolerance, link + "tolerance");
  readNamed(link + "method", settings.method, methodNamed, methodChoices(), options.method);
  readNamed(link + "effort", settings.effort, effortNamed, effortChoices(), options.effort);
  readNamed(link + "shapes", settings.shapes, shapesNamed, shapesChoices(), options.shapes);
  readNamed(link + "source", settings.source, sourceNamed, "auto, visual, collision", options.source);
  options.fill = settings.fill;
  options.max_hulls = settings.max_hulls;
  options.max_vertices = settings.max_vertices;
  if (!settings.padding.empty()) options.padding = parsePadding(settings.padding, link + "padding");
  if (!settings.close_openings.empty()) options.close_openings = parsePadding(settings.close_openings, link + "close_openings");
  for (const LinkRegion& region : settings.regions) options.regions.push_back(toRegion(link, region));
  checkLimits(options);
  inContext("link '" + settings.link + "'", [&] { checkShapes(options); });
  if (options.method != Method::kCertified) options.effort = Effort::kQuick, options.fill = false;
  return options;
}

}  // namespace collision_hulls
