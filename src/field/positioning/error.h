// External errors as ERR shows them, and numbers of STATUS and JOB_STAT (technology manual 3.6.1,
// 3.8.2, 4.8.2; POS-ERR).
#pragma once

#include <cstdint>

namespace merker::positioning {

enum ExternalError : std::uint16_t {
  kMissingPulse = 0x0004,
  kTravelRange = 0x0800,
  kWorkingRange = 0x1000,
  kMovement = 0x2000,
  kTargetApproach = 0x4000,
  kTargetRange = 0x8000,
};
// Those that abort a run (POS-MON-15), and those that end the synchronisation.
constexpr std::uint16_t kAborting = kMissingPulse | kTravelRange | kWorkingRange | kMovement;
constexpr std::uint16_t kDesynchronising = kMissingPulse | kTravelRange;

enum StatusNumber : std::uint16_t {
  kNoError = 0,
  kUseDigitalBlock = 0x2001,  // SFB 46
  kUseAnalogBlock = 0x2002,   // SFB 44
  kWrongChannel = 0x2004,
  kJobFailed = 0x3001,
  kModeChanged = 0x3002,
  kUnknownMode = 0x3003,
  kSeveralStarts = 0x3004,
  kStartNotAllowed = 0x3005,
  kDirectionNotAllowed = 0x3006,
  kNotSynchronised = 0x3007,
  kOutsideWorkingRange = 0x3008,
  kNotParametrised = 0x3101,
  kNoDriveEnable = 0x3102,
  kStopSet = 0x3103,
  kPositioning = 0x3104,
  kErrorPending = 0x3105,
  kWrongSpeed = 0x3202,
  kWrongAcceleration = 0x3203,
  kWrongDeceleration = 0x3204,
  kBelowReferenceSpeed = 0x3206,
  kDifferenceTooLarge = 0x3301,
  kChangeoverBelowCutOff = 0x3303,
  kCutOffTooSmall = 0x3304,
  kChangeoverTooSmall = 0x3305,
  kTargetOutside = 0x3401,
  kWrongTarget = 0x3402,
  kNegativeDistance = 0x3403,
  kTargetTooLow = 0x3404,
  kTargetTooHigh = 0x3405,
  kTargetRangeOutside = 0x3406,
  kWayTooLongMinus = 0x3501,
  kWayTooLongPlus = 0x3502,
  kWayTooShortPlus = 0x3503,
  kWayTooShortMinus = 0x3504,
  kLimitTooClosePlus = 0x3505,
  kLimitTooCloseMinus = 0x3506,
  kJobNotParametrised = 0x4001,
  kJobWhilePositioning = 0x4002,
  kUnknownJob = 0x4004,
  kReferenceOutside = 0x4101,
  kReferenceTooLow = 0x4102,  // with the distance to go; too high: the next number
  kReferenceTooHigh = 0x4103,
  kReferenceStartTooLow = 0x4104,  // with the start point of an interrupted run
  kReferenceStartTooHigh = 0x4105,
  kReferenceNotOnAxis = 0x4106,
};

}  // namespace merker::positioning
