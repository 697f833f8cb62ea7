// What asks for attention comes first: whoever opens a page because a link failed sees that link and why. Otherwise the order is the
// description's. Lengths in millimetres, as in the table on a terminal; whoever needs more digits reads report.json.
#include "web/link_table.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/decimal.h"
#include "base/figure.h"
#include "base/looks.h"
#include "base/string_parts.h"
#include "web/html_text.h"

namespace collision_hulls {
namespace {

/// Most urgent first.
int urgency(Status status) {
  switch (status) {
    case Status::kFailed: return 0;
    case Status::kDegraded: return 1;
    case Status::kOk: return 2;
    case Status::kKept: return 3;
    case Status::kRemoved: return 4;
  }
  return 2;
}

bool hasHulls(const ElementReport& row) {
  return row.status == Status::kOk || row.status == Status::kDegraded;
}

/// What is not known sorts below everything.
std::string numberCell(double value, const std::string& text, bool known) {
  return "<td class=\"number\" data-value=\"" + (known ? fixedDecimal(value) : "-1") + "\">" + (known ? text : "\xE2\x80\x93") + "</td>";
}

std::string countCell(std::size_t count, bool known) {
  return numberCell(static_cast<double>(count), grouped(count), known);
}

std::string lengthCell(double metres, bool known) {
  return numberCell(1e6 * metres, figure(1000 * metres), known);
}

std::string hullsCell(const ElementReport& row) {
  std::string text = row.hulls > 0 || row.primitives == 0 ? grouped(row.hulls) : "";
  if (row.primitives > 0) text += (text.empty() ? "" : " + ") + std::to_string(row.primitives) + "\xC2\xA0prim.";
  return numberCell(static_cast<double>(row.hulls + row.primitives), text, hasHulls(row));
}

std::string statusCell(Status status) {
  return "<td data-value=\"" + std::to_string(urgency(status)) + "\"><span class=\"status " + name(status) + "\">" + name(status) +
         "</span></td>";
}

/// Below a row: what has no column.
std::string detailRow(const std::string& text) {
  return "<tr class=\"reason\"><td colspan=\"9\"><div>" + escapedHtml(text) + "</div></td></tr>";
}

std::string regionText(const Region& region, const RegionProof& proof) {
  return "region " + region.name + ": protrusion " + figure(1000 * proof.bound) + " mm, found " + figure(1000 * proof.found) +
         " mm, tolerance " + figure(1000 * region.tolerance) + " mm";
}

/// The link's name is a button: it selects the mesh in the view, from the keyboard as well.
std::string tableRow(const ElementReport& row, std::size_t index) {
  const std::string link = escapedHtml(row.link), mesh = escapedHtml(lastPart(row.uri)), uri = escapedHtml(row.uri);
  std::string text = "<tbody data-row=\"" + std::to_string(index) + "\"><tr><th scope=\"row\" data-value=\"" + link +
                     "\"><button type=\"button\" class=\"link\">" + link + "</button></th><td class=\"mesh\" data-value=\"" + mesh +
                     "\" title=\"" + uri + "\">" + mesh + "</td>" + statusCell(row.status);
  text += hullsCell(row) + lengthCell(row.protrusion, hasHulls(row)) + lengthCell(row.protrusion_found, hasHulls(row)) +
          lengthCell(row.tolerance, hasHulls(row)) + countCell(row.triangles, row.triangles > 0) +
          countCell(row.hull_vertices, hasHulls(row));
  text += "</tr>";
  for (std::size_t i = 0; i < std::min(row.regions.size(), row.regions_given.size()); ++i)
    text += detailRow(regionText(row.regions_given[i], row.regions[i]));
  if (!row.reason.empty()) text += detailRow(row.reason);
  return text + "</tbody>\n";
}

std::string heading() {
  struct Column {
    const char *name, *unit, *title;
    bool number;
  };
  const Column columns[] = {{"Link", "", "", false},
                            {"Mesh", "", "", false},
                            {"Status", "", "", false},
                            {"Hulls", "", "and primitives in place of hulls", true},
                            {"Protrusion", "mm", "proved: no point of the hulls is further from the solid than this", true},
                            {"Found", "mm", "the largest protrusion that was found", true},
                            {"Tolerance", "mm", "what the protrusion was allowed to be", true},
                            {"Triangles", "", "of the mesh", true},
                            {"Vertices", "", "of all hulls of the mesh", true}};
  std::string text = "<thead><tr>";
  for (const Column& column : columns) {
    text += std::string("<th scope=\"col\"") + (column.number ? " class=\"number\"" : "") + "><button type=\"button\" title=\"" +
            column.title + "\">" + column.name + (*column.unit ? std::string(" <small>[") + column.unit + "]</small>" : "") +
            "</button></th>";
  }
  return text + "</tr></thead>\n";
}

}  // namespace

std::string linkTable(const ModelReport& model, const RunControl& control) {
  std::vector<std::size_t> order(model.links.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return urgency(model.links[a].status) < urgency(model.links[b].status); });
  std::string text = "<table class=\"links\">\n" + heading();
  Looks look(control, kLargeItemsBetweenLooks);
  for (const std::size_t row : order) look(), text += tableRow(model.links[row], row);
  return text + "</table>\n";
}

}  // namespace collision_hulls
