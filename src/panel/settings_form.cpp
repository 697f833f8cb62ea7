// The slider's own positions mean nothing: each is taken to the nearest tolerance that the hull trees offer, and the slider goes there. Its
// arrow keys go from one of these to the next.
#include "panel/settings_form.h"

#include <QComboBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "collision_hulls/decompose/reduce_vertices.h"
#include "collision_hulls/error.h"
#include "panel/table_model.h"
#include "report/check_text.h"

namespace collision_hulls {
namespace {

constexpr int kPage = 5;           // steps
constexpr double kMetre = 0.9995;  // [m] from here on a tolerance is 1 m, the most there is
constexpr double kSame = 0.001;    // of a tolerance: steps are further apart
constexpr int kMostHulls = 1000, kMostVertices = 1000;

QComboBox* addBox(QGridLayout* grid, int row, int column, const QString& label, const char* object, const QStringList& items) {
  auto* const text = new QLabel(label);
  auto* const box = new QComboBox;
  box->setObjectName(object);
  box->addItems(items);
  text->setBuddy(box);
  grid->addWidget(text, row, column);
  grid->addWidget(box, row, column + 1);
  return box;
}

QSpinBox* addSpin(QGridLayout* grid, int row, int column, const QString& label, const char* object, int most) {
  auto* const text = new QLabel(label);
  auto* const spin = new QSpinBox;
  spin->setObjectName(object);
  spin->setRange(0, most);
  spin->setSpecialValueText("no limit");
  spin->setKeyboardTracking(false);
  text->setBuddy(spin);
  grid->addWidget(text, row, column);
  grid->addWidget(spin, row, column + 1);
  return spin;
}

/// [m] as somebody would type it.
QString openingsText(double width) {
  return width > 0 ? QString::fromStdString(toString(lengthOf(width))) : QString("0");
}

// What somebody typed, as a change. A value that is refused throws kBadOption.

SettingsForm::Change typedTolerance(const std::string& text) {
  const Length tolerance = parseTolerance(text);
  return [tolerance](LinkOptions& options) { options.tolerance = tolerance; };
}

SettingsForm::Change typedOpenings(const std::string& text) {
  const double width = parsePadding(text, "close openings");
  return [width](LinkOptions& options) { options.close_openings = width; };
}

template <typename T>
QStringList namesOf(const std::vector<T>& all) {
  QStringList names;
  for (const T& one : all) names << name(one);
  return names;
}

}  // namespace

SettingsForm::SettingsForm(QWidget* parent) : QWidget(parent) {
  auto* const grid = new QGridLayout(this);
  addTolerance(grid);
  addBoxes(grid);
  addOpenings(grid);
  for (const int column : {1, 3, 5}) grid->setColumnStretch(column, 1);
  show({});
}

void SettingsForm::addTolerance(QGridLayout* grid) {
  auto* const text = new QLabel("&Tolerance");
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setObjectName("tolerance");
  slider_->setRange(0, ToleranceScale::kPositions);
  slider_->setToolTip("How far the hulls of the chosen links may protrude: left is finer. The arrow keys go to the next number of hulls.");
  slider_->installEventFilter(this);
  text->setBuddy(slider_);
  tolerance_text_ = new QLineEdit;
  tolerance_text_->setObjectName("tolerance_text");
  tolerance_text_->setToolTip("A length such as 5mm, a percentage of each mesh's diagonal, or both: 1cm,5%");
  tolerance_text_->setAccessibleName("Tolerance");
  effect_ = new QLabel;
  effect_->setObjectName("effect");
  effect_->setWordWrap(true);
  grid->addWidget(text, 0, 0);
  grid->addWidget(slider_, 0, 1, 1, 4);
  grid->addWidget(tolerance_text_, 0, 5);
  grid->addWidget(effect_, 1, 1, 1, 5);
  connect(slider_, &QSlider::valueChanged, this, &SettingsForm::slide);
  connect(tolerance_text_, &QLineEdit::editingFinished, this, [this] { type(tolerance_text_, typedTolerance); });
}

void SettingsForm::addBoxes(QGridLayout* grid) {
  action_ = addBox(grid, 2, 0, "&Collision", "action", {"decompose", "keep", "remove"});
  action_->setToolTip("What becomes of the links' <collision> elements");
  method_ = addBox(grid, 2, 2, "&Method", "method", namesOf(allMethods()));
  method_->setToolTip("How meshes are decomposed; the slider works with certified");
  effort_ = addBox(grid, 2, 4, "&Effort", "effort", namesOf(allEfforts()));
  effort_->setToolTip("instant: quickest, more hulls; best: fewest hulls, slowest (method certified)");
  max_hulls_ = addSpin(grid, 3, 0, "Most &hulls", "max_hulls", kMostHulls);
  max_hulls_->setToolTip("Most hulls per mesh; the hulls may then protrude further than the tolerance");
  max_vertices_ = addSpin(grid, 3, 2, "Most &vertices", "max_vertices", kMostVertices);
  max_vertices_->setToolTip("Most vertices per hull, 8 or more");
  source_ = addBox(grid, 4, 0, "Sou&rce", "source", {"auto", "visual", "collision"});
  source_->setToolTip("Elements to decompose; auto: <collision> if the link has any, else <visual>");
  const auto choose = [this](QComboBox* box, auto apply) {
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, box, apply](int) {
      const std::string text = box->currentText().toStdString();
      if (!is_showing_) goes_on_ = false, Q_EMIT changed([text, apply](LinkOptions& options) { apply(text, options); }, false);
    });
  };
  choose(action_, [](const std::string& text, LinkOptions& options) { options.action = *actionNamed(text); });
  choose(method_, [](const std::string& text, LinkOptions& options) { options.method = *methodNamed(text); });
  choose(effort_, [](const std::string& text, LinkOptions& options) { options.effort = *effortNamed(text); });
  choose(source_, [](const std::string& text, LinkOptions& options) { options.source = *sourceNamed(text); });
  const auto limit = [this](QSpinBox* spin, int LinkOptions::*option, int least) {
    connect(spin, QOverload<int>::of(&QSpinBox::valueChanged), this, [this, option, least](int value) {
      const int limit = value == 0 ? 0 : std::max(value, least);
      if (!is_showing_) goes_on_ = false, Q_EMIT changed([=](LinkOptions& options) { options.*option = limit; }, false);
    });
  };
  limit(max_hulls_, &LinkOptions::max_hulls, 1);
  limit(max_vertices_, &LinkOptions::max_vertices, kLeastVertices);
}

void SettingsForm::addOpenings(QGridLayout* grid) {
  auto* const text = new QLabel("Close &openings");
  openings_ = new QLineEdit;
  openings_->setObjectName("close_openings");
  openings_->setToolTip(
      "First close openings of shells up to this width, as 5cm; 0: none. Protrusion is then measured from the closed meshes");
  text->setBuddy(openings_);
  grid->addWidget(text, 4, 2);
  grid->addWidget(openings_, 4, 3);
  connect(openings_, &QLineEdit::editingFinished, this, [this] { type(openings_, typedOpenings); });
}

void SettingsForm::show(const std::vector<const LinkRow*>& links) {
  is_showing_ = true;
  std::vector<std::vector<double>> steps;
  std::vector<std::string> names;
  for (const LinkRow* link : links) steps.push_back(link->facts.steps), names.push_back(link->link);
  refused_.turnTo(names);
  if (steps != steps_) scale_ = ToleranceScale(steps), steps_ = std::move(steps);
  const LinkOptions options = links.empty() ? LinkOptions() : links.front()->options;
  const double known = links.empty() ? 0 : links.front()->facts.tolerance;
  if (options.tolerance.share == Length::kUnset || known == 0) {
    tolerance_ = std::min(options.tolerance.limit, 1.0);
  } else {
    tolerance_ = known;
  }
  slider_->setValue(scale_.positionOf(tolerance_));
  refused_.show(tolerance_text_, QString::fromStdString(toString(options.tolerance)));
  refused_.show(openings_, openingsText(options.close_openings));
  action_->setCurrentText(name(options.action));
  method_->setCurrentText(name(options.method));
  effort_->setCurrentText(name(options.effort));
  source_->setCurrentText(name(options.source));
  max_hulls_->setValue(options.max_hulls);
  max_vertices_->setValue(options.max_vertices);
  enable(!links.empty(), options);
  describe(links);
  is_showing_ = false;
}

void SettingsForm::enable(bool any, const LinkOptions& options) {
  const bool decomposed = any && options.action == Action::kDecompose;
  const bool takes_tolerance = options.method != Method::kSingleHull && options.method != Method::kBoundingBox;
  action_->setEnabled(any);
  for (QWidget* widget : std::initializer_list<QWidget*>{method_, source_, max_vertices_, openings_}) widget->setEnabled(decomposed);
  slider_->setEnabled(decomposed && takes_tolerance);
  tolerance_text_->setEnabled(decomposed && takes_tolerance);
  max_hulls_->setEnabled(decomposed && takes_tolerance);
  effort_->setEnabled(decomposed && options.method == Method::kCertified);
}

/// The number of bodies and the bound, beside the slider.
void SettingsForm::describe(const std::vector<const LinkRow*>& links) {
  std::size_t hulls = 0, primitives = 0;
  double bound = 0;
  bool unbuilt = false;
  for (const LinkRow* link : links) {
    hulls += link->facts.hulls;
    primitives += link->facts.primitives;
    bound = std::max(bound, link->facts.protrusion);
    unbuilt = unbuilt || link->facts.status == "unbuilt";
  }
  if (!refused_.reason().isEmpty()) {
    effect_->setText(refused_.reason());
  } else if (links.empty()) {
    effect_->setText("Choose links in the table to change them.");
  } else if (unbuilt) {
    effect_->setText("Not built yet with these settings.");
  } else {
    effect_->setText(QString("<b>%1</b>%2")
                         .arg(QString::fromStdString(countedBodies(hulls, primitives)))
                         .arg(bound > 0 ? ", proved to protrude at most <b>" + lengthText(bound) + "</b>" : QString()));
  }
}

void SettingsForm::slide(int position) {
  if (is_showing_) return;
  const double tolerance = scale_.toleranceAt(position);
  if (std::abs(tolerance - tolerance_) > kSame * tolerance) setTolerance(tolerance);
}

void SettingsForm::step(int by) {
  setTolerance(scale_.stepFrom(tolerance_, by));
}

/// In millimetres of three digits, as people write it.
void SettingsForm::setTolerance(double metres) {
  const QString text = metres < kMetre ? QString::number(1000 * metres, 'g', 3) + "mm" : QString("1m");
  const Length tolerance = parseLength(text.toStdString());
  tolerance_ = tolerance.limit;
  refused_.take(tolerance_text_);
  const bool goes_on = std::exchange(goes_on_, true);
  Q_EMIT changed([tolerance](LinkOptions& options) { options.tolerance = tolerance; }, goes_on);
}

void SettingsForm::type(QLineEdit* line, Change (*read)(const std::string& text)) {
  if (!line->isModified()) return;
  try {
    const Change change = read(line->text().trimmed().toStdString());
    goes_on_ = false;
    refused_.take(line);
    Q_EMIT changed(change, false);
  } catch (const Error& error) {
    refused_.refuse(line, QString::fromStdString(error.what()));
    effect_->setText(refused_.reason());
  }
}

/// The slider's keys.
bool SettingsForm::eventFilter(QObject* watched, QEvent* event) {
  if (watched == slider_ && event->type() == QEvent::KeyPress) {
    switch (static_cast<QKeyEvent*>(event)->key()) {
      case Qt::Key_Left:
      case Qt::Key_Down: step(-1); return true;
      case Qt::Key_Right:
      case Qt::Key_Up: step(1); return true;
      case Qt::Key_PageDown: step(-kPage); return true;
      case Qt::Key_PageUp: step(kPage); return true;
    }
  }
  if (watched == slider_ && event->type() == QEvent::MouseButtonPress) goes_on_ = false;
  return QWidget::eventFilter(watched, event);
}

}  // namespace collision_hulls
