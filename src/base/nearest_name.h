// The name that a user probably meant.
#pragma once

#include <string>
#include <vector>

namespace collision_hulls {

/// How many letters to insert, delete or replace, or neighbours to swap, to turn one text into the other. No letter is edited twice
/// (optimal string alignment).
std::size_t editDistance(const std::string& a, const std::string& b);

/// The name that `text` begins, or else the nearest one by edit distance; empty if they all differ by more than a third of `text`.
std::string nearestName(const std::string& text, const std::vector<std::string>& names);

/// "; did you mean 'certified'?", or nothing if no name is near.
std::string didYouMean(const std::string& text, const std::vector<std::string>& names);

}  // namespace collision_hulls
