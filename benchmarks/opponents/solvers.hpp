// Solvers of others behind our face, to be timed against ours.
#pragma once

#include <memory>

#include "retiarius/solve/linear_solver.hpp"

namespace retiarius::benchmarks {

// Eigen's SimplicialLDLT on scalars, under minimum degree or nested dissection (METIS).
std::unique_ptr<LinearSolver> make_eigen_amd_solver();
std::unique_ptr<LinearSolver> make_eigen_metis_solver();

// CHOLMOD's supernodal Cholesky under nested dissection (METIS).
std::unique_ptr<LinearSolver> make_cholmod_solver();

}  // namespace retiarius::benchmarks
