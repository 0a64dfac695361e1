#include <__verbose_abort>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

// Exceptions and memory without the runtime of C++ exceptions, which Debian has not for WebAssembly. Sources are
// compiled with -fignore-exceptions: a throw calls the functions below, and no frame catches. The throw of JavaScript
// unwinds the frames of WebAssembly, and JavaScript drops the instance, whose memory is in any state then.

namespace {

/// Throws in JavaScript. \param type the mangled name of the exception's type \param what its message; both end with 0
[[noreturn]] __attribute__((import_module("whittle"), import_name("raise"))) void raise(const char* type,
                                                                                        const char* what);

void* memory_of(std::size_t size) {
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) raise("St9bad_alloc", "out of memory");
  return memory;
}

void* aligned_memory_of(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  void* const memory = std::aligned_alloc(step, (size + step - 1) / step * step);
  if (memory == nullptr) raise("St9bad_alloc", "out of memory");
  return memory;
}

}  // namespace

extern "C" {

void* __cxa_allocate_exception(std::size_t size) { return memory_of(size); }

void __cxa_free_exception(void* exception) { std::free(exception); }

/// \pre the exception is a std::exception, as all of Whittle and of the standard library are
[[noreturn]] void __cxa_throw(void* exception, std::type_info* type, void (*)(void*)) {
  raise(type->name(), static_cast<const std::exception*>(exception)->what());
}

/// How libc++abi ends a program. Its own prints, which takes all of printf.
[[noreturn]] void abort_message(const char* format, ...) { raise("abort", format); }

}  // extern "C"

/// How libc++ does.
void std::__libcpp_verbose_abort(const char* format, ...) { raise("abort", format); }

void* operator new(std::size_t size) { return memory_of(size); }
void* operator new[](std::size_t size) { return memory_of(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return aligned_memory_of(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return aligned_memory_of(size, alignment); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
