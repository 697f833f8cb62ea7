// An arm of one link that turns about z, and a post in its way.
#pragma once

#include <string>

#include "collision_hulls/pipeline/input.h"
#include "collision_hulls/scene/scene.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace plan_fixtures {

inline std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                         const std::string& more = "<limit lower=\"-3\" upper=\"3\" effort=\"1\" velocity=\"1\"/>") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/><axis xyz=\"0 0 1\"/>" + more + "</joint>\n";
}

/// A rod of 1 m along x on "turn", a cap that "lift" slides, and a hook that follows "lift".
inline std::string arm() {
  const std::string slide = "<limit lower=\"0\" upper=\"0.2\" effort=\"1\" velocity=\"1\"/>";
  return "<robot name=\"rod\"><link name=\"base\"/>\n<link name=\"rod\"><collision><origin xyz=\"0.5 0 0\"/>"
         "<geometry><box size=\"1 0.1 0.1\"/></geometry></collision></link>\n<link name=\"cap\"/><link name=\"hook\"/><link "
         "name=\"mast\"/>\n" +
         joint("turn", "revolute", "base", "rod") + joint("lift", "prismatic", "rod", "cap", slide) +
         joint("follow", "prismatic", "rod", "hook", slide + "<mimic joint=\"lift\" multiplier=\"2\"/>") +
         joint("spin", "continuous", "base", "mast", "") + "</robot>\n";
}

/// A post at x = 0.8 m, which the arm hits when it points there.
inline Scene post() {
  Scene scene{"post", {}};
  SceneBody body{"post", boxShape({0.1, 0.1, 0.5})};
  body.pose.translation() = Eigen::Vector3d(0.8, 0, 0);
  addBody(scene, body);
  return scene;
}

}  // namespace plan_fixtures
}  // namespace collision_hulls
