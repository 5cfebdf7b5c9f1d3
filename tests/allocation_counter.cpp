#include "allocation_counter.hpp"

#include <cstdlib>

namespace {

bool counting = false;
long allocations = 0;

}  // namespace

// Eigen takes its memory from malloc, the standard library from operator new, which calls malloc: this
// program's own malloc counts both, and hands on to the C library's.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CONTENSOU_COUNTS_ALLOCATIONS 1
extern "C" {
void* malloc(std::size_t size) noexcept {
  if (counting) ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  if (counting) ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  if (counting) ++allocations;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  if (counting) ++allocations;
  return __libc_memalign(alignment, size);
}
}
#endif

namespace allocation_counter {

bool available() {
#ifdef CONTENSOU_COUNTS_ALLOCATIONS
  return true;
#else
  return false;
#endif
}
void start() { counting = true; }
void stop() { counting = false; }
long count() { return allocations; }
void reset() { allocations = 0; }

}  // namespace allocation_counter
