// Columns are as wide as their widest cell. What counts for a terminal is characters, near enough: bytes that start a UTF-8 character.
#include "report/text_table.h"

#include <algorithm>

namespace collision_hulls {
namespace {

std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

std::string figureInMillimetres(double metres) {
  return figure(1000 * metres);
}

std::string aligned(const std::vector<Cells>& rows, std::size_t text_columns) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string text;
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - width(row[i]), ' ');
      const bool last = i + 1 == row.size();
      text += i < text_columns ? row[i] + padding : last ? row[i] : padding + row[i];
      text += last ? "\n" : "  ";
    }
  }
  return text;
}

}  // namespace collision_hulls
