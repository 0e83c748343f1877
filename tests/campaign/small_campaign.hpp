// A campaign of runs that take a millisecond each, and ways to look at what became of it.
#pragma once

#include <string>
#include <vector>

#include "tests/program/subprocess.hpp"

namespace retiarius::testing {

// Writes m.toml and c.toml: a small net that falls on a ball, whose place, attitude and spin vary.
// `plan` stands in [plan]; `more` at the end.
void write_small_campaign(const WorkFolder& folder, const std::string& plan,
                          const std::string& more = "");

std::string monte_carlo(int runs);

// Every column of the rows of `runs`, in order of the ids, a row a line.
std::string rows_of(const WorkFolder& folder, const std::string& out);

// The first column of the first row that a query of the collected database gives; empty: none.
std::string query(const WorkFolder& folder, const std::string& out, const std::string& sql);

// Runs mpirun in the folder with the program as ranks.
ProcessResult mpirun(const WorkFolder& folder, int ranks,
                     const std::vector<std::string>& arguments);
bool has_mpi();

// The processes that a process has started and that live.
std::vector<pid_t> children_of(pid_t process);

}  // namespace retiarius::testing
