// MoveIt's text format:
//
//   name of the scene
//   * name of an object                  followed, since MoveIt 1.1, by its pose
//   number of shapes                     for each shape:
//     kind, and its numbers
//     x y z on a line; qx qy qz qw on a line
//     r g b a
//   number of subframes                  since MoveIt 1.1; for each: name, pose
//   .                                    end
//
// MoveIt tells the two versions apart by the line after the first object's name: if that contains a blank, it starts a pose.
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/decimal.h"
#include "base/finite_number.h"
#include "base/in_context.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "scene/reading.h"
#include "storage/text_file.h"

namespace collision_hulls {
namespace {

constexpr double kMostItems = 20'000'000;  // of a kind: shapes, vertices, triangles
constexpr int kCountDigits = 15;           // of counts and indices in messages

class MoveitReader {
 public:
  MoveitReader(const std::string& file, const RunControl& control)
      : file_(file), control_(control), text_(readTextFile(file, ".scene file", control)), rest_(text_) {}

  Scene read() {
    Scene scene;
    SceneBuilder builder(scene);
    scene.name = trimmed(line(), kBlanks);
    for (std::string marker = word("an object, '*', or the end, '.'"); marker != "."; marker = word("an object, '*', or the end, '.'")) {
      if (marker != "*") fail("expected an object ('*') or the end of the scene ('.'), found '" + marker + "'");
      object(builder);
    }
    return scene;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(ErrorCode::kBadScene, "'" + file_ + "', line " + std::to_string(line_) + ": " + reason);
  }

  std::string_view line() {
    const std::size_t length = std::min(rest_.find('\n'), rest_.size());
    const std::string_view result = rest_.substr(0, length);
    line_ += length < rest_.size();
    rest_.remove_prefix(std::min(length + 1, rest_.size()));
    return result;
  }

  std::string word(const std::string& what) {
    control_.check();
    while (!rest_.empty() && kBlanks.find(rest_.front()) != std::string_view::npos) {
      line_ += rest_.front() == '\n';
      rest_.remove_prefix(1);
    }
    const std::string result(rest_.substr(0, rest_.find_first_of(kBlanks)));
    if (result.empty()) fail("the file ends early: expected " + what + "; save the scene again");
    rest_.remove_prefix(result.size());
    return result;
  }

  double number(const std::string& what) {
    const std::string text = word(what);
    double value = 0;
    if (!parseFinite(text, value)) fail("expected " + what + ", a finite number, found '" + text + "'");
    return value;
  }

  std::size_t count(const std::string& what) {
    const double value = number("the number of " + what);
    if (!(value >= 0 && value <= kMostItems && value == static_cast<double>(static_cast<std::size_t>(value)))) {
      fail("the number of " + what + " is " + decimal(value, kCountDigits) + "; it must be an integer from 0 to 20 million");
    }
    return static_cast<std::size_t>(value);
  }

  Eigen::Vector3d vector(const std::string& what) {
    const double x = number(what), y = number(what);
    return {x, y, number(what)};
  }

  Eigen::Isometry3d pose() {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.translation() = vector("a position");
    const double x = number("a quaternion"), y = number("a quaternion"), z = number("a quaternion"), w = number("a quaternion");
    inThisLine([&] { result.linear() = checkedQuaternion(x, y, z, w).toRotationMatrix(); });
    return result;
  }

  void inThisLine(const std::function<void()>& action) { inContext("'" + file_ + "', line " + std::to_string(line_), action); }

  /// Looks at the line after the name of the first object, as MoveIt does.
  bool hasObjectPoses() {
    if (!has_object_poses_) has_object_poses_ = trimmed(rest_.substr(0, rest_.find('\n')), kBlanks).find(' ') != std::string::npos;
    return *has_object_poses_;
  }

  void object(SceneBuilder& builder) {
    const std::string name = trimmed(rest_.substr(0, rest_.find('\n')), kBlanks);
    if (name.empty()) fail("an object has no name; give it one");
    line();
    const bool with_pose = hasObjectPoses();
    const Eigen::Isometry3d object_pose = with_pose ? pose() : Eigen::Isometry3d::Identity();
    const std::size_t shapes = count("shapes");
    for (std::size_t i = 0; i < shapes; ++i) {
      SceneBody body = shape();
      body.name = shapes == 1 ? name : name + "/" + std::to_string(i + 1);
      body.pose = object_pose * pose() * body.pose;
      for (int k = 0; k < 4; ++k) number("a colour");
      inThisLine([&] { builder.add(std::move(body)); });
    }
    if (with_pose) subframes();
  }

  void subframes() {
    const std::size_t frames = count("subframes");
    for (std::size_t i = 0; i < frames; ++i) {
      if (trimmed(line(), kBlanks).empty()) line();  // the rest of the last line; then the name, which may contain blanks
      pose();
    }
  }

  /// A body without a name; its pose is not the identity if the shape is not centred at its origin.
  SceneBody shape() {
    const std::string kind = word("a shape");
    SceneBody body;
    if (kind == "mesh") {
      body.shape = mesh();
      return body;
    }
    std::vector<double> sizes(sizesOf(kind));
    if (sizes.empty()) fail("unknown shape '" + kind + "'; supported are box, sphere, cylinder, cone, plane and mesh");
    for (double& size : sizes) size = number("a size of a " + kind);
    inThisLine([&] { setShape(body, kind, sizes); });
    return body;
  }

  TriangleMesh mesh() {
    const std::size_t vertices = count("vertices"), triangles = count("triangles");
    TriangleMesh result;
    for (std::size_t i = 0; i < vertices; ++i) result.vertices.push_back(vector("a vertex"));
    for (std::size_t i = 0; i < triangles; ++i) {
      Triangle& triangle = result.triangles.emplace_back();
      for (int& corner : triangle) {
        const double index = number("a triangle");
        if (!(index >= 0 && index < static_cast<double>(vertices) && index == std::floor(index))) {
          fail("a triangle refers to vertex " + decimal(index, kCountDigits) + ", but the mesh has " + std::to_string(vertices) +
               " vertices");
        }
        corner = static_cast<int>(index);
      }
    }
    return result;
  }

  const std::string file_;
  const RunControl& control_;
  const std::string text_;
  std::string_view rest_;
  std::size_t line_ = 1;
  std::optional<bool> has_object_poses_;
};

}  // namespace

Scene readMoveItScene(const std::string& file, const RunControl& control) {
  return MoveitReader(file, control).read();
}

}  // namespace collision_hulls
