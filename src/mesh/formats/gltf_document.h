// A glTF 2.0 document: its JSON, and the numbers in its buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/formats/gltf_container.h"

namespace collision_hulls {

/// Checks what it hands out: indices, ranges and types. Everything throws kNotAMesh with the name of the item, as in "accessors[3]".
class GltfDocument {
 public:
  using Json = nlohmann::json;

  /// A .glb or .gltf file, or one that is packed (gltf_container.h), told apart by the first bytes. Keeps references.
  GltfDocument(const std::string& bytes, const std::string& path);

  /// The files that hold buffers, each once, by their first buffers.
  std::vector<BufferFile> bufferFiles() const;

  /// Comes before any number. Refuses buffers in files that are not packed.
  void readBuffers();

  /// An element of one of the document's lists, such as "nodes".
  const Json& item(const char* list, std::size_t index) const;
  std::size_t count(const char* list) const;

  // Members of an object that is called `name` in messages.
  std::optional<std::size_t> index(const Json& object, const char* member, const std::string& name) const;  ///< a whole number
  std::vector<std::size_t> indices(const Json& object, const char* member, const std::string& name) const;  ///< empty where it is missing
  std::vector<double> numbers(const Json& object, const char* member, std::size_t count, const std::string& name) const;  ///< the same

  /// The numbers of an accessor of type VEC3 or SCALAR (`components`: 3 or 1), one element after another, at most `most` elements.
  std::vector<double> accessor(std::size_t index, std::size_t components, std::size_t most) const;
  /// The same for whole numbers: those of unsigned types alone.
  std::vector<std::uint32_t> wholeNumbers(std::size_t index, std::size_t most) const;

  [[noreturn]] void fail(const std::string& reason) const;
  const Json& root() const { return root_; }

 private:
  struct Elements;
  using Contents = std::map<std::string, std::string_view>;  // of files, by their URIs

  void parse(std::string_view text);
  void checkVersion() const;
  void checkExtensions() const;
  const std::string* bufferUri(std::size_t buffer) const;  // null for a buffer without one
  void readBuffer(std::size_t buffer, const Contents& files);
  std::string_view view(std::size_t index, std::size_t* stride) const;
  Elements elements(const Json& object, const std::string& name, std::size_t components, std::size_t count, int type) const;

  const std::string& path_;
  const GltfParts parts_;
  Json root_;
  std::vector<std::string> decoded_;  // from data: URIs
  std::vector<std::string_view> buffers_;
};

/// What GltfDocument::bufferFiles() says of some bytes.
std::vector<BufferFile> buffersInFiles(const std::string& bytes, const std::string& path);

}  // namespace collision_hulls
