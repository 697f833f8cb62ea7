// Tables as CSV. Chart scripts and users' own tools read them, so a number is always written in the same way.
#include "storage/csv.h"

#include <cerrno>
#include <cstring>

#include "base/decimal.h"
#include "storage/files.h"

namespace collision_hulls {
namespace {

/// Whether a spreadsheet would take a text for a formula, and run what a robot of that name says. Of the letters of numbers alone, among
/// them -inf, no formula calls anything.
bool looksLikeFormula(const std::string& text) {
  constexpr const char* kOfNumbers = "+-.0123456789einf";
  return !text.empty() && std::strchr("=+-@\t\r", text[0]) != nullptr && text.find_first_not_of(kOfNumbers) != std::string::npos;
}

std::string csvField(const std::string& field) {
  const std::string text = looksLikeFormula(field) ? "'" + field : field;
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string csvLine(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) line += (i ? "," : "") + csvField(fields[i]);
  return line + "\n";
}

std::string csvNumber(const std::optional<double>& value) {
  return value ? decimal(*value, 9) : "";
}

std::string csvCount(const std::optional<std::size_t>& value) {
  return value ? std::to_string(*value) : "";
}

CsvFile::CsvFile(const std::string& path, const std::string& header) : path_(path), stream_(path, std::ios::trunc) {
  add(header);
}

void CsvFile::add(const std::string& line) {
  if (stream_) errno = 0;
  if (!(stream_ << line << std::flush)) throwUnwritable(path_, errno ? std::strerror(errno) : "writing failed");
}

}  // namespace collision_hulls
