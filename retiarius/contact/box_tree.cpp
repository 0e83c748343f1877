#include "retiarius/contact/box_tree.hpp"

#include <algorithm>
#include <bit>

namespace retiarius {
namespace {

// The lowest 21 bits of k with two zeros between any two of them.
std::uint64_t spread_bits(std::uint64_t k) {
  k = (k | k << 32) & 0x001F00000000FFFFull;
  k = (k | k << 16) & 0x001F0000FF0000FFull;
  k = (k | k << 8) & 0x100F00F00F00F00Full;
  k = (k | k << 4) & 0x10C30C30C30C30C3ull;
  k = (k | k << 2) & 0x1249249249249249ull;
  return k;
}

// Place along a Morton curve through the cube at `corner` with this many cells a metre.
std::uint64_t morton_key(const Vec3& point, const Vec3& corner, double cells) {
  constexpr double kLast = 2097151.0;
  std::uint64_t key = 0;
  for (int k = 0; k < 3; ++k) {
    const double cell = std::clamp((point[k] - corner[k]) * cells, 0.0, kLast);
    key |= spread_bits(static_cast<std::uint64_t>(cell)) << k;
  }
  return key;
}

bool is_usable(const Box& box) {
  return box.min().allFinite() && box.max().allFinite() && !box.isEmpty();
}

}  // namespace

void BoxTree::build(const std::vector<Box>& boxes) {
  Box centers;
  for (const Box& box : boxes)
    if (is_usable(box)) centers.extend(box.center());
  keys_.clear();
  const double width = centers.isEmpty() ? 0.0 : centers.sizes().maxCoeff();
  const double cells = width > 0.0 ? 2097152.0 / width : 0.0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (is_usable(boxes[k]))
      keys_.emplace_back(morton_key(boxes[k].center(), centers.min(), cells),
                         static_cast<Index>(k));
  }
  std::sort(keys_.begin(), keys_.end());
  order_.resize(keys_.size());
  if (keys_.empty()) return;
  leaves_ = std::bit_ceil(keys_.size());
  nodes_.assign(2 * leaves_, Box());
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    order_[k] = keys_[k].second;
    nodes_[leaves_ + k] = boxes[static_cast<std::size_t>(order_[k])];
  }
  for (std::size_t node = leaves_ - 1; node >= 1; --node)
    nodes_[node] = nodes_[2 * node].merged(nodes_[2 * node + 1]);
}

}  // namespace retiarius
