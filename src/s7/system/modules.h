// The modules as system functions see them: where they are plugged, which addresses they have, and
// their data records. The station fills this in; without it a CPU has no modules.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clock/instant.h"

namespace merker::system {

// User data of one direction: bytes first … first + count - 1 of the periphery; count 0: none.
struct AddressRange {
  std::uint16_t first = 0, count = 0;
  bool contains(std::uint32_t byte) const { return byte >= first && byte - first < count; }
  bool operator==(const AddressRange&) const = default;
};

struct ModulePlace {
  std::uint8_t rack = 0, slot = 0;
  std::uint8_t subslot = 0;  // 2 = DI/DO of a compact CPU, 3 = AI/AO … ; 0 = the module itself
  bool operator==(const ModulePlace&) const = default;
};

struct ModuleInfo {
  ModulePlace place;
  AddressRange inputs, outputs;
  std::uint16_t type = 0;    // as SZL 0D91 shows it: class of the module and kind (S7-DIAG-05)
  bool plugged = true;       // false: configured, but nobody is there
  bool wrongType = false;    // another module than the configured one
  bool diagnostics = false;  // has diagnostic data (records 0 and 1)
  bool distributed = false;  // DP slave: SFC 13 … 15
  bool ethernet = false;     // CP 343-1: AG_SEND, AG_RECV
};

// What a module says to a data record. The codes are those of SFC 58 and SFC 59.
enum class RecordResult : std::uint16_t {
  Good = 0,
  NotAcknowledged = 0x80A1,  // removed or defective
  UnknownRecord = 0x80B0,    // the module does not know this number
  WrongLength = 0x80B1,
  Busy = 0x80C1  // the record before is not yet worked on
};

class Modules {
 public:
  virtual ~Modules() = default;
  // All configured modules with addresses, by rack and slot.
  virtual std::vector<ModuleInfo> all() const = 0;
  virtual RecordResult readRecord(const ModulePlace& place, std::uint8_t number,
                                  std::vector<std::uint8_t>& data) = 0;
  virtual RecordResult writeRecord(const ModulePlace& place, std::uint8_t number,
                                   std::span<const std::uint8_t> data) = 0;
  // Parameters as the hardware configuration has them: SFC 54, 56 and 57 (records of the SDB).
  virtual std::vector<std::uint8_t> configuredRecords(const ModulePlace& place) const = 0;
  virtual std::optional<std::vector<std::uint8_t>> configuredRecord(const ModulePlace& place,
                                                                    std::uint8_t number) const = 0;

  // Of the DP slave with this diagnostic address; none if there is no such slave (SFC 13).
  virtual std::optional<std::vector<std::uint8_t>> slaveDiagnosis(std::uint32_t /*address*/) const {
    return std::nullopt;
  }
  // SFC 11: SYNC, FREEZE and their ends (bits 2 to 5) for all slaves of these groups; RET_VAL.
  struct SlaveCommand {
    std::uint32_t master = 0;  // diagnostic address
    std::uint8_t groups = 0, commands = 0;
  };
  virtual std::uint32_t command(const SlaveCommand& /*command*/, Instant /*now*/) {
    constexpr std::uint32_t kNoMaster = 0x8090;
    return kNoMaster;
  }
};

}  // namespace merker::system
