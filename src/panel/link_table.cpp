// Undo keeps the settings of all links before each change: a few kilobytes for the largest robots.
#include "panel/link_table.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "collision_hulls/config/config.h"
#include "collision_hulls/config/link_decisions.h"
#include "config/link_rule.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostUndone = 200;

void markUnbuilt(LinkRow& row) {
  const std::vector<double> steps = row.facts.steps;
  row.facts = {};
  row.facts.status = "unbuilt";
  row.facts.steps = steps;
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
    if (rows_[i].facts.status != "unbuilt" || equalSettings(rows_[i].options, rows[i].options)) continue;
    rows[i].options = rows_[i].options;
    markUnbuilt(rows[i]);
  }
  rows_ = std::move(rows);
}

bool LinkTable::answer(const LinkRow& row) {
  const int index = indexOf(row.link);
  if (index < 0) return false;
  LinkRow& own = rows_[static_cast<std::size_t>(index)];
  if (!equalSettings(own.options, row.options)) return false;
  const std::vector<double> steps = own.facts.steps;
  own.facts = row.facts;
  if (own.facts.steps.empty()) own.facts.steps = steps;  // what is not built yet offers what it did
  return true;
}

std::vector<LinkOptions> LinkTable::options() const {
  std::vector<LinkOptions> options;
  for (const LinkRow& row : rows_) options.push_back(row.options);
  return options;
}

void LinkTable::change(const std::vector<int>& rows, const std::function<void(LinkOptions&)>& change, bool goes_on) {
  if (!goes_on || history_.empty()) history_.push_back(options());
  if (history_.size() > kMostUndone) history_.erase(history_.begin());
  for (const int index : rows) {
    LinkRow& row = rows_[static_cast<std::size_t>(index)];
    const LinkOptions before = row.options;
    change(row.options);
    if (row.options.method != Method::kCertified) row.options.effort = Effort::kQuick, row.options.fill = false;
    if (!equalSettings(before, row.options)) markUnbuilt(row);
  }
}

std::vector<int> LinkTable::undo() {
  std::vector<int> changed;
  if (history_.empty()) return changed;
  const std::vector<LinkOptions> before = std::move(history_.back());
  history_.pop_back();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (equalSettings(rows_[i].options, before[i])) continue;
    rows_[i].options = before[i];
    markUnbuilt(rows_[i]);
    changed.push_back(static_cast<int>(i));
  }
  return changed;
}

TableTotals LinkTable::totals() const {
  TableTotals totals;
  totals.links = rows_.size();
  for (const LinkRow& row : rows_) {
    totals.hulls += row.facts.hulls;
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
  return options.tree;
}

}  // namespace collision_hulls
