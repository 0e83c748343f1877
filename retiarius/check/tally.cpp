#include "retiarius/check/tally.hpp"

#include <algorithm>

namespace retiarius::check {
namespace {

// Violations of the same kind against the same body, or of threads among themselves.
bool is_same_kind(const ContactViolation& a, const ContactViolation& b) {
  return a.fault == b.fault && a.body == b.body;
}

void keep_worst(std::vector<ContactViolation>& list, const ContactViolation& violation) {
  for (ContactViolation& known : list) {
    if (!is_same_kind(known, violation)) continue;
    if (violation.depth > known.depth) known = violation;
    return;
  }
  list.push_back(violation);
}

}  // namespace

void Tally::add(const ContactViolation& violation) {
  ++counts_[static_cast<int>(violation.fault)];
  keep_worst(worst_, violation);
}

void Tally::merge(const Tally& other) {
  looked_at += other.looked_at;
  unresolved += other.unresolved;
  for (int k = 0; k < 3; ++k) counts_[k] += other.counts_[k];
  for (const ContactViolation& violation : other.worst_) keep_worst(worst_, violation);
}

void Tally::write_to(ContactCheck& result) const {
  result.looked_at = looked_at;
  result.unresolved = unresolved;
  result.penetrations = counts_[static_cast<int>(ContactFault::penetration)];
  result.approaches = counts_[static_cast<int>(ContactFault::approach)];
  result.crossings = counts_[static_cast<int>(ContactFault::crossing)];
  result.worst = worst_;
  std::stable_sort(result.worst.begin(), result.worst.end(),
                   [](const auto& a, const auto& b) { return a.depth > b.depth; });
  result.deepest = result.worst.empty() ? 0.0 : result.worst.front().depth;
}

}  // namespace retiarius::check
