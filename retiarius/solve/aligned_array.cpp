#include "retiarius/solve/aligned_array.hpp"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace retiarius {

namespace {
constexpr std::size_t kLine = 64;
constexpr std::size_t kHugePage = std::size_t{1} << 21;
}  // namespace

void AlignedArray::resize(std::size_t size) {
  if (size == size_) return;
  data_.reset();
  size_ = 0;
  std::size_t bytes = size * sizeof(double);
  const std::size_t alignment = bytes >= kHugePage ? kHugePage : kLine;
  bytes = (bytes + alignment - 1) / alignment * alignment;
  void* memory = ::operator new[](bytes, std::align_val_t{alignment});
  data_ = {static_cast<double*>(memory), Free{alignment}};
  size_ = size;
#ifdef __linux__
  // Advice only: a kernel without huge pages goes on with small ones.
  if (alignment == kHugePage) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
}

void AlignedArray::Free::operator()(double* p) const {
  ::operator delete[](p, std::align_val_t{alignment});
}

}  // namespace retiarius
