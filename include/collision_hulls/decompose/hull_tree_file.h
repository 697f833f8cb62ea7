// Saves and loads hull trees; other levels of detail then need no new decomposition.
//
// The format, little-endian: "CHULTREE", version (32 bits), size of the payload (64), payload,
// FNV-1a checksum (64) of everything before it. The payload: tolerance, number of nodes (64), and
// for each node parent, left, right (32 each), protrusion, and its hull: vertices, triangles and
// faces, each preceded by their number (64), thickness, slack. Real numbers are doubles, so nothing
// is lost.
#pragma once

#include <string>

#include "collision_hulls/decompose/hull_tree.h"

namespace collision_hulls {

/// Writes a tree to a file, atomically (by a rename). Throws kUnwritableOutput, and kInternal for a
/// tree that loading would refuse.
void saveHullTree(const HullTree& tree, const std::string& file);

/// Reads a tree from a file, identical to the last bit. Throws kFileNotFound, kTooLarge above 1
/// GiB, and kNotAHullTree (naming the file and the fault) unless everything holds: magic, version,
/// size, checksum; finite numbers, indices in range; children before their parents, root last,
/// bounds that never decrease toward it.
HullTree loadHullTree(const std::string& file);

/// The bytes of such a file, and back; `name` stands for the file in messages. Throw kInternal and
/// kNotAHullTree as above.
std::string encodeHullTree(const HullTree& tree);
HullTree decodeHullTree(const std::string& bytes, const std::string& name);

}  // namespace collision_hulls
