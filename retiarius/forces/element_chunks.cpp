#include "retiarius/forces/element_chunks.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>

#include "retiarius/base/parallel.hpp"

namespace retiarius {

namespace {

// Long enough that handing one out costs little, short enough for many: some 10 microseconds.
constexpr std::size_t kLength = 256;
// Chunks that fit no colour before the last run one after the other in colours of their own.
constexpr int kMostColors = 64;

}  // namespace

ElementChunks::ElementChunks(const std::vector<Index>& nodes, std::size_t arity) {
  const std::size_t count = nodes.size() / arity;
  for (std::size_t k = 0; k < count; k += kLength) starts_.push_back(static_cast<long>(k));
  if (count > 0) starts_.push_back(static_cast<long>(count));
  parts_.assign(chunks(), 0.0);
  const Index last = nodes.empty() ? 0 : *std::max_element(nodes.begin(), nodes.end());
  std::vector<std::uint64_t> taken(static_cast<std::size_t>(last) + 1, 0);  // colours at each node
  std::vector<int> color(chunks());
  int next = kMostColors;
  for (std::size_t c = 0; c < chunks(); ++c) {
    const auto* const first = nodes.data() + static_cast<std::size_t>(starts_[c]) * arity;
    const auto* const end = nodes.data() + static_cast<std::size_t>(starts_[c + 1]) * arity;
    std::uint64_t used = 0;
    for (const Index* n = first; n < end; ++n) used |= taken[*n];
    color[c] = std::countr_one(used);
    if (color[c] == kMostColors) {
      color[c] = next++;
      continue;
    }
    for (const Index* n = first; n < end; ++n) taken[*n] |= std::uint64_t{1} << color[c];
  }
  order_.resize(chunks());
  std::iota(order_.begin(), order_.end(), 0);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](Index a, Index b) { return color[a] < color[b]; });
  for (std::size_t k = 0; k < order_.size(); ++k)
    if (k == 0 || color[order_[k]] != color[order_[k - 1]]) color_starts_.push_back(k);
  if (!order_.empty()) color_starts_.push_back(order_.size());
}

double ElementChunks::sum_chunks(const std::function<double(long begin, long end)>& body) const {
  for (std::size_t c = 0; c < colors(); ++c) {
    const std::size_t first = color_starts_[c];
    parallel_for(color_starts_[c + 1] - first, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = first + begin; k < first + end; ++k) {
        const Index chunk = order_[k];
        parts_[chunk] = body(starts_[chunk], starts_[chunk + 1]);
      }
    });
  }
  return std::accumulate(parts_.begin(), parts_.end(), 0.0);
}

}  // namespace retiarius
