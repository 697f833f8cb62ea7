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
//   cut                            names of the panel's widgets that reach beyond the screen
//   drag LINK FROM TO              the mouse in the view, between two points of a link, as 0,0,0.1
//   file PATH                      what the next file dialog is given; a question after it is answered with what it proposes
//   focus KEYS TIMES               keys to whatever has the focus; the name of the widget that has it then
//   config FILE                    saves rviz's configuration
//   picture FILE                   of the window
//   end
#include <OgreCamera.h>
#include <ros/ros.h>
#include <rviz/frame_manager.h>
#include <rviz/ogre_helpers/ogre_logging.h>
#include <rviz/render_panel.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

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
    if (verb == "cut") return cut();
    if (verb == "drag") return drag(words.at(1), words.at(2), words.at(3));
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

  QString cut() const {
    QStringList names;
    for (const QWidget* const part : widget("forms")->parentWidget()->parentWidget()->findChildren<QWidget*>())
      if (part->isVisible() && !part->objectName().isEmpty() &&
          !frame_.screen()->geometry().contains(QRect(part->mapToGlobal(QPoint(0, 0)), part->size())))
        names << part->objectName();
    return names.join(' ');
  }

  /// Where a point of a link is drawn.
  QPointF pixelOf(const QString& link, const QString& point) {
    const QStringList numbers = point.split(',');
    geometry_msgs::Pose pose;
    pose.position.x = numbers.at(0).toDouble();
    pose.position.y = numbers.at(1).toDouble();
    pose.position.z = numbers.at(2).toDouble();
    pose.orientation.w = 1;
    Ogre::Vector3 place;
    Ogre::Quaternion turn;
    if (!frame_.getManager()->getFrameManager()->transform(link.toStdString(), ros::Time(), pose, place, turn))
      throw std::runtime_error("no frame " + link.toStdString());
    const rviz::RenderPanel& view = *frame_.getManager()->getRenderPanel();
    const Ogre::Camera& camera = *view.getCamera();
    const Ogre::Vector3 seen = camera.getProjectionMatrix() * (camera.getViewMatrix() * place);
    return {(1 + seen.x) / 2 * view.width(), (1 - seen.y) / 2 * view.height()};
  }

  void mouse(QEvent::Type type, const QPointF& place, Qt::MouseButton button, Qt::MouseButtons buttons) {
    QWidget* const view = frame_.getManager()->getRenderPanel();
    QMouseEvent event(type, place, view->mapToGlobal(place.toPoint()), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(view, &event);
    QTest::qWait(150);  // rviz looks once a frame what is below the mouse
  }

  QString drag(const QString& link, const QString& from, const QString& to) {
    const QPointF begin = pixelOf(link, from), end = pixelOf(link, to);
    for (const double aside : {9.0, 1.0, 0.0}) mouse(QEvent::MouseMove, begin + QPointF(aside, 0), Qt::NoButton, Qt::NoButton);
    mouse(QEvent::MouseButtonPress, begin, Qt::LeftButton, Qt::LeftButton);
    constexpr int kSteps = 5;
    for (int i = 1; i <= kSteps; ++i) mouse(QEvent::MouseMove, begin + (end - begin) * i / kSteps, Qt::NoButton, Qt::LeftButton);
    mouse(QEvent::MouseButtonRelease, end, Qt::LeftButton, Qt::NoButton);
    return QString("%1,%2 to %3,%4").arg(begin.x()).arg(begin.y()).arg(end.x()).arg(end.y());
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

// Of Xlib, for use before a program's first connection: XSynchronize(3), "Debugging".
extern "C" int _Xdebug;  // NOLINT(bugprone-reserved-identifier): Xlib's name

int main(int argc, char** argv) {
  // Ogre makes its window through one connection to the X server and draws into it through another, without waiting until the server has
  // it. Where Mesa draws in software and asks first, it takes an undefined size from the server's error and writes outside its memory.
  _Xdebug = 1;
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
