// glTF's binary container (ISO/IEC 12113, 4.4): a header of three numbers (mark, version, length), and chunks with headers of two (length,
// type). Chunks that are packed have any length: filled up to four bytes, a file that is too short would pass for a complete one.
#include "mesh/formats/gltf_container.h"

#include "base/string_parts.h"
#include "geometry/bytes.h"
#include "mesh/formats/scan.h"

namespace collision_hulls {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kPackedMagic = 0x50546C67;  // "glTF", "glTP"
constexpr std::uint32_t kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;

std::uint32_t littleEndian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

bool begins(std::string_view bytes, std::uint32_t magic) {
  return bytes.size() >= kHeaderBytes && littleEndian(bytes, 0) == magic;
}

void checkHeader(std::string_view bytes, const std::string& path) {
  const std::uint32_t version = littleEndian(bytes, 4), length = littleEndian(bytes, 8);
  if (version != kVersion) failNotAMesh(path, "is glTF " + std::to_string(version), "export it as glTF 2");
  if (length != bytes.size()) failNotAMesh(path, "announces " + std::to_string(length) + " bytes, but has " + std::to_string(bytes.size()));
}

struct Chunk {
  std::uint32_t type = 0;
  std::string_view content;
};

/// Takes a chunk off the front of `rest`.
Chunk nextChunk(std::string_view& rest, const std::string& path) {
  if (rest.size() < kChunkHeaderBytes) failNotAMesh(path, "ends within the header of a chunk");
  const std::size_t length = littleEndian(rest, 0);
  const std::uint32_t type = littleEndian(rest, 4);
  rest.remove_prefix(kChunkHeaderBytes);
  if (length > rest.size())
    failNotAMesh(path, "announces a chunk of " + std::to_string(length) + " bytes, of which " + std::to_string(rest.size()) + " are there");
  const std::string_view content = rest.substr(0, length);
  rest.remove_prefix(length);
  return {type, content};
}

}  // namespace

bool isGltfContainer(std::string_view bytes) {
  return begins(bytes, kMagic) || isPackedGltf(bytes);
}

bool isPackedGltf(std::string_view bytes) {
  return begins(bytes, kPackedMagic);
}

GltfParts gltfParts(std::string_view bytes, const std::string& path) {
  if (!isGltfContainer(bytes)) {
    if (lowerExtension(path) == ".glb" && trimmed(bytes.substr(0, kHeaderBytes), " \t\r\n").find_first_of("{[") != 0)
      failNotAMesh(path, "does not begin with 'glTF' and a version, as binary glTF does");
    return {false, checkedText(bytes, path), {}};
  }
  checkHeader(bytes, path);
  GltfParts parts;
  parts.packed = isPackedGltf(bytes);
  std::string_view rest = bytes.substr(kHeaderBytes);
  for (int number = 0; number == 0 || !rest.empty(); ++number) {
    const Chunk chunk = nextChunk(rest, path);
    if ((number == 0) != (chunk.type == kJsonChunk)) failNotAMesh(path, "has its JSON in another chunk than the first");
    if (number == 0) parts.json = parts.packed ? checkedText(chunk.content, path) : chunk.content;
    if (chunk.type == kBinaryChunk && (number == 1 || parts.packed)) parts.binaries.push_back(chunk.content);
  }
  return parts;
}

std::string packedGltf(std::string_view json, const std::vector<std::string>& files) {
  std::size_t size = kHeaderBytes + kChunkHeaderBytes + json.size();
  for (const std::string& file : files) size += kChunkHeaderBytes + file.size();
  std::string packed = toBytes(kPackedMagic, kVersion, static_cast<std::uint32_t>(size));
  packed.reserve(size);
  const auto add = [&packed](std::uint32_t type, std::string_view content) {
    packed += toBytes(static_cast<std::uint32_t>(content.size()), type);
    packed += content;
  };
  add(kJsonChunk, json);
  for (const std::string& file : files) add(kBinaryChunk, file);
  return packed;
}

}  // namespace collision_hulls
