// Finds tags without building a tree. Knows just enough XML to skip comments, CDATA, declarations and quoted '>'.
#include "mesh/formats/xml_tags.h"

#include <algorithm>

namespace collision_hulls {
namespace {

constexpr std::string_view kBlanks = " \t\n\r";
constexpr auto kNone = std::string_view::npos;

/// Skips a comment, CDATA section or declaration at the front of `rest`; false if there is none.
bool skipOther(std::string_view* rest) {
  struct Section {
    std::string_view begin, end;
  };
  constexpr Section kSections[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}};
  for (const Section& section : kSections) {
    if (rest->substr(0, section.begin.size()) != section.begin) continue;
    const std::size_t end = rest->find(section.end, section.begin.size());
    rest->remove_prefix(end == kNone ? rest->size() : end + section.end.size());
    return true;
  }
  return false;
}

/// The position of the '>' that ends the tag at the front of `text`, ignoring any in quotes.
std::size_t endOfTag(std::string_view text) {
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '>') {
      return i;
    }
  }
  return kNone;
}

}  // namespace

bool nextTag(std::string_view* rest, XmlTag* tag) {
  do {
    rest->remove_prefix(std::min(rest->find('<'), rest->size()));
  } while (skipOther(rest));
  const std::size_t end = endOfTag(*rest);
  if (end == kNone) return false;
  std::string_view inside = rest->substr(1, end - 1);
  rest->remove_prefix(end + 1);
  const bool closing = inside.substr(0, 1) == "/";
  const bool empty = !inside.empty() && inside.back() == '/';
  tag->opens = !closing;
  tag->closes = closing || empty;
  if (closing) inside.remove_prefix(1);
  if (empty && !inside.empty()) inside.remove_suffix(1);
  tag->name = inside.substr(0, inside.find_first_of(kBlanks));
  tag->attributes = inside.substr(tag->name.size());
  return true;
}

std::string_view XmlTag::attribute(std::string_view key) const {
  std::string_view rest = attributes;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
    const std::size_t equals = rest.find('=');
    if (equals == kNone) return {};
    const std::string_view found = rest.substr(0, rest.find_first_of(" \t\n\r="));
    rest.remove_prefix(equals + 1);
    const std::size_t open = rest.find_first_of("\"'");
    if (open == kNone) return {};
    const std::size_t close = rest.find(rest[open], open + 1);
    if (close == kNone) return {};
    if (found == key) return rest.substr(open + 1, close - open - 1);
    rest.remove_prefix(close + 1);
  }
}

}  // namespace collision_hulls
