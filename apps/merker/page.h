// The page of the workbench, embedded in the program (tools/embed).
#pragma once

#include <span>

#include "server/asset.h"

namespace merker::app {

std::span<const hmi::Asset> page();

}  // namespace merker::app
