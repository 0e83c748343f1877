// Rotation of a rigid body that no torque acts on.
#pragma once

#include "retiarius/base/vec.hpp"

namespace retiarius {

// The unit quaternion that turns by |vector| radians about vector.
Quat rotation(const Vec3& vector);

// Attitude after time h (s) at constant angular momentum (world axes, kg m2/s), in `substeps`
// equal steps of the commutator-free Lie-group scheme of order four of Celledoni, Marthinsen and
// Owren (Future Generation Computer Systems 19, 2003) applied to R' = [R I^-1 R^T L]x R.
Quat turn_freely(const Mat3& inverse_inertia, const Quat& attitude, const Vec3& angular_momentum,
                 double h, int substeps);

// The number of substeps that keeps the attitude error of a step below 1e-10 rad for a body that
// turns by at most `angle` rad in it. Throws RunError beyond 1000 rad.
int free_rotation_substeps(double angle);

}  // namespace retiarius
