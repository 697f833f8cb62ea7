// What a glTF file is made of: JSON, and the bytes of its buffers.
//
// A .glb file is a container of both: a chunk of JSON, and one of bytes. A .gltf file is the JSON; its buffers may be in files beside it.
// Such a file and those beside it are packed in one byte string, by which the mesh is known: a container with a mark of its own and a chunk
// for each of those files. No other program writes or reads one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace collision_hulls {

/// A file that holds buffers of a .gltf file.
struct BufferFile {
  std::uint64_t buffer = 0;  ///< the first that it holds
  std::string uri;           ///< as the JSON has it
};

struct GltfParts {
  bool packed = false;
  std::string_view json;
  std::vector<std::string_view> binaries;  ///< of a .glb file one at most, for buffer 0; of a packed one the files in their order
};

/// Whether bytes begin as a container of either kind does, and as a packed one.
bool isGltfContainer(std::string_view bytes);
bool isPackedGltf(std::string_view bytes);

/// Of a container, or of the text of a .gltf file. Throws kNotAMesh; `path` is for the message.
GltfParts gltfParts(std::string_view bytes, const std::string& path);

/// The most bytes of JSON and files that can be packed: lengths have 32 bits, and the headers of a thousand chunks take some of them.
constexpr std::uintmax_t kMostPacked = 0xFFFF0000;

/// The JSON of a .gltf file, and the files of buffersInFiles() in their order.
std::string packedGltf(std::string_view json, const std::vector<std::string>& files);

}  // namespace collision_hulls
