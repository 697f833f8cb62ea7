// Undo keeps the settings of all links, and all regions, before each change: a few kilobytes for the largest robots.
#include "panel/link_table.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "base/in_context.h"
#include "collision_hulls/config/config.h"
#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/error.h"
#include "config/link_rule.h"
#include "report/link_pattern.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostUndone = 200;

void markUnbuilt(LinkRow& row) {
  LinkFacts unbuilt;
  unbuilt.status = "unbuilt";
  unbuilt.around = row.facts.around;
  unbuilt.steps = std::move(row.facts.steps);
  row.facts = std::move(unbuilt);
}

void markChanged(LinkRow& row) {
  markUnbuilt(row);
  row.changed = true;
}

bool holdsFor(const RegionRule& region, const std::string& link) {
  return !region.pattern.empty() && LinkPattern(region.pattern, "link of region '" + region.name + "'").matches(link);
}

/// Gives those without a name the smallest number that is none yet. Throws for a name that two have.
void nameRegions(std::vector<RegionRule>& regions) {
  std::set<std::string> names;
  for (const RegionRule& region : regions)
    if (!region.name.empty() && !names.insert(region.name).second)
      throw Error(ErrorCode::kBadOption, "two regions have the name '" + region.name + "': give one of them another");
  for (RegionRule& region : regions)
    for (int number = 1; region.name.empty(); ++number)
      if (names.insert(std::to_string(number)).second) region.name = std::to_string(number);
}

/// A robot of these links alone, for LinkDecisions.
RobotDescription robotOf(const std::vector<LinkRow>& rows) {
  RobotDescription robot;
  robot.name = "shown";
  for (const LinkRow& row : rows) {
    LinkDescription link;
    link.name = row.link;
    robot.links.push_back(link);
  }
  return robot;
}

}  // namespace

int LinkTable::indexOf(const std::string& link) const {
  const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const LinkRow& r) { return r.link == link; });
  return row == rows_.end() ? -1 : static_cast<int>(row - rows_.begin());
}

void LinkTable::take(std::vector<LinkRow> rows, std::vector<RegionRule> regions) {
  const auto same_link = [](const LinkRow& a, const LinkRow& b) { return a.link == b.link; };
  const bool is_same = std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(), same_link);
  if (!is_same) history_.clear(), has_own_regions_ = false;
  if (!has_own_regions_) regions_ = std::move(regions);
  for (std::size_t i = 0; is_same && i < rows.size(); ++i) {
    const bool is_equal = equalSettings(rows_[i].options, rows[i].options);
    rows[i].changed = rows_[i].changed && !(is_equal && rows[i].facts.proved);  // a cut is not built
    if (!rows[i].changed || is_equal) continue;
    rows[i].options = rows_[i].options;
    markUnbuilt(rows[i]);
  }
  rows_ = std::move(rows);
  applyRegions();
}

/// Gives each row's options the regions that hold for it. Returns the rows whose hulls these are not.
std::vector<int> LinkTable::applyRegions() {
  std::vector<int> changed;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const LinkOptions before = rows_[i].options;
    rows_[i].options.regions.clear();
    for (const int region : regionsOf(rows_[i].link))
      rows_[i].options.regions.push_back(regionOf(regions_[static_cast<std::size_t>(region)]));
    if (equalSettings(before, rows_[i].options)) continue;
    markUnbuilt(rows_[i]);
    if (has_own_regions_) rows_[i].changed = true;
    changed.push_back(static_cast<int>(i));
  }
  return changed;
}

std::vector<int> LinkTable::regionsOf(const std::string& link) const {
  std::vector<int> indices;
  for (std::size_t i = 0; i < regions_.size(); ++i)
    if (holdsFor(regions_[i], link)) indices.push_back(static_cast<int>(i));
  return indices;
}

std::vector<int> LinkTable::linksOf(const RegionRule& region) const {
  std::vector<int> indices;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (holdsFor(region, rows_[i].link)) indices.push_back(static_cast<int>(i));
  return indices;
}

std::vector<int> LinkTable::changeRegions(const std::function<void(std::vector<RegionRule>&)>& change, bool goes_on) {
  std::vector<RegionRule> regions = regions_;
  change(regions);
  nameRegions(regions);
  for (const RegionRule& region : regions) inContext("region '" + region.name + "'", [&] { regionOf(region); });
  remember(goes_on);
  regions_ = std::move(regions);
  has_own_regions_ = true;
  return applyRegions();
}

bool LinkTable::answer(const LinkRow& row) {
  const int index = indexOf(row.link);
  if (index < 0) return false;
  LinkRow& own = rows_[static_cast<std::size_t>(index)];
  if (!equalSettings(own.options, row.options)) return false;
  const LinkFacts before = std::exchange(own.facts, row.facts);
  if (own.facts.steps.empty()) own.facts.steps = before.steps;  // what is not built yet offers what it did, and is where it was
  if (own.facts.around.isEmpty()) own.facts.around = before.around;
  return true;
}

LinkTable::Moment LinkTable::now() const {
  Moment moment{{}, regions_, has_own_regions_};
  for (const LinkRow& row : rows_) moment.options.push_back(row.options);
  return moment;
}

void LinkTable::remember(bool goes_on) {
  if (!goes_on || history_.empty()) history_.push_back(now());
  if (history_.size() > kMostUndone) history_.erase(history_.begin());
}

void LinkTable::change(const std::vector<int>& rows, const std::function<void(LinkOptions&)>& change, bool goes_on) {
  remember(goes_on);
  for (const int index : rows) {
    LinkRow& row = rows_[static_cast<std::size_t>(index)];
    const LinkOptions before = row.options;
    change(row.options);
    if (row.options.method != Method::kCertified) row.options.effort = Effort::kQuick, row.options.fill = false;
    if (!equalSettings(before, row.options)) markChanged(row);
  }
}

std::vector<int> LinkTable::undo() {
  std::vector<int> changed;
  if (history_.empty()) return changed;
  const Moment before = std::move(history_.back());
  history_.pop_back();
  regions_ = before.regions;
  has_own_regions_ = before.has_own_regions;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (equalSettings(rows_[i].options, before.options[i])) continue;
    rows_[i].options = before.options[i];
    markChanged(rows_[i]);
    changed.push_back(static_cast<int>(i));
  }
  return changed;
}

TableTotals LinkTable::totals() const {
  TableTotals totals;
  totals.links = rows_.size();
  for (const LinkRow& row : rows_) {
    totals.hulls += row.facts.hulls;
    totals.primitives += row.facts.primitives;
    totals.vertices += row.facts.vertices;
    totals.unbuilt += row.facts.status == "unbuilt";
    totals.failed += row.facts.status == "failed";
    if (row.facts.protrusion <= totals.protrusion) continue;
    totals.protrusion = row.facts.protrusion;
    totals.worst_link = row.link;
  }
  return totals;
}

std::string LinkTable::configuration(const std::optional<Length>& tree) const {
  Options options;
  options.tree = tree;
  options.region_rules = regions_;
  for (const LinkRow& row : rows_) {
    LinkRule rule = differingRuleFor(row.link, row.options, options);
    if (hasSettings(rule)) options.rules.push_back(std::move(rule));
  }
  return configText(options);
}

std::optional<Length> LinkTable::load(const std::string& file) {
  const Config config = readConfig(file);
  return loadText(config.text, file);
}

std::optional<Length> LinkTable::loadText(const std::string& text, const std::string& name) {
  Options options;
  apply(parseConfig(text, name), options);
  check(options);
  const LinkDecisions decisions(options, robotOf(rows_));
  std::vector<int> all(rows_.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  std::size_t next = 0;
  change(all, [&](LinkOptions& own) {
    const LinkOptions* const decided = decisions.of(rows_[next++].link);
    if (decided) own = *decided;
  });
  regions_ = options.region_rules;
  has_own_regions_ = true;
  applyRegions();  // of links that the configuration leaves alone
  return options.tree;
}

}  // namespace collision_hulls
