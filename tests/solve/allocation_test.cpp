// Replaces operator new of this test program by one that counts.
#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "retiarius/base/parallel.hpp"
#include "retiarius/solve/linear_solver.hpp"
#include "tests/solve/graphs.hpp"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* p = alignment == 0
                ? std::malloc(size == 0 ? 1 : size)
                : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (p == nullptr) throw std::bad_alloc();
  return p;
}
}  // namespace

void* operator new(std::size_t size) { return counted(size, 0); }
void* operator new[](std::size_t size) { return counted(size, 0); }
void* operator new(std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace retiarius {
namespace {

TEST(Allocation, IsCounted) {
  const long before = allocations;
  std::vector<Vec3> x(100);
  EXPECT_GT(allocations, before) << "the counting operator new is not in use";
  EXPECT_EQ(x.size(), 100u);
}

TEST(Allocation, FactorAndSolveDoNone) {
  set_threads(1);
  for (const auto make : {make_multifrontal_solver, make_piece_solver}) {
    const BlockPattern pattern = test::hexagon_net(8, 4, test::Bend::hinged);
    const BlockMatrix matrix = test::random_matrix(pattern, 1);
    std::vector<Vec3> x = test::random_vector(pattern.blocks(), 2);
    std::vector<Vec3> seven = test::random_vector(7 * pattern.blocks(), 3);
    const auto solver = make();
    solver->analyse(pattern);
    ASSERT_TRUE(solver->factor(matrix));
    solver->solve(x);
    solver->solve(seven);
    const long before = allocations;
    bool good = true;
    for (int repeat = 0; repeat < 3; ++repeat) {
      good = good && solver->factor(matrix);
      solver->solve(x);
      solver->solve(seven);
    }
    EXPECT_EQ(allocations, before);
    EXPECT_TRUE(good);
  }
}

}  // namespace
}  // namespace retiarius
