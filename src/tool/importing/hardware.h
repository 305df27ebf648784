// HW Config's export of a station (*.cfg), and modules for merker.toml.
#pragma once

#include "importing/material.h"
#include "importing/report.h"

namespace merker::importing {

// Station, CPU and the modules of its racks with their addresses. Distributed periphery is left
// out.
void readHardware(std::string_view text, Material& material);

// [project], [cpu] and [[module]].
std::string settingsText(const Material& material, const std::string& model, Report& report);

// The keyword of the CPU for merker.toml: by order number or name, else a generic one.
std::string modelOf(const Material& material, Report& report);

}  // namespace merker::importing
