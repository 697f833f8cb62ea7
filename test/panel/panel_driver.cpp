// Runs rviz with a configuration in this process and does what lines on its standard input say, as a person would: with keys and clicks, by
// the names of the panel's widgets. Answers each with a line. For test/ros/panel_test.py and scripts/panel_picture.
//
//   get WIDGET PROPERTY            its value
//   wait WIDGET PROPERTY S REGEX   until a property matches, at most S seconds; the value
//   click WIDGET                   once it is enabled
//   key WIDGET KEYS TIMES          such as Right or Ctrl+A, to a widget that has the focus
//   type WIDGET TEXT               in the place of what is there, and return
//   choose LINK...                 rows of the table; none: all that are chosen are no longer
//   slide POSITION                 the slider; how long until the panel shows the answer [ms]
//   table                          its rows, cells separated by bars, rows by slashes
//   file PATH                      what the next file dialog is given; a question after it is answered with what it proposes
//   focus KEYS TIMES               keys to whatever has the focus; the name of the widget that has it then
//   config FILE                    saves rviz's configuration
//   picture FILE                   of the window
//   end
#include <ros/ros.h>
#include <rviz/ogre_helpers/ogre_logging.h>
#include <rviz/visualization_frame.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QInputDialog>
#include <QKeySequence>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QSlider>
#include <QTimer>
#include <QtTest>
#include <iostream>
#include <string>
#include <thread>

namespace {

constexpr int kPatience = 10000;  // [ms] for what happens within the panel

class Driver : public QObject {
 public:
  explicit Driver(rviz::VisualizationFrame& frame) : frame_(frame) {}

  QString obey(const QString& line) {
    const QStringList words = line.split(' ');
    const QString& verb = words.front();
    const auto rest = [&](int from) { return words.mid(from).join(' '); };
    if (verb == "get") return widget(words.at(1))->property(words.at(2).toLatin1()).toString();
    if (verb == "wait") return wait(words);
    if (verb == "click") return click(words.at(1));
    if (verb == "key") return press(widget(words.at(1)), words.at(2), words.at(3).toInt());
    if (verb == "type") return type(words.at(1), rest(2));
    if (verb == "choose") return choose(words.mid(1));
    if (verb == "slide") return slide(words.at(1).toInt());
    if (verb == "table") return table();
    if (verb == "file") return file_ = rest(1);
    if (verb == "focus") return press(frame_.focusWidget(), words.at(1), words.at(2).toInt());
    if (verb == "config") return frame_.saveDisplayConfig(rest(1)) ? "saved" : "not saved";
    if (verb == "picture") return picture(rest(1));
    throw std::runtime_error("unknown: " + verb.toStdString());
  }

 private:
  QWidget* widget(const QString& name) const {
    if (auto* const found = frame_.findChild<QWidget*>(name)) return found;
    throw std::runtime_error("no widget " + name.toStdString());
  }

  QString wait(const QStringList& words) {
    const QRegularExpression wanted(words.mid(4).join(' '));
    QString value;
    const auto is_there = [&] {
      value = widget(words.at(1))->property(words.at(2).toLatin1()).toString();
      return wanted.match(value).hasMatch();
    };
    if (QTest::qWaitFor(is_there, words.at(3).toInt() * 1000)) return value;
    throw std::runtime_error(words.at(1).toStdString() + " is still '" + value.toStdString() + "'");
  }

  QString click(const QString& name) {
    QWidget* const target = widget(name);
    if (!QTest::qWaitFor([&] { return target->isEnabled(); }, kPatience)) throw std::runtime_error(name.toStdString() + " is disabled");
    if (!file_.isEmpty()) QTimer::singleShot(500, this, [this] { fillDialog(); });
    QTest::mouseClick(target, Qt::LeftButton);
    return "clicked";
  }

  void fillDialog() {
    auto* const dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    auto* const name = dialog->findChild<QLineEdit*>("fileNameEdit");
    name->setText(file_);
    file_.clear();
    QTimer::singleShot(500, this, [] {
      if (auto* const question = qobject_cast<QInputDialog*>(QApplication::activeModalWidget())) question->accept();
    });
    QTest::keyClick(name, Qt::Key_Return);
  }

  QString press(QWidget* target, const QString& keys, int times) {
    if (!target) throw std::runtime_error("nothing has the focus");
    target->setFocus();
    const int code = QKeySequence(keys)[0];
    for (int i = 0; i < times; ++i)
      QTest::keyClick(frame_.focusWidget(), static_cast<Qt::Key>(code & ~Qt::KeyboardModifierMask),
                      Qt::KeyboardModifiers(code & Qt::KeyboardModifierMask), 30);
    return frame_.focusWidget() ? frame_.focusWidget()->objectName() : "";
  }

  QString type(const QString& name, const QString& text) {
    auto* const line = qobject_cast<QLineEdit*>(widget(name));
    line->setFocus();
    line->clear();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    return line->text();
  }

  QAbstractItemView* links() const { return qobject_cast<QAbstractItemView*>(widget("links")); }

  QString choose(const QStringList& names) {
    QItemSelection selection;
    const QAbstractItemModel* const model = links()->model();
    for (int row = 0; row < model->rowCount(); ++row)
      if (names.contains(model->index(row, 0).data().toString()))
        selection.select(model->index(row, 0), model->index(row, model->columnCount() - 1));
    links()->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
    return QString::number(links()->selectionModel()->selectedRows().size());
  }

  QString slide(int position) {
    auto* const slider = qobject_cast<QSlider*>(widget("tolerance"));
    const QString before = widget("tolerance_text")->property("text").toString();
    QElapsedTimer timer;
    timer.start();
    slider->setValue(position);
    const auto is_shown = [&] { return widget("tolerance_text")->property("text").toString() != before; };
    while (!is_shown() && timer.elapsed() < 1000) QApplication::processEvents(QEventLoop::AllEvents, 1);
    return is_shown() ? QString::number(static_cast<double>(timer.nsecsElapsed()) / 1e6) : "unchanged";
  }

  QString table() const {
    QStringList rows;
    const QAbstractItemModel* const model = links()->model();
    for (int row = 0; row < model->rowCount(); ++row) {
      QStringList cells;
      for (int column = 0; column < model->columnCount(); ++column) cells << model->index(row, column).data().toString();
      rows << cells.join('|');
    }
    return rows.join('/');
  }

  QString picture(const QString& file) {
    QTest::qWait(1500);  // until rviz has drawn
    return frame_.screen()->grabWindow(0).save(file) ? "saved" : "not saved";
  }

  rviz::VisualizationFrame& frame_;
  QString file_;
};

/// Reads lines on another thread, so that rviz goes on drawing.
void listen(Driver& driver) {
  for (std::string line; std::getline(std::cin, line) && line != "end";) {
    QMetaObject::invokeMethod(
        &driver,
        [&driver, line] {
          QString answer;
          try {
            answer = "ok " + driver.obey(QString::fromStdString(line));
          } catch (const std::exception& error) {
            answer = QString("failed ") + error.what();
          }
          std::cout << answer.replace('\n', ' ').toStdString() << std::endl;
        },
        Qt::BlockingQueuedConnection);
  }
  QMetaObject::invokeMethod(
      qApp, [] { QApplication::quit(); }, Qt::QueuedConnection);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "panel_driver", ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  const ros::NodeHandle node;
  QApplication app(argc, argv);
  if (argc < 4) {
    std::cerr << "usage: panel_driver CONFIG WIDTH HEIGHT\n";
    return 2;
  }
  rviz::VisualizationFrame frame;
  frame.setApp(&app);
  frame.setShowChooseNewMaster(false);
  frame.initialize(argv[1]);
  frame.setGeometry(0, 0, std::atoi(argv[2]), std::atoi(argv[3]));
  frame.show();
  Driver driver(frame);
  std::thread listener([&] { listen(driver); });
  const int status = QApplication::exec();
  listener.join();
  return status;
}
