// Memory in large pages: most of the cost of new memory is per page.
#pragma once

namespace collision_hulls {

/// The environment variable by which takeLargePages() asks: pages of 2 MB; memory taken in pieces of 4 MB, blocks up to 32 MB from it, and
/// none of it given back. That suits our programs; others are started without it.
constexpr char kLargePages[] =
    "GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.top_pad=4194304:glibc.malloc.mmap_threshold=33554432:"
    "glibc.malloc.trim_threshold=1000000000";

/// To be called first in main(), with its arguments. Where the kernel gives large pages to those who ask for them (Linux; "madvise" in
/// /sys/kernel/mm/transparent_hugepage/enabled), the C library (glibc) has to be told before the program starts: this starts it again,
/// once, with GLIBC_TUNABLES set, and keeps memory that was freed. Does nothing if the variable is set, to whatever, if memory is limited
/// to less than 1 GiB, or if the kernel gives large pages to everyone or to nobody.
void takeLargePages(char** arguments);

/// Gives the system the memory that all threads have freed, which otherwise stays with the process in pieces that may not suit what comes
/// next. For the end of a stage that took much. Takes milliseconds, and some more where the memory is taken again. Does nothing without
/// glibc.
void giveBackFreedMemory();

}  // namespace collision_hulls
