// User parameters as they go to the slave.
#pragma once

#include "gsd/device.h"

namespace merker::gsd {

// With the standard values of the parameters.
Bytes standardParameters(const UserParameters& parameters, const Device& device);

}  // namespace merker::gsd
