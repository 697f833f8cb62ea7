// What the panel looks like, what it remembers, and what happens when the node says something. What its buttons do: panel_actions.cpp.
//
// No colours and no sizes in pixels: themes and densities are the platform's.
#include "panel/hulls_panel.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QSortFilterProxyModel>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

#include "collision_hulls/config/config.h"
#include "report/check_text.h"

namespace collision_hulls {
namespace {

constexpr int kSettled = 400;  // [ms] after the last change, until the hulls are certified
constexpr const char* kNode = "collision_hulls";
constexpr const char* kTree = "2mm,1%";

QHBoxLayout* rowOf(QWidget* widget) {
  auto* const row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  return row;
}

/// Of a node's own configuration, which is not in question.
std::vector<RegionRule> regionsIn(const std::string& configuration) {
  Options options;
  if (!configuration.empty()) apply(parseConfig(configuration, "the node's configuration"), options);
  return options.region_rules;
}

}  // namespace

HullsPanel::HullsPanel(QWidget* parent) : rviz::Panel(parent) {
  settled_.setSingleShot(true);
  settled_.setInterval(kSettled);
  auto* const column = new QVBoxLayout(this);
  column->addWidget(nodeRow());
  advice_ = new QLabel;
  advice_->setObjectName("advice");
  advice_->setWordWrap(true);
  advice_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  column->addWidget(advice_);
  work_ = new QWidget;
  auto* const work = new QVBoxLayout(work_);
  work->setContentsMargins(0, 0, 0, 0);
  work->addWidget(tableArea(), 1);
  work->addWidget(forms());
  work->addWidget(buttons());
  column->addWidget(work_, 1);
  column->addWidget(jobRow());
  message_ = new QLabel;
  message_->setObjectName("message");
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(message_);
  connect(form_, &SettingsForm::changed, this, &HullsPanel::change);
  connect(&settled_, &QTimer::timeout, this, &HullsPanel::buildChanged);
  connectClient();
  connectRegions();
  showNode(false, "Looking for the node.");
}

QWidget* HullsPanel::forms() {
  auto* const tabs = new QTabWidget;
  tabs->setObjectName("forms");
  form_ = new SettingsForm;
  region_form_ = new RegionForm;
  tabs->addTab(form_, "Settings");
  tabs->addTab(region_form_, "Regions");
  return tabs;
}

QWidget* HullsPanel::nodeRow() {
  auto* const widget = new QWidget;
  QHBoxLayout* const row = rowOf(widget);
  auto* const label = new QLabel("&Node");
  node_ = new QLineEdit(kNode);
  node_->setObjectName("node");
  node_->setToolTip("The node's name, with its name space: collision_hulls or /left/collision_hulls");
  label->setBuddy(node_);
  auto* const filter = new QLabel("Fi&lter");
  filter_ = new QLineEdit;
  filter_->setObjectName("filter");
  filter_->setPlaceholderText("part of a link's name");
  filter_->setClearButtonEnabled(true);
  filter->setBuddy(filter_);
  for (QWidget* part :
       {static_cast<QWidget*>(label), static_cast<QWidget*>(node_), static_cast<QWidget*>(filter), static_cast<QWidget*>(filter_)})
    row->addWidget(part);
  connect(node_, &QLineEdit::editingFinished, this, &HullsPanel::connectNode);
  return widget;
}

QWidget* HullsPanel::tableArea() {
  auto* const widget = new QWidget;
  auto* const column = new QVBoxLayout(widget);
  column->setContentsMargins(0, 0, 0, 0);
  sorted_ = new QSortFilterProxyModel(this);
  sorted_->setSourceModel(&model_);
  sorted_->setSortRole(TableModel::kSortRole);
  sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  sorted_->setFilterKeyColumn(TableModel::kLink);
  view_ = new QTableView;
  view_->setObjectName("links");
  view_->setAccessibleName("Links");
  view_->setModel(sorted_);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setAlternatingRowColors(true);
  view_->setTabKeyNavigation(false);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setDefaultSectionSize(view_->fontMetrics().height() * 3 / 2);
  view_->horizontalHeader()->setHighlightSections(false);
  view_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  view_->setSortingEnabled(true);
  view_->sortByColumn(-1, Qt::AscendingOrder);  // the robot's order
  totals_ = new QLabel;
  totals_->setObjectName("totals");
  totals_->setWordWrap(true);
  column->addWidget(view_, 1);
  column->addWidget(totals_);
  connect(filter_, &QLineEdit::textChanged, sorted_, &QSortFilterProxyModel::setFilterFixedString);
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &HullsPanel::choose);
  return widget;
}

QPushButton* HullsPanel::button(QLayout* layout, const QString& text, const char* object, const QString& tip,
                                void (HullsPanel::*pressed)()) {
  auto* const button = new QPushButton(text);
  button->setObjectName(object);
  button->setToolTip(tip);
  button->setAutoDefault(false);
  layout->addWidget(button);
  connect(button, &QPushButton::clicked, this, pressed);
  buttons_[object] = button;
  return button;
}

QWidget* HullsPanel::buttons() {
  auto* const widget = new QWidget;
  auto* const column = new QVBoxLayout(widget);
  column->setContentsMargins(0, 0, 0, 0);
  auto* const first = new QHBoxLayout;
  auto* const label = new QLabel("F&inest tolerance");
  tree_ = new QLineEdit(kTree);
  tree_->setObjectName("tree");
  tree_->setToolTip("The finest tolerance that the slider offers without building again, as 2mm or 2mm,1%; finer takes longer to build");
  label->setBuddy(tree_);
  first->addWidget(label);
  first->addWidget(tree_);
  button(first, "&Build", "build", "Build the hull trees of all links, which make the slider live, and certify all hulls",
         &HullsPanel::build);
  button(first, "Vali&date", "validate", "Compare the hulls, as they are now, with the original meshes by collision queries",
         &HullsPanel::validate);
  button(first, "&Worst place", "worst", "Move the camera to where the chosen link's hulls protrude furthest", &HullsPanel::goToWorst);
  button(first, "&Undo", "undo", "Take the last change of settings back", &HullsPanel::undo);
  auto* const second = new QHBoxLayout;
  button(second, "Lo&ad…", "load", "Load a configuration (doc/configuration.md)", &HullsPanel::loadConfiguration);
  button(second, "&Save…", "save", "Save the settings as a configuration, for decompose --config", &HullsPanel::saveConfiguration);
  button(second, "&Fit to scene…", "fit", "Fit the robot to a scene from a file, and write the package", &HullsPanel::fit);
  button(second, "Write &package", "write", "Write the robot with these hulls as a package, in the node's output folder",
         &HullsPanel::write);
  column->addLayout(first);
  column->addLayout(second);
  return widget;
}

QWidget* HullsPanel::jobRow() {
  job_row_ = new QWidget;
  QHBoxLayout* const row = rowOf(job_row_);
  progress_ = new QProgressBar;
  progress_->setObjectName("progress");
  progress_->setRange(0, 100);
  job_text_ = new QLabel;
  row->addWidget(progress_);
  row->addWidget(job_text_, 1);
  auto* const cancel = new QPushButton("Cancel");
  cancel->setObjectName("cancel");
  cancel->setAutoDefault(false);
  row->addWidget(cancel);
  buttons_["cancel"] = cancel;
  connect(cancel, &QPushButton::clicked, &client_, &NodeClient::cancel);
  QSizePolicy policy = job_row_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  job_row_->setSizePolicy(policy);
  job_row_->hide();
  return job_row_;
}

void HullsPanel::connectClient() {
  connect(&client_, &NodeClient::connected, this, &HullsPanel::showNode);
  connect(&client_, &NodeClient::known, this, &HullsPanel::takeKnown);
  connect(&client_, &NodeClient::previewed, this, [this](const std::vector<LinkRow>& rows, double) { takeAnswers(rows); });
  connect(&client_, &NodeClient::working, this, &HullsPanel::showJob);
  connect(&client_, &NodeClient::finished, this, &HullsPanel::endJob);
  connect(&client_, &NodeClient::failed, this, &HullsPanel::say);
}

void HullsPanel::onInitialize() {
  connectNode();
}

void HullsPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString text;
  if (config.mapGetString("Node", &text)) node_->setText(text);
  if (config.mapGetString("Filter", &text)) filter_->setText(text);
  if (config.mapGetString("Leaves", &text)) tree_->setText(text);
  config.mapGetString("Robot", &saved_robot_);
  config.mapGetString("Configuration", &saved_configuration_);
  config.mapGetString("File", &file_);
  config.mapGetString("Scene", &scene_);
  int column = -1, order = Qt::AscendingOrder;
  if (config.mapGetInt("Sort Column", &column) && config.mapGetInt("Sort Order", &order))
    view_->sortByColumn(column, static_cast<Qt::SortOrder>(order));
  connectNode();
}

void HullsPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Node", node_->text());
  config.mapSetValue("Filter", filter_->text());
  config.mapSetValue("Leaves", tree_->text());
  config.mapSetValue("Sort Column", view_->horizontalHeader()->sortIndicatorSection());
  config.mapSetValue("Sort Order", view_->horizontalHeader()->sortIndicatorOrder());
  config.mapSetValue("File", file_);
  config.mapSetValue("Scene", scene_);
  const bool has_links = !table_.rows().empty();
  config.mapSetValue("Robot", has_links ? robot_ : saved_robot_);
  config.mapSetValue("Configuration", has_links ? QString::fromStdString(table_.configuration(std::nullopt)) : saved_configuration_);
}

void HullsPanel::connectNode() {
  if (node_->text() == connected_to_) return;
  connected_to_ = node_->text();
  model_.take({});
  refresh();
  showNode(false, "Looking for the node.");
  client_.setNode(connected_to_);
  region_server_.setTopic(connected_to_.trimmed().toStdString() + "/regions");
}

void HullsPanel::showNode(bool is_there, const QString& advice) {
  is_there_ = is_there;
  if (!is_there) job_.clear(), is_own_ = is_own_build_ = false;
  advice_->setText(advice);
  advice_->setVisible(!is_there);
  job_row_->setVisible(!job_.isEmpty());
  enableButtons();
}

void HullsPanel::takeKnown(const QString& robot, const std::vector<LinkRow>& rows, const QString& configuration) {
  robot_ = robot;
  std::vector<RegionRule> regions;
  try {
    regions = regionsIn(configuration.toStdString());
  } catch (const std::exception& error) {
    say(QString::fromStdString(error.what()));
  }
  model_.take(rows, std::move(regions));
  if (!rows.empty() && robot == saved_robot_ && !saved_configuration_.isEmpty()) {
    try {
      table_.loadText(saved_configuration_.toStdString(), "rviz's configuration");
    } catch (const std::exception& error) {
      say(QString::fromStdString(error.what()));
    }
    saved_configuration_.clear();
  }
  refresh();
  advice_->setVisible(rows.empty());
  if (rows.empty())
    advice_->setText(robot.isEmpty() ? "The node has read no robot yet: press Build." : "The robot has no links with meshes.");
  const std::vector<int> still_chosen = chosenRows();
  if (!still_chosen.empty() && !is_own_) sendPreview(still_chosen);
}

void HullsPanel::takeAnswers(const std::vector<LinkRow>& rows) {
  for (const LinkRow& row : rows) table_.answer(row);
  refresh();
  if (!uncertifiedRows().empty()) settled_.start();
}

void HullsPanel::showJob(const QString& job, double fraction, const QString& text) {
  job_ = job;
  progress_->setValue(static_cast<int>(100 * fraction));
  progress_->setAccessibleName(job);
  job_text_->setText(text.isEmpty() ? job : text.section(", ", 1));
  job_row_->setVisible(!job.isEmpty());
  enableButtons();
}

void HullsPanel::refresh() {
  model_.refresh();
  const std::vector<int> chosen = chosenRows();
  std::vector<const LinkRow*> links;
  for (const int index : chosen) links.push_back(&table_.rows()[static_cast<std::size_t>(index)]);
  form_->show(links);
  showRegions();
  const TableTotals totals = table_.totals();
  const QString bodies = QString::fromStdString(countedBodies(totals.hulls, totals.primitives));
  QString text = QString("%1 links, <b>%2</b>, %3 vertices").arg(totals.links).arg(bodies).arg(totals.vertices);
  if (totals.protrusion > 0)
    text += ", at most <b>" + lengthText(totals.protrusion) + "</b> (" + QString::fromStdString(totals.worst_link).toHtmlEscaped() + ")";
  if (totals.unbuilt > 0) text += QString("; %1 to build").arg(totals.unbuilt);
  if (totals.failed > 0) text += QString("; %1 failed").arg(totals.failed);
  totals_->setText(table_.rows().empty() ? QString() : text);
  enableButtons();
}

void HullsPanel::enableButtons() {
  const bool is_idle = is_there_ && job_.isEmpty(), has_links = !table_.rows().empty();
  buttons_["build"]->setEnabled(is_idle);
  for (const char* const name : {"write", "validate"}) buttons_[name]->setEnabled(is_idle && has_links);
  buttons_["fit"]->setEnabled(is_idle && has_links);
  buttons_["load"]->setEnabled(has_links);
  buttons_["save"]->setEnabled(has_links);
  buttons_["undo"]->setEnabled(table_.canUndo());
  buttons_["cancel"]->setEnabled(is_own_);
  const std::vector<int> chosen = chosenRows();
  buttons_["worst"]->setEnabled(!chosen.empty() && table_.rows()[static_cast<std::size_t>(chosen.front())].facts.found > 0);
}

void HullsPanel::say(const QString& text) {
  message_->setText(text);
}

}  // namespace collision_hulls

PLUGINLIB_EXPORT_CLASS(collision_hulls::HullsPanel, rviz::Panel)
