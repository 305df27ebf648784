// The diagnosis of a slave as SFC 13 reads it (EN 50170, Slave_Diag; S7-SFC-06).
#pragma once

#include <cstdint>
#include <vector>

#include "io/rack.h"
#include "io/slave.h"

namespace merker::profibus {

// Station status 1 to 3, master address, identity number, then which modules have a fault.
std::vector<std::uint8_t> slaveDiagnosis(const io::Rack& rack, const io::Slave& slave);

}  // namespace merker::profibus
