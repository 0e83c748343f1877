// What stays on disk of a run beside its row.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "retiarius/campaign/spec.hpp"
#include "retiarius/mission/observer.hpp"

namespace retiarius {

// Results are written to a folder of another name beside their place and moved there as a whole, so
// that a folder runs/ID is always that of a run that came to its end.
class KeptResults {
 public:
  // Throws RunError where the folder cannot be made.
  KeptResults(const KeepSpec& keep, std::int64_t id, const std::filesystem::path& campaign,
              const Mission& mission);
  ~KeptResults();  // removes what was not settled
  KeptResults(const KeptResults&) = delete;
  KeptResults& operator=(const KeptResults&) = delete;

  // What writes them; null where nothing is kept.
  Observer* recorder() const { return recorder_.get(); }

  // Moves the results to their place, or removes them where they are not wanted after all. The
  // place, relative to the campaign's folder, or empty. Throws RunError.
  std::string settle(bool success);

 private:
  bool failures_only_ = false;
  std::filesystem::path campaign_, written_, place_;
  std::unique_ptr<Observer> recorder_;
};

}  // namespace retiarius
