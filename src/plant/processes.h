// The kinds of plants there are, each in a file of its own.
#pragma once

#include "plant/kind.h"

namespace merker::plant {

extern const Kind kBouncingSwitch, kFirstOrder, kGenerator, kTank, kTemperature, kValve;

}  // namespace merker::plant
