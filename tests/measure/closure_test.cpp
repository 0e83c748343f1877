#include "retiarius/measure/closure.hpp"

#include <gtest/gtest.h>

namespace retiarius {
namespace {

Readings mouth(double area, double vector_area, double width) {
  Readings r;
  r.mouth_area = area;
  r.mouth_vector_area = vector_area;
  r.mouth_width = width;
  return r;
}

const Readings kShut = mouth(4.9, 4.9, 0.99);  // of a flat mouth of 100 m2 and 10 m

Closure watching() {
  Closure closure(100.0, 10.0);
  closure.set_prescribed(0.0, false);
  return closure;
}

TEST(Closure, NeedsHalfASecond) {
  Closure closure = watching();
  for (int k = 0; k <= 49; ++k) {
    closure.see(1.0 + 0.01 * k, kShut);
    EXPECT_FALSE(closure.closed()) << k;
  }
  closure.see(1.5, kShut);
  EXPECT_TRUE(closure.closed());
}

TEST(Closure, NeedsAllThreeMeasuresSmall) {
  for (const Readings& r : {mouth(5.0, 4.9, 0.99), mouth(4.9, 5.0, 0.99), mouth(4.9, 4.9, 1.0)}) {
    Closure closure = watching();
    for (int k = 0; k <= 100; ++k) closure.see(0.01 * k, r);
    EXPECT_FALSE(closure.closed());
  }
}

TEST(Closure, StartsAnewWhenTheMouthOpens) {
  Closure closure = watching();
  closure.see(0.0, kShut);
  closure.see(0.6, kShut);
  EXPECT_TRUE(closure.closed());
  closure.see(0.7, mouth(50.0, 50.0, 7.0));
  EXPECT_FALSE(closure.closed());
  closure.see(0.8, kShut);
  closure.see(1.2, kShut);
  EXPECT_FALSE(closure.closed());
  closure.see(1.3, kShut);
  EXPECT_TRUE(closure.closed());
}

TEST(Closure, DoesNotCountWhileSomethingHoldsItShut) {
  Closure closure = watching();
  closure.set_prescribed(0.1, true);
  closure.see(0.1, kShut);
  closure.see(2.0, kShut);
  EXPECT_FALSE(closure.closed());
  closure.set_prescribed(2.0, false);
  closure.see(2.4, kShut);
  EXPECT_FALSE(closure.closed());
  closure.set_prescribed(2.4, false);  // saying it again changes nothing
  closure.see(2.5, kShut);
  EXPECT_TRUE(closure.closed());
}

}  // namespace
}  // namespace retiarius
