// SPDX-License-Identifier: MIT
// Preloaded into a program, counts the bytes that it and each library have allocated and not given back: whoever calls
// malloc, operator new and their like is charged. After every so many files that get their name (rename) a line goes to
// a log: how many, bytes of the program itself, bytes of all others, and the largest of these by name (Linux, glibc).
//
//   STRAHL_MEMORY_LOG     the log
//   STRAHL_MEMORY_EVERY   files a line
#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
void __libc_free(void*);
}

namespace {

struct Module {
  std::uintptr_t begin, end;
  char name[64];
  long live;
};
std::array<Module, 128> modules{};  // The program itself is the first.
std::size_t module_count = 0;

struct Block {
  void* at;
  std::uint32_t module;
  std::size_t bytes;
};
constexpr std::size_t slots = std::size_t{1} << 22;
Block blocks[slots];
void* const removed = reinterpret_cast<void*>(1);

std::atomic_flag busy = ATOMIC_FLAG_INIT;
class Lock {
 public:
  Lock() {
    while (busy.test_and_set(std::memory_order_acquire))
      ;
  }
  ~Lock() { busy.clear(std::memory_order_release); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
};

int add_module(dl_phdr_info* info, size_t, void*) {
  Module module{UINTPTR_MAX, 0, {}, 0};
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    if (info->dlpi_phdr[i].p_type != PT_LOAD) continue;
    const std::uintptr_t begin = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
    module.begin = std::min(module.begin, begin);
    module.end = std::max<std::uintptr_t>(module.end, begin + info->dlpi_phdr[i].p_memsz);
  }
  for (std::size_t i = 0; i < module_count; ++i)
    if (modules[i].begin == module.begin) return 0;
  if (module_count == modules.size()) std::abort();
  const char* slash = std::strrchr(info->dlpi_name, '/');
  std::snprintf(module.name, sizeof module.name, "%s", slash != nullptr ? slash + 1 : info->dlpi_name);
  modules[module_count++] = module;
  return 0;
}

/// Index of the module that the address is in; code that was made while it ran has none and is charged to the last.
std::uint32_t module_of(const void* address) {
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  for (int tries = 0; tries < 2; ++tries) {
    for (std::size_t i = 0; i < module_count; ++i)
      if (at >= modules[i].begin && at < modules[i].end) return static_cast<std::uint32_t>(i);
    dl_iterate_phdr(add_module, nullptr);
  }
  return static_cast<std::uint32_t>(module_count - 1);
}

std::size_t slot_of(const void* at) {
  return static_cast<std::size_t>((reinterpret_cast<std::uintptr_t>(at) >> 4) * 0x9e3779b97f4a7c15U >> 42U) % slots;
}

void* counted(void* at, std::size_t bytes, const void* caller) {
  if (at == nullptr) return at;
  const Lock lock;
  const std::uint32_t module = module_of(caller);
  modules[module].live += static_cast<long>(bytes);
  std::size_t slot = slot_of(at);
  for (std::size_t tries = 0; blocks[slot].at != nullptr && blocks[slot].at != removed; slot = (slot + 1) % slots)
    if (++tries == slots) std::abort();
  blocks[slot] = {at, module, bytes};
  return at;
}

void uncount(const void* at) {
  if (at == nullptr) return;
  const Lock lock;
  for (std::size_t slot = slot_of(at); blocks[slot].at != nullptr; slot = (slot + 1) % slots) {
    if (blocks[slot].at != at) continue;
    modules[blocks[slot].module].live -= static_cast<long>(blocks[slot].bytes);
    // A run of removed ones that ends in nothing is nothing.
    const bool ends = blocks[(slot + 1) % slots].at == nullptr;
    blocks[slot].at = ends ? nullptr : removed;
    for (std::size_t before = (slot + slots - 1) % slots; ends && blocks[before].at == removed;
         before = (before + slots - 1) % slots)
      blocks[before].at = nullptr;
    return;
  }
}

void write_line(long files) {
  char line[1024];
  long others = 0;
  std::array<const Module*, modules.size()> order{};
  int size = 0;
  {
    const Lock lock;
    for (std::size_t i = 0; i < module_count; ++i) {
      if (i > 0) others += modules[i].live;
      order[i] = &modules[i];
    }
    std::sort(order.begin() + 1, order.begin() + static_cast<std::ptrdiff_t>(module_count),
              [](const Module* a, const Module* b) { return a->live > b->live; });
    size = std::snprintf(line, sizeof line, "%ld %ld %ld", files, modules[0].live, others);
    for (std::size_t i = 1; i < std::min<std::size_t>(module_count, 6); ++i)
      size += std::snprintf(line + size, sizeof line - static_cast<std::size_t>(size), " %s=%ld", order[i]->name,
                            order[i]->live);
  }
  line[size++] = '\n';
  const int log = ::open(std::getenv("STRAHL_MEMORY_LOG"), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (log < 0 || ::write(log, line, static_cast<std::size_t>(size)) != size) std::abort();
  ::close(log);
}

}  // namespace

extern "C" {

void* malloc(size_t bytes) { return counted(__libc_malloc(bytes), bytes, __builtin_return_address(0)); }
void* calloc(size_t count, size_t bytes) {
  return counted(__libc_calloc(count, bytes), count * bytes, __builtin_return_address(0));
}
void* realloc(void* old, size_t bytes) {
  uncount(old);
  return counted(__libc_realloc(old, bytes), bytes, __builtin_return_address(0));
}
void* memalign(size_t alignment, size_t bytes) {
  return counted(__libc_memalign(alignment, bytes), bytes, __builtin_return_address(0));
}
void* aligned_alloc(size_t alignment, size_t bytes) {
  return counted(__libc_memalign(alignment, bytes), bytes, __builtin_return_address(0));
}
int posix_memalign(void** at, size_t alignment, size_t bytes) {
  *at = counted(__libc_memalign(alignment, bytes), bytes, __builtin_return_address(0));
  return *at == nullptr ? ENOMEM : 0;
}
void free(void* at) {
  uncount(at);
  __libc_free(at);
}

int rename(const char* from, const char* to) {
  static const auto real = reinterpret_cast<int (*)(const char*, const char*)>(::dlsym(RTLD_NEXT, "rename"));
  static std::atomic<long> files{0};
  const int code = real(from, to);
  const char* every = std::getenv("STRAHL_MEMORY_EVERY");
  if (const long now = ++files; every != nullptr && now % std::atol(every) == 0) write_line(now);
  return code;
}
}

// Those of libstdc++ call malloc, and it would be charged. The others end in these.
void* operator new(size_t bytes) {
  void* const at = counted(__libc_malloc(bytes), bytes, __builtin_return_address(0));
  if (at == nullptr) throw std::bad_alloc();
  return at;
}
void* operator new[](size_t bytes) {
  void* const at = counted(__libc_malloc(bytes), bytes, __builtin_return_address(0));
  if (at == nullptr) throw std::bad_alloc();
  return at;
}
void operator delete(void* at) noexcept { free(at); }
void operator delete[](void* at) noexcept { free(at); }
void operator delete(void* at, size_t) noexcept { free(at); }
void operator delete[](void* at, size_t) noexcept { free(at); }
