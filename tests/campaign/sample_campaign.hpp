// A campaign made up of formulas, for tests of the report: a net of radius 1.5 m is aimed with an
// error in two directions at a target that spins.
#pragma once

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "retiarius/base/random.hpp"
#include "retiarius/base/vec.hpp"
#include "retiarius/campaign/table.hpp"

namespace retiarius::testing {

inline CampaignRow sample_run(std::int64_t id, const std::vector<double>& u) {
  CampaignRow row;
  row.id = id;
  const double x = 2.4 * u[0] - 1.2, y = 2.4 * u[1] - 1.2, spin = 40.0 * u[2];
  const double speed = 18.0 + 4.0 * u[3];
  row.inputs = {x, y, spin, speed};
  row.outcome = "finished";
  const double miss = std::hypot(x, y) + 0.012 * spin;
  const double quality =
      0.3 + miss * miss + 0.1 * random_uniform(3, 9, static_cast<std::uint64_t>(id));
  row.measures = {quality, std::min(1.0, 1.6 - miss), 120.0 * speed + 30.0 * spin * spin / 40.0};
  row.success = miss < 1.1;
  if (id % 97 == 13) {
    row.outcome = id % 2 == 0 ? "failed" : "timeout";
    row.reason = id % 2 == 0
                     ? fmt::format("step at t = 0.{} s does not converge at node {}", id, id)
                     : "took longer than 60 s";
    row.success.reset();
    row.measures.assign(3, std::nan(""));
  }
  if (!row.success.value_or(false)) row.replay = fmt::format("runs/{}/report.html", id);
  row.command = fmt::format("retiarius campaign replay aim.toml --id {}", id);
  return row;
}

inline CampaignTable sample_campaign(std::int64_t runs,
                                     CampaignDesign design = CampaignDesign::independent) {
  CampaignTable table;
  table.title = "Aim <and> spin";
  table.design = design;
  table.inputs = {"target.position[0]", "target.position[1]", "target.spin_deg[2]", "shoot.speed"};
  table.measures = {"capture_quality_settled", "captured_share", "peak_tension_20ms"};
  table.planned = runs;
  table.facts = {"mission missions/capture.toml, seed 1", "retiarius 0.1.0"};
  const auto k = static_cast<std::int64_t>(table.inputs.size());
  for (std::int64_t id = 0; id < runs; ++id) {
    const bool blocks = design == CampaignDesign::saltelli;
    const std::int64_t j = blocks ? id % (k + 2) : 0;
    const auto row = static_cast<std::uint64_t>(blocks ? id / (k + 2) : id);
    std::vector<double> u;
    for (std::int64_t i = 0; i < k; ++i) {
      const bool from_b = j == 1 || j == 2 + i;
      u.push_back(random_uniform(1, row, static_cast<std::uint64_t>(from_b ? k + i : i)));
    }
    table.runs.push_back(sample_run(id, u));
  }
  return table;
}

}  // namespace retiarius::testing
