// Lets numbers below the normal range count as zero while an object of this type lives.
//
// The entries of a factor of a large net fall off so fast with distance that many are denormal;
// some processors take a hundred times longer over them, and they mean nothing here.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace retiarius {

class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | kFlush); }
  ~FlushDenormals() { _mm_setcsr(before_); }
#else
  FlushDenormals() = default;
  ~FlushDenormals() {}
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr unsigned kFlush = 0x8040;  // results (FTZ) and operands (DAZ)
  unsigned before_;
#endif
};

}  // namespace retiarius
