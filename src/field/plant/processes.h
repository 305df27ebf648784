// The kinds of plants there are, each in a file of its own.
#pragma once

#include "plant/kind.h"

namespace merker::plant {

extern const Kind kAxis, kBouncingSwitch, kEncoder, kFirstOrder, kGarageDoor, kGenerator, kLift,
    kPositioningDrive, kPulseTrain, kSortingPlant, kSpeedDrive, kTank, kTemperature, kTrafficLight,
    kValve, kVessel;

}  // namespace merker::plant
