// Boost.Program_options splits the arguments into options and values; only this file uses it. Every ROS 1 brings it along, unlike the
// parsers that do more. This file adds what it lacks: --help in groups, checks of values, and a suggestion for an unknown option.
#include "command_line.h"

#include <algorithm>
#include <boost/program_options.hpp>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <utility>

#include "base/decimal.h"
#include "base/finite_number.h"
#include "base/nearest_name.h"
#include "base/shell_word.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/report/report.h"

namespace collision_hulls {
namespace {

namespace po = boost::program_options;

void printVersion(const std::string& program) {
  std::cout << program << " of collision_hulls " << collision_hulls::version() << "\n";
  try {
    std::cout << "Each mesh is read in " << readerProtection() << ".\n";
  } catch (const Error& error) {
    std::cout << "Meshes cannot be read: " << error.what() << ".\n";
  }
}

/// The words of a text in lines of `width` characters, those after the first indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::istringstream in(text);
  std::string result;
  std::size_t length = 0;
  for (std::string word; in >> word;) {
    if (length > 0 && length + 1 + word.size() > width) {
      result += "\n" + std::string(indent, ' ');
      length = 0;
    }
    result += (length > 0 ? " " : "") + word;
    length += (length > 0 ? 1 : 0) + word.size();
  }
  return result;
}

std::string helpRow(const std::string& names, const std::string& type, const std::string& help) {
  constexpr std::size_t kIndent = 30, kWidth = 100 - kIndent;
  std::string row = "  " + names + (type.empty() ? "" : " " + type);
  row += row.size() + 2 > kIndent ? "\n" + std::string(kIndent, ' ') : std::string(kIndent - row.size(), ' ');
  return row + wrapped(help, kIndent, kWidth) + "\n";
}

/// Whether a word is NAME:=VALUE. One that may be a path is not.
bool isAssignment(const std::string& word) {
  const std::size_t sign = word.find(":=");
  return sign != std::string::npos && sign > 0 && word.find('/') > sign;
}

}  // namespace

Check range(double least, double most) {
  return [=](const std::string& text) {
    double value = 0;
    const bool within = parseFinite(text, value) && value >= least && value <= most;
    return within ? "" : "a number from " + decimal(least) + " to " + decimal(most);
  };
}

Check notEmpty(const std::string& expected) {
  return [=](const std::string& text) { return text.empty() ? expected : ""; };
}

CommandLine::Option* CommandLine::Option::type_name(const std::string& text) {
  type_ = text;
  return this;
}

CommandLine::Option* CommandLine::Option::group(const std::string& name) {
  group_ = name;
  return this;
}

CommandLine::Option* CommandLine::Option::required() {
  required_ = true;
  return this;
}

CommandLine::Option* CommandLine::Option::check(const Check& check) {
  check_ = check;
  return this;
}

CommandLine::CommandLine(std::string purpose, std::string program) : purpose_(std::move(purpose)), program_(std::move(program)) {
  const auto nothing = [] {};
  add_flag_callback("-h,--help", nothing, "Print this help and exit");
  add_flag_callback("--version", nothing, "Print the version and exit");
}

CommandLine::Option* CommandLine::add(const std::string& names, const std::string& help) {
  Option& option = *options_.emplace_back(std::make_unique<Option>());
  option.names_ = names;
  option.help_ = help;
  option.positional_ = names.front() != '-';
  const std::size_t comma = names.find(',');
  if (comma != std::string::npos) option.short_name_ = names.substr(1, comma - 1);
  option.name_ = option.positional_ ? names : names.substr(names.find("--") + 2);
  return &option;
}

CommandLine::Option* CommandLine::add_assignments(std::vector<std::string>& values, const std::string& help) {
  Option* const option = add_option("NAME:=VALUE", values, help);
  option->assigns_ = true;
  return option;
}

CommandLine::Option* CommandLine::add_option_function(const std::string& names, const std::function<void(const std::string&)>& set,
                                                      const std::string& help) {
  Option* const option = add(names, help);
  option->set_ = [set](const std::string& text) { return set(text), true; };
  return option;
}

CommandLine::Option* CommandLine::add_flag(const std::string& names, bool& value, const std::string& help) {
  return add_flag_callback(
      names, [&value] { value = true; }, help);
}

CommandLine::Option* CommandLine::add_flag_callback(const std::string& names, const std::function<void()>& set, const std::string& help) {
  Option* const option = add(names, help);
  option->takes_value_ = false;
  option->set_ = [set](const std::string&) { return set(), true; };
  return option;
}

void CommandLine::hide(const std::vector<std::string>& names) {
  for (const auto& option : options_)
    if (std::find(names.begin(), names.end(), option->name_) != names.end()) option->hidden_ = true;
}

bool CommandLine::parse(int argc, const char* const* argv) {
  path_ = argv[0];
  given_ = split(argc, argv);
  if (given_.count("help")) return std::cout << help(), false;
  if (given_.count("version")) return printVersion(program_), false;
  for (const auto& option : options_) {
    const auto found = given_.find(option->name_);
    if (found != given_.end()) {
      apply(*option, found->second);
    } else if (option->required_) {
      refuse((option->positional_ ? "" : "--") + option->name_ + " is required");
    }
  }
  return true;
}

std::string CommandLine::given() const {
  std::string words;
  const auto add = [&](const std::string& word) { words += (words.empty() ? "" : " ") + word; };
  for (const auto& option : options_) {
    const auto found = given_.find(option->name_);
    if (found == given_.end() || (option->positional_ && !option->assigns_)) continue;
    if (!option->takes_value_) add("--" + option->name_);
    const auto before = [&](const std::string& text) {
      return option->assigns_ ? "" : "--" + option->name_ + (text.rfind('-', 0) == 0 ? "=" : " ");
    };
    for (const std::string& text : found->second) add(before(text) + shellWord(text));
  }
  return words;
}

std::map<std::string, std::pair<bool, bool>> CommandLine::takesValue() const {
  std::map<std::string, std::pair<bool, bool>> takes;
  for (const auto& option : options_)
    if (!option->positional_) takes[option->name_] = {option->takes_value_, option->repeatable_};
  return takes;
}

std::string CommandLine::call() const {
  if (path_.find('/') == std::string::npos) return program_;
  const char* const spaces = std::getenv("CMAKE_PREFIX_PATH");
  std::istringstream all(spaces ? spaces : "");
  for (std::string space; std::getline(all, space, ':');)
    if (path_ == space + "/lib/collision_hulls/" + program_) return "rosrun collision_hulls " + program_;
  return shellWord(path_);
}

/// Whether a word is one of the long options. Boost would take it for the value of the option before.
bool CommandLine::isOption(const std::string& word) const {
  const std::string name = word.substr(0, word.find('='));
  return std::any_of(options_.begin(), options_.end(),
                     [&](const auto& option) { return !option->positional_ && name == "--" + option->name_; });
}

std::map<std::string, CommandLine::Texts> CommandLine::split(int argc, const char* const* argv) const {
  const std::string kWithoutDash = "an argument without a dash";  // no option's name
  po::options_description known;
  known.add_options()(kWithoutDash.c_str(), po::value<std::vector<std::string>>(), "");
  for (const auto& option : options_) {
    if (option->positional_) continue;
    const std::string names = option->name_ + (option->short_name_.empty() ? "" : "," + option->short_name_);
    if (option->takes_value_) {
      known.add_options()(names.c_str(), po::value<std::vector<std::string>>(), "");
    } else {
      known.add_options()(names.c_str(), "");
    }
  }
  po::positional_options_description positional;
  positional.add(kWithoutDash.c_str(), -1);
  std::map<std::string, Texts> given;
  try {
    const auto style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    for (const po::option& option : po::command_line_parser(argc, argv).options(known).positional(positional).style(style).run().options) {
      if (option.position_key < 0 && option.original_tokens.size() == 2 && isOption(option.original_tokens[1]))
        refuse("--" + option.string_key + " lacks its value: '" + option.original_tokens[1] + "' is another option");
      Texts& texts = given[option.string_key];
      texts.insert(texts.end(), option.value.begin(), option.value.end());
    }
  } catch (const po::unknown_option& e) {
    const std::string name = e.get_option_name().substr(0, e.get_option_name().find('='));
    refuse("there is no option " + name + nearest(name));
  } catch (const po::error& e) {
    refuse(e.what());
  }
  const Texts words = given[kWithoutDash];
  given.erase(kWithoutDash);
  deal(words, given);
  return given;
}

/// Arguments without a dash go to those that are declared, in their order: the last takes all that are left, each of the others one.
void CommandLine::deal(const Texts& words, std::map<std::string, Texts>& given) const {
  const Option* assigned = nullptr;
  Texts names;
  for (const auto& option : options_) {
    if (option->assigns_) assigned = option.get();
    if (option->positional_ && !option->assigns_) names.push_back(option->name_);
  }
  std::size_t next = 0;
  for (const std::string& word : words) {
    if (assigned && isAssignment(word)) {
      given[assigned->name_].push_back(word);
    } else if (names.empty()) {
      refuse("unexpected argument '" + word + "'");
    } else {
      given[names[std::min(next++, names.size() - 1)]].push_back(word);
    }
  }
}

void CommandLine::refuse(const std::string& problem) const {
  throw Error(ErrorCode::kBadOption, problem + (problem.back() == '?' ? " See " : "; see ") + program_ + " --help");
}

std::string CommandLine::nearest(const std::string& unknown) const {
  std::vector<std::string> names;
  for (const auto& option : options_)
    if (!option->positional_ && !option->hidden_) names.push_back("--" + option->name_);
  return didYouMean("--" + unknown.substr(std::min(unknown.find_first_not_of('-'), unknown.size())), names);
}

std::string CommandLine::forXacro(const std::string& argument) const {
  if (argument.find(":=") == std::string::npos) return "";
  if (std::any_of(options_.begin(), options_.end(), [](const auto& option) { return option->assigns_; }))
    return ": an argument for xacro is NAME:=VALUE, as in prefix:=left_";
  return ": give it to xacro itself, as in 'xacro FILE.xacro " + argument + " > FILE.urdf', and give the .urdf";
}

void CommandLine::apply(const Option& option, const Texts& texts) const {
  const std::string name = (option.positional_ ? "" : "--") + option.name_;
  if (!option.takes_value_) {
    option.set_("");
    return;
  }
  if (texts.size() > 1 && !option.repeatable_)
    refuse(option.positional_ ? "unexpected argument '" + texts[1] + "'" + forXacro(texts[1])
                              : name + " is given twice: '" + texts[0] + "' and '" + texts[1] + "'");
  for (const std::string& text : texts) {
    std::string expected = option.check_ ? option.check_(text) : "";
    if (expected.empty() && !option.set_(text)) expected = option.expected_;
    if (!expected.empty()) refuse(name + " '" + text + "' is not understood: it takes " + expected);
  }
}

bool CommandLine::setNumber(const std::string& text, double& value) {
  return parseFinite(text, value);
}

std::vector<std::string> CommandLine::shownGroups() const {
  std::vector<std::string> names;
  for (const auto& option : options_) {
    const bool is_shown = !option->positional_ && !option->hidden_;
    if (is_shown && std::find(names.begin(), names.end(), option->group_) == names.end()) names.push_back(option->group_);
  }
  return names;
}

std::string CommandLine::help() const {
  std::string usage = "Usage: " + program_ + " [OPTIONS]", arguments;
  for (const auto& option : options_) {
    if (!option->positional_) continue;
    const std::string name = option->name_ + (option->repeatable_ ? "..." : "");
    usage += option->required_ ? " " + name : " [" + name + "]";
    arguments += helpRow(name, "", option->help_);
  }
  std::string text = purpose_ + "\n" + usage + "\n\n" + arguments;
  for (const std::string& group : shownGroups()) {
    text += "\n" + group + ":\n";
    for (const auto& option : options_) {
      if (option->positional_ || option->hidden_ || option->group_ != group) continue;
      text += helpRow(option->names_, option->type_ + (option->required_ ? " REQUIRED" : ""), option->help_);
    }
  }
  return text + footer_ + "\n";
}

void addXacroArguments(CommandLine& app, std::vector<std::string>& values, const std::string& input) {
  app.add_assignments(values, "Values for the arguments of " + input + ", where that is a .xacro file");
}

void addPackagePath(CommandLine& app, std::vector<std::string>& folders) {
  app.add_option("--package-path", folders, "Extra folder to search for packages, or the folder of one package (NAME=DIR); repeatable")
      ->type_name("DIR or NAME=DIR")
      ->check(notEmpty("a folder"))
      ->group("Input");
}

}  // namespace collision_hulls
