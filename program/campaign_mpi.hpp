// A campaign done by the ranks of an MPI job.
#pragma once

#include <functional>

#include "program/exit_code.hpp"
#include "retiarius/campaign/process_engine.hpp"

namespace retiarius::program {

// Whether this program can be a rank, and what to say of it: "Open MPI v4.1.4" or "not built in".
bool mpi_built_in();
std::string mpi_text();

// Whether it was started as a rank by mpirun or the like.
bool under_mpi();

// Rank 0 tells every rank, itself included, which run is next; each rank has one worker process,
// which writes a shard of its own, so that a run that dies costs no rank. `finish` is called on
// rank 0 with whether all is done. Throws InputError where MPI is not built in.
ExitCode run_mpi(const Campaign& campaign, const EngineSettings& settings,
                 const std::function<ExitCode(bool done)>& finish);

}  // namespace retiarius::program
