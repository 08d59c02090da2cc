// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <jemalloc/jemalloc.h>

/// Settings that jemalloc reads when the program starts. Opening materials and moving sliders allocate and free
/// gigabytes around small blocks that stay. With glibc's allocator, these blocks pin the pages that they share with
/// freed memory: after an hour of random actions, the resident memory of a window at rest was 13 % larger than after
/// ten minutes, while the memory in use was only 3 % larger. jemalloc keeps blocks of different sizes apart, and
/// returns unused pages to the system after five seconds. Two arenas, because tables that one thread allocates are
/// often freed by another one. Tables of more than 8 MB would return their pages at once (oversize_threshold), and each
/// new page costs a fault: encoding a material took twice the time. Large pages have fewer faults.
const char* malloc_conf =
    "narenas:2,background_thread:true,dirty_decay_ms:5000,muzzy_decay_ms:0,oversize_threshold:0,thp:always";
