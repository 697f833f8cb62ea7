// glTF 2.0 (ISO/IEC 12113). A .glb file holds a chunk of JSON and one of bytes; a .gltf file is the JSON, with its bytes in data: URIs or
// in files beside it. Nothing here opens a file: buffersInFiles() says which are needed, and whoever may read them packs them with the JSON
// (gltf_container.h), so that a mesh is still one byte string, by which it is known. Buffers in other files are refused elsewhere.
//
// The JSON names byte ranges (buffers, and views of them) and says what numbers they hold (accessors). A sparse accessor changes some of
// the numbers of another range. Nothing is taken on trust: each offset, length and count is checked before a byte is read.
#include "mesh/formats/gltf_document.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include "mesh/formats/scan.h"

namespace collision_hulls {
namespace {

using Json = nlohmann::json;

constexpr int kInt8 = 5120, kUint8 = 5121, kInt16 = 5122, kUint16 = 5123, kUint32 = 5125, kFloat = 5126;  // componentType
constexpr int kDeepest = 64;                                                                              // of JSON: the format needs seven

std::size_t bytesOf(int type) {
  switch (type) {
    case kInt8:
    case kUint8: return 1;
    case kInt16:
    case kUint16: return 2;
    case kUint32:
    case kFloat: return 4;
    default: return 0;
  }
}

/// As the specification turns normalized integers into numbers from -1 or 0 to 1.
double numberAt(const char* bytes, int type, bool normalized) {
  const auto as = [bytes](auto value) {
    std::memcpy(&value, bytes, sizeof value);
    return value;
  };
  const auto scaled = [normalized](auto value) {
    const double number = value;
    return normalized ? std::max(number / std::numeric_limits<decltype(value)>::max(), -1.0) : number;
  };
  switch (type) {
    case kInt8: return scaled(as(std::int8_t{}));
    case kUint8: return scaled(as(std::uint8_t{}));
    case kInt16: return scaled(as(std::int16_t{}));
    case kUint16: return scaled(as(std::uint16_t{}));
    case kUint32: return as(std::uint32_t{});
    default: return as(float{});
  }
}

/// RFC 4648; nullopt for anything else.
std::optional<std::string> fromBase64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int held = 0;
  if (text.size() % 4 != 0) return std::nullopt;
  for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding) text.remove_suffix(1);
  for (const char c : text) {
    static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 0xFF);
  }
  return bytes;
}

bool isData(const std::string& uri) {
  return uri.rfind("data:", 0) == 0;
}

/// nullopt for any other encoding.
std::optional<std::string> fromDataUri(const std::string& uri) {
  constexpr std::string_view kBase64 = ";base64,";
  const std::size_t data = uri.find(kBase64);
  return data == std::string::npos ? std::nullopt : fromBase64(std::string_view(uri).substr(data + kBase64.size()));
}

std::string named(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

}  // namespace

/// Elements of an accessor in a buffer.
struct GltfDocument::Elements {
  std::string_view bytes;
  std::size_t stride = 0, components = 0, bytes_each = 0;
  int type = 0;
  bool normalized = false;

  double number(std::size_t element, std::size_t component) const {
    return numberAt(bytes.data() + element * stride + component * bytes_each, type, normalized);
  }
};

GltfDocument::GltfDocument(const std::string& bytes, const std::string& path) : path_(path), parts_(gltfParts(bytes, path)) {
  parse(parts_.json);
  checkVersion();
  checkExtensions();
}

void GltfDocument::fail(const std::string& reason) const {
  failNotAMesh(path_, reason);
}

/// Names within an object must differ: readers do not agree on which of two counts.
void GltfDocument::parse(std::string_view text) {
  std::vector<std::set<std::string>> names;
  const auto look = [&](int depth, Json::parse_event_t event, Json& value) {
    if (depth > kDeepest) fail("is nested deeper than " + std::to_string(kDeepest) + " levels");
    if (event == Json::parse_event_t::object_start) names.emplace_back();
    if (event == Json::parse_event_t::object_end) names.pop_back();
    if (event == Json::parse_event_t::key && !names.back().insert(value.get<std::string>()).second)
      fail("has an object with " + inQuotes(value.get<std::string>()) + " twice");
    return true;
  };
  try {
    root_ = Json::parse(text.begin(), text.end(), look);
  } catch (const Json::parse_error& error) {
    fail("is not JSON from byte " + std::to_string(error.byte) + " on");
  } catch (const Json::exception&) {
    fail("has a number that is too large for JSON");
  }
  if (!root_.is_object()) fail("is not a glTF file: its JSON is not an object");
}

/// Before anything else is looked at: other versions have it in other places.
void GltfDocument::checkVersion() const {
  const std::string version =
      root_.contains("asset") && root_["asset"].is_object() ? root_["asset"].value("version", Json("")).dump() : "\"\"";
  if (version.rfind("\"2.", 0) != 0) fail("is glTF " + version + "; export it as glTF 2");
}

/// Those about looks change no surface.
void GltfDocument::checkExtensions() const {
  if (!root_.contains("extensionsRequired")) return;
  for (const Json& each : root_["extensionsRequired"]) {
    const std::string name = each.is_string() ? each.get<std::string>() : each.dump();
    const auto begins = [&](const char* with) { return name.rfind(with, 0) == 0; };
    if (begins("KHR_materials_") || begins("KHR_texture_") || begins("KHR_lights_") || begins("EXT_texture_") || begins("MSFT_texture_") ||
        name == "KHR_mesh_quantization")
      continue;
    fail("requires the extension " + inQuotes(name) + ", which is not supported; export the mesh without it");
  }
}

const std::string* GltfDocument::bufferUri(std::size_t buffer) const {
  const Json& object = item("buffers", buffer);
  if (!object.contains("uri")) return nullptr;
  if (!object["uri"].is_string()) fail(named("buffers", buffer) + ".uri is not a string");
  return object["uri"].get_ptr<const std::string*>();
}

std::vector<BufferFile> GltfDocument::bufferFiles() const {
  std::vector<BufferFile> files;
  std::set<std::string> known;
  for (std::size_t i = 0; i < count("buffers"); ++i) {
    const std::string* const uri = bufferUri(i);
    if (uri && !isData(*uri) && known.insert(*uri).second) files.push_back({i, *uri});
  }
  return files;
}

void GltfDocument::readBuffers() {
  const std::vector<BufferFile> files = bufferFiles();
  if (!parts_.packed && !files.empty())
    fail(named("buffers", files[0].buffer) + " is in another file, " + inQuotes(files[0].uri) +
         "; export the mesh as .glb, which holds everything");
  if (parts_.packed && files.size() != parts_.binaries.size())
    fail("names " + std::to_string(files.size()) + " files of buffers, but is packed with " + std::to_string(parts_.binaries.size()));
  Contents contents;
  for (std::size_t i = 0; i < files.size(); ++i) contents[files[i].uri] = parts_.binaries[i];
  decoded_.resize(count("buffers"));
  for (std::size_t i = 0; i < decoded_.size(); ++i) readBuffer(i, contents);
}

void GltfDocument::readBuffer(std::size_t buffer, const Contents& files) {
  const std::string name = named("buffers", buffer);
  const std::optional<std::size_t> length = index(item("buffers", buffer), "byteLength", name);
  if (!length) fail(name + " has no byteLength");
  const std::string* const uri = bufferUri(buffer);
  std::string_view content;
  std::string place = "there";
  if (uri && isData(*uri)) {
    const std::optional<std::string> bytes = fromDataUri(*uri);
    if (!bytes) fail(name + " is not valid base64");
    content = decoded_[buffer] = *bytes;
  } else if (uri) {
    content = files.at(*uri);
    place = "in " + inQuotes(*uri);
  } else if (buffer == 0 && !parts_.packed && !parts_.binaries.empty()) {
    content = parts_.binaries[0];
  }
  if (*length > content.size())
    fail(name + " announces " + std::to_string(*length) + " bytes, of which " + std::to_string(content.size()) + " are " + place);
  buffers_.push_back(content.substr(0, *length));
}

std::size_t GltfDocument::count(const char* list) const {
  if (!root_.contains(list)) return 0;
  if (!root_[list].is_array()) fail(std::string(list) + " is not a list");
  return root_[list].size();
}

const Json& GltfDocument::item(const char* list, std::size_t index) const {
  if (index >= count(list)) fail("names " + named(list, index) + ", but there are " + std::to_string(count(list)));
  const Json& found = root_[list][index];
  if (!found.is_object()) fail(named(list, index) + " is not an object");
  return found;
}

std::optional<std::size_t> GltfDocument::index(const Json& object, const char* member, const std::string& name) const {
  const auto found = object.find(member);
  if (found == object.end()) return std::nullopt;
  if (!found->is_number_unsigned()) fail(name + "." + member + " is " + inQuotes(found->dump()) + ", no whole number");
  return found->get<std::size_t>();
}

std::vector<std::size_t> GltfDocument::indices(const Json& object, const char* member, const std::string& name) const {
  std::vector<std::size_t> result;
  if (!object.contains(member)) return result;
  const Json& list = object[member];
  if (!list.is_array()) fail(name + "." + member + " is not a list");
  for (const Json& each : list) {
    if (!each.is_number_unsigned()) fail(name + "." + member + " holds " + inQuotes(each.dump()) + ", no whole number");
    result.push_back(each.get<std::size_t>());
  }
  return result;
}

std::vector<double> GltfDocument::numbers(const Json& object, const char* member, std::size_t count, const std::string& name) const {
  std::vector<double> result;
  if (!object.contains(member)) return result;
  const Json& list = object[member];
  for (std::size_t i = 0; list.is_array() && i < list.size() && list[i].is_number(); ++i) result.push_back(list[i].get<double>());
  if (result.size() != count || list.size() != count) fail(name + "." + member + " are not " + std::to_string(count) + " numbers");
  return result;
}

std::string_view GltfDocument::view(std::size_t index, std::size_t* stride) const {
  const std::string name = named("bufferViews", index);
  const Json& view = item("bufferViews", index);
  const std::optional<std::size_t> buffer = this->index(view, "buffer", name), length = this->index(view, "byteLength", name);
  if (!buffer || !length) fail(name + " has no buffer or no byteLength");
  if (*buffer >= buffers_.size())
    fail(name + " names buffer " + std::to_string(*buffer) + ", but there are " + std::to_string(buffers_.size()));
  const std::string_view bytes = buffers_[*buffer];
  const std::size_t offset = this->index(view, "byteOffset", name).value_or(0);
  if (offset > bytes.size() || *length > bytes.size() - offset) fail(name + " leaves its buffer");
  *stride = this->index(view, "byteStride", name).value_or(0);
  return bytes.substr(offset, *length);
}

/// `object`: an accessor, or a part of a sparse one. `type`: 0 for the one that it names.
GltfDocument::Elements GltfDocument::elements(const Json& object, const std::string& name, std::size_t components, std::size_t count,
                                              int type) const {
  const std::optional<std::size_t> view = index(object, "bufferView", name);
  if (!view) fail(name + " has no bufferView");
  Elements result;
  result.bytes = this->view(*view, &result.stride);
  result.type = type != 0 ? type : static_cast<int>(std::min<std::size_t>(index(object, "componentType", name).value_or(0), 10'000));
  result.components = components;
  result.bytes_each = bytesOf(result.type);
  if (result.bytes_each == 0) fail(name + " has numbers of the unknown type " + std::to_string(result.type));
  const std::size_t size = components * result.bytes_each;
  if (result.stride == 0) result.stride = size;
  if (result.stride < size)
    fail(name + " has elements of " + std::to_string(size) + " bytes, but a stride of " + std::to_string(result.stride));
  const std::size_t offset = index(object, "byteOffset", name).value_or(0);
  const bool fits =
      offset <= result.bytes.size() &&
      (count == 0 || (result.bytes.size() - offset >= size && (result.bytes.size() - offset - size) / result.stride >= count - 1));
  if (!fits) fail(name + " leaves its bufferView");
  result.bytes.remove_prefix(offset);
  return result;
}

std::vector<double> GltfDocument::accessor(std::size_t index, std::size_t components, std::size_t most) const {
  const std::string name = named("accessors", index);
  const Json& object = item("accessors", index);
  const std::string type = components == 3 ? "VEC3" : "SCALAR";
  if (!object.contains("type") || object["type"] != type) fail(name + " is not of type " + type);
  const std::size_t count = this->index(object, "count", name).value_or(0);
  if (count > most)
    throw Error(ErrorCode::kTooLarge,
                path_ + ": " + name + " has " + std::to_string(count) + " elements; at most " + std::to_string(most) + " are allowed");
  const bool normalized = object.contains("normalized") && object["normalized"] == true, sparse = object.contains("sparse");
  if (!sparse && !object.contains("bufferView"))
    fail(name + " has no bufferView; if it is compressed, export the mesh without compression");
  std::vector<double> result(count * components, 0);
  int component_type = static_cast<int>(std::min<std::size_t>(this->index(object, "componentType", name).value_or(0), 10'000));
  const auto take = [&](const Elements& from, std::size_t element, std::size_t to) {
    for (std::size_t c = 0; c < components; ++c) result[to * components + c] = from.number(element, c);
  };
  if (object.contains("bufferView")) {
    Elements all = elements(object, name, components, count, 0);
    all.normalized = normalized;
    for (std::size_t i = 0; i < count; ++i) take(all, i, i);
  }
  if (!sparse) return result;
  const Json& changes = object["sparse"];
  if (!changes.is_object() || !changes.contains("indices") || !changes.contains("values")) fail(name + ".sparse lacks indices or values");
  const std::size_t changed = this->index(changes, "count", name + ".sparse").value_or(0);
  const Elements places = elements(changes["indices"], name + ".sparse.indices", 1, changed, 0);
  Elements values = elements(changes["values"], name + ".sparse.values", components, changed, component_type);
  values.normalized = normalized;
  for (std::size_t i = 0; i < changed; ++i) {
    const double place = places.number(i, 0);
    if (!(place >= 0 && place < static_cast<double>(count))) fail(name + ".sparse changes an element that is not there");
    take(values, i, static_cast<std::size_t>(place));
  }
  return result;
}

std::vector<std::uint32_t> GltfDocument::wholeNumbers(std::size_t index, std::size_t most) const {
  const Json& object = item("accessors", index);
  const std::size_t type = this->index(object, "componentType", named("accessors", index)).value_or(0);
  if ((type != kUint8 && type != kUint16 && type != kUint32) || (object.contains("normalized") && object["normalized"] == true))
    fail(named("accessors", index) + " holds indices, which are unsigned whole numbers");
  std::vector<std::uint32_t> result;
  for (const double number : accessor(index, 1, most)) result.push_back(static_cast<std::uint32_t>(number));
  return result;
}

std::vector<BufferFile> buffersInFiles(const std::string& bytes, const std::string& path) {
  return GltfDocument(bytes, path).bufferFiles();
}

}  // namespace collision_hulls
