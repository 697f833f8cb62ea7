// Whether this is built with AddressSanitizer. It reserves terabytes of address space, opens files of its own and ends a process in its own
// way.
#pragma once

namespace collision_hulls {

#ifdef __SANITIZE_ADDRESS__  // GCC
constexpr bool kSanitized = true;
#elif defined(__has_feature)  // clang
constexpr bool kSanitized = __has_feature(address_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

}  // namespace collision_hulls
