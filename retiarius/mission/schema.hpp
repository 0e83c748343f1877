// The schema of the mission file: every table and key, once. See key.hpp for what a key holds.
#pragma once

#include <string>
#include <vector>

#include "retiarius/mission/key.hpp"
#include "retiarius/mission/mission.hpp"

namespace retiarius {

inline constexpr int kMissionFormat = 1;  // of the mission file, key `format`

const Table<Mission>& mission_table();  // the keys at the top of the file
const Table<NetSpec>& net_table();
const Table<ThreadSpec>& thread_table();
const Table<BorderSpec>& border_table();
const Table<CornerMassSpec>& corner_mass_table();
const Table<BodySpec>& target_table();
const Table<EnvironmentSpec>& environment_table();
const Table<IntegratorSpec>& integrator_table();
const Table<ContactSpec>& contact_table();
const Table<PhaseSpec>& phase_table();
const Table<MoveSpec>& move_table();
const Table<ProbeSpec>& probe_table();
const Table<OutputSpec>& output_table();

// Every table without its bindings, in the order of the mission file.
struct TableView {
  const TableInfo* info = nullptr;
  std::vector<const KeyInfo*> keys;
};
const std::vector<TableView>& schema_tables();

// The table at a dotted path without brackets ("phase.environment" has the keys of "environment");
// null if there is none.
const TableView* find_table(const std::string& path);

}  // namespace retiarius
