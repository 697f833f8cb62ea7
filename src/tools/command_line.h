// The command line of a program: each option is declared with the variable that it fills, then the arguments are parsed.
#pragma once

#include <charconv>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace collision_hulls {

/// Checks an option's text: "" if it is valid, else what the option takes, as in "a folder".
using Check = std::function<std::string(const std::string& text)>;

/// Numbers from `least` to `most`.
Check range(double least, double most);

/// Refuses "", which is what a shell makes of an unset variable.
Check notEmpty(const std::string& expected);

/// Whether the value of an option that takes "a file, or - for standard output" is a file.
inline bool isFile(const std::string& value) {
  return !value.empty() && value != "-";
}

class CommandLine {
 public:
  /// One option. The setters return it, so that they can be chained.
  class Option {
   public:
    /// How --help names the value, with the default in brackets: "N [64]".
    Option* type_name(const std::string& text);
    /// The heading under which --help lists the option.
    Option* group(const std::string& name);
    Option* required();
    Option* check(const Check& check);

   private:
    friend class CommandLine;
    using Setter = std::function<bool(const std::string& text)>;  ///< false: not a valid value

    std::string names_, name_, short_name_, help_, type_, group_ = "Options", expected_;
    bool positional_ = false, assigns_ = false, takes_value_ = true, repeatable_ = false, required_ = false, hidden_ = false;
    Check check_;
    Setter set_;
  };

  CommandLine(std::string purpose, std::string program);

  /// The text below the options in --help.
  void footer(const std::string& text) { footer_ = text; }

  /// `names` is "-o,--output", "--output" or, for an argument without a dash, "INPUT". The option fills `value`, which has to
  /// outlive parse(). An option that fills a list may be given several times; an argument without a dash then takes all that are left.
  template <typename T>
  Option* add_option(const std::string& names, T& value, const std::string& help);

  /// Arguments of the form NAME:=VALUE, in any place among those without a dash. Without this, they are refused.
  Option* add_assignments(std::vector<std::string>& values, const std::string& help);

  /// An option whose text goes to a function.
  Option* add_option_function(const std::string& names, const std::function<void(const std::string&)>& set, const std::string& help);

  /// An option without a value: it sets `value` to true.
  Option* add_flag(const std::string& names, bool& value, const std::string& help);
  Option* add_flag_callback(const std::string& names, const std::function<void()>& set, const std::string& help);

  /// Leaves options, named without dashes, out of --help: those that the program takes only to say why they do not apply to it.
  void hide(const std::vector<std::string>& names);

  /// Fills the variables, in the order in which the options were declared. Returns false if it has printed --help or --version instead.
  /// Throws kBadOption, and whatever the options' functions throw.
  bool parse(int argc, const char* const* argv);

  /// The text of --help.
  std::string help() const;

  /// The options given to parse(), as words of a shell: "hand:=true --output out --quiet". Other arguments without a dash are left out.
  std::string given() const;

  /// The long options by name, without dashes: whether they take a value, and whether they may take several, as in
  /// {"model": {true, true}, "output": {true, false}, "quiet": {false, false}}.
  std::map<std::string, std::pair<bool, bool>> takesValue() const;

  const std::string& get_name() const { return program_; }

  /// How a shell calls the program as parse() was called: "decompose", "rosrun collision_hulls decompose", or its path.
  std::string call() const;

 private:
  using Texts = std::vector<std::string>;

  Option* add(const std::string& names, const std::string& help);
  std::map<std::string, Texts> split(int argc, const char* const* argv) const;
  void deal(const Texts& words, std::map<std::string, Texts>& given) const;
  [[noreturn]] void refuse(const std::string& problem) const;
  std::string forXacro(const std::string& argument) const;  ///< what to do with NAME:=VALUE
  std::string nearest(const std::string& unknown) const;
  bool isOption(const std::string& word) const;
  void apply(const Option& option, const Texts& texts) const;
  std::vector<std::string> shownGroups() const;

  template <typename T>
  static bool setNumber(const std::string& text, T& value);
  static bool setNumber(const std::string& text, double& value);

  std::string purpose_, program_, footer_, path_;
  std::vector<std::unique_ptr<Option>> options_;
  std::map<std::string, Texts> given_;
};

template <typename T>
bool CommandLine::setNumber(const std::string& text, T& value) {
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

template <typename T>
CommandLine::Option* CommandLine::add_option(const std::string& names, T& value, const std::string& help) {
  Option* const option = add(names, help);
  if constexpr (std::is_same_v<T, std::string>) {
    option->set_ = [&value](const std::string& text) { return value = text, true; };
  } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
    option->repeatable_ = true;
    option->set_ = [&value](const std::string& text) { return value.push_back(text), true; };
  } else {
    option->expected_ = std::is_floating_point_v<T> ? "a number" : "a whole number";
    option->set_ = [&value](const std::string& text) { return setNumber(text, value); };
  }
  return option;
}

/// Values for the arguments of a .xacro file, which is `input`.
void addXacroArguments(CommandLine& app, std::vector<std::string>& values, const std::string& input);

/// The option --package-path, which fills `folders`: where to search for packages.
void addPackagePath(CommandLine& app, std::vector<std::string>& folders);

}  // namespace collision_hulls
