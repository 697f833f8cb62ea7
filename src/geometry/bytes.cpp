// Framing of the library's own files: magic, version, size, payload, checksum.
#include "geometry/bytes.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kHeader = 8 + 4 + 8;  // magic, version, size of the payload
constexpr std::size_t kChecksum = 8;

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 0xcbf29ce484222325u;
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  return sum;
}

std::string sealed(const FileKind& kind, const std::string& payload) {
  std::string bytes = toBytes(kind.magic, kind.version, std::uint64_t{payload.size()});
  bytes.reserve(bytes.size() + payload.size() + kChecksum);
  bytes += payload;
  bytes += toBytes(checksum(bytes));
  return bytes;
}

std::string opened(const FileKind& kind, const std::string& bytes) {
  FileKind found{};
  std::uint64_t size = 0, sum = 0;
  ByteReader in(bytes);
  in(found.magic);
  if (found.magic != kind.magic) throw ByteFault("its first bytes are not those of this kind of file");
  in(found.version);
  if (found.version != kind.version) {
    throw ByteFault("its format is version " + std::to_string(found.version) + "; this program reads version " +
                    std::to_string(kind.version));
  }
  in(size);
  const std::size_t around = kHeader + kChecksum;
  if (bytes.size() < around || bytes.size() - around != size) {
    throw ByteFault("it is " + std::to_string(bytes.size()) + " bytes long, but its header announces " + std::to_string(size) +
                    " bytes of content and the frame takes " + std::to_string(around));
  }
  fromBytes(bytes.substr(bytes.size() - kChecksum), sum);
  if (sum != checksum(std::string_view(bytes).substr(0, bytes.size() - kChecksum)))
    throw ByteFault("its checksum does not match its content");
  return bytes.substr(kHeader, size);
}

}  // namespace collision_hulls
