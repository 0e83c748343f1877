// Splits a law's elements so that several threads can add them up without meeting.
#pragma once

#include <functional>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

// Consecutive elements in chunks of fixed length, and chunks in colours: chunks of one colour share
// no node, so they may be added at the same time, colour after colour. Neither depends on the
// number of threads, so sums are the same bit for bit.
class ElementChunks {
 public:
  ElementChunks() = default;
  // nodes: those of element k at [k * arity, (k + 1) * arity).
  ElementChunks(const std::vector<Index>& nodes, std::size_t arity);

  // Sum of what `body` returns for each range of elements, in the order of the chunks.
  template <class Body>
  double sum(const Body& body) const {
    return sum_chunks(std::ref(body));
  }

  std::size_t chunks() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  std::size_t colors() const { return color_starts_.empty() ? 0 : color_starts_.size() - 1; }

 private:
  double sum_chunks(const std::function<double(long begin, long end)>& body) const;

  std::vector<long> starts_;               // of the chunks, and the end
  std::vector<Index> order_;               // chunks by colour
  std::vector<std::size_t> color_starts_;  // in order_
  mutable std::vector<double> parts_;      // of each chunk
};

}  // namespace retiarius
