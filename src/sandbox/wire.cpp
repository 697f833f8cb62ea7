// Bytes and descriptors between processes. A descriptor travels as control data of a message (unix(7), SCM_RIGHTS).
#include "sandbox/wire.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace collision_hulls {
namespace {

/// A message of some bytes with room for descriptors.
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
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(Numbers))] = {};
};

}  // namespace

long sendWith(int socket, const void* bytes, std::size_t size, const Numbers& descriptors, int flags) {
  const std::size_t count = descriptors[0] < 0 ? 0 : descriptors[1] < 0 ? 1 : 2;
  if (count == 0) return send(socket, bytes, size, MSG_NOSIGNAL | flags);
  Message message(const_cast<void*>(bytes), size);
  message.message.msg_controllen = CMSG_SPACE(count * sizeof(int));
  cmsghdr* const rights = CMSG_FIRSTHDR(&message.message);
  rights->cmsg_level = SOL_SOCKET;
  rights->cmsg_type = SCM_RIGHTS;
  rights->cmsg_len = CMSG_LEN(count * sizeof(int));
  std::memcpy(CMSG_DATA(rights), descriptors.data(), count * sizeof(int));
  return sendmsg(socket, &message.message, MSG_NOSIGNAL | flags);
}

long receiveWith(int socket, void* bytes, std::size_t size, Descriptors& descriptors, int flags) {
  Message message(bytes, size);
  const long got = recvmsg(socket, &message.message, MSG_CMSG_CLOEXEC | flags);
  if (got <= 0) return got;
  const cmsghdr* const rights = CMSG_FIRSTHDR(&message.message);
  if (rights == nullptr || rights->cmsg_type != SCM_RIGHTS) return got;
  Numbers numbers{-1, -1};
  std::memcpy(numbers.data(), CMSG_DATA(rights), std::min(sizeof numbers, rights->cmsg_len - CMSG_LEN(0)));
  descriptors = {Descriptor(numbers[0]), Descriptor(numbers[1])};
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

}  // namespace collision_hulls
