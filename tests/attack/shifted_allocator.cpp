// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors

// An allocator that is loaded before a program (LD_PRELOAD), whose addresses are multiples of 16 bytes, but of 32 and
// 64 bytes only by chance: sums that depend on the alignment of their data then differ between seeds
// (GONIO_SHIFT_SEED). Only what asks for a larger alignment gets it.
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

// Of glibc: its own allocator under other names.
extern "C" void* __libc_memalign(std::size_t alignment, std::size_t size);
extern "C" void __libc_free(void* address);

namespace {

/// Before each address that the program gets.
struct Header {
  void* base;
  std::size_t size;
};
static_assert(sizeof(Header) == 16);

Header& headerOf(void* address) { return static_cast<Header*>(address)[-1]; }

/// Xorshift (Marsaglia 2003), one per thread; not by an address, which would differ from run to run.
std::uint64_t nextRandom() {
  static std::atomic<std::uint64_t> threads = 0;
  thread_local std::uint64_t state = 0;
  if (state == 0) {
    const char* seed = std::getenv("GONIO_SHIFT_SEED");
    state = 0x9E3779B97F4A7C15u * (1 + (seed ? std::strtoull(seed, nullptr, 10) : 0)) + ++threads;
  }
  state ^= state << 13;
  state ^= state >> 7;
  return state ^= state << 17;
}

void* allocate(std::size_t size, std::size_t alignment) {
  constexpr std::size_t line = 64;
  const std::size_t margin = alignment > line ? alignment : 2 * line;
  if (size > SIZE_MAX - margin) return nullptr;
  auto* base = static_cast<char*>(__libc_memalign(alignment > line ? alignment : line, size + margin));
  if (!base) return nullptr;
  const std::size_t step = alignment < 16 ? 16 : alignment;
  const std::size_t choices = step < line ? line / step : 1;
  char* address = base + (step < line ? line + step * ((nextRandom() >> 32) % choices) : margin);
  headerOf(address) = {base, size};
  return address;
}

void* orError(void* address) {
  if (!address) errno = ENOMEM;
  return address;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) { return orError(allocate(size, 16)); }

void free(void* address) {
  if (address) __libc_free(headerOf(address).base);
}

void* calloc(std::size_t count, std::size_t size) {
  std::size_t bytes = 0;
  void* address = __builtin_mul_overflow(count, size, &bytes) ? nullptr : allocate(bytes, 16);
  return address ? std::memset(address, 0, bytes) : orError(nullptr);
}

void* realloc(void* old, std::size_t size) {
  if (old && size == 0) {
    free(old);
    return nullptr;
  }
  void* address = malloc(size);
  if (!address || !old) return address;
  const std::size_t before = headerOf(old).size;
  std::memcpy(address, old, before < size ? before : size);
  free(old);
  return address;
}

void* reallocarray(void* old, std::size_t count, std::size_t size) {
  std::size_t bytes = 0;
  return __builtin_mul_overflow(count, size, &bytes) ? orError(nullptr) : realloc(old, bytes);
}

void* memalign(std::size_t alignment, std::size_t size) { return orError(allocate(size, alignment)); }
void* aligned_alloc(std::size_t alignment, std::size_t size) { return orError(allocate(size, alignment)); }
void* valloc(std::size_t size) { return orError(allocate(size, 4096)); }

int posix_memalign(void** address, std::size_t alignment, std::size_t size) {
  void* found = allocate(size, alignment);
  if (!found) return ENOMEM;
  *address = found;
  return 0;
}

std::size_t malloc_usable_size(void* address) { return address ? headerOf(address).size : 0; }
}
