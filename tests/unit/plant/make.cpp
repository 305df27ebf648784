#include "make.h"

namespace merker::plant {

io::Configuration onBoard() {
  Problems problems;
  return io::configure({}, defaultCpuModel(), problems);
}

PlantSettings make(std::string_view name, std::string_view kind, std::vector<Given> given) {
  PlantSettings plant;
  plant.name = name;
  plant.kind = findKind(kind);
  plant.step = plant.kind->step;
  for (const Parameter& parameter : plant.kind->parameters) {
    double value = parameter.standard;
    for (const Given& one : given)
      if (one.key == parameter.key) value = one.value;
    plant.parameters.push_back(value);
  }
  return plant;
}

void wire(PlantSettings& plant, std::string_view signal, io::Terminal terminal, double scale) {
  plant.wires.push_back({plant.kind->signal(signal).value(), terminal, "", scale, 0});
}

}  // namespace merker::plant
