// Numbers that begin on a cache line, so that whole vectors of them never lie across two.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace retiarius {

template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kLine{64};

  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>& /*other*/) {}  // NOLINT(google-explicit-constructor)

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), kLine));
  }
  void deallocate(T* p, std::size_t /*count*/) { ::operator delete(p, kLine); }
  friend bool operator==(const LineAllocator& /*a*/, const LineAllocator& /*b*/) { return true; }
};

using LineVector = std::vector<double, LineAllocator<double>>;

}  // namespace retiarius
