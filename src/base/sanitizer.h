// Whether this is built with AddressSanitizer or ThreadSanitizer. They reserve terabytes of address space, open files of their own and end
// a process in their own way.
#pragma once

namespace collision_hulls {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // GCC
constexpr bool kSanitized = true;
#elif defined(__has_feature)  // clang
constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

}  // namespace collision_hulls
