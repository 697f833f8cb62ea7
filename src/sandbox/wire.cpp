// Bytes and descriptors between processes. A descriptor travels as control data of a message (unix(7), SCM_RIGHTS).
#include "sandbox/wire.h"

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace collision_hulls {
namespace {

/// A message of some bytes with room for one descriptor.
struct Message {
  Message(void* bytes, std::size_t size) : part{bytes, size} {
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
  }
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;

  iovec part;
  msghdr message{};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
};

}  // namespace

Descriptor memoryFile() {
#ifdef MFD_NOEXEC_SEAL  // a machine may demand it
  if (const int file = memfd_create("collision_hulls", MFD_CLOEXEC | MFD_NOEXEC_SEAL); file >= 0 || errno != EINVAL)
    return Descriptor(file);
#endif
  return Descriptor(memfd_create("collision_hulls", MFD_CLOEXEC));
}

long sendWith(int socket, const void* bytes, std::size_t size, int descriptor, int flags) {
  if (descriptor < 0) return send(socket, bytes, size, MSG_NOSIGNAL | flags);
  Message message(const_cast<void*>(bytes), size);
  cmsghdr* const rights = CMSG_FIRSTHDR(&message.message);
  rights->cmsg_level = SOL_SOCKET;
  rights->cmsg_type = SCM_RIGHTS;
  rights->cmsg_len = CMSG_LEN(sizeof descriptor);
  std::memcpy(CMSG_DATA(rights), &descriptor, sizeof descriptor);
  return sendmsg(socket, &message.message, MSG_NOSIGNAL | flags);
}

long receiveWith(int socket, void* bytes, std::size_t size, Descriptor& descriptor, int flags) {
  Message message(bytes, size);
  const long got = recvmsg(socket, &message.message, MSG_CMSG_CLOEXEC | flags);
  if (got <= 0) return got;
  const cmsghdr* const rights = CMSG_FIRSTHDR(&message.message);
  if (rights == nullptr || rights->cmsg_type != SCM_RIGHTS || rights->cmsg_len != CMSG_LEN(sizeof(int))) return got;
  int number = -1;
  std::memcpy(&number, CMSG_DATA(rights), sizeof number);
  descriptor = Descriptor(number);
  return got;
}

bool writeAll(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool readAll(int file, std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    errno = 0;
    const ssize_t got = pread(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    done += static_cast<std::size_t>(got);
  }
  return true;
}

std::optional<std::uint64_t> sizeOf(int file) {
  struct stat status {};
  if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

}  // namespace collision_hulls
