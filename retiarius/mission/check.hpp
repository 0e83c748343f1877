// What no single key can tell: values of a mission that must fit each other.
#pragma once

#include "retiarius/mission/mission.hpp"
#include "retiarius/mission/places.hpp"

namespace retiarius {

// Throws InputError at the place of the offending key.
void check_mission(const Mission& mission, const Places& places);

// The parts of it.
void check_net(const Mission& mission, const Places& places);
void check_targets(const Mission& mission, const Places& places);
void check_phases(const Mission& mission, const Places& places);
void check_output(const Mission& mission, const Places& places);
void check_newton(const Mission& mission, const Places& places);

// Corners that a net of this pattern has; 0 where only the network file knows.
int corner_count(const NetSpec& net);

// Whether `whole` is a whole multiple of `part`, at least once, within round-off.
bool is_multiple(double whole, double part);

}  // namespace retiarius
