// Retentive data as named runs of bytes, the form in which they lie on a card
// (docs/formats/card.md). Numbers are big-endian.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "plc/retentive.h"

namespace merker::store {

struct AreaId {
  std::string kind;  // "state", "M", "T", "Z", "meters", "DB", "made DB", "diagnostics"
  std::uint16_t number = 0;
  auto operator<=>(const AreaId&) const = default;
};

using Bytes = std::vector<std::uint8_t>;

extern const AreaId kStateArea, kFlagArea, kTimerArea, kCounterArea, kMeterArea, kDiagnosticArea;
// Those that each card has on which something was kept.
const std::set<AreaId>& areasOfEachCard();
AreaId areaOf(const block::RetentiveDataBlock& block);

Bytes stateBytes(const block::RetentiveData& data);
Bytes timerBytes(const block::RetentiveData& data);
Bytes counterBytes(const block::RetentiveData& data);
Bytes meterBytes(const block::RetentiveData& data);
Bytes diagnosticBytes(const block::RetentiveData& data);

// The other way; throws Damage if the bytes say what no CPU can have.
block::RetentiveData fromAreas(const std::map<AreaId, Bytes>& areas);

}  // namespace merker::store
