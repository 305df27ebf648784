// SFC 51 RDSYSST (S7-SFC-19) and the table of the lists.
#include "system/szl.h"

#include <algorithm>

#include "base/bytes.h"
#include "system/call.h"

namespace merker::system {
namespace {

enum class Part : std::uint8_t { All, One, Some };

struct Row {
  std::uint16_t number;
  std::uint16_t recordLength;
  Part part;  // One: the records that INDEX names, which must exist; Some: if there are any
  void (*fill)(const SzlSource&, std::uint32_t index, SzlList&);
};

constexpr Row kRows[] = {
    {0x0011, 28, Part::All, szlIdentification},
    {0x0111, 28, Part::One, szlIdentification},
    {0x0012, 2, Part::All, szlCharacteristics},
    {0x0112, 2, Part::Some, szlCharacteristics},
    {0x0013, 36, Part::All, szlMemory},
    {0x0113, 36, Part::One, szlMemory},
    {0x0014, 8, Part::All, szlAreas},
    {0x0114, 8, Part::One, szlAreas},
    {0x0015, 10, Part::All, szlBlockTypes},
    {0x0115, 10, Part::One, szlBlockTypes},
    {0x0018, 4, Part::All, szlExpansion},
    {0x0118, 4, Part::One, szlOneExpansion},
    {0x0019, 4, Part::All, szlLeds},
    {0x0119, 4, Part::One, szlLeds},
    {0x001C, 34, Part::All, szlNames},
    {0x011C, 34, Part::One, szlNames},
    {0x0021, 4, Part::All, szlStartEvents},
    {0x0A21, 4, Part::All, szlLoadedEvents},
    {0x0222, 28, Part::One, szlInterruptStatus},
    {0x0024, 20, Part::All, szlAllModes},
    {0x0124, 20, Part::All, szlLastMode},
    {0x0424, 20, Part::All, szlCurrentMode},
    {0x0524, 20, Part::One, szlOneMode},
    {0x0025, 4, Part::All, szlProcessImages},
    {0x0125, 4, Part::Some, szlProcessImage},
    {0x0225, 4, Part::Some, szlProcessImageOfOb},
    {0x0131, 40, Part::One, szlOffers},
    {0x0132, 40, Part::One, szlCommunication},
    {0x0232, 40, Part::One, szlProtection},
    {0x0037, 48, Part::All, szlEthernet},
    {0x0137, 48, Part::One, szlEthernet},
    {0x0074, 4, Part::All, szlLeds},
    {0x0174, 4, Part::One, szlLeds},
    {0x0591, 16, Part::All, szlSubmodules},
    {0x0A91, 16, Part::All, szlMasterSystems},
    {0x0C91, 16, Part::One, szlModuleByAddress},
    {0x0D91, 16, Part::One, szlModulesOfRack},
    {0x0092, 16, Part::One, szlRacks},
    {0x0292, 16, Part::One, szlRacks},
    {0x0692, 16, Part::One, szlFaultyRacks},
    {0x0094, 258, Part::One, szlStations},
    {0x0294, 258, Part::One, szlStations},
    {0x0694, 258, Part::One, szlFaultyStations},
    {0x0794, 258, Part::One, szlFaultyStations},
    {0x00A0, 20, Part::All, szlDiagnostics},
    {0x01A0, 20, Part::Some, szlLatestDiagnostics},
    {0x00B1, 4, Part::One, szlRecord0},
    {0x00B2, 0, Part::One, szlRecord1BySlot},
    {0x00B3, 0, Part::One, szlRecord1ByAddress},
};

constexpr std::uint32_t kExtract = 0x0F00;

// The numbers of all lists (16#0000).
void listOfLists(SzlList& list) {
  list.recordLength = 2;
  list.word(0x0000);
  for (const Row& row : kRows) list.word(row.number);
}

// The row of a list; of a head alone, any extract of it that there is.
const Row* findRow(std::uint32_t number) {
  const bool headOnly = (number & kExtract) == kExtract;
  const auto is = [&](std::uint32_t wanted, std::uint32_t mask) {
    return std::ranges::find_if(
        kRows, [=](const Row& row) { return (row.number & mask) == (wanted & mask); });
  };
  const Row* row = is(headOnly ? number & ~kExtract : number, 0xFFFF);
  if (row == std::end(kRows) && headOnly) row = is(number, ~kExtract);
  return row == std::end(kRows) ? nullptr : row;
}

void fillList(const SzlSource& source, std::uint32_t number, std::uint32_t index, SzlList& list) {
  if (number == 0 || number == kExtract) return listOfLists(list);
  const Row* const row = findRow(number);
  if (row == nullptr) {
    list.error = kSzlUnknown;
    return;
  }
  list.recordLength = row->recordLength;
  // a whole list does not look at INDEX: 0 takes every record
  row->fill(source, row->part == Part::All ? 0 : index, list);
  if (list.error == 0 && list.data.empty() && row->part == Part::One) list.error = kSzlIndex;
}

}  // namespace

SzlList readSzl(const SzlSource& source, std::uint32_t number, std::uint32_t index) {
  SzlList list;
  const bool headOnly = (number & kExtract) == kExtract;
  fillList(source, number, index, list);
  if (list.recordLength != 0)
    list.records = static_cast<std::uint16_t>(list.data.size() / list.recordLength);
  if (list.error != 0 || headOnly) list.data.clear();
  return list;
}

// Everything is at hand: BUSY is never 1.
void readSystemStatus(Sfc<51>& a) {
  constexpr std::uint32_t kPart = 0x0081, kTooShort = 0x8081;
  a.set("BUSY", 0);
  if (!a.flag("REQ")) return a.status(kNoJob);
  const SzlList list =
      readSzl({a.cpu(), a.modules(), &a.communication()}, a.value("SZL_ID"), a.value("INDEX"));
  if (list.error != 0) return a.status(list.error);
  const Region header = a.structure("SZL_HEADER", 4);
  if (!header) return a.parameterError("SZL_HEADER", header.error);
  const AnyPointer where = a.any("DR");
  const bool data = !list.data.empty();
  const std::uint32_t room = data ? byteCount(where) / list.recordLength : list.records;
  const std::uint32_t fitting = std::min<std::uint32_t>(room, list.records);
  if (data && fitting == 0) return a.status(kTooShort);
  const std::uint32_t bytes = data ? fitting * list.recordLength : 0;
  const Region target = a.region(where, bytes, cpu::Access::Write);
  if (data && !target) return a.parameterError("DR", target.error);
  storeWord(header.data, list.recordLength);
  storeWord(header.data + 2, fitting);
  if (data) std::copy_n(list.data.begin(), bytes, target.data);
  a.status(fitting < list.records ? kPart : 0);
}

}  // namespace merker::system
