// A process whose numbers have a decimal comma, as in Germany.
#pragma once

#include <stdlib.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <locale>
#include <string>

#include "base/run_program.h"

namespace collision_hulls {

/// Sets the locale of numbers, of C (printf, strtod) and of C++ (streams), until it is destroyed.
class CommaLocale {
 public:
  CommaLocale() {
    for (const char* const name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
      if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
    if (!isOfC()) setMadeLocale();
    std::locale::global(std::locale(std::locale::classic(), new Comma));
  }
  ~CommaLocale() {
    std::locale::global(before_);
    std::setlocale(LC_NUMERIC, "C");
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  /// False where none is installed and none can be made: then only streams have a comma.
  static bool isOfC() { return std::string(std::localeconv()->decimal_point) == ","; }

 private:
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };

  /// Most containers have no locale but C; localedef, which comes with glibc, makes one of the category of numbers alone.
  static void setMadeLocale() {
    namespace fs = std::filesystem;
    std::string folder = (fs::temp_directory_path() / "comma_locale_XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) return;
    const std::string source = folder + "/source";
    std::ofstream(source) << "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n";
    runProgram({"localedef", "-c", "-i", source, folder + "/comma"});  // its status is 1, as the other categories are missing
    setenv("LOCPATH", folder.c_str(), 1);
    std::setlocale(LC_NUMERIC, "comma");
    unsetenv("LOCPATH");
    fs::remove_all(folder);
  }

  std::locale before_;
};

}  // namespace collision_hulls
