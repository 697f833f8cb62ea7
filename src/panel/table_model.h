// The rows of a LinkTable for Qt's views.
#pragma once

#include <QAbstractTableModel>

#include "panel/link_table.h"

namespace collision_hulls {

class TableModel : public QAbstractTableModel {
 public:
  enum Column { kLink, kMethod, kTolerance, kHulls, kVertices, kBound, kFound, kStatus, kSource, kColumns };
  static constexpr int kSortRole = Qt::UserRole;  ///< the value by which a column is sorted

  explicit TableModel(LinkTable& table, QObject* parent = nullptr) : QAbstractTableModel(parent), table_(table) {}

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  /// The table takes other rows; views forget what was chosen where the links are others.
  void take(std::vector<LinkRow> rows, std::vector<RegionRule> regions = {});

  /// Call it after any other change of the table.
  void refresh();

 private:
  LinkTable& table_;
};

/// "4.83 mm"; a dash for what is not known.
QString lengthText(double metres);

}  // namespace collision_hulls
