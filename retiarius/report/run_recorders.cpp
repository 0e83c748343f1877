#include "retiarius/report/run_recorders.hpp"

#include "retiarius/report/report_recorder.hpp"

namespace retiarius {

std::unique_ptr<FanOut> make_run_recorders(const std::filesystem::path& folder,
                                           const RecordOptions& options) {
  std::unique_ptr<FanOut> all = make_recorders(folder, options);
  all->add(std::make_unique<ReportRecorder>(folder, options.resolved, options.build));
  return all;
}

}  // namespace retiarius
