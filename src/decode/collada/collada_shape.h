// A <geometry> of Collada.
#pragma once

#include "decode/collada/collada.h"
#include "decode/collada/collada_xml.h"

namespace collision_hulls {

/// The polygons of a <geometry>: of triangles, polylist, polygons, trifans and tristrips. Throws as readCollada().
ColladaShape readColladaShape(const ColladaElement& geometry, const std::string& path, std::size_t max_triangles,
                              const RunControl& control);

/// Appends a number and a blank: as `word` spells it if Assimp reads that rightly, and otherwise `value` in nine digits.
void appendColladaNumber(std::string_view word, double value, std::string* text);

}  // namespace collision_hulls
