// Plants of a project of several stations: each belongs to one of them, whose time moves it.
#pragma once

#include <string>
#include <vector>

#include "io/configuration.h"
#include "plant/configuration.h"
#include "project/network.h"
#include "source/source_file.h"

namespace merker::project {

// What of a station the wires of plants may end at. `hardware` null: it has no modules.
struct StationField {
  std::string name;
  const io::Configuration* hardware = nullptr;
  plant::Configuration* plants = nullptr;  // to be completed
};

// "Line, Press", of many the first ones.
std::string namesOf(const std::vector<StationField>& stations);

// [[plant]] of the project's merker.toml, behind the plants of the stations' own.
void readStationPlants(const source::SourceFile& file, std::vector<StationField>& stations,
                       Problems& problems);

}  // namespace merker::project
