// What the ranges of parallel loops find, in one order whatever the number of threads.
#pragma once

#include <functional>
#include <vector>

#include "retiarius/base/parallel.hpp"
#include "retiarius/contact/contact_pair.hpp"

namespace retiarius {

class PairParts {
 public:
  using List = std::vector<ContactPair>;

  // Forgets what was found; memory is used again.
  void clear() {
    used_ = 0;
    for (List& part : parts_) part.clear();
  }

  // Calls call(k, found) for k in [0, count), in parallel ranges that have a list each.
  template <class Call>
  void each(std::size_t count, Call&& call) {
    const std::size_t first = used_;
    used_ += (count + kGrain - 1) / kGrain;
    if (parts_.size() < used_) parts_.resize(used_);
    const auto run = [&](std::size_t begin, std::size_t end) {
      List& found = parts_[first + begin / kGrain];
      for (std::size_t k = begin; k < end; ++k) call(static_cast<Index>(k), found);
    };
    parallel_for(count, kGrain, std::cref(run));
  }

  // Range after range.
  void append_to(List& all) const {
    for (std::size_t k = 0; k < used_; ++k)
      all.insert(all.end(), parts_[k].begin(), parts_[k].end());
  }

 private:
  static constexpr std::size_t kGrain = 256;

  std::vector<List> parts_;
  std::size_t used_ = 0;
};

}  // namespace retiarius
