// One transfer between the NC and the PLC: checked when FB 61 or FB 62 takes it, done when its
// turn in the FIFO has come.
#pragma once

#include "nc/macro_error.h"
#include "nc/request.h"

namespace merker::nc {

constexpr std::uint16_t kReadMacro = 61, kWriteMacro = 62;

// Error numbers of FB 61 and FB 62 (S5-FM-34), low byte of AKKU 2.
enum class JobError : std::uint8_t {
  NumberAboveOne = 0,
  InterfaceByte = 1,
  Place = 2,
  Type = 3,
  Number = 4,
  Direction = 5,
  Format = 6,
  CoarseOrFine = 7,
  NotEnabled = 8
};

// Words of a data block, or flags.
struct Place {
  std::uint8_t block = 0;  // 0: flags
  std::uint8_t first = 0;  // word, or byte of the flags
};

struct Job {
  bool write = false;  // FB 62: from the PLC to the NC
  unsigned interfaceByte = 0;
  const DataType* type = nullptr;
  Where where{};
  unsigned values = 1;
  Format format = Format::F0;
  Place place;

  std::uint16_t macro() const { return write ? kWriteMacro : kReadMacro; }
};

struct Checked {
  Job job;
  std::optional<JobError> error;
};
Checked makeJob(const Request& request, sinumerik::Machine& machine, Model model);

enum class Result : std::uint8_t {
  Done,
  Refused,      // FEHLER in the interface byte; when writing NC alarm 3016 (S5-FM-35)
  WrongFormat,  // stops the PLC: error 6
  NoPlace       // error 2: the data block has gone meanwhile
};
Result execute(const Job& job, Control& control, sinumerik::Machine& machine);

}  // namespace merker::nc
