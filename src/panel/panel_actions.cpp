// What the panel's buttons, boxes and slider do. See panel/hulls_panel.h.
//
// A change goes to the node at once as a preview, which it cuts from its trees. Once the settings have not changed for a moment, what is
// not certified yet is built: then the table has what a run would write, and where the hulls protrude most.
#include <rviz/frame_manager.h>
#include <rviz/properties/property.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QSaveFile>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <algorithm>
#include <utility>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "panel/hulls_panel.h"

namespace collision_hulls {
namespace {

constexpr double kClose = 60;                    // the camera's distance from the worst place, in protrusions,
constexpr double kNearest = 0.3, kFurthest = 3;  // [m] and its limits
constexpr int kMostRefusals = 10, kRetry = 300;  // [ms]
constexpr double kClearance = 0.01;              // [m] from a scene, if nobody changes it
constexpr const char* kFilter = "Configurations (*.yaml *.yml);;All files (*)";

/// What scenes are read from.
QString sceneFilter() {
  std::string filter = "Scenes (*.scene *.urdf *.sdf *.world *.yaml *.yml *.bt *.ot";
  for (const std::string& extension : meshExtensions()) filter += " *" + extension;
  return QString::fromStdString(filter + ");;All files (*)");
}

}  // namespace

std::vector<int> HullsPanel::chosenRows() const {
  std::vector<int> rows;
  if (!view_->selectionModel()) return rows;
  for (const QModelIndex& index : view_->selectionModel()->selectedRows()) rows.push_back(sorted_->mapToSource(index).row());
  std::sort(rows.begin(), rows.end());
  return rows;
}

std::vector<LinkRow> HullsPanel::rowsAt(const std::vector<int>& indices) const {
  std::vector<LinkRow> rows;
  for (const int index : indices) rows.push_back(table_.rows()[static_cast<std::size_t>(index)]);
  return rows;
}

void HullsPanel::choose() {
  refresh();
  sendPreview(chosenRows());
}

void HullsPanel::sendPreview(const std::vector<int>& rows) {
  if (is_there_) client_.preview(rowsAt(rows));
}

/// The answer refreshes the panel, so that nothing flickers in between.
void HullsPanel::change(const SettingsForm::Change& change, bool goes_on) {
  const std::vector<int> rows = chosenRows();
  table_.change(rows, change, goes_on);
  follow(rows);
}

/// Of rows that were changed; without any, what is going on stays as it is.
void HullsPanel::follow(const std::vector<int>& rows) {
  if (rows.empty()) return;
  changed(rows);
  endOwnBuild();
  if (is_there_) {
    sendPreview(rows);
  } else {
    refresh();
  }
}

/// Of earlier settings, also one that is about to begin.
void HullsPanel::endOwnBuild() {
  settled_.stop();
  if (is_own_build_) client_.cancel();
}

void HullsPanel::undo() {
  follow(table_.undo());
  refresh();  // regions may have changed that hold for no link
}

Length HullsPanel::tree() const {
  return parseTolerance(tree_->text().toStdString(), "finest tolerance");
}

void HullsPanel::changed(const std::vector<int>& rows) {
  for (const LinkRow& row : rowsAt(rows)) changed_.insert(row.link);
}

/// Of what was changed here. What fails stays as it is.
std::vector<int> HullsPanel::uncertifiedRows() const {
  std::vector<int> rows;
  for (const std::string& link : changed_) {
    const int index = table_.indexOf(link);
    if (index < 0) continue;
    const LinkFacts& facts = table_.rows()[static_cast<std::size_t>(index)].facts;
    if (!facts.proved && facts.status != "failed") rows.push_back(index);
  }
  return rows;
}

/// Certifies what was changed, now or once the node is free.
void HullsPanel::buildChanged() {
  const std::vector<int> rows = uncertifiedRows();
  if (rows.empty() || !is_there_) return;
  if (is_own_ || !job_.isEmpty()) {
    settled_.start();
  } else {
    beginBuild(rows);
    is_own_build_ = is_own_;
  }
}

void HullsPanel::build() {
  beginBuild({});
}

void HullsPanel::beginBuild(const std::vector<int>& rows) {
  try {
    NodeJob job;
    if (!table_.rows().empty()) job.configuration = table_.configuration(tree());
    for (const LinkRow& row : rowsAt(rows)) job.only.push_back(row.link);
    say("");
    begin(job);
  } catch (const Error& error) {
    say(QString::fromStdString(error.what()));
  }
}

void HullsPanel::begin(const NodeJob& job) {
  is_own_ = true;
  is_own_build_ = false;
  last_job_ = job;
  client_.begin(job);
  enableButtons();
}

void HullsPanel::write() {
  try {
    NodeJob job;
    job.kind = NodeJob::kWrite;
    job.configuration = table_.configuration(tree());
    say("");
    begin(job);
  } catch (const Error& error) {
    say(QString::fromStdString(error.what()));
  }
}

void HullsPanel::validate() {
  NodeJob job;
  job.kind = NodeJob::kValidate;
  say("");
  begin(job);
}

void HullsPanel::fit() {
  const QString file = QFileDialog::getOpenFileName(this, "Scene", scene_, sceneFilter());
  if (file.isEmpty()) return;
  bool is_given = false;
  const double clearance = QInputDialog::getDouble(this, "Fit to scene", "The model is free wherever the robot keeps this distance [mm]",
                                                   1000 * kClearance, 0.1, 1000, 1, &is_given);
  if (!is_given) return;
  scene_ = file;
  try {
    NodeJob job;
    job.kind = NodeJob::kFit;
    job.configuration = table_.configuration(std::nullopt);  // a fit builds trees of its own
    job.scene = file.toStdString();
    job.clearance = clearance / 1000;
    say("");
    begin(job);
  } catch (const Error& error) {
    say(QString::fromStdString(error.what()));
  }
}

void HullsPanel::endJob(int kind, bool success, bool refused, const QString& message) {
  const bool was_small = std::exchange(is_own_build_, false);
  is_own_ = false;
  enableButtons();
  if (refused && was_small) {
    settled_.start();  // once more, when the node is free
  } else if (refused && job_.isEmpty() && ++refusals_ < kMostRefusals) {
    QTimer::singleShot(kRetry, this, [this, job = last_job_] {  // the job before is ending just now
      if (!is_own_) begin(job);
    });
  } else {
    refusals_ = 0;
    const bool is_routine = success ? kind == NodeJob::kBuild : was_small && message.startsWith("cancelled");
    if (!is_routine) say(message);
    if (!was_small && kind == NodeJob::kBuild) sendPreview(chosenRows());  // their edges
  }
}

void HullsPanel::saveConfiguration() {
  QString file = QFileDialog::getSaveFileName(this, "Save the configuration", file_.isEmpty() ? robot_ + "_hulls.yaml" : file_, kFilter);
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) file += ".yaml";
  try {
    const std::string text = table_.configuration(tree());
    QSaveFile out(file);  // what it replaces stays until all is written
    const bool saved = out.open(QIODevice::WriteOnly) && out.write(QByteArray::fromStdString(text)) >= 0 && out.commit();
    if (saved) file_ = file;
    say(saved ? "Saved " + file : "'" + file + "' cannot be written: choose another place");
  } catch (const Error& error) {
    say(QString::fromStdString(error.what()));
  }
}

void HullsPanel::loadConfiguration() {
  const QString file = QFileDialog::getOpenFileName(this, "Load a configuration", file_, kFilter);
  if (file.isEmpty()) return;
  try {
    if (const std::optional<Length> leaves = table_.load(file.toStdString())) tree_->setText(QString::fromStdString(toString(*leaves)));
    endOwnBuild();
    file_ = file;
    say("Loaded " + file + "; press Build to see its hulls.");
  } catch (const Error& error) {
    say(QString::fromStdString(error.what()));
  }
  refresh();
}

void HullsPanel::goToWorst() {
  const std::vector<int> chosen = chosenRows();
  rviz::ViewController* const camera = vis_manager_->getViewManager()->getCurrent();
  if (chosen.empty() || !camera) return;
  const LinkRow row = rowsAt({chosen.front()}).front();
  geometry_msgs::Pose pose;
  pose.position.x = row.facts.worst.x();
  pose.position.y = row.facts.worst.y();
  pose.position.z = row.facts.worst.z();
  pose.orientation.w = 1;
  Ogre::Vector3 place;
  Ogre::Quaternion turn;
  if (!vis_manager_->getFrameManager()->transform(row.link, ros::Time(), pose, place, turn)) {
    say("The place of link '" + QString::fromStdString(row.link) + "' is not known: nobody publishes its frame.");
    return;
  }
  camera->lookAt(place);
  camera->subProp("Distance")->setValue(std::clamp(kClose * row.facts.found, kNearest, kFurthest));
}

}  // namespace collision_hulls
