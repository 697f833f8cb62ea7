// The text of a <collision> element.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// How new elements are set among their neighbours.
struct Layout {
  bool one_line = false;    ///< no line ends at all
  std::string newline;      ///< "\n" or "\r\n"
  std::string link_indent;  ///< white space before <link> on its line
  std::string indent;       ///< of the new elements
  std::string step;         ///< added per level

  /// The white space before an element `level` levels below <collision>; -1 for the link's end tag.
  std::string lineEnd(int level) const;
};

/// The layout of elements beside one that `space` precedes, in a link that `link_space` precedes.
Layout layoutBeside(const std::string& space, const std::string& link_space);

/// The layout of elements in a link without children, which `link_space` precedes.
Layout layoutWithin(const std::string& link_space);

/// An <origin .../> of the source and the transform that it means.
struct KnownOrigin {
  Eigen::Isometry3d transform;
  std::string text;
};

/// The element with the white space before it. Its <origin> is that of `origins` with exactly its transform, else written from
/// the transform's numbers; none for the identity. No name attribute for an empty name.
std::string collisionText(const CollisionElement& element, const std::vector<KnownOrigin>& origins, const Layout& layout);

}  // namespace collision_hulls
