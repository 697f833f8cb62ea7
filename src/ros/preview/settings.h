// A link's options as messages, and back.
#pragma once

#include <collision_hulls/LinkChoice.h>

#include <string>

#include "collision_hulls/report/options.h"

namespace collision_hulls {

LinkChoice toMessage(const std::string& link, const LinkOptions& options);

/// Throws kBadOption for a value that cannot be; the message names link and item. LinkOptions::tree is not set.
LinkOptions toOptions(const LinkChoice& settings);

}  // namespace collision_hulls
