// Reads configurations from CSV and from what rostopic prints. YAML is parsed one document at a time, and joint messages are found wherever
// they are nested, so that any message that contains them can be recorded.
#include <algorithm>
#include <string_view>

#include "base/counted.h"
#include "base/finite_number.h"
#include "base/looks.h"
#include "base/string_parts.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "collision_hulls/scene/configurations.h"
#include "scene/reading.h"
#include "scene/yaml_node.h"
#include "storage/text_file.h"

namespace collision_hulls {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

constexpr std::string_view kDocument = "---";  // starts a YAML document

constexpr std::ptrdiff_t kMostColumns = 100'000;

using Names = std::vector<std::string>;
using Cells = std::vector<std::string_view>;  // of the file's text

std::string place(const std::string& file, std::size_t line) {
  return "'" + file + "', line " + std::to_string(line);
}

/// Without surrounding blanks and quotes.
std::string_view stripped(std::string_view text) {
  const auto strip = [&](std::string_view characters) {
    const std::size_t begin = std::min(text.find_first_not_of(characters), text.size());
    text = text.substr(begin, text.find_last_not_of(characters) + 1 - begin);
  };
  strip(kBlanks);
  strip("\"'");
  return text;
}

/// Takes the first line off a text, without its end.
std::string_view takeLine(std::string_view& rest) {
  const std::size_t length = std::min(rest.find('\n'), rest.size());
  const std::string_view line = rest.substr(0, length);
  rest.remove_prefix(std::min(length + 1, rest.size()));
  return line;
}

Cells split(std::string_view line, char separator, const std::string& where, const RunControl& control) {
  const std::ptrdiff_t columns = 1 + std::count(line.begin(), line.end(), separator);
  if (columns > kMostColumns) {
    throw Error(ErrorCode::kTooLarge, where + ": " + std::to_string(columns) + " columns, above the limit of " +
                                          std::to_string(kMostColumns) + "; leave out those that are no joints");
  }
  Cells cells;
  Looks look(control);
  while (true) {
    look();
    const std::size_t length = std::min(line.find(separator), line.size());
    cells.push_back(stripped(line.substr(0, length)));
    if (length == line.size()) return cells;
    line.remove_prefix(length + 1);
  }
}

/// Which cells of a row hold joint names and positions.
struct Columns {
  std::vector<std::size_t> positions;
  std::vector<std::size_t> names;  ///< only for `rostopic echo -p`, which repeats them in each row
  Cells header;
};

Columns columnsOf(const Cells& header, const std::string& where) {
  Columns columns;
  columns.header = header;
  const bool of_rostopic = header.front() == "%time";
  for (std::size_t i = 0; i < header.size(); ++i) {
    const std::string_view cell = header[i];
    if (of_rostopic) {
      if (cell.rfind("field.name", 0) == 0) columns.names.push_back(i);
      if (cell.rfind("field.position", 0) == 0) columns.positions.push_back(i);
    } else if (const std::string name = inLowerCase(std::string(cell)); name != "time" && name != "stamp") {
      columns.positions.push_back(i);
    }
  }
  if (of_rostopic && (columns.names.empty() || columns.names.size() != columns.positions.size())) {
    failConfigurations(
        where, "these are not the columns of a sensor_msgs/JointState; record other messages as .yaml, by `rostopic echo` without -p");
  }
  if (columns.positions.empty()) failConfigurations(where, "no column names a joint; the first line must hold the names of the joints");
  double number = 0;
  for (const std::size_t i : columns.positions) {
    if (header[i].empty())
      failConfigurations(where, "column " + std::to_string(i + 1) + " has no name; name its joint, or remove the separator before it");
    if (parseFinite(header[i], number))
      failConfigurations(where,
                         "expected a joint name, found '" + std::string(header[i]) + "'; the first line must hold the names of the joints");
  }
  return columns;
}

/// The joints that a header names.
Names namesIn(const Columns& columns) {
  Names names;
  for (const std::size_t column : columns.positions) names.emplace_back(columns.header[column]);
  return names;
}

void addRow(const Columns& columns, const Cells& cells, const std::string& where, ConfigurationCollector& collector,
            const RunControl& control) {
  if (cells.size() != columns.header.size()) {
    failConfigurations(where, counted(cells.size(), "cell") + ", but the first line has " + std::to_string(columns.header.size()) +
                                  "; give each column a value");
  }
  Names names;
  std::vector<double> positions;
  for (std::size_t i = 0; i < columns.positions.size(); ++i) {
    const std::size_t column = columns.positions[i];
    names.emplace_back(columns.names.empty() ? columns.header[column] : cells[columns.names[i]]);
    if (!parseFinite(cells[column], positions.emplace_back())) {
      failConfigurations(
          where, "the position of joint '" + names.back() + "' is '" + std::string(cells[column]) + "'; it must be a finite number");
    }
  }
  collector.add(names, positions, where, control);
}

void readCsv(const std::string& text, const std::string& file, ConfigurationCollector& collector, const RunControl& control) {
  std::string_view rest = text;
  if (rest.substr(0, kByteOrderMark.size()) == kByteOrderMark) rest.remove_prefix(kByteOrderMark.size());
  Columns columns;
  char separator = ',';
  for (std::size_t number = 1; !rest.empty(); ++number) {
    control.check();
    const std::string_view line = stripped(takeLine(rest));
    if (line.empty() || line.front() == '#') continue;
    const std::string where = place(file, number);
    if (columns.header.empty()) {
      const std::size_t first = line.find_first_of(",;\t");
      if (first != std::string_view::npos) separator = line[first];
      columns = columnsOf(split(line, separator, where, control), where);
      if (columns.names.empty()) collector.expectJoints(namesIn(columns), where);
    } else {
      addRow(columns, split(line, separator, where, control), where, collector, control);
    }
  }
}

/// Finds joint messages anywhere in a document.
class Messages {
 public:
  Messages(ConfigurationCollector& collector, std::vector<std::string>& notes, const RunControl& control)
      : collector_(collector), notes_(notes), control_(control) {}

  void read(const YamlValue& value, int depth = 0) {
    if (depth > kDeepest) value.fail("more than " + std::to_string(kDeepest) + " levels stand above this value; nest less");
    if (value.has("name") && value.has("position")) {
      const Names names = textsOf(value["name"]);
      if (!names.empty()) collector_.add(names, value["position"].numbers(), value.where(), control_);  // skips empty messages
    } else if (value.has("joint_names") && value.has("points")) {
      readTrajectory(value);
    } else if (value.has("joint_names") && value.has("transforms")) {
      passOver(value["joint_names"], value["transforms"]);
    } else if (value.isMap()) {
      for (const auto& [key, below] : value.entries()) read(below, depth + 1);
    } else if (value.isSequence()) {
      for (const YamlValue& item : value.items()) read(item, depth + 1);
    }
  }

 private:
  static constexpr int kDeepest = 50;

  static Names textsOf(const YamlValue& list) {
    Names texts;
    for (const YamlValue& item : list.items()) texts.push_back(item.text());
    return texts;
  }

  void readTrajectory(const YamlValue& trajectory) {
    const Names names = textsOf(trajectory["joint_names"]);
    collector_.endTrajectory();
    for (const YamlValue& point : trajectory["points"].items()) {
      if (point.has("transforms"))
        passOver(trajectory["joint_names"], point["transforms"]);
      else
        collector_.add(names, point["positions"].numbers(), point.where(), control_);
    }
    collector_.endTrajectory();
  }

  /// Joints of several degrees of freedom place the robot in the world, and the scene is given in the robot's frame.
  void passOver(const YamlValue& names, const YamlValue& transforms) {
    if (!notes_.empty() || !transforms.isSequence() || transforms.items().empty() || names.items().empty()) return;
    notes_.push_back("transforms of joints are ignored, such as that of '" + shown(names.items().front().text()) + "' in " +
                     transforms.where() + ": the root link stays at the origin of the scene");
  }

  ConfigurationCollector& collector_;
  std::vector<std::string>& notes_;
  const RunControl& control_;
};

/// Some documents at a time, so that a long recording needs little more memory than its text.
class YamlReader {
 public:
  YamlReader(const std::string& file, ConfigurationCollector& collector, const RunControl& control)
      : file_(file), collector_(collector), control_(control) {}

  /// Returns notes for the user.
  std::vector<std::string> read(std::string_view rest) {
    YamlText document;
    for (std::size_t number = 1; !rest.empty(); ++number) {
      const std::string_view line = takeLine(rest);
      const bool begins = line.substr(0, kDocument.size()) == kDocument;
      if (begins) add(std::exchange(document, {"", number}));
      document.text.append(begins ? line.substr(kDocument.size()) : line).append("\n");
    }
    add(std::move(document));
    readAdded();
    return std::move(notes_);
  }

 private:
  static constexpr std::size_t kAtOnce = 1 << 20;  // [bytes]

  void add(YamlText document) {
    if (stripped(document.text).empty()) return;
    size_ += document.text.size();
    added_.push_back(std::move(document));
    if (size_ >= kAtOnce) readAdded();
  }

  void readAdded() {
    for (const YamlValue& value : YamlValue::parse(added_, file_, ErrorCode::kBadConfigurations, control_)) {
      control_.check();
      Messages(collector_, notes_, control_).read(value);
    }
    added_.clear();
    size_ = 0;
  }

  const std::string& file_;
  ConfigurationCollector& collector_;
  const RunControl& control_;
  std::vector<std::string> notes_;
  std::vector<YamlText> added_;
  std::size_t size_ = 0;
};

}  // namespace

ConfigurationSet readConfigurations(const std::string& file, const Kinematics& kinematics, const ConfigurationOptions& options,
                                    const RunControl& control) {
  const std::string extension = lowerExtension(file);
  const bool yaml = extension == ".yaml" || extension == ".yml";
  if (!yaml && extension != ".csv") {
    throw Error(ErrorCode::kUnsupportedFormat,
                "'" + file + "': unknown format; give a .csv file, or a .yaml file as `rostopic echo` writes it");
  }
  ConfigurationCollector collector(kinematics, options);
  const std::string text = readTextFile(file, extension + " file", control);
  std::vector<std::string> notes;
  if (yaml)
    notes = YamlReader(file, collector, control).read(text);
  else
    readCsv(text, file, collector, control);
  ConfigurationSet set = collector.take();
  set.notes.insert(set.notes.end(), notes.begin(), notes.end());
  if (set.configurations.empty()) {
    failConfigurations("'" + file + "'", yaml ? "no message with name and position, or with joint_names and points that have positions"
                                              : "no line of positions after the line of joint names");
  }
  return set;
}

}  // namespace collision_hulls
