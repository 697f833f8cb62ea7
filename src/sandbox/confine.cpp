// Three layers, each of which does without the others: resource limits, which every Linux has; a filter of system calls (seccomp, through
// libseccomp where it was there at build time); and Landlock, which denies every path (Linux 5.13).
//
// The filter lets through what computing needs and answers all else with EPERM. It does not kill: the C library of another system may try a
// call that is not in the list and do without it.
#include "sandbox/confine.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>

#include "base/descriptor.h"
#include "sandbox/wire.h"

#if __has_include(<linux/landlock.h>)
#include <linux/landlock.h>
#endif
#ifdef COLLISION_HULLS_SECCOMP
#include <seccomp.h>
#endif

namespace collision_hulls {
namespace {

// A sanitizer reserves terabytes, and opens files to describe what it found.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
constexpr const char* kNoSeccomp = "built with a sanitizer";
#else
constexpr bool kSanitized = false;
#ifdef COLLISION_HULLS_SECCOMP
constexpr const char* kNoSeccomp = "refused by the kernel";
#else
constexpr const char* kNoSeccomp = "built without libseccomp";
#endif
#endif

bool limit(decltype(RLIMIT_AS) what, rlim_t soft, rlim_t hard) {
  rlimit now{};
  if (getrlimit(what, &now) != 0) return false;
  const rlimit wanted{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
  return setrlimit(what, &wanted) == 0;
}

bool limit(decltype(RLIMIT_AS) what, rlim_t most) {
  return limit(what, most, most);
}

bool limitResources(std::uint64_t memory, std::uint64_t cpu_seconds) {
  bool done = limit(RLIMIT_CORE, 0);
  done &= limit(RLIMIT_CPU, cpu_seconds, cpu_seconds + 1);  // the soft limit sends SIGXCPU, which says why
  done &= limit(RLIMIT_FSIZE, memory / 4);                  // of the answer, which is no part of the address space
  done &= limit(RLIMIT_NOFILE, 0);                          // what is open stays open
  done &= limit(RLIMIT_NPROC, 0);
  done &= limit(RLIMIT_MEMLOCK, 0);
  if (!kSanitized) done &= limit(RLIMIT_AS, memory - memory / 4);
  return done;
}

/// Where memory ends for the whole machine, the kernel shall end this process and not the one that asked.
void offerToOutOfMemoryKiller() {
  const Descriptor file(open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC));
  if (file.number() >= 0 && write(file.number(), "1000", 4) < 0) return;  // without it the limits still hold
}

/// Ends the process before a parser can take the failure for a fault of the file.
[[noreturn]] void endForWantOfMemory() {
  _exit(kOutOfMemory);
}

#ifdef LANDLOCK_ACCESS_FS_EXECUTE
/// A set of rules that handles every access to files and grants none.
bool denyPaths() {
  landlock_ruleset_attr rules{};
  rules.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;  // all that its first version knows
  const Descriptor set(static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, sizeof rules, 0)));
  return set.number() >= 0 && syscall(SYS_landlock_restrict_self, set.number(), 0) == 0;
}
#else
bool denyPaths() {
  return false;
}
#endif

#ifdef COLLISION_HULLS_SECCOMP
/// What computing, and writing to what is open, may call.
constexpr int kFree[] = {SCMP_SYS(read),         SCMP_SYS(readv),           SCMP_SYS(pread64),
                         SCMP_SYS(write),        SCMP_SYS(writev),          SCMP_SYS(close),
                         SCMP_SYS(lseek),        SCMP_SYS(fstat),           SCMP_SYS(fcntl),
                         SCMP_SYS(poll),         SCMP_SYS(ppoll),           SCMP_SYS(brk),
                         SCMP_SYS(munmap),       SCMP_SYS(mremap),          SCMP_SYS(madvise),
                         SCMP_SYS(futex),        SCMP_SYS(clock_gettime),   SCMP_SYS(gettimeofday),
                         SCMP_SYS(time),         SCMP_SYS(clock_getres),    SCMP_SYS(nanosleep),
                         SCMP_SYS(sched_yield),  SCMP_SYS(clock_nanosleep), SCMP_SYS(getrandom),
                         SCMP_SYS(getpid),       SCMP_SYS(gettid),          SCMP_SYS(rt_sigprocmask),
                         SCMP_SYS(rt_sigreturn), SCMP_SYS(restart_syscall), SCMP_SYS(exit),
                         SCMP_SYS(exit_group)};

bool addRules(scmp_filter_ctx filter) {
  bool added = true;
  for (const int call : kFree) added &= seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0) == 0;
  // Memory that is not code, and signals to itself, as abort() sends them.
  const auto no_code = SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0);
  for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mprotect)}) added &= seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 1, no_code) == 0;
  // fstat(), as newer C libraries call it.
  const auto no_path = SCMP_A3(SCMP_CMP_MASKED_EQ, AT_EMPTY_PATH, AT_EMPTY_PATH);
  added &= seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(newfstatat), 1, no_path) == 0;
  const auto self = SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(getpid()));
  added &= seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(tgkill), 1, self) == 0;
  return added;
}

bool filterCalls() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (filter == nullptr) return false;
  const bool loaded = addRules(filter) && seccomp_load(filter) == 0;
  seccomp_release(filter);
  return loaded;
}
#else
bool filterCalls() {
  return false;
}
#endif

/// Ends this process with its parent, and keeps others of the same user, and privileged programs, away from it.
void bindToParent(int parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it ended before the line above
  prctl(PR_SET_DUMPABLE, 0);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
}

}  // namespace

std::string text(const Protection& protection) {
  std::string result = std::string("a process of its own, ") + (protection.limits ? "with limits" : "some limits refused");
  result += protection.seccomp ? ", seccomp" : std::string(", no seccomp (") + kNoSeccomp + ")";
  return result + (protection.landlock ? ", Landlock" : ", no Landlock");
}

Protection confine(std::uint64_t memory, std::uint64_t cpu_seconds, int parent) {
  offerToOutOfMemoryKiller();  // before the process is closed to others, and with it its own files in /proc
  bindToParent(parent);
  std::set_new_handler(endForWantOfMemory);
  Protection result;
  if (!kSanitized) result.landlock = denyPaths();  // needs a descriptor, so before the limits
  result.limits = limitResources(memory, cpu_seconds);
  if (!kSanitized) result.seccomp = filterCalls();
  return result;
}

}  // namespace collision_hulls
