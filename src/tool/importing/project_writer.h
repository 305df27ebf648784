// A project folder from what a program holds.
#pragma once

#include "importing/material.h"
#include "importing/output.h"
#include "importing/report.h"

namespace merker::importing {

void writeProject(const Material& material, Output& output, Report& report);

}  // namespace merker::importing
