// What a program of a STEP 7 project holds.
#pragma once

#include "importing/material.h"
#include "importing/report.h"
#include "s7p/catalogue.h"

namespace merker::importing {

Material materialOf(const archive::Tree& tree, const s7p::Project& project,
                    const s7p::Program& program, Report& report);

}  // namespace merker::importing
