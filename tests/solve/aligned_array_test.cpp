#include "retiarius/solve/aligned_array.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace retiarius {
namespace {

TEST(AlignedArray, StandsOnCacheLinesAndLargeOnesOnHugePages) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1001},
                                 std::size_t{262144}, std::size_t{300001}}) {
    AlignedArray array;
    array.resize(size);
    EXPECT_EQ(array.size(), size);
    const auto address = reinterpret_cast<std::uintptr_t>(array.data());
    EXPECT_EQ(address % (size * sizeof(double) >= 2097152 ? 2097152 : 64), 0u) << size;
    for (std::size_t k = 0; k < size; ++k) array.data()[k] = static_cast<double>(k);
    if (size > 0) {
      EXPECT_EQ(array.data()[size - 1], static_cast<double>(size - 1));
    }
  }
}

TEST(AlignedArray, KeepsItsMemoryWhileTheSizeStays) {
  AlignedArray array;
  array.resize(100);
  array.data()[99] = 7.0;
  const double* before = array.data();
  array.resize(100);
  EXPECT_EQ(array.data(), before);
  EXPECT_EQ(array.data()[99], 7.0);
  array.resize(0);
  EXPECT_EQ(array.size(), 0u);
}

}  // namespace
}  // namespace retiarius
