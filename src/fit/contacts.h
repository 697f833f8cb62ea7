// Which bodies of a model touch each other in a sample.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "fit/checked_pairs.h"

namespace collision_hulls {

/// Two nodes that touch in a sample.
struct Contact {
  std::size_t sample = 0;
  int piece[2] = {0, 0}, node[2] = {0, 0};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of the second piece in the first one's frame
};

/// Whether the contact's pieces touch with other nodes in place of its own.
bool touches(const Assembly& assembly, const Contact& contact, int first, int second);

/// All contacts of a model between the parts of these pairs.
std::vector<Contact> contacts(const Assembly& assembly, const Cuts& cuts, const CheckedPairs& pairs, const Places& places,
                              std::size_t sample);

/// The parts in contact.
std::set<PartIndices> partsOf(const Assembly& assembly, const std::vector<Contact>& contacts);

/// Whether there is at least one such contact.
bool inContact(const Assembly& assembly, const Cuts& cuts, const CheckedPairs& pairs, const Places& places);

}  // namespace collision_hulls
