// Each field is read alone when its editing ends: what nobody touched keeps all its digits.
#include "panel/region_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>

#include "base/finite_number.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

constexpr double kTolerance = 0.001;  // [m] of a region that is no longer kept clear

QString vectorText(const Eigen::Vector3d& v) {
  return QString("%1, %2, %3").arg(v.x(), 0, 'g', 6).arg(v.y(), 0, 'g', 6).arg(v.z(), 0, 'g', 6);
}

double numberIn(const QString& text, const std::string& what) {
  double number = 0;
  const std::string word = text.trimmed().toStdString();
  if (!parseFinite(word, number)) throw Error(ErrorCode::kBadOption, "'" + word + "' is not a number: enter " + what);
  return number;
}

Eigen::Vector3d vectorIn(const std::string& text, const std::string& what) {
  const QStringList words = QString::fromStdString(text).split(',');
  if (words.size() != 3) throw Error(ErrorCode::kBadOption, "'" + text + "' is not three numbers with commas between them: enter " + what);
  return {numberIn(words[0], what), numberIn(words[1], what), numberIn(words[2], what)};
}

bool isClear(const RegionRule& rule) {
  return rule.tolerance == kRegionSlack;
}

void readName(const std::string& text, RegionRule& rule) {
  if (text.empty()) throw Error(ErrorCode::kBadOption, "a region needs a name, for the report");
  rule.name = text;
}

void readTolerance(const std::string& text, RegionRule& rule) {
  const double tolerance = parseMetres(text, "tolerance");
  checkTolerance(lengthOf(tolerance));
  rule.tolerance = tolerance;
}

void readCenter(const std::string& text, RegionRule& rule) {
  std::get<RegionBox>(rule.shape).center = vectorIn(text, "the center in metres, as 0, 0, 0.08");
}

void readSize(const std::string& text, RegionRule& rule) {
  std::get<RegionBox>(rule.shape).size = vectorIn(text, "the sides in metres, as 0.08, 0.2, 0.03");
}

void readRpy(const std::string& text, RegionRule& rule) {
  std::get<RegionBox>(rule.shape).rpy = vectorIn(text, "roll, pitch and yaw in radians, as 0, 0, 1.57");
}

void readNormal(const std::string& text, RegionRule& rule) {
  std::get<RegionHalfSpace>(rule.shape).normal = vectorIn(text, "the normal, which points into the region, as 0, 0, -1");
}

void readOffset(const std::string& text, RegionRule& rule) {
  std::get<RegionHalfSpace>(rule.shape).offset = numberIn(QString::fromStdString(text), "the offset, in metres along the normal, as 0.05");
}

}  // namespace

RegionForm::RegionForm(QWidget* parent) : QWidget(parent) {
  auto* const grid = new QGridLayout(this);
  list_ = new QComboBox;
  list_->setObjectName("region");
  list_->setAccessibleName("Region");
  list_->setToolTip("The regions of the link that is chosen first");
  auto* const buttons = new QHBoxLayout;
  buttons->addWidget(list_, 1);
  box_ = addButton("+ Bo&x", "add_box", "Add a box in which the link's hulls may protrude less");
  half_space_ = addButton("+ Half spac&e", "add_half_space", "Add all that is beyond a plane: the table that a robot stands on");
  remove_ = addButton("&Remove", "remove_region", "Remove the region");
  for (QPushButton* const button : {box_, half_space_, remove_}) buttons->addWidget(button);
  grid->addLayout(buttons, 0, 0, 1, 6);
  addNumbers();
  advice_ = new QLabel;
  advice_->setObjectName("region_advice");
  advice_->setWordWrap(true);
  grid->addWidget(advice_, 3, 0, 1, 6);
  for (const int column : {1, 3, 5}) grid->setColumnStretch(column, 1);
  connect(list_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    if (!is_showing_) showChosen();
  });
  connect(box_, &QPushButton::clicked, this, &RegionForm::boxWanted);
  connect(half_space_, &QPushButton::clicked, this, &RegionForm::halfSpaceWanted);
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (chosen()) Q_EMIT removed(chosen()->name);
  });
  show({}, false, "");
}

QPushButton* RegionForm::addButton(const QString& text, const char* object, const QString& tip) {
  auto* const button = new QPushButton(text);
  button->setObjectName(object);
  button->setToolTip(tip);
  button->setAutoDefault(false);
  return button;
}

void RegionForm::addNumbers() {
  auto* const grid = static_cast<QGridLayout*>(layout());
  const auto place = [grid](QLineEdit* line, int row, int column) -> std::vector<QWidget*> {
    QWidget* const label = line->property("label").value<QWidget*>();
    grid->addWidget(label, row, column);
    grid->addWidget(line, row, column + 1);
    return {label, line};
  };
  const auto add = [](std::vector<QWidget*>& all, const std::vector<QWidget*>& some) { all.insert(all.end(), some.begin(), some.end()); };
  clear_ = new QCheckBox("&Keep clear");
  clear_->setObjectName("keep_clear");
  clear_->setToolTip("No hull enters the region, except within 0.1 mm of the solid");
  name_ = addLine("Na&me", "region_name", "The region's name in the report", readName);
  tolerance_ = addLine("T&olerance", "region_tolerance", "How far hulls may protrude in the region, as 1mm", readTolerance);
  place(name_, 1, 0);
  grid->addWidget(clear_, 1, 3);
  place(tolerance_, 1, 4);
  center_ = addLine("Center", "region_center", "x, y and z in the link's frame [m]", readCenter);
  size_ = addLine("Size", "region_size", "Along the box's own axes [m]", readSize);
  rpy_ = addLine("Rotation", "region_rpy", "Roll, pitch and yaw [rad], as in URDF", readRpy);
  normal_ = addLine("Normal", "region_normal", "Points into the region, in the link's frame", readNormal);
  offset_ = addLine("Offset", "region_offset", "Of the plane along the normal [m]", readOffset);
  int column = 0;
  for (QLineEdit* const line : {center_, size_, rpy_}) add(of_box_, place(line, 2, column)), column += 2;
  add(of_half_space_, place(normal_, 2, 0));
  add(of_half_space_, place(offset_, 2, 2));
  connect(clear_, &QCheckBox::toggled, this, [this](bool is_clear) {
    if (is_showing_ || !chosen()) return;
    RegionRule rule = *chosen();
    rule.tolerance = is_clear ? kRegionSlack : kTolerance;
    change(rule);
  });
}

/// Its label is its property "label".
QLineEdit* RegionForm::addLine(const QString& label, const char* object, const QString& tip,
                               void (*read)(const std::string& text, RegionRule& rule)) {
  auto* const line = new QLineEdit;
  auto* const text = new QLabel(label);
  line->setObjectName(object);
  line->setToolTip(tip);
  text->setBuddy(line);
  line->setProperty("label", QVariant::fromValue<QWidget*>(text));
  connect(line, &QLineEdit::editingFinished, this, [this, line, read] { edit(line, read); });
  return line;
}

const RegionRule* RegionForm::chosen() const {
  const int index = list_->currentIndex();
  return index < 0 || index >= static_cast<int>(regions_.size()) ? nullptr : &regions_[static_cast<std::size_t>(index)];
}

void RegionForm::show(const std::vector<RegionRule>& regions, bool may_add, const QString& advice) {
  const QString before = list_->currentText();
  is_showing_ = true;
  regions_ = regions;
  advice_text_ = advice;
  list_->clear();
  for (const RegionRule& region : regions) list_->addItem(QString::fromStdString(region.name));
  list_->setCurrentIndex(std::max(0, list_->findText(before)));
  is_showing_ = false;
  for (QWidget* const widget : {box_, half_space_}) widget->setEnabled(may_add);
  showChosen();
}

void RegionForm::choose(const std::string& region) {
  list_->setCurrentIndex(list_->findText(QString::fromStdString(region)));
}

void RegionForm::showChosen() {
  is_showing_ = true;
  const RegionRule* const rule = chosen();
  const RegionRule shown = rule ? *rule : RegionRule{"", RegionBox(), kRegionSlack, "", ""};
  const auto* const box = std::get_if<RegionBox>(&shown.shape);
  const auto* const half_space = std::get_if<RegionHalfSpace>(&shown.shape);
  for (QWidget* const widget : of_box_) widget->setVisible(box != nullptr);
  for (QWidget* const widget : of_half_space_) widget->setVisible(half_space != nullptr);
  refused_.turnTo({shown.pattern, shown.name});
  const auto set = [this, rule](QLineEdit* line, const QString& text) {
    line->setEnabled(rule != nullptr);
    refused_.show(line, rule ? text : "");
  };
  set(name_, QString::fromStdString(shown.name));
  set(tolerance_, QString::fromStdString(toString(lengthOf(shown.tolerance))));
  if (box) set(center_, vectorText(box->center)), set(size_, vectorText(box->size)), set(rpy_, vectorText(box->rpy));
  if (half_space) set(normal_, vectorText(half_space->normal)), set(offset_, QString::number(half_space->offset));
  clear_->setChecked(rule && isClear(shown));
  tolerance_->setEnabled(rule && !isClear(shown));
  for (QWidget* const widget : {static_cast<QWidget*>(list_), static_cast<QWidget*>(clear_), static_cast<QWidget*>(remove_)})
    widget->setEnabled(rule != nullptr);
  advice_->setText(refused_.reason().isEmpty() ? advice_text_ : refused_.reason());
  is_showing_ = false;
}

void RegionForm::edit(QLineEdit* line, void (*read)(const std::string& text, RegionRule& rule)) {
  if (!line->isModified() || !chosen()) return;
  try {
    RegionRule rule = *chosen();
    read(line->text().trimmed().toStdString(), rule);
    refused_.take(line);
    change(rule);
  } catch (const Error& error) {
    refused_.refuse(line, QString::fromStdString(error.what()));
    advice_->setText(refused_.reason());
  }
}

void RegionForm::change(const RegionRule& rule) {
  const std::string name = chosen()->name;
  Q_EMIT changed(name, rule);
}

}  // namespace collision_hulls
