// A station in RUN with a program.
#pragma once

#include <string>

#include "station/station.h"

namespace merker::bench {

station::Station stationWith(const std::string& source,
                             station::Engine engine = station::Engine::Interpreter);
// Of one run of OB 1 with this loop.
std::uint64_t instructionsOfLoop(const std::string& body);

}  // namespace merker::bench
