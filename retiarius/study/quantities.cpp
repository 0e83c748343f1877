#include "retiarius/study/quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace retiarius {

namespace {

constexpr std::array<std::string_view, 5> kNoResults = {"steps", "newton_iterations", "wall_time",
                                                        "mouth_area_flat", "mouth_width_flat"};

double number_of(const Measure& measure) {
  if (const double* number = std::get_if<double>(&measure.value)) return *number;
  if (const auto* count = std::get_if<std::int64_t>(&measure.value))
    return static_cast<double>(*count);
  if (const bool* truth = std::get_if<bool>(&measure.value)) return *truth ? 1.0 : 0.0;
  return NAN;
}

double flat_width(const Measures& measures) {
  for (const Measure& m : measures)
    if (m.name == "mouth_width_flat") return number_of(m);
  return 0.0;
}

double size_of(const Mission& mission, const std::string& name) {
  if (name.ends_with("_drift")) return 1.0;
  if (name == "smallest_distance") return mission.net.thread.radius;
  return 0.0;
}

void add_measures(const Mission& mission, const Measures& measures, const std::string& prefix,
                  std::vector<Quantity>& out) {
  for (const Measure& m : measures) {
    if (std::find(kNoResults.begin(), kNoResults.end(), m.name) != kNoResults.end()) continue;
    const bool truth =
        std::holds_alternative<bool>(m.value) || m.name == "closed" || m.name == "success";
    out.push_back(
        {prefix + m.name, truth ? "yes/no" : m.unit, number_of(m), size_of(mission, m.name)});
  }
}

// Energies at the end, compared with the largest that occurred.
void add_energies(const Mission& mission, const std::vector<HistoryRow>& rows,
                  std::vector<Quantity>& out) {
  double largest = 0.0;
  for (const HistoryRow& row : rows)
    largest = std::max({largest, row.kinetic_energy, row.stretching_energy, row.bending_energy});
  const HistoryRow& last = rows.back();
  const auto add = [&](const char* name, double value) {
    out.push_back({std::string(name) + "_final", "J", value, largest});
  };
  add("kinetic_energy", last.kinetic_energy);
  add("stretching_energy", last.stretching_energy);
  if (mission.net.thread.bending != Bending::none) add("bending_energy", last.bending_energy);
  if (last.gravity_energy != 0.0) add("gravity_energy", last.gravity_energy);
  add("integrator_loss", last.integrator_loss);
}

void add_probes(const Mission& mission, const HistoryRow& last, double width,
                std::vector<Quantity>& out) {
  for (std::size_t k = 0; k < mission.probes.size() && k < last.probes.size(); ++k)
    for (int axis = 0; axis < 3; ++axis)
      out.push_back({fmt::format("{}.{}", mission.probes[k].name, "xyz"[axis]), "m",
                     last.probes[k].position[axis], width});
}

// "spread."; "phase[2].spread." where several phases have the name.
std::string phase_prefix(const std::vector<PhaseReport>& phases, std::size_t k) {
  const auto same = std::count_if(phases.begin(), phases.end(), [&](const PhaseReport& phase) {
    return phase.name == phases[k].name;
  });
  return same > 1 ? fmt::format("phase[{}].{}.", k, phases[k].name) : phases[k].name + ".";
}

}  // namespace

std::vector<Quantity> run_quantities(const Mission& mission, const RunReport& report,
                                     const std::vector<HistoryRow>& rows) {
  std::vector<Quantity> all;
  add_measures(mission, report.measures, "", all);
  if (!rows.empty()) {
    add_energies(mission, rows, all);
    add_probes(mission, rows.back(), flat_width(report.measures), all);
  }
  for (std::size_t k = 0; k < report.phases.size(); ++k) {
    const PhaseReport& phase = report.phases[k];
    const std::string prefix = phase_prefix(report.phases, k);
    all.push_back({prefix + "end", "s", phase.end, 0.0});
    if (report.phases.size() > 1) add_measures(mission, phase.measures, prefix, all);
  }
  return all;
}

const Quantity* find_quantity(const std::vector<Quantity>& quantities, const std::string& name) {
  const auto at = std::find_if(quantities.begin(), quantities.end(),
                               [&](const Quantity& q) { return q.name == name; });
  return at == quantities.end() ? nullptr : &*at;
}

}  // namespace retiarius
