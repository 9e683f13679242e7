// SPDX-License-Identifier: MIT
// Preloaded into a program, has no memory for blocks of one size, as operator new is asked for (Linux).
//
//   STRAHL_FAULT_BYTES   the size
//   STRAHL_FAULT_FIRST   the first block of that size that is refused, from 1; all later ones are, too
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

long number_of(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::atol(value) : 0;
}

}  // namespace

void* operator new(std::size_t bytes) {
  static const long refused = number_of("STRAHL_FAULT_BYTES"), first = number_of("STRAHL_FAULT_FIRST");
  static std::atomic<long> blocks{0};
  if (static_cast<long>(bytes) == refused && ++blocks >= first) throw std::bad_alloc();
  void* const at = std::malloc(bytes != 0 ? bytes : 1);
  if (at == nullptr) throw std::bad_alloc();
  return at;
}
void operator delete(void* at) noexcept { std::free(at); }
void operator delete(void* at, std::size_t) noexcept { std::free(at); }
