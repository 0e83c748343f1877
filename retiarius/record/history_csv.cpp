#include "retiarius/record/history_csv.hpp"

#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

std::vector<std::string> history_header(const Mission& mission) {
  std::vector<std::string> names;
  for (const HistoryColumn& column : history_columns()) names.push_back(column.name);
  for (const ProbeSpec& probe : mission.probes)
    for (const char* part : {"x", "y", "z", "fx", "fy", "fz"})
      names.push_back(probe.name + "." + part);
  for (const BodySpec& target : mission.targets)
    for (const char* part : {"contact_fx", "contact_fy", "contact_fz", "normal", "friction"})
      names.push_back(target.name + "." + part);
  return names;
}

std::vector<double> history_values(const HistoryRow& row) {
  std::vector<double> values;
  values.reserve(history_columns().size() + 6 * row.probes.size() + 5 * row.loads.size());
  for (const HistoryColumn& column : history_columns()) values.push_back(column.value(row));
  for (const ProbeValue& probe : row.probes) {
    values.insert(values.end(), probe.position.begin(), probe.position.end());
    values.insert(values.end(), probe.force.begin(), probe.force.end());
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const BodyLoad& load : row.loads) {
    values.insert(values.end(), load.force.begin(), load.force.end());
    values.insert(values.end(), {load.normal.value_or(none), load.friction.value_or(none)});
  }
  return values;
}

namespace {

// Hands out the values of a row one by one.
class Values {
 public:
  explicit Values(const std::vector<double>& values) : values_(values) {}

  bool finished() const { return next_ >= values_.size(); }
  double number() {
    if (finished()) throw Error("a history row has too few values");
    return values_[next_++];
  }
  template <class... Numbers>
  void read(Numbers&... numbers) {
    ((numbers = static_cast<Numbers>(number())), ...);
  }
  void read_vector(Vec3& v) { read(v.x(), v.y(), v.z()); }
  void read_optional(std::optional<double>& value) {
    const double v = number();
    if (!std::isnan(v)) value = v;
  }

 private:
  const std::vector<double>& values_;
  std::size_t next_ = 0;
};

}  // namespace

HistoryRow history_row(const std::vector<double>& values, const Mission& mission) {
  Values in(values);
  HistoryRow r;
  in.read(r.time, r.step, r.phase, r.mouth_area, r.mouth_vector_area, r.mouth_width,
          r.perimeter_area, r.kinetic_energy, r.stretching_energy, r.bending_energy,
          r.gravity_energy, r.material_loss, r.environment_loss, r.friction_loss, r.impact_loss,
          r.integrator_loss, r.prescribed_work);
  in.read_vector(r.momentum);
  in.read_vector(r.angular_momentum);
  in.read(r.peak_tension, r.peak_strain, r.contacts);
  in.read_optional(r.smallest_distance);
  in.read(r.newton_iterations);
  in.read_optional(r.captured_share);
  in.read_optional(r.capture_quality);
  in.read(r.step_size, r.contact_energy, r.contacts_face, r.contacts_edge, r.contacts_thread,
          r.contacts_body);
  for (std::size_t k = 0; k < mission.probes.size(); ++k) {
    ProbeValue& probe = r.probes.emplace_back();
    in.read_vector(probe.position);
    in.read_vector(probe.force);
  }
  for (std::size_t k = 0; k < mission.targets.size(); ++k) {
    BodyLoad& load = r.loads.emplace_back();
    in.read_vector(load.force);
    in.read_optional(load.normal);
    in.read_optional(load.friction);
  }
  if (!in.finished()) throw Error("a history row has too many values");
  return r;
}

std::string csv_line(const std::vector<double>& values) {
  std::string line;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0) line += ',';
    if (!std::isnan(values[k])) fmt::format_to(std::back_inserter(line), "{}", values[k]);
  }
  line += '\n';
  return line;
}

void HistoryCsv::begin(const RunModel& model) {
  file_ = std::make_unique<OutputFile>(model.resumed ? new_name(path_) : path_);
  file_->write(fmt::format("{}\n", fmt::join(history_header(*model.mission), ",")));
}

void HistoryCsv::history(const HistoryRow& row) { file_->write(csv_line(history_values(row))); }

void HistoryCsv::save(const Checkpoint&, bool durable) {
  if (durable) file_->sync();
}

void HistoryCsv::resumed() { file_->rename_to(path_); }

void HistoryCsv::end(const RunReport&) {
  if (file_) file_->sync();
}

}  // namespace retiarius
