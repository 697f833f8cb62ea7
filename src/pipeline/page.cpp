// Hands a result to the room that makes pages, which knows nothing of runs. Rows without an element, as in a report that was made by hand,
// are in the table alone.
#include "pipeline/page.h"

#include <algorithm>

#include "base/parallel.h"
#include "web/report_page.h"
#include "web/three_js.h"

namespace collision_hulls {
namespace {

PageModel pageModel(const ModelReport& report, const ModelResult& model) {
  PageModel page{report, {}};
  const std::size_t count = std::min(report.links.size(), model.elements.size());
  for (std::size_t i = 0; i < count; ++i) {
    const ElementResult& element = model.elements[i];
    page.elements.push_back({element.original, element.hulls, element.pose});
  }
  return page;
}

}  // namespace

std::string pageOf(const RobotResult& result) {
  const Report& report = result.report;
  PageContent content{result.robot_name, report, {pageModel(report, result)}, result.single_mesh, result.scene};
  for (std::size_t i = 0; i < result.models.size(); ++i) content.models.push_back(pageModel(report.models[i], result.models[i]));
  std::string page;
  withJobs(report.options.jobs, [&] { page = reportPage(content, threeJs()); });
  return page;
}

}  // namespace collision_hulls
