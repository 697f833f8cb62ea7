// Tables for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/figure.h"

namespace collision_hulls {

using Cells = std::vector<std::string>;

/// [mm] A length in metres as a figure.
std::string figureInMillimetres(double metres);

/// Rows of equal length, one a line: the first `text_columns` are aligned left, numbers right, and the last column as it is.
std::string aligned(const std::vector<Cells>& rows, std::size_t text_columns);

}  // namespace collision_hulls
