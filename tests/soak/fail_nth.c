/* SPDX-License-Identifier: GPL-3.0-or-later
 * Preloaded into the program by soak.py. Of the allocations of FAIL_SIZE bytes or more, number
 * FAIL_ALLOCATION and all after it fail; of the calls of write(), number FAIL_WRITE and all after
 * it, but for those to the terminal's files 0 to 2, fail as on a full disk. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <unistd.h>

static long setting(const char* name, long otherwise) {
  const char* text = getenv(name);
  return text ? atol(text) : otherwise;
}

/* Counted down; settings are read once, since getenv() may not be called from every allocation. */
static atomic_long allocations_left, writes_left;
static long least_size = -1;

__attribute__((constructor)) static void read_settings(void) {
  allocations_left = setting("FAIL_ALLOCATION", 0);
  writes_left = setting("FAIL_WRITE", 0);
  least_size = setting("FAIL_SIZE", 1 << 20);
}

static int is_due(atomic_long* left) {
  if (atomic_load(left) <= 0) return 0; /* not asked for */
  if (atomic_load(left) == 1) return 1; /* this one, and all after it */
  atomic_fetch_sub(left, 1);
  return 0;
}

static int fails(size_t size) {
  return least_size >= 0 && size >= (size_t)least_size && is_due(&allocations_left);
}

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);

static void* none(void) {
  errno = ENOMEM;
  return NULL;
}

void* malloc(size_t size) { return fails(size) ? none() : __libc_malloc(size); }
void* calloc(size_t count, size_t size) {
  return fails(count * size) ? none() : __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) { return fails(size) ? none() : __libc_realloc(old, size); }
void* aligned_alloc(size_t alignment, size_t size) {
  return fails(size) ? none() : __libc_memalign(alignment, size);
}
int posix_memalign(void** result, size_t alignment, size_t size) {
  if (fails(size)) return ENOMEM;
  *result = __libc_memalign(alignment, size);
  return *result ? 0 : ENOMEM;
}

ssize_t write(int file, const void* data, size_t size) {
  static ssize_t (*real)(int, const void*, size_t);
  if (!real) real = (ssize_t(*)(int, const void*, size_t))dlsym(RTLD_NEXT, "write");
  if (file > 2 && is_due(&writes_left)) {
    errno = ENOSPC;
    return -1;
  }
  return real(file, data, size);
}
