#include "retiarius/record/history_csv.hpp"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::SampleRun;
using ::testing::StartsWith;
using testing::TemporaryFolder;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (char c : line) {
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

TEST(HistoryColumns, HaveTheNamesThatScriptsRelyOn) {
  std::string names;
  for (const HistoryColumn& column : history_columns())
    names += (names.empty() ? "" : ", ") + column.name;
  EXPECT_EQ(names,
            "time, step, phase, mouth_area, mouth_vector_area, mouth_width, perimeter_area, "
            "kinetic_energy, stretching_energy, bending_energy, gravity_energy, material_loss, "
            "environment_loss, friction_loss, impact_loss, integrator_loss, prescribed_work, "
            "momentum_x, momentum_y, momentum_z, angular_momentum_x, angular_momentum_y, "
            "angular_momentum_z, peak_tension, peak_strain, contacts, smallest_distance, "
            "newton_iterations, captured_share, capture_quality, step_size, contact_energy, "
            "contacts_face, contacts_edge, contacts_thread, contacts_body");
}

// A row whose every member differs shows that each column reads its own.
TEST(HistoryColumns, ReadTheirOwnMembers) {
  HistoryRow row;
  row.time = 0;
  row.step = 1;
  row.phase = 2;
  double* members[] = {&row.mouth_area,       &row.mouth_vector_area, &row.mouth_width,
                       &row.perimeter_area,   &row.kinetic_energy,    &row.stretching_energy,
                       &row.bending_energy,   &row.gravity_energy,    &row.material_loss,
                       &row.environment_loss, &row.friction_loss,     &row.impact_loss,
                       &row.integrator_loss,  &row.prescribed_work};
  double next = 3;
  for (double* member : members) *member = next++;
  row.momentum = Vec3(17, 18, 19);
  row.angular_momentum = Vec3(20, 21, 22);
  row.peak_tension = 23;
  row.peak_strain = 24;
  row.contacts = 25;
  row.smallest_distance = 26;
  row.newton_iterations = 27;
  row.captured_share = 28;
  row.capture_quality = 29;
  row.step_size = 30;
  row.contact_energy = 31;
  row.contacts_face = 32;
  row.contacts_edge = 33;
  row.contacts_thread = 34;
  row.contacts_body = 35;
  const std::vector<double> values = history_values(row);
  ASSERT_EQ(values.size(), 36u);
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_EQ(values[k], static_cast<double>(k));
}

TEST(HistoryRow, ComesBackFromItsValues) {
  Mission mission;
  mission.probes.resize(2);
  mission.targets.resize(1);
  std::vector<double> values;
  for (std::size_t k = 0; k < history_columns().size() + 2 * 6 + 5; ++k)
    values.push_back(static_cast<double>(k));
  EXPECT_EQ(history_values(history_row(values, mission)), values);
  EXPECT_EQ(history_row(values, mission).probes.size(), 2u);

  HistoryRow without_body;
  const HistoryRow back = history_row(history_values(without_body), Mission{});
  EXPECT_FALSE(back.smallest_distance);
  EXPECT_FALSE(back.captured_share);

  values.pop_back();
  EXPECT_EQ(testing::error_text<Error>([&] { history_row(values, mission); }),
            "a history row has too few values");
  values.insert(values.end(), {1.0, 2.0});
  EXPECT_EQ(testing::error_text<Error>([&] { history_row(values, mission); }),
            "a history row has too many values");
}

TEST(CsvLine, WritesShortestNumbersAndNothingForAbsentValues) {
  EXPECT_EQ(csv_line({0.1, std::nan(""), 1e-300, 3.0, -0.0}), "0.1,,1e-300,3,-0\n");
}

TEST(CsvLine, NumbersReadBackToTheSameDouble) {
  for (double value : {1.0 / 3.0, 0.1 + 0.2, 1e22, 5e-324, 1.7976931348623157e308, -2.5e-7})
    EXPECT_EQ(std::strtod(csv_line({value}).c_str(), nullptr), value);
}

TEST(HistoryCsv, HasAHeaderAndOneRowPerOutputTimeWhileTheRunGoesOn) {
  TemporaryFolder folder;
  const SampleRun run;
  HistoryCsv recorder(folder.path());
  run.feed(recorder, 5);  // the run has not ended: what is there is on disk already
  const auto lines = lines_of(read_whole_file(folder / "history.csv"));
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_THAT(lines[0], StartsWith("time,step,phase,mouth_area,"));
  const auto names = cells_of(lines[0]);
  EXPECT_EQ(names.size(), 36u + 12u);
  EXPECT_EQ(names[36], "center.x");
  EXPECT_EQ(names.back(), "corner0.fz");
  const auto first = cells_of(lines[1]);
  const auto last = cells_of(lines[5]);
  ASSERT_EQ(first.size(), names.size());
  ASSERT_EQ(last.size(), names.size());
  EXPECT_EQ(first[26], "");  // no distance yet
  EXPECT_EQ(std::strtod(last[0].c_str(), nullptr), 0.1 * 4);
  EXPECT_EQ(std::strtod(last[26].c_str(), nullptr), *run.row(0.1 * 4).smallest_distance);
  EXPECT_EQ(std::strtod(last[37].c_str(), nullptr), 1.0 / 3.0);
  EXPECT_EQ(last.back(), "2.5");
}

}  // namespace
}  // namespace retiarius
