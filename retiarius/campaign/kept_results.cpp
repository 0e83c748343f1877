#include "retiarius/campaign/kept_results.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/mission/writer.hpp"
#include "retiarius/record/history_csv.hpp"
#include "retiarius/record/output_folder.hpp"
#include "retiarius/record/summary_json.hpp"
#include "retiarius/report/run_recorders.hpp"

namespace retiarius {

namespace fs = std::filesystem;

namespace {

bool wanted(const KeepSpec& keep, std::int64_t id) {
  if (keep.what == Keep::measures) return false;
  if (keep.what != Keep::sample) return true;
  const bool listed =
      std::find(keep.ids.begin(), keep.ids.end(), static_cast<double>(id)) != keep.ids.end();
  return listed || (keep.every > 0 && id % keep.every == 0);
}

std::unique_ptr<FanOut> make_recorder(const KeepSpec& keep, const fs::path& folder,
                                      const Mission& mission) {
  BuildInfo build = build_info();
  build.kernels = kernel_name();
  if (keep.what != Keep::history)
    return make_run_recorders(folder, {to_toml(mission), {}, build, false, false});
  prepare_output_folder(folder);
  auto all = std::make_unique<FanOut>();
  all->add(std::make_unique<HistoryCsv>(folder));
  all->add(std::make_unique<SummaryJson>(folder, build));
  return all;
}

}  // namespace

KeptResults::KeptResults(const KeepSpec& keep, std::int64_t id, const fs::path& campaign,
                         const Mission& mission)
    : failures_only_(keep.what == Keep::failures), campaign_(campaign) {
  if (!wanted(keep, id)) return;
  place_ = campaign / "runs" / fmt::format("{}", id);
  written_ = campaign / "runs" / fmt::format("{}.part", id);
  try {
    fs::remove_all(written_);  // of an attempt that did not come to its end
    recorder_ = make_recorder(keep, written_, mission);
  } catch (const std::exception& error) {
    throw RunError(error.what());
  }
}

KeptResults::~KeptResults() {
  if (!recorder_) return;
  recorder_.reset();
  std::error_code ignored;
  fs::remove_all(written_, ignored);
}

std::string KeptResults::settle(bool success) {
  if (!recorder_) return {};
  recorder_.reset();
  try {
    if (failures_only_ && success) {
      fs::remove_all(written_);
      return {};
    }
    fs::remove_all(place_);
    fs::rename(written_, place_);
  } catch (const fs::filesystem_error& error) {
    throw RunError(fmt::format("{}: {}", error.path1().string(), error.code().message()));
  }
  return place_.lexically_relative(campaign_).string();
}

}  // namespace retiarius
