// Tables as CSV (RFC 4180).
#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace collision_hulls {

/// A line of CSV; fields with a comma, quote or line break are quoted. A text that a spreadsheet would take for a formula, "=...", gets an
/// apostrophe before it, as OWASP advises.
std::string csvLine(const std::vector<std::string>& fields);

/// A number with nine significant digits; empty if there is none.
std::string csvNumber(const std::optional<double>& value);
std::string csvCount(const std::optional<std::size_t>& value);

/// A CSV file that is written line by line, so that an interrupted run keeps what it measured.
class CsvFile {
 public:
  /// Replaces an existing file. Throws kUnwritableOutput, as add() does.
  CsvFile(const std::string& path, const std::string& header);

  /// Appends one or more lines, each with its line break.
  void add(const std::string& line);

 private:
  const std::string path_;
  std::ofstream stream_;
};

}  // namespace collision_hulls
