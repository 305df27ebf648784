// Addresses of the modules of a configuration.
#pragma once

#include "io/configuration.h"

namespace merker::io {

void assignAddresses(Configuration& configuration);
void checkAddresses(const Configuration& configuration, Problems& problems);

}  // namespace merker::io
