// What checks by queries found, in the words that tables, pages and messages share.
#pragma once

#include <cstddef>
#include <string>

#include "base/counted.h"
#include "collision_hulls/report/report.h"

namespace collision_hulls {

/// Writes a number of things: counted(), or one that groups digits.
using CountText = std::string (*)(std::size_t number, const std::string& noun, const std::string& plural);

/// "7 hulls", "7 hulls and 1 primitive", "2 primitives".
std::string countedBodies(std::size_t hulls, std::size_t primitives);

/// "7", "7 hulls and 1 primitive", "2 primitives": for a table's column.
std::string bodiesInColumn(std::size_t hulls, std::size_t primitives);

/// "hulls", "primitives", or "bodies" where a model has both.
std::string kindOfBodies(const ModelReport& model);

/// "no collision missed, 2 false collisions beyond the protrusion"; `limit`: what false collisions may stay within.
std::string verdictText(std::size_t missed, std::size_t phantom, const std::string& limit, CountText count = counted);

/// "400 queries compared hulls and meshes: no collision missed, no false collision beyond the protrusion; distances at most 3.2 mm too
/// short"; `bodies`: "hulls" there.
std::string checkText(const Validation& validation, const std::string& bodies, CountText count = counted);

}  // namespace collision_hulls
