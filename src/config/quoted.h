// Texts in a configuration.
#pragma once

#include <string>

namespace collision_hulls {

/// In double quotes, as YAML and JSON read it.
std::string quoted(const std::string& text);

}  // namespace collision_hulls
