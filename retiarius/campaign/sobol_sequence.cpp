#include "retiarius/campaign/sobol_sequence.hpp"

#include "retiarius/base/random.hpp"
#include "retiarius/campaign/sobol_numbers.hpp"

namespace retiarius {

namespace {

int degree(std::uint32_t polynomial) {
  int result = -1;
  for (; polynomial != 0; polynomial >>= 1) ++result;
  return result;
}

// m_i = 2 a_1 m_(i-1) ^ 4 a_2 m_(i-2) ^ ... ^ 2^s m_(i-s) ^ m_(i-s), for the polynomial
// x^s + a_1 x^(s-1) + ... + 1 (Bratley & Fox 1988).
std::array<std::uint32_t, SobolSequence::kDigits> directions_of(std::uint32_t polynomial,
                                                                const SobolNumbers& initial) {
  std::array<std::uint32_t, SobolSequence::kDigits> m{};
  const int s = degree(polynomial);
  for (int i = 0; i < SobolSequence::kDigits; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (i < s) {
      m[at] = initial[at];
      continue;
    }
    const std::uint32_t oldest = m[static_cast<std::size_t>(i - s)];
    m[at] = oldest ^ (oldest << s);
    for (int k = 1; k < s; ++k)
      if ((polynomial >> (s - k) & 1u) != 0) m[at] ^= m[static_cast<std::size_t>(i - k)] << k;
  }
  for (int i = 0; i < SobolSequence::kDigits; ++i)
    m[static_cast<std::size_t>(i)] <<= SobolSequence::kDigits - 1 - i;
  return m;
}

}  // namespace

// x generates all 2^s - 1 residues and returns to 1 only then.
bool is_primitive(std::uint32_t polynomial) {
  const int s = degree(polynomial);
  if (s < 1 || (polynomial & 1u) == 0) return false;
  const std::uint32_t order = (std::uint32_t{1} << s) - 1;
  std::uint32_t power = 1;
  for (std::uint32_t k = 1; k <= order; ++k) {
    power <<= 1;
    if ((power >> s & 1u) != 0) power ^= polynomial;
    if (power == 1) return k == order;
  }
  return false;
}

SobolSequence::SobolSequence() {
  for (int i = 0; i < kDigits; ++i)
    directions_[0][static_cast<std::size_t>(i)] = std::uint32_t{1} << (kDigits - 1 - i);
  std::uint32_t polynomial = 3;
  for (std::size_t d = 1; d < kDimensions; ++d, polynomial += 2) {
    while (!is_primitive(polynomial)) polynomial += 2;
    directions_[d] = directions_of(polynomial, kSobolNumbers[d - 1]);
  }
}

std::uint32_t SobolSequence::digits(std::uint64_t index, int dimension) const {
  const auto& directions = directions_[static_cast<std::size_t>(dimension)];
  std::uint32_t result = 0;
  for (std::size_t i = 0; i < kDigits; ++i)
    if ((index >> i & 1u) != 0) result ^= directions[i];
  return result;
}

double SobolSequence::scrambled(std::uint64_t index, int dimension, std::uint64_t seed) const {
  const std::uint32_t plain = digits(index, dimension);
  const auto stream = static_cast<std::uint64_t>(dimension);
  std::uint32_t result = 0;
  std::uint64_t before = 1;  // the digits so far, after a leading one
  for (int bit = kDigits - 1; bit >= 0; --bit) {
    const std::uint32_t digit = plain >> bit & 1u;
    const auto flip = static_cast<std::uint32_t>(random_bits(seed, stream, before) >> 63);
    result |= (digit ^ flip) << bit;
    before = before << 1 | digit;
  }
  const double below = random_uniform(seed, stream + (std::uint64_t{1} << 32), index);
  // Its last digits are cut, so that the sum never rounds up to 1.
  const double rest = static_cast<double>(static_cast<std::uint32_t>(below * 0x1.0p20)) * 0x1.0p-20;
  return (static_cast<double>(result) + rest) * 0x1.0p-32;
}

}  // namespace retiarius
