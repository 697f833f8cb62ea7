// People read "false collision" where fields and columns are called "phantom", and "no" where they hold 0.
#include "report/check_text.h"

#include "collision_hulls/report/totals.h"
#include "report/text_table.h"

namespace collision_hulls {

std::string countedBodies(std::size_t hulls, std::size_t primitives) {
  if (primitives == 0) return counted(hulls, "hull");
  return (hulls > 0 ? counted(hulls, "hull") + " and " : "") + counted(primitives, "primitive");
}

std::string bodiesInColumn(std::size_t hulls, std::size_t primitives) {
  return primitives == 0 ? std::to_string(hulls) : countedBodies(hulls, primitives);
}

std::string kindOfBodies(const ModelReport& model) {
  const Totals sum = totals(model);
  if (sum.primitives == 0) return "hulls";
  return sum.hulls == 0 ? "primitives" : "bodies";
}

std::string verdictText(std::size_t missed, std::size_t phantom, const std::string& limit, CountText count) {
  const auto number = [&](std::size_t n, const std::string& noun) { return n == 0 ? "no " + noun : count(n, noun, ""); };
  return number(missed, "collision") + " missed, " + number(phantom, "false collision") + " beyond the " + limit;
}

std::string checkText(const Validation& v, const std::string& bodies, CountText count) {
  return count(v.queries, "query", "queries") + " compared " + bodies +
         " and meshes: " + verdictText(v.missed, v.phantom, "protrusion", count) + "; distances at most " +
         figureInMillimetres(v.max_underestimate) + " mm too short";
}

}  // namespace collision_hulls
