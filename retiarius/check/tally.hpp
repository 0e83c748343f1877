// What a part of the check found.
#pragma once

#include "retiarius/check/check_contact.hpp"

namespace retiarius::check {

class Tally {
 public:
  std::uint64_t looked_at = 0, unresolved = 0;

  void add(const ContactViolation& violation);
  void merge(const Tally& other);
  void write_to(ContactCheck& result) const;

 private:
  std::uint64_t counts_[3] = {0, 0, 0};
  std::vector<ContactViolation> worst_;  // in the order of their first appearance
};

}  // namespace retiarius::check
