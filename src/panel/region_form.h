// The regions of the link that is chosen, in numbers.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "collision_hulls/report/options.h"
#include "panel/refused_entry.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace collision_hulls {

/// Changes nothing by itself. A value that cannot be read says so in the form, and is not passed on.
class RegionForm : public QWidget {
  Q_OBJECT
 public:
  explicit RegionForm(QWidget* parent = nullptr);

  /// Shows the regions of a link, by their names the one that was chosen before, or else the first. `may_add`: the link has hulls, which a
  /// region can shape. `advice`: what there is to know of the link, or why it can have no region.
  void show(const std::vector<RegionRule>& regions, bool may_add, const QString& advice);

  /// Chooses one, by its name.
  void choose(const std::string& region);

 Q_SIGNALS:
  void boxWanted();
  void halfSpaceWanted();
  void removed(const std::string& region);
  /// Somebody changed the region of this name, which may have another now.
  void changed(const std::string& region, const collision_hulls::RegionRule& rule);

 private:
  void showChosen();
  const RegionRule* chosen() const;
  void edit(QLineEdit* line, void (*read)(const std::string& text, RegionRule& rule));
  void change(const RegionRule& rule);
  QLineEdit* addLine(const QString& label, const char* object, const QString& tip, void (*read)(const std::string& text, RegionRule& rule));
  void addNumbers();
  QPushButton* addButton(const QString& text, const char* object, const QString& tip);

  std::vector<RegionRule> regions_;
  RefusedEntry refused_;
  QString advice_text_;
  bool is_showing_ = false;  // fields change because of show()
  QComboBox* list_ = nullptr;
  QPushButton *box_ = nullptr, *half_space_ = nullptr, *remove_ = nullptr;
  QCheckBox* clear_ = nullptr;
  QLineEdit *name_ = nullptr, *tolerance_ = nullptr, *center_ = nullptr, *size_ = nullptr, *rpy_ = nullptr, *normal_ = nullptr,
            *offset_ = nullptr;
  std::vector<QWidget*> of_box_, of_half_space_;  // with their labels
  QLabel* advice_ = nullptr;
};

}  // namespace collision_hulls
