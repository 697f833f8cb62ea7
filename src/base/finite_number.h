// Numbers in the text of scenes, configurations and forms.
#pragma once

#include <string_view>

namespace collision_hulls {

/// Parses a number with a decimal point, whatever the locale; false if the word is not a finite number. Blanks may stand in front. Mesh
/// files have a grammar of their own, which also knows infinity: mesh/formats/number.h.
bool parseFinite(std::string_view word, double& value);

}  // namespace collision_hulls
