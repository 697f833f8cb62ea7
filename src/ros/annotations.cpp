// Sizes of texts and arrows follow the robot's size. Arrows come from where no hull is; labels stand beside the robot, with a line to their
// link, as text within the robot would be hidden.
#include "annotations.h"

#include <algorithm>
#include <cmath>

#include "base/millimetres.h"
#include "report/check_text.h"

namespace collision_hulls {
namespace {

using visualization_msgs::Marker;

constexpr double kTextHeight = 0.035;  // of the robot's radius
constexpr double kLineSpacing = 1.7;   // of labels, in their height
constexpr double kColumn = 0.75;       // of the robot's radius: from its middle to the labels
constexpr double kArrowLength = 0.16;  // of the robot's radius
constexpr int kDigits = 3;             // of a length

Marker& addText(const std::string& text, double height, const std::string& kind, const std::string& link, const Eigen::Isometry3d& pose,
                Pen& pen, MarkerList& list) {
  Marker& marker = pen.add(list, kind, link, Marker::TEXT_VIEW_FACING, pose);
  marker.scale = toScale({0, 0, height});
  marker.color = colour(0.05, 0.05, 0.1, 1);
  marker.text = text;
  return marker;
}

/// Whether an arrow that ends at `tip` would be in the open, with its text. All in the root link's frame.
bool isInTheOpen(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction, double length, const std::vector<ConvexHull>& hulls) {
  for (const double share : {0.4, 0.7, 1.0, 1.25}) {
    const Eigen::Vector3d p = tip + share * length * direction;
    if (std::any_of(hulls.begin(), hulls.end(), [&](const ConvexHull& hull) { return planeDistance(hull, p) < 0; })) return false;
  }
  return true;
}

/// Where an arrow to `tip` comes from: as near to `outward` as is in the open; `outward` where nothing is.
Eigen::Vector3d openDirection(const Eigen::Vector3d& tip, const Eigen::Vector3d& outward, double length,
                              const std::vector<ConvexHull>& hulls) {
  std::vector<Eigen::Vector3d> directions{outward};
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) directions.push_back(Eigen::Vector3d(x, y, z).normalized());
  std::stable_sort(directions.begin(), directions.end(), [&](const auto& a, const auto& b) { return a.dot(outward) > b.dot(outward); });
  const auto open = std::find_if(directions.begin(), directions.end(),
                                 [&](const Eigen::Vector3d& direction) { return isInTheOpen(tip, direction, length, hulls); });
  return open == directions.end() ? outward : *open;
}

std::string labelText(const Link& link) {
  double protrusion = 0;
  for (const LinkMesh& mesh : link.meshes) protrusion = std::max(protrusion, mesh.row.protrusion);
  std::string text = link.name + ": " + countedBodies(link.hulls, link.primitives);
  if (protrusion > 0) text += ", " + millimetres(protrusion, kDigits);
  return text;
}

/// Places labels in a column to the left or right of the robot (side -1 or 1), in the order of their links' heights. Returns their spacing.
double placeColumn(std::vector<Label*> column, int side, const RobotBounds& robot) {
  std::stable_sort(column.begin(), column.end(), [](const Label* a, const Label* b) { return a->anchor.z() < b->anchor.z(); });
  const double lines = static_cast<double>(column.size());
  const double spacing = robot.radius * std::min(kLineSpacing * kTextHeight, 2 / std::max(lines, 1.0));
  for (std::size_t i = 0; i < column.size(); ++i)
    column[i]->place =
        robot.centre + Eigen::Vector3d(0, side * kColumn * robot.radius, (static_cast<double>(i) - 0.5 * (lines - 1)) * spacing);
  return spacing;
}

/// A text in its link's colour, and a line from there to the link: text within the robot would be hidden.
void drawLabel(const Label& label, double spacing, Pen& pen, MarkerList& list) {
  const Link& link = *label.link;
  const Eigen::Isometry3d to_link = label.link_pose.inverse();
  const auto dark = fromHsv(link.hue, 0.9, 0.5, 1);
  const double height = spacing / kLineSpacing;
  const Eigen::Isometry3d place(Eigen::Translation3d(to_link * label.place));
  addText(labelText(link), height, "labels", link.name, place, pen, list).color = dark;
  Marker& line = pen.add(list, "labels", link.name, Marker::LINE_LIST, to_link);
  line.scale = toScale({0.08 * height, 0, 0});
  line.points = {toPoint(label.place - Eigen::Vector3d(0, 0, 0.6 * height)), toPoint(label.anchor)};
  line.color = dark;
}

}  // namespace

/// The arrow comes from outside and ends at the place; it is as long as the robot's size says, since the protrusion itself is millimetres.
void drawWorst(const Link& link, double radius, const std::vector<ConvexHull>& hulls, Pen& pen, MarkerList& list) {
  const auto less = [](const LinkMesh& a, const LinkMesh& b) { return a.row.protrusion_found < b.row.protrusion_found; };
  const auto worst = std::max_element(link.meshes.begin(), link.meshes.end(), less);
  if (worst == link.meshes.end() || !(worst->row.protrusion_found > 0)) return;
  const ElementReport& row = worst->row;
  const Eigen::Isometry3d& origin = worst->element.source.origin;
  const double most = kArrowLength * radius;
  const double length = std::clamp(0.5 * row.diagonal, 0.4 * most, most);
  const auto red = colour(0.85, 0, 0.1, 1);

  Marker& sphere = pen.add(list, "worst", link.name, Marker::SPHERE, origin * Eigen::Translation3d(row.worst));
  sphere.scale = toScale(Eigen::Vector3d::Constant(0.12 * length));
  sphere.color = red;
  const Eigen::Isometry3d& pose = worst->element.pose;
  const Eigen::Vector3d outward = pose.linear() * (row.worst - row.worst_nearest).stableNormalized();
  const Eigen::Vector3d away = pose.linear().transpose() * openDirection(pose * row.worst, outward, length, hulls);
  Marker& arrow = pen.add(list, "worst", link.name, Marker::ARROW, origin);
  arrow.scale = toScale({0.05 * length, 0.14 * length, 0.3 * length});
  arrow.points = {toPoint(row.worst + length * away), toPoint(row.worst)};
  arrow.color = red;
  const Eigen::Isometry3d end(origin * Eigen::Translation3d(row.worst + 1.25 * length * away));
  addText(millimetres(row.protrusion_found, kDigits), kTextHeight * radius * std::max(length / most, 0.7), "worst", link.name, end, pen,
          list)
      .color = red;
}

Label labelOf(const Link& link, const LinkDescription& description) {
  Eigen::AlignedBox3d box;
  for (const LinkMesh& mesh : link.meshes) box.extend(rootBox(mesh.element));
  for (const GeometryElement& element : description.collisions) {
    if (isPrimitive(element)) box.extend(moved(localBox(element), description.pose * element.origin));
  }
  const Eigen::Vector3d anchor = box.isEmpty() ? Eigen::Vector3d(description.pose.translation()) : Eigen::Vector3d(box.center());
  return {&link, description.pose, anchor, anchor};
}

void drawLabels(std::vector<Label> labels, const RobotBounds& robot, Pen& pen, MarkerList& list) {
  std::vector<Label*> columns[2];
  for (Label& label : labels) {
    const double y = label.anchor.y() - robot.centre.y();
    const bool is_central = std::abs(y) < 0.1 * robot.radius;
    columns[is_central ? columns[0].size() > columns[1].size() : y > 0].push_back(&label);
  }
  for (int i = 0; i < 2; ++i) {
    const double spacing = placeColumn(columns[i], 2 * i - 1, robot);
    for (const Label* label : columns[i]) drawLabel(*label, spacing, pen, list);
  }
}

Marker drawProgress(const std::string& text, const std::string& frame, const RobotBounds& bounds) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = "progress";
  marker.type = Marker::TEXT_VIEW_FACING;
  marker.action = Marker::ADD;
  const Eigen::Vector3d place(bounds.centre.x(), bounds.centre.y(), bounds.top + 0.15 * bounds.radius);
  marker.pose = toPose(Eigen::Isometry3d(Eigen::Translation3d(place)));
  marker.scale = toScale({0, 0, 0.08 * bounds.radius});
  marker.color = colour(0.05, 0.05, 0.1, 1);
  marker.frame_locked = true;
  marker.text = text;
  return marker;
}

}  // namespace collision_hulls
