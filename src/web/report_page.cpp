// The page from top to bottom. All that can be said without a script is HTML: totals, warnings, the table, notes. The script draws the
// view, and sorts and filters the table. It gets its data in two elements of its own, JSON and base64, which hold no markup.
#include "web/report_page.h"

#include <algorithm>

#include "base/figure.h"
#include "web/base64.h"
#include "web/html_text.h"
#include "web/link_table.h"
#include "web/page_files.h"
#include "web/summary.h"
#include "web/three_js.h"
#include "web/view_data.h"

namespace collision_hulls {
namespace {

std::string paragraph(const std::string& text, const std::string& kind) {
  return "<p class=\"" + kind + "\">" + escapedHtml(text) + "</p>\n";
}

std::string list(const std::vector<std::string>& items, const std::string& kind = "") {
  std::string text = kind.empty() ? "<ul>\n" : "<ul class=\"" + kind + "\">\n";
  for (const std::string& item : items) text += "<li>" + escapedHtml(item) + "</li>\n";
  return text + "</ul>\n";
}

std::string details(const std::string& title, const std::vector<std::string>& items, bool open) {
  return items.empty()
             ? ""
             : std::string("<details") + (open ? " open" : "") + "><summary>" + title + "</summary>\n" + list(items) + "</details>\n";
}

std::string hiddenUnlessFirst(std::size_t model) {
  return model == 0 ? "" : " hidden";
}

/// The sentences on a model, those on its faults last.
std::string modelSummary(const PageContent& content, std::size_t index) {
  const ModelReport& model = content.models[index].report;
  const std::vector<std::string> sentences = summary(model, content.report), faults = warnings(model, content.report);
  std::string text = "<div class=\"of-model\" data-model=\"" + std::to_string(index) + "\"" + hiddenUnlessFirst(index) + ">\n";
  for (std::size_t i = 0; i < sentences.size(); ++i) text += paragraph(sentences[i], i == 0 ? "lead" : "quiet");
  if (!faults.empty()) text += list(faults, std::string("warnings") + (anyFailed(content.report) ? " failed" : ""));
  return text + "</div>\n";
}

std::string header(const PageContent& content) {
  std::string text = "<header>\n<h1>" + escapedHtml(content.title) + "</h1>\n";
  for (std::size_t i = 0; i < content.models.size(); ++i) text += modelSummary(content, i);
  return text + "</header>\n";
}

std::string checkbox(const std::string& id, const std::string& label) {
  return "<label><input type=\"checkbox\" id=\"" + id + "\" checked>" + label + "</label>\n";
}

bool hasRegions(const PageContent& content) {
  const auto has = [](const ElementReport& row) { return !row.regions_given.empty(); };
  return std::any_of(content.models.begin(), content.models.end(),
                     [&](const PageModel& model) { return std::any_of(model.report.links.begin(), model.report.links.end(), has); });
}

bool hasKept(const PageContent& content) {
  return std::any_of(content.models.begin(), content.models.end(), [](const PageModel& model) { return !model.kept.empty(); });
}

/// Whether anything that is drawn stands for a mesh whose hulls are cuts of a tree; or, `but_for_these`, for another.
bool hasTrees(const PageContent& content, bool but_for_these) {
  const auto has = [&](const PageElement& element) { return !element.hulls.empty() && (element.tree == nullptr) == but_for_these; };
  return std::any_of(content.models.begin(), content.models.end(),
                     [&](const PageModel& model) { return std::any_of(model.elements.begin(), model.elements.end(), has); });
}

std::string sliderNote(const PageContent& content) {
  std::string text;
  if (hasTrees(content, false)) text += "The slider goes through the coarser cuts of the hull tree, with the proved protrusion of each. ";
  if (hasTrees(content, true))
    text +=
        "The slider merges the hulls of this result pair by pair. The bound that it shows is proved: the bound of these hulls plus "
        "a bound on what merging adds. decompose at that tolerance usually needs fewer hulls.";
  return text;
}

std::string view(const PageContent& content) {
  std::string text =
      "<section class=\"view\" aria-label=\"3D view\">\n"
      "<div class=\"stage\" id=\"stage\" tabindex=\"0\" role=\"img\" aria-label=\"Meshes and hulls in 3D; arrow keys turn, + and - zoom\">"
      "<canvas id=\"canvas\"></canvas><svg id=\"overlay\" aria-hidden=\"true\"></svg></div>\n<div class=\"controls\">\n";
  text += checkbox("show-original", "Original meshes") + checkbox("show-hulls", "Hulls") + checkbox("show-worst", "Worst place");
  if (hasRegions(content)) text += checkbox("show-regions", "Regions");
  if (hasKept(content)) text += checkbox("show-kept", "Kept as they are");
  if (!content.scene.triangles.empty()) text += checkbox("show-scene", "Scene");
  text +=
      "<button type=\"button\" id=\"reset\">Show all</button>\n</div>\n"
      "<div class=\"cut\"><label for=\"slider\">Fewer hulls</label>"
      "<input type=\"range\" id=\"slider\" min=\"0\" max=\"0\" value=\"0\" step=\"1\">\n"
      "<div class=\"told\"><output id=\"count\" for=\"slider\"></output><span class=\"small\" id=\"merged\"></span></div></div>\n"
      "<p class=\"small\">" +
      sliderNote(content) +
      "</p>\n"
      "<p class=\"small\" id=\"thinned\"></p>\n"
      "<p class=\"small\">Drag to turn, with shift to move, scroll to zoom.";
  if (!content.single_mesh)
    text += " Choose a link in the table to look at it. The robot is at rest: its joints are at zero, or at the limit nearest to it.";
  text += "</p>\n<noscript><p>The view needs JavaScript.</p></noscript>\n</section>\n";
  return text;
}

std::string modelChoice(const PageContent& content) {
  if (content.models.size() < 2) return "";
  std::string text = "<label>Model <select id=\"models\">";
  for (std::size_t i = 0; i < content.models.size(); ++i)
    text += "<option value=\"" + std::to_string(i) + "\">" + escapedHtml(content.models[i].report.model) + "</option>";
  return text + "</select></label>\n";
}

/// "panda_link3: 3 hulls: against shelf at 18 mm"
std::vector<std::string> reasonsOfFit(const Report& report) {
  std::vector<std::string> reasons;
  if (!report.scene) return reasons;
  for (const FittedLink& link : report.scene->links) reasons.push_back(link.link + ": " + link.reason);
  return reasons;
}

std::string tables(const PageContent& content, const RunControl& control) {
  std::string text = "<section aria-label=\"Links\">\n<div class=\"bar\"><h2>" + std::string(content.single_mesh ? "Mesh" : "Links") +
                     "</h2>\n" + modelChoice(content) +
                     "<input type=\"search\" id=\"filter\" placeholder=\"Filter\" aria-label=\"Filter the table\"></div>\n";
  for (std::size_t i = 0; i < content.models.size(); ++i) {
    const ModelReport& model = content.models[i].report;
    text += "<div class=\"model\" id=\"model-" + std::to_string(i) + "\"" + hiddenUnlessFirst(i) + ">\n<div class=\"wide\">\n" +
            linkTable(model, control) + "</div>\n" + details("Remarks of the check", model.validation.remarks, false) + "</div>\n";
  }
  return text + details("What the scene asked of each link", reasonsOfFit(content.report), false) +
         details("Notes", content.report.notes, true) + "</section>\n";
}

/// Of each model, if there are several; a link's own tolerance stands in the table alone.
std::string tolerances(const Options& options) {
  std::string text;
  for (const ModelOptions& model : options.models) text += (text.empty() ? "" : ", ") + model.name + " " + toString(model.tolerance);
  const bool some_own =
      std::any_of(options.rules.begin(), options.rules.end(), [](const LinkRule& rule) { return rule.settings.tolerance.has_value(); });
  return (text.empty() ? toString(options.tolerance) : text) + (some_own ? "; some links have their own, see the table" : "");
}

std::string footer(const PageContent& content) {
  const Report& report = content.report;
  const Options& options = report.options;
  return "<footer>\n<p>" + escapedHtml(report.input_path) + " \xC2\xB7 SHA-256 " + escapedHtml(report.input_sha256) +
         "</p>\n<p>tolerance " + escapedHtml(tolerances(options)) + ", method " + name(options.method) + ", effort " +
         name(options.effort) + " \xC2\xB7 all options and numbers: report.json</p>\n<p>collision_hulls " + version() +
         " \xC2\xB7 <span id=\"drawn-by\"></span></p>\n</footer>\n";
}

std::string scripts(const PageContent& content, const std::string& three_js, const RunControl& control) {
  const ViewData data = viewData(content, control);
  std::string text = "<script type=\"application/json\" id=\"view-data\">" + scriptJson(data.json) +
                     "</script>\n<script type=\"text/plain\" id=\"geometry\">" + base64(data.geometry) + "</script>\n";
  if (!three_js.empty()) text += std::string("<script>\n/* ") + threeJsNotice() + " */\n" + three_js + "\n</script>\n";
  return text + "<script>\n" + pageScript() + "</script>\n";
}

}  // namespace

std::string reportPage(const PageContent& content, const std::string& three_js, const RunControl& control) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         // Whatever slips through: no request leaves the page.
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; style-src "
         "'unsafe-inline'; "
         "img-src data:\">\n<title>" +
         escapedHtml(content.title) + " \xE2\x80\x93 collision hulls</title>\n<style>\n" + pageStyle() + "</style>\n</head>\n<body>\n" +
         header(content) + "<main>\n" + view(content) + tables(content, control) + "</main>\n" + footer(content) +
         scripts(content, three_js, control) + "</body>\n</html>\n";
}

}  // namespace collision_hulls
