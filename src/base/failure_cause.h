// What failures have in common, so that those of many meshes can be said once.
#pragma once

#include <cstddef>
#include <string>

namespace collision_hulls {

/// Of a file that a reason names.
enum class Folder { kKept, kLeftOut };

/// A reason without what it says of one failure alone: the file of `uri` (may be empty), the link, and the line.
std::string failureCause(std::string reason, const std::string& uri, const std::string& link, Folder folder);

/// " (the same for 8 more meshes, of 3 links in all)", behind the first of them.
std::string theSameFor(std::size_t more_meshes, std::size_t links);

}  // namespace collision_hulls
