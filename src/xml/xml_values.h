// Attributes of an XML text that get other values, in place.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// What an attribute becomes; nullopt: it stays. `path`: the names of its element and of those around it,
/// "robot/link/visual/geometry/mesh"; `value`: as a reader of the XML sees it.
using NewValue = std::function<std::optional<std::string>(const std::string& path, const std::string& value)>;

/// The text with new values for the attributes called `name`; all else stays byte for byte. Throws what parseXml() does.
std::string withNewValues(const std::string& text, const std::string& label, const std::string& name, const NewValue& new_value,
                          const RunControl& control = {});

}  // namespace collision_hulls
