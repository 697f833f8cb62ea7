// Checks the tree of links and joints before urdfdom builds it: urdfdom overflows the stack on long chains and loops.
#include "decode/urdf/joint_graph.h"

#include <tinyxml2.h>

#include <algorithm>
#include <map>
#include <vector>

namespace collision_hulls {
namespace {

constexpr int kLongestChain = 2000;

struct Node {
  int line = 0;
  int depth = 0;         // joints on the longest way from a root
  int open_parents = 0;  // joints to it whose parent was not visited yet
  std::vector<std::string> children;
};
using Graph = std::map<std::string, Node>;

const char* nameOf(const tinyxml2::XMLElement* element, const char* attribute) {
  const char* name = element ? element->Attribute(attribute) : nullptr;
  return name ? name : "";
}

Graph readGraph(const tinyxml2::XMLElement& robot) {
  Graph graph;
  for (const auto* link = robot.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
    graph[nameOf(link, "name")].line = link->GetLineNum();
  }
  for (const auto* joint = robot.FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint")) {
    const auto parent = graph.find(nameOf(joint->FirstChildElement("parent"), "link"));
    const auto child = graph.find(nameOf(joint->FirstChildElement("child"), "link"));
    if (parent == graph.end() || child == graph.end()) continue;
    parent->second.children.push_back(child->first);
    ++child->second.open_parents;
  }
  return graph;
}

// After all links that can be were visited: names the first in the document that is left.
void refuseLoops(const Graph& graph) {
  const Node* looped = nullptr;
  std::string looped_name;
  for (const auto& [name, node] : graph) {
    if (node.open_parents == 0 || (looped && node.line >= looped->line)) continue;
    looped = &node;
    looped_name = name;
  }
  if (looped) throw JointGraphError(looped->line, "link '" + looped_name + "' hangs on joints that form a loop; a URDF is a tree");
}

}  // namespace

// Kahn's topological order: a link is visited after all its parents; what is never visited lies on or behind a loop.
void checkJointGraph(const tinyxml2::XMLElement& robot) {
  Graph graph = readGraph(robot);
  std::vector<const Node*> open;
  for (const auto& [name, node] : graph) {
    if (node.open_parents == 0) open.push_back(&node);
  }
  while (!open.empty()) {
    const Node& parent = *open.back();
    open.pop_back();
    for (const std::string& name : parent.children) {
      Node& child = graph[name];
      child.depth = std::max(child.depth, parent.depth + 1);
      if (child.depth > kLongestChain) {
        throw JointGraphError(child.line,
                              "more than " + std::to_string(kLongestChain) + " joints stand between link '" + name + "' and the root");
      }
      if (--child.open_parents == 0) open.push_back(&child);
    }
  }
  refuseLoops(graph);
}

}  // namespace collision_hulls
