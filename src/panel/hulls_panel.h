// rviz's panel: the table of links, the settings of those that are chosen, and what can be done with them.
#pragma once

#include <rviz/panel.h>

#include <QTimer>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "panel/link_table.h"
#include "panel/node_client.h"
#include "panel/region_form.h"
#include "panel/region_server.h"
#include "panel/settings_form.h"
#include "panel/table_model.h"

class QLabel;
class QLayout;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace collision_hulls {

class HullsPanel : public rviz::Panel {
  Q_OBJECT
 public:
  explicit HullsPanel(QWidget* parent = nullptr);

  void onInitialize() override;
  /// The panel's state in rviz's configuration: node, filter, order, settings of the links, leaves of the trees, files.
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  QWidget* nodeRow();
  QWidget* jobRow();
  QWidget* tableArea();
  QWidget* forms();
  QWidget* buttons();
  QPushButton* button(QLayout* layout, const QString& text, const char* object, const QString& tip, void (HullsPanel::*pressed)());
  void connectClient();

  void showNode(bool is_there, const QString& advice);
  void takeKnown(const QString& robot, const std::vector<LinkRow>& rows, const QString& configuration);
  void takeAnswers(const std::vector<LinkRow>& rows);
  void showJob(const QString& job, double fraction, const QString& text);
  void endJob(int kind, bool success, bool refused, const QString& message);

  std::vector<int> chosenRows() const;
  std::vector<LinkRow> rowsAt(const std::vector<int>& indices) const;
  void choose();
  void change(const SettingsForm::Change& change, bool goes_on);
  void follow(const std::vector<int>& rows);
  void endOwnBuild();
  void changed(const std::vector<int>& rows);
  std::vector<int> uncertifiedRows() const;
  void sendPreview(const std::vector<int>& rows);
  void connectRegions();
  void addRegion(const RegionShape& shape);
  void changeRegion(const std::string& region, const std::function<void(RegionRule&)>& change, bool goes_on = false);
  void changeRegions(const std::function<void(std::vector<RegionRule>&)>& change, bool goes_on = false);
  void showRegions();

  void refresh();
  void enableButtons();
  void say(const QString& text);

  void connectNode();
  void build();
  void buildChanged();
  void begin(const NodeJob& job);
  void beginBuild(const std::vector<int>& rows);
  void write();
  void validate();
  void fit();
  void goToWorst();
  void saveConfiguration();
  void loadConfiguration();
  void undo();
  Length tree() const;

  LinkTable table_;
  TableModel model_{table_};
  NodeClient client_;
  RegionServer region_server_;
  QTimer settled_;  // runs out when the settings have not changed for a moment
  QString connected_to_, robot_, saved_robot_, saved_configuration_, file_, scene_;
  QString job_;
  std::set<std::string> changed_;  // links, by somebody at this panel
  NodeJob last_job_;
  int refusals_ = 0;  // of it, in a row
  bool is_there_ = false;
  bool is_own_ = false;        // a job that was begun here is not over
  bool is_own_build_ = false;  // and it builds what changed
  QLineEdit *node_ = nullptr, *filter_ = nullptr, *tree_ = nullptr;
  QLabel *advice_ = nullptr, *totals_ = nullptr, *message_ = nullptr, *job_text_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QWidget *job_row_ = nullptr, *work_ = nullptr;
  QTableView* view_ = nullptr;
  QSortFilterProxyModel* sorted_ = nullptr;
  SettingsForm* form_ = nullptr;
  RegionForm* region_form_ = nullptr;
  std::map<std::string, QPushButton*> buttons_;  // by object name
};

}  // namespace collision_hulls
