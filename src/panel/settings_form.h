// The boxes and the slider that change the settings of the links that are chosen.
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "panel/link_table.h"
#include "panel/refused_entry.h"
#include "panel/tolerance_scale.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QSlider;
class QSpinBox;

namespace collision_hulls {

class SettingsForm : public QWidget {
  Q_OBJECT
 public:
  using Change = std::function<void(LinkOptions&)>;

  explicit SettingsForm(QWidget* parent = nullptr);

  /// Shows these links, whose first one's settings the boxes have; none: everything is disabled. Changes nothing.
  void show(const std::vector<const LinkRow*>& links);

 Q_SIGNALS:
  /// Somebody changed a setting of the links that are shown. `goes_on`: see LinkTable::change().
  void changed(const collision_hulls::SettingsForm::Change& change, bool goes_on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addTolerance(QGridLayout* grid);
  void addBoxes(QGridLayout* grid);
  void addOpenings(QGridLayout* grid);
  void enable(bool any, const LinkOptions& options);
  void describe(const std::vector<const LinkRow*>& links);
  void slide(int position);
  void step(int by);
  void type(QLineEdit* line, Change (*read)(const std::string& text));
  void setTolerance(double metres);

  ToleranceScale scale_;
  std::vector<std::vector<double>> steps_;
  double tolerance_ = 0.01;  // [m] that the slider has
  bool is_showing_ = false;  // boxes change because of show()
  bool goes_on_ = false;     // the slider moved last
  RefusedEntry refused_;
  QSlider* slider_ = nullptr;
  QLineEdit *tolerance_text_ = nullptr, *openings_ = nullptr;
  QLabel* effect_ = nullptr;
  QComboBox *action_ = nullptr, *method_ = nullptr, *effort_ = nullptr, *source_ = nullptr;
  QSpinBox *max_hulls_ = nullptr, *max_vertices_ = nullptr;
};

}  // namespace collision_hulls
