// Text for people and numbers for sorting; colours are the views' own, so that any theme works.
#include "panel/table_model.h"

#include <algorithm>
#include <utility>

#include "report/check_text.h"

namespace collision_hulls {
namespace {

QString methodText(const LinkOptions& options) {
  return options.action == Action::kDecompose ? name(options.method) : name(options.action);
}

bool hasHulls(const LinkRow& row) {
  return row.options.action == Action::kDecompose && row.facts.status != "unbuilt" && row.facts.status != "failed";
}

QVariant text(const LinkRow& row, int column) {
  const bool has_hulls = hasHulls(row);
  const QString dash = QStringLiteral("–");
  switch (column) {
    case TableModel::kLink: return QString::fromStdString(row.link);
    case TableModel::kMethod: return methodText(row.options);
    case TableModel::kTolerance:
      return row.options.action == Action::kDecompose ? QString::fromStdString(toString(row.options.tolerance)) : dash;
    case TableModel::kHulls: return has_hulls ? QString::fromStdString(bodiesInColumn(row.facts.hulls, row.facts.primitives)) : dash;
    case TableModel::kVertices: return has_hulls ? QString::number(row.facts.vertices) : dash;
    case TableModel::kBound: return lengthText(has_hulls ? row.facts.protrusion : 0);
    case TableModel::kFound: return lengthText(has_hulls && row.facts.proved ? row.facts.found : 0);
    case TableModel::kStatus: return QString::fromStdString(row.facts.status);
    case TableModel::kSource: return name(row.options.source);
  }
  return {};
}

QVariant sortValue(const LinkRow& row, int column) {
  switch (column) {
    case TableModel::kTolerance: return row.facts.tolerance > 0 ? row.facts.tolerance : row.options.tolerance.limit;
    case TableModel::kHulls: return static_cast<qulonglong>(row.facts.hulls + row.facts.primitives);
    case TableModel::kVertices: return static_cast<qulonglong>(row.facts.vertices);
    case TableModel::kBound: return row.facts.protrusion;
    case TableModel::kFound: return row.facts.found;
  }
  return text(row, column);
}

bool isNumber(int column) {
  return column >= TableModel::kTolerance && column <= TableModel::kFound;
}

}  // namespace

QString lengthText(double metres) {
  return metres > 0 ? QString::number(1000 * metres, 'g', 3) + " mm" : QStringLiteral("–");
}

int TableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(table_.rows().size());
}

int TableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant TableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const LinkRow& row = table_.rows()[static_cast<std::size_t>(index.row())];
  if (role == Qt::DisplayRole) return text(row, index.column());
  if (role == kSortRole) return sortValue(row, index.column());
  if (role == Qt::ToolTipRole && !row.facts.reason.empty()) return QString::fromStdString(row.facts.reason);
  if (role == Qt::TextAlignmentRole && isNumber(index.column())) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  static const char* const names[kColumns] = {"Link", "Method", "Tolerance", "Hulls", "Vertices", "Bound", "Found", "Status", "Source"};
  static const char* const tips[kColumns] = {"",
                                             "Or keep, or remove",
                                             "How far the hulls may protrude",
                                             "",
                                             "Of all hulls",
                                             "The proved bound on the protrusion: no point of the hulls is further from the solid",
                                             "The largest protrusion that was found",
                                             "",
                                             "Which elements become hulls"};
  if (orientation != Qt::Horizontal || section < 0 || section >= kColumns) return {};
  if (role == Qt::DisplayRole) return QString(names[section]);
  if (role == Qt::ToolTipRole) return QString(tips[section]);
  return {};
}

void TableModel::take(std::vector<LinkRow> rows, std::vector<RegionRule> regions) {
  const auto& old = table_.rows();
  const bool is_same =
      std::equal(rows.begin(), rows.end(), old.begin(), old.end(), [](const LinkRow& a, const LinkRow& b) { return a.link == b.link; });
  if (!is_same) beginResetModel();
  table_.take(std::move(rows), std::move(regions));
  if (!is_same) endResetModel();
  refresh();
}

void TableModel::refresh() {
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

}  // namespace collision_hulls
