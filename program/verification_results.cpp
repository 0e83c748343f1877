#include "program/verification_results.hpp"

#include "retiarius/record/file.hpp"
#include "retiarius/report/chart_svg.hpp"
#include "verification/framework/page.hpp"
#include "verification/framework/results_json.hpp"
#include "verification/framework/results_markdown.hpp"

namespace retiarius::program {

using namespace verification;

ExitCode conclude(const std::vector<Rung>& rungs, const std::filesystem::path& out, bool quick,
                  double wall_time) {
  std::filesystem::create_directories(out / "figures");
  const Recorded recorded = recorded_comparisons();
  write_atomically(out / "verification.json", results_json(rungs, quick));
  write_atomically(out / "verification.html",
                   verification_page(rungs, {quick, wall_time, recorded}));
  write_atomically(out / "verification.md", results_markdown(rungs, recorded, "figures", quick));
  for (const Rung& rung : rungs)
    for (std::size_t k = 0; k < rung.result.charts.size(); ++k)
      write_atomically(out / "figures" / figure_name(*rung.of, k),
                       chart_svg(rung.result.charts[k], ChartLook::standalone));
  return passes(rungs) ? kOk : kFailed;
}

}  // namespace retiarius::program
