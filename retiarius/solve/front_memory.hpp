// Where the update matrices of a multifrontal factorisation lie, and which subtrees are tasks.
#pragma once

#include "retiarius/solve/symbolic.hpp"

namespace retiarius {

// Splits the tree into tasks of bounded estimated time and the fronts above them.
void assign_tasks(Symbolic& symbolic);

// Gives each update a place. Within a task, memory is used again as soon as a parent has taken a
// child's update.
void place_updates(Symbolic& symbolic);

}  // namespace retiarius
