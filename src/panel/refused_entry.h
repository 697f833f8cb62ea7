// What somebody typed and the panel refused: the text and the reason stay to be read, whatever answers of the node arrive meanwhile.
#pragma once

#include <QLineEdit>
#include <QString>
#include <string>
#include <vector>

namespace collision_hulls {

class RefusedEntry {
 public:
  void refuse(QLineEdit* line, const QString& reason) {
    line_ = line;
    reason_ = reason.toHtmlEscaped();
  }

  /// What `line` says now was taken.
  void take(QLineEdit* line) {
    line->setModified(false);
    if (line == line_) forget();
  }

  /// The fields show what has these names from now on. Of anything else, nothing was refused.
  void turnTo(const std::vector<std::string>& subject) {
    if (subject != subject_) forget();
    subject_ = subject;
  }

  /// Shows `value`, unless somebody is typing, or a refused text still stands for this very value.
  void show(QLineEdit* line, const QString& value) {
    if (line == line_ && line->property(kShown).toString() != value) forget();
    line->setProperty(kShown, value);
    if (line != line_ && !(line->hasFocus() && line->isModified())) line->setText(value);
  }

  /// Of the text that was refused, as HTML; empty: there is none.
  const QString& reason() const { return reason_; }

 private:
  void forget() {
    if (line_) line_->setModified(false);
    line_ = nullptr;
    reason_.clear();
  }

  static constexpr const char* kShown = "shown_value";

  std::vector<std::string> subject_;
  QLineEdit* line_ = nullptr;
  QString reason_;
};

}  // namespace collision_hulls
