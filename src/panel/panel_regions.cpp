// What the panel does with regions, in its form and in the view. See panel/hulls_panel.h.
//
// Whatever a region's change is, the links that it holds for are built anew once it rests: no tree knows of regions.
#include <algorithm>
#include <utility>

#include "collision_hulls/error.h"
#include "config/link_rule.h"
#include "panel/hulls_panel.h"

namespace collision_hulls {
namespace {

/// Why a link can have no region; empty: it can.
QString obstacleOf(const LinkOptions& options) {
  if (options.action != Action::kDecompose) return QString("A link with the setting %1 has no regions.").arg(name(options.action));
  if (options.padding > 0) return "A link whose hulls are padded has no regions.";
  return {};
}

QString adviceOn(const LinkRow& row) {
  const QString obstacle = obstacleOf(row.options);
  if (!obstacle.isEmpty()) return obstacle;
  if (row.options.method != Method::kCertified)
    return QString("Only certified aims at regions; for %1, the report says how far hulls protrude there.").arg(name(row.options.method));
  return QString("In the frame of %1: metres and radians.").arg(QString::fromStdString(row.link));
}

}  // namespace

void HullsPanel::connectRegions() {
  connect(region_form_, &RegionForm::boxWanted, this, [this] { addRegion(firstBox(rowsAt(chosenRows()).front().facts.around)); });
  connect(region_form_, &RegionForm::halfSpaceWanted, this,
          [this] { addRegion(firstHalfSpace(rowsAt(chosenRows()).front().facts.around)); });
  connect(region_form_, &RegionForm::removed, this, [this](const std::string& region) {
    changeRegions([&](std::vector<RegionRule>& all) {
      all.erase(std::remove_if(all.begin(), all.end(), [&](const RegionRule& rule) { return rule.name == region; }), all.end());
    });
  });
  connect(region_form_, &RegionForm::changed, this, [this](const std::string& region, const RegionRule& changed) {
    changeRegion(region, [&](RegionRule& rule) { rule = changed; });
    region_form_->choose(changed.name);
  });
  connect(&region_server_, &RegionServer::dragged, this, [this](const RegionDrag& drag) {
    changeRegion(
        drag.region, [&](RegionRule& rule) { rule.shape = collision_hulls::dragged(rule.shape, drag.handle, drag.pose); }, drag.goes_on);
    region_form_->choose(drag.region);
  });
}

/// To the first of the links that are chosen.
void HullsPanel::addRegion(const RegionShape& shape) {
  RegionRule rule;
  rule.pattern = expressionFor({rowsAt(chosenRows()).front().link});
  rule.shape = shape;
  changeRegions([&](std::vector<RegionRule>& all) { all.push_back(rule); });
  region_form_->choose(table_.regions().back().name);
}

void HullsPanel::changeRegion(const std::string& region, const std::function<void(RegionRule&)>& change, bool goes_on) {
  const auto all = table_.regions();
  const auto rule = std::find_if(all.begin(), all.end(), [&](const RegionRule& one) { return one.name == region; });
  if (rule == all.end()) return;  // removed while it was dragged
  const std::ptrdiff_t index = rule - all.begin();
  changeRegions([&](std::vector<RegionRule>& changed) { change(changed[static_cast<std::size_t>(index)]); }, goes_on);
}

void HullsPanel::changeRegions(const std::function<void(std::vector<RegionRule>&)>& change, bool goes_on) {
  try {
    follow(table_.changeRegions(change, goes_on));
    say("");
  } catch (const Error& error) {
    say(QString::fromStdString(error.what()));
  }
  refresh();
}

void HullsPanel::showRegions() {
  const std::vector<int> chosen = chosenRows();
  std::vector<ShownRegion> shown;
  for (std::size_t i = 0; i < table_.rows().size(); ++i) {
    const LinkRow& row = table_.rows()[i];
    const bool is_chosen = std::find(chosen.begin(), chosen.end(), static_cast<int>(i)) != chosen.end();
    for (const int region : table_.regionsOf(row.link)) {
      const RegionRule& rule = table_.regions()[static_cast<std::size_t>(region)];
      shown.push_back({rule.name, row.link, rule.shape, row.facts.around, is_chosen});
    }
  }
  region_server_.show(shown);
  if (chosen.empty()) return region_form_->show({}, false, "Choose a link in the table to give it a region.");
  const LinkRow row = rowsAt(chosen).front();
  std::vector<RegionRule> of_link;
  for (const int region : table_.regionsOf(row.link)) of_link.push_back(table_.regions()[static_cast<std::size_t>(region)]);
  region_form_->show(of_link, obstacleOf(row.options).isEmpty(), adviceOn(row));
}

}  // namespace collision_hulls
