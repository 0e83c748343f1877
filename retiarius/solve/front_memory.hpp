// Where the update matrices of a multifrontal factorisation lie, and which subtrees are tasks.
#pragma once

#include "retiarius/solve/symbolic.hpp"

namespace retiarius {

// Splits the tree into tasks of bounded estimated time and the fronts above them.
void assign_tasks(Symbolic& symbolic);

// Gives each update two places: one for a single thread, which uses memory again as soon as a
// parent has taken a child's update and so stays in cache, and one for tasks that run side by side.
void place_updates(Symbolic& symbolic);

}  // namespace retiarius
