// What failures have in common, so that those of many meshes can be said once.
#pragma once

#include <cstddef>
#include <string>

namespace collision_hulls {

/// Of a file that a reason names.
enum class Folder { kKept, kLeftOut };

/// The reason of a file that is equal to another, whose reason is `reason`.
std::string reasonOfCopy(const std::string& uri, const std::string& first, const std::string& reason);

/// A reason without what it says of one failure alone: the file of `uri` (may be empty), the link, and the line. That of a copy is that of
/// the first.
std::string failureCause(std::string reason, std::string uri, const std::string& link, Folder folder);

/// " (the same for 8 more, of 3 links in all)", behind the first of them.
std::string theSameFor(std::size_t more, std::size_t links);

}  // namespace collision_hulls
