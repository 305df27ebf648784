// The other station of a project ([[station]]) and the operands that are named after it.
#pragma once

#include <string_view>

#include "compilation/build.h"

namespace merker::compilation {

// In front of the operands of the control or station at the other end: "partner.MW 10".
inline constexpr std::string_view kPartner = "partner.";

// Compiles the station that X27 is connected to; its problems are those of the project, too.
void addStation(Build& build);
// `own` and, with the name of the other station in front (Press/E 0.0), the operands of that one.
simulator::Resolver withStation(const Build& build, const simulator::Resolver& own,
                                const simulator::Resolver& others);

}  // namespace merker::compilation
