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
#include "base/sanitizer.h"
#include "sandbox/wire.h"

#if __has_include(<linux/landlock.h>)
#include <linux/landlock.h>
#endif
#ifdef COLLISION_HULLS_SECCOMP
#include <seccomp.h>
#endif

namespace collision_hulls {
namespace {

#ifdef COLLISION_HULLS_SECCOMP
constexpr const char* kNoSeccomp = kSanitized ? "built with a sanitizer" : "refused by the kernel";
#else
constexpr const char* kNoSeccomp = kSanitized ? "built with a sanitizer" : "built without libseccomp";
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

bool limitResources(const WorkerLimits& limits) {
  bool done = limit(RLIMIT_CORE, 0);
  done &= limit(RLIMIT_CPU, limits.cpu_seconds, limits.cpu_seconds + 1);  // the soft limit sends SIGXCPU, which says why
  done &= limit(RLIMIT_FSIZE, 0);
  done &= limit(RLIMIT_NPROC, 0);
  done &= limit(RLIMIT_MEMLOCK, 0);
  if (kSanitized) return done;
  done &= limit(RLIMIT_NOFILE, 0);  // what is open stays open
  done &= limit(RLIMIT_AS, limits.memory);
  return done;
}

/// Where memory ends for the whole machine, the kernel shall end this process and not the one that asked.
void offerToOutOfMemoryKiller() {
  const Descriptor file(open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC));
  if (file.number() >= 0 && write(file.number(), "1000", 4) < 0) return;  // without it the limits still hold
}

/// Ends the process before a parser can take the failure for a fault of the file.
[[noreturn]] void endForWantOfMemory() {
  _exit(kWorkerOutOfMemory);
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
/// What computing, and reading and writing what is open, may call; by name, as not every machine has every call.
constexpr const char* kFree[] = {"read",         "readv",         "pread64",         "write",        "writev",
                                 "close",        "lseek",         "_llseek",         "fstat",        "fstat64",
                                 "brk",          "munmap",        "mremap",          "madvise",      "futex",
                                 "futex_time64", "clock_gettime", "clock_gettime64", "clock_getres", "gettimeofday",
                                 "time",         "nanosleep",     "clock_nanosleep", "sched_yield",  "getrandom",
                                 "getpid",       "gettid",        "rt_sigprocmask",  "rt_sigreturn", "restart_syscall",
                                 "exit",         "exit_group"};

/// Lets a call through, under a condition. Where that fails, the call fails later, which is the safe side.
template <typename... Conditions>
void allow(scmp_filter_ctx filter, const char* name, const Conditions&... conditions) {
  const int call = seccomp_syscall_resolve_name(name);
  if (call != __NR_SCMP_ERROR) seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, sizeof...(conditions), conditions...);
}

void addRules(scmp_filter_ctx filter) {
  for (const char* const name : kFree) allow(filter, name);
  const auto no_code = SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0);
  for (const char* const name : {"mmap", "mmap2", "mprotect"}) allow(filter, name, no_code);
  const auto no_path = SCMP_A3(SCMP_CMP_MASKED_EQ, AT_EMPTY_PATH, AT_EMPTY_PATH);
  for (const char* const name : {"newfstatat", "fstatat64"}) allow(filter, name, no_path);  // fstat() of newer C libraries
  // Not those that make a descriptor send signals to others.
  for (const char* const name : {"fcntl", "fcntl64"})
    for (const int command : {F_GETFD, F_SETFD, F_GETFL}) allow(filter, name, SCMP_A1(SCMP_CMP_EQ, static_cast<scmp_datum_t>(command)));
  allow(filter, "tgkill", SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(getpid())));  // abort()
}

bool filterCalls() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (filter == nullptr) return false;
  addRules(filter);
  const bool loaded = seccomp_load(filter) == 0;
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
  std::string result = std::string("a process of its own, confined by ") +
                       (protection.limits ? "resource limits" : "some resource limits (others were refused)");
  result += protection.seccomp ? ", seccomp" : std::string(", no seccomp (") + kNoSeccomp + ")";
  return result + (protection.landlock ? ", Landlock" : ", no Landlock");
}

Protection confine(const WorkerLimits& limits, int parent) {
  offerToOutOfMemoryKiller();  // before the process is closed to others, and with it its own files in /proc
  bindToParent(parent);
  std::set_new_handler(endForWantOfMemory);
  Protection result;
  if (!kSanitized) result.landlock = denyPaths();  // needs a descriptor, so before the limits
  result.limits = limitResources(limits);
  if (!kSanitized) result.seccomp = filterCalls();
  return result;
}

}  // namespace collision_hulls
