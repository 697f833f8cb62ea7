// The graph of links and joints as it stands in the XML, checked before urdfdom builds its tree from it.
#pragma once

#include <stdexcept>
#include <string>

namespace tinyxml2 {
class XMLElement;
}

namespace collision_hulls {

/// Thrown for a graph that is no tree.
class JointGraphError : public std::runtime_error {
 public:
  JointGraphError(int line, const std::string& reason) : std::runtime_error(reason), line_(line) {}
  int line() const { return line_; }  ///< of the link that it is about

 private:
  int line_;
};

/// Throws JointGraphError for joints that form a loop and for a chain of more than 2000 joints. urdfdom never frees the former
/// and frees the latter recursively. Leaves missing names, unknown links and second roots for urdfdom to complain about.
void checkJointGraph(const tinyxml2::XMLElement& robot);

}  // namespace collision_hulls
