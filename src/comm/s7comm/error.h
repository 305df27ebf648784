// What a PLC answers when it does not do what was asked: of a whole job in the header of the
// answer, and of each item of a variable job.
#pragma once

#include <cstdint>

namespace merker::s7comm {

// Error class in the high byte, error code in the low one.
enum class Error : std::uint16_t {
  None = 0,
  TransferFailed = 0x8003,        // a piece of a block was not what was asked for
  FunctionNotAvailable = 0x8104,  // no such function, or before the setup
  NoMemory = 0x8301,              // load or work memory
  WrongSequence = 0x8401,         // of services, or of segments
  WrongObjectState = 0x8402,      // of what was addressed
  CannotBeDone = 0x8404,          // not in this state
  BlockDisabled = 0x8405,         // a receiving block of the program
  WrongPduSize = 0x8500,          // the PDU, or its answer, is too long or its lengths are wrong
  NoSuchObject = 0x8701,          // at this address
  AccessRefused = 0x8703,         // to an object
  // of test and installation
  TestNotOffered = 0xD003,  // by this PLC
  WrongTrigger = 0xD00A,
  NoBlockToTest = 0xD011,
  WrongTestAddress = 0xD012,  // in a block
  WrongJobLength = 0xD033,
  WrongTestVariable = 0xD042,
  WrongTestValue = 0xD044,
  WrongTestData = 0xD05F,
  NoRoomForJob = 0xD061,
  TooManyJobs = 0xD062,
  ResultTooLong = 0xD064,  // for one PDU
  NotInThisMode = 0xD081,
  TestProtected = 0xD0A1,
  ForcedAlready = 0xD0A4,
  NoSuchJob = 0xD0A5,
  NotToBeEnabled = 0xD0A6,
  NotToBeReplaced = 0xD0A8,
  JobOfAnother = 0xD0AE,  // of another connection
  WrongBlockName = 0xD201,
  NoSuchBlock = 0xD209,
  NotForUpload = 0xD20C,  // a CPU has no block of this number
  NoBlocks = 0xD20E,      // of this type
  BlockTooLarge = 0xD20F,
  WrongBlockNumber = 0xD210,
  WrongBlockFiles = 0xD218,  // active or passive
  WrongBlockLength = 0xD219,
  WrongBlockStructure = 0xD226,
  WrongChecksum = 0xD235,
  NeedsPassword = 0xD241,
  NoSuchList = 0xD401,     // of the system status
  NoInformation = 0xD402,  // there is none with this index, or nothing is left of it
  WrongFunctionParameters = 0xD405,
  WrongPassword = 0xD602,
  PasswordStands = 0xD604,  // it was entered before; or none was, to be cancelled
  NoPassword = 0xD605,      // the PLC has none
  WrongVariable = 0xD801,   // of a cyclic job
  NoSuchReading = 0xD802,
  WrongInterval = 0xD804,
  TooManyReadings = 0xD805,
  WrongTime = 0xDC01
};

enum class ItemCode : std::uint8_t {
  Requested = 0x00,  // of a write job
  HardwareFault = 0x01,
  AccessDenied = 0x03,
  OutOfRange = 0x05,
  TypeNotSupported = 0x06,
  TypeMismatch = 0x07,
  Missing = 0x0A,  // the data block does not exist
  Done = 0xFF
};

}  // namespace merker::s7comm
