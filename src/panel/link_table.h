// What the panel's table shows and its buttons change: the robot's links, with settings and what is known of them. Knows neither ROS nor
// Qt.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/report/options.h"

namespace collision_hulls {

/// What a link becomes with its settings; see LinkPreview.msg.
struct LinkFacts {
  std::string status;  ///< "ok", "degraded", "failed", "kept", "removed", "unbuilt"
  std::string reason;
  bool proved = false;
  std::size_t triangles = 0, hulls = 0, primitives = 0, vertices = 0;
  double tolerance = 0, protrusion = 0, found = 0;  ///< [m]
  Eigen::Vector3d worst = Eigen::Vector3d::Zero();  ///< in the link's frame
  Eigen::AlignedBox3d around;                       ///< the link's bodies, in its frame; empty: it has none
  std::vector<double> steps;                        ///< [m]
};

struct LinkRow {
  std::string link;
  LinkOptions options;
  LinkFacts facts;
  bool changed = false;  ///< its settings, here, since the node built it
};

struct TableTotals {
  std::size_t links = 0, hulls = 0, primitives = 0, vertices = 0;
  std::size_t unbuilt = 0, failed = 0;
  double protrusion = 0;   ///< [m] the largest that is proved
  std::string worst_link;  ///< that has it
};

/// Rows in the robot's order. Indices are those of rows().
class LinkTable {
 public:
  const std::vector<LinkRow>& rows() const { return rows_; }

  /// The index of a link; -1: there is none.
  int indexOf(const std::string& link) const;

  /// Takes what a node says of all links, and of the regions (doc/configuration.md). Settings that were changed here and not built yet
  /// stay, if the links are the same; so do regions that were changed or loaded here, and what can be undone. Otherwise all are gone.
  void take(std::vector<LinkRow> rows, std::vector<RegionRule> regions = {});

  /// Takes a node's answer on one link. An answer to other settings than the row has now came too late and changes nothing; whether it did.
  bool answer(const LinkRow& row);

  /// Changes settings of rows. `goes_on`: the same change as before, such as the next move of a slider; undo() takes both back at once.
  void change(const std::vector<int>& rows, const std::function<void(LinkOptions&)>& change, bool goes_on = false);

  const std::vector<RegionRule>& regions() const { return regions_; }
  /// Indices of the regions that hold for a link.
  std::vector<int> regionsOf(const std::string& link) const;
  /// The links for which a region holds, as rows.
  std::vector<int> linksOf(const RegionRule& region) const;

  /// Changes, adds or removes regions. A name that is empty becomes a number. Returns the rows that are to be built anew. Throws kBadOption
  /// for what is no region, and for a name that two have; then nothing is changed. `goes_on`: as change().
  std::vector<int> changeRegions(const std::function<void(std::vector<RegionRule>&)>& change, bool goes_on = false);

  bool canUndo() const { return !history_.empty(); }
  /// The rows whose settings it brought back.
  std::vector<int> undo();

  TableTotals totals() const;

  /// The configuration that makes these hulls (doc/configuration.md): a rule for each link that differs from the defaults. `tree`: of the
  /// node's trees, whose cuts the hulls are.
  std::string configuration(const std::optional<Length>& tree) const;

  /// Sets the rows' settings as a configuration says; other links of it are none of ours. Returns the configuration's tree, if it has one.
  /// Throws as readConfig() and LinkDecisions.
  std::optional<Length> load(const std::string& file);
  std::optional<Length> loadText(const std::string& text, const std::string& name);

 private:
  /// What undo() brings back.
  struct Moment {
    std::vector<LinkOptions> options;
    std::vector<RegionRule> regions;
    bool has_own_regions = false;
  };

  Moment now() const;
  void remember(bool goes_on);
  std::vector<int> applyRegions();

  std::vector<LinkRow> rows_;
  std::vector<RegionRule> regions_;  // each row's options have those that hold for it
  bool has_own_regions_ = false;     // changed or loaded here: they count before the node's
  std::vector<Moment> history_;      // before each change
};

}  // namespace collision_hulls
