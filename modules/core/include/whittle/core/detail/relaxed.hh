#pragma once

#include <atomic>
#include <type_traits>

// Numbers that several threads read and write at a time, without an order between them: `std::atomic_ref` with relaxed
// order, and the compilers' functions for standard libraries that haven't it (LLVM's up to version 18).

namespace whittle::detail {

#ifdef __cpp_lib_atomic_ref

template <class Number>
Number load_relaxed(Number& from) {
  return std::atomic_ref(from).load(std::memory_order_relaxed);
}
template <class Number>
void store_relaxed(Number& to, std::type_identity_t<Number> value) {
  std::atomic_ref(to).store(value, std::memory_order_relaxed);
}
/// \return the number before
template <class Number>
Number fetch_or_relaxed(Number& to, std::type_identity_t<Number> bits) {
  return std::atomic_ref(to).fetch_or(bits, std::memory_order_relaxed);
}

#else

template <class Number>
Number load_relaxed(Number& from) {
  return __atomic_load_n(&from, __ATOMIC_RELAXED);
}
template <class Number>
void store_relaxed(Number& to, std::type_identity_t<Number> value) {
  __atomic_store_n(&to, value, __ATOMIC_RELAXED);
}
template <class Number>
Number fetch_or_relaxed(Number& to, std::type_identity_t<Number> bits) {
  return __atomic_fetch_or(&to, bits, __ATOMIC_RELAXED);
}

#endif

}  // namespace whittle::detail
