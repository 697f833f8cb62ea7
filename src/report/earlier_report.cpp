// The report may be anything by now, so it is read value by value, each looked at once, and only what is asked for is kept of it: as a
// tree, JSON takes many times its text's memory.
#include "report/earlier_report.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/looks.h"
#include "base/read_file.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

using nlohmann::json;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;  // some hundred thousand rows
constexpr std::size_t kDeepest = 100;                             // objects and arrays in one another; ours has fewer than ten
constexpr std::size_t kLongestPath = 4096;                        // [bytes] of a file that Linux opens

std::optional<std::string> textOf(const fs::path& folder, const RunControl& control) {
  try {
    const OpenFile file((folder / kReportFile).string());
    file.expectAllowed();
    return file.content("report", kMostBytes, control);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::kCancelled) throw;
    return std::nullopt;
  }
}

enum class Kind { kText, kObject, kArray, kOther };

/// What is asked for, by its place: the keys on the way to it, an empty one for any item of an array.
const std::map<std::string_view, Kind>& wanted() {
  static const std::map<std::string_view, Kind> places = {{"/collision_hulls", Kind::kText}, {"/files", Kind::kArray},
                                                          {"/files/", Kind::kText},          {"/input/sha256", Kind::kText},
                                                          {"/options/source", Kind::kText},  {"/scene", Kind::kObject},
                                                          {"/links", Kind::kArray},          {"/links/", Kind::kObject},
                                                          {"/links//link", Kind::kText},     {"/links//source", Kind::kText},
                                                          {"/links//status", Kind::kText},   {"/links//files", Kind::kArray},
                                                          {"/links//files/", Kind::kText},   {"/models//links//status", Kind::kText}};
  return places;
}

/// Receives the values of a report as nlohmann's parser comes across them; false ends it.
class ReportReader {
 public:
  enum class Wants { kOutput, kSource };
  ReportReader(Wants wants, const RunControl& control) : wants_(wants), look_(control, kLargeItemsBetweenLooks) {}

  std::optional<EarlierOutput> output() {
    if (!has("/collision_hulls") || !has("/files") || !has("/links") || !inEachRow("/links//files")) return std::nullopt;
    return std::move(output_);
  }
  std::optional<EarlierSource> source() {
    if (!has("/collision_hulls") || !has("/input/sha256") || !has("/options/source") || !has("/links") || !inEachRow("/links//link") ||
        !inEachRow("/links//source"))
      return std::nullopt;
    source_.fitted = has("/scene");
    return std::move(source_);
  }

  bool null() { return take(Kind::kOther); }
  bool boolean(bool) { return take(Kind::kOther); }
  bool number_integer(json::number_integer_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(json::number_unsigned_t value) { return number(static_cast<double>(value)); }
  bool number_float(json::number_float_t value, const std::string&) { return number(value); }
  bool string(const std::string& text) {
    if (!take(Kind::kText)) return false;
    keep(text);
    return true;
  }
  /// JSON has none. A template, because not every version of nlohmann's library has a type for it.
  template <class Bytes>
  bool binary(Bytes&) {
    return false;
  }
  bool start_object(std::size_t) { return begin(Kind::kObject); }
  bool start_array(std::size_t) { return begin(Kind::kArray); }
  bool key(const std::string& name) {
    place_.resize(above_.back());
    place_.append(1, '/').append(name);
    return true;
  }
  bool end_object() { return end(); }
  bool end_array() { return end(); }
  bool parse_error(std::size_t, const std::string&, const json::exception&) { return false; }

 private:
  struct Row {
    std::string link, source;
  };

  bool has(std::string_view place) const { return seen_.count(place) > 0; }
  std::size_t count(std::string_view place) const { return has(place) ? seen_.at(place) : 0; }
  bool inEachRow(std::string_view place) const { return count(place) == count("/links/"); }

  /// Whether a value is of the kind that its place asks for, if it does.
  bool take(Kind kind) {
    look_();
    const auto known = wanted().find(place_);
    if (known == wanted().end()) return true;
    ++seen_[known->first];
    return known->second == kind;
  }

  bool number(double value) {
    if (!take(Kind::kOther)) return false;
    if (place_ == "/links//close_openings") source_.close_openings = std::max(source_.close_openings, value);
    return true;
  }

  bool begin(Kind kind) {
    if (!take(kind) || above_.size() == kDeepest) return false;
    above_.push_back(place_.size());
    place_ += '/';
    return true;
  }

  bool end() {
    place_.resize(above_.back());
    above_.pop_back();
    if (place_ == "/links/") {
      source_.of_link[row_.link] = row_.source == "visual" ? Source::kVisual : Source::kCollision;
      row_ = {};
    }
    return true;
  }

  void keep(const std::string& text) {
    if (place_ == "/files/" || place_ == "/links//files/") addFile(text);
    if (place_ == "/input/sha256") source_.input_sha256 = text;
    if (place_ == "/options/source") source_.source = sourceNamed(text).value_or(Source::kAuto);
    if (place_ == "/links//link") row_.link = text;
    if (place_ == "/links//source") row_.source = text;
    if ((place_ == "/links//status" || place_ == "/models//links//status") && text == "failed") output_.complete = false;
  }

  /// Of the files that an output has; a report that was written by hand may name others.
  void addFile(const std::string& name) {
    if (wants_ != Wants::kOutput || name.size() >= kLongestPath) return;
    const fs::path file = fs::path(name).lexically_normal();
    if (file.is_relative() && !file.empty() && *file.begin() != "..") output_.files.insert(file);
  }

  const Wants wants_;
  Looks look_;
  std::string place_;                             // of the value that comes next, or of the one that holds it
  std::vector<std::size_t> above_;                // the lengths of the places of what holds it
  std::map<std::string_view, std::size_t> seen_;  // how often what is asked for was there
  Row row_;                                       // as far as it was read
  EarlierOutput output_{{kReportFile}, true};
  EarlierSource source_;
};

/// Whether there is a report that can be read as one.
bool read(const fs::path& folder, ReportReader& reader, const RunControl& control) {
  const std::optional<std::string> text = textOf(folder, control);
  return text && json::sax_parse(*text, &reader);
}

}  // namespace

std::optional<EarlierOutput> earlierOutput(const fs::path& folder, const RunControl& control) {
  ReportReader reader(ReportReader::Wants::kOutput, control);
  return read(folder, reader, control) ? reader.output() : std::nullopt;
}

std::optional<EarlierSource> earlierSource(const fs::path& folder, const RunControl& control) {
  ReportReader reader(ReportReader::Wants::kSource, control);
  return read(folder, reader, control) ? reader.source() : std::nullopt;
}

}  // namespace collision_hulls
