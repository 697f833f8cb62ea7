// Hull trees to and from files, so that other levels of detail need no decomposition.
//
// The format, little-endian: "CHULTREE", version (32 bits), size of the payload (64), payload, FNV-1a checksum (64) of all before it.
// The payload: tolerance, number of nodes (64), and for each node parent, left, right (32 each), protrusion, and its hull: vertices,
// triangles and faces, each preceded by their number (64), thickness, slack. Real numbers are doubles, so that nothing is lost.
#pragma once

#include <string>

#include "collision_hulls/decompose/hull_tree.h"

namespace collision_hulls {

/// Writes a tree to a file, in one rename. Throws kUnwritableOutput, and kInternal for a tree that loading would refuse.
void saveHullTree(const HullTree& tree, const std::string& file);

/// The tree of a file, the same to the last bit. Throws kFileNotFound, and kNotAHullTree, naming file and fault, unless all of it is
/// as it should be: magic, version, size, checksum; finite numbers, indices in range; children before their parents, the root last,
/// bounds that never decrease toward it.
HullTree loadHullTree(const std::string& file);

/// The bytes of such a file, and back; `name` stands for the file in messages.
std::string encodeHullTree(const HullTree& tree);
HullTree decodeHullTree(const std::string& bytes, const std::string& name);

}  // namespace collision_hulls
