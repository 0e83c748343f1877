// Storage of factors: uninitialised scalars on cache lines, large ones on huge pages.
#pragma once

#include <cstddef>
#include <memory>

namespace retiarius {

class AlignedArray {
 public:
  // Contents are lost unless the size stays.
  void resize(std::size_t size);

  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }
  std::size_t size() const { return size_; }

 private:
  struct Free {
    std::size_t alignment;
    void operator()(double* p) const;
  };
  std::unique_ptr<double[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace retiarius
