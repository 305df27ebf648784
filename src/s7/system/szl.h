// The system status list (SZL): what SFC 51 and S7 communication read (S7-DIAG-05). A list is
// one or more records of equal length.
#pragma once

#include <cstdint>
#include <vector>

#include "cpu/cpu.h"
#include "system/communication.h"
#include "system/modules.h"

namespace merker::system {

// What a list is made of.
struct SzlSource {
  cpu::Cpu& cpu;
  Modules* modules = nullptr;
  const Communication* communication = nullptr;  // null: as the model has it, nobody connected
};

struct SzlList {
  std::uint32_t error = 0;         // RET_VAL of SFC 51
  std::uint16_t recordLength = 0;  // bytes
  std::uint16_t records = 0;
  std::vector<std::uint8_t> data;

  void byte(std::uint32_t value) { data.push_back(static_cast<std::uint8_t>(value)); }
  void word(std::uint32_t value) { byte(value >> 8), byte(value); }
  void dword(std::uint32_t value) { word(value >> 16), word(value); }
};

constexpr std::uint32_t kSzlUnknown = 0x8082, kSzlIndex = 0x8083;

// Bits 11..8 of the number say which extract of the list is meant; 16#0Fxy: only its size.
SzlList readSzl(const SzlSource& source, std::uint32_t number, std::uint32_t index);

// As the source says, or as the model has it.
Communication communicationOf(const SzlSource& source);
void szlConnections(const SzlSource&, SzlList&);  // 16#0131, INDEX 1

// The lists: each adds its records.
void szlIdentification(const SzlSource&, std::uint32_t index, SzlList&);     // 16#xy11
void szlCharacteristics(const SzlSource&, std::uint32_t index, SzlList&);    // 16#xy12
void szlMemory(const SzlSource&, std::uint32_t index, SzlList&);             // 16#xy13
void szlAreas(const SzlSource&, std::uint32_t index, SzlList&);              // 16#xy14
void szlBlockTypes(const SzlSource&, std::uint32_t index, SzlList&);         // 16#xy15
void szlLeds(const SzlSource&, std::uint32_t index, SzlList&);               // 16#xy19, 16#xy74
void szlAllModes(const SzlSource&, std::uint32_t index, SzlList&);           // 16#0024
void szlLastMode(const SzlSource&, std::uint32_t index, SzlList&);           // 16#0124
void szlCurrentMode(const SzlSource&, std::uint32_t index, SzlList&);        // 16#0424
void szlOneMode(const SzlSource&, std::uint32_t index, SzlList&);            // 16#0524
void szlCommunication(const SzlSource&, std::uint32_t index, SzlList&);      // 16#0132
void szlOffers(const SzlSource&, std::uint32_t index, SzlList&);             // 16#0131
void szlProtection(const SzlSource&, std::uint32_t index, SzlList&);         // 16#0232
void szlNames(const SzlSource&, std::uint32_t index, SzlList&);              // 16#xy1C
void szlDiagnostics(const SzlSource&, std::uint32_t index, SzlList&);        // 16#00A0
void szlLatestDiagnostics(const SzlSource&, std::uint32_t index, SzlList&);  // 16#01A0
void szlExpansion(const SzlSource&, std::uint32_t index, SzlList&);          // 16#0018
void szlOneExpansion(const SzlSource&, std::uint32_t index, SzlList&);       // 16#0118
void szlStartEvents(const SzlSource&, std::uint32_t index, SzlList&);        // 16#0021
void szlLoadedEvents(const SzlSource&, std::uint32_t index, SzlList&);       // 16#0A21
void szlInterruptStatus(const SzlSource&, std::uint32_t index, SzlList&);    // 16#0222
void szlProcessImages(const SzlSource&, std::uint32_t index, SzlList&);      // 16#0025
void szlProcessImage(const SzlSource&, std::uint32_t index, SzlList&);       // 16#0125
void szlProcessImageOfOb(const SzlSource&, std::uint32_t index, SzlList&);   // 16#0225
void szlEthernet(const SzlSource&, std::uint32_t index, SzlList&);           // 16#xy37
void szlSubmodules(const SzlSource&, std::uint32_t index, SzlList&);         // 16#0591
void szlMasterSystems(const SzlSource&, std::uint32_t index, SzlList&);      // 16#0A91
void szlModuleByAddress(const SzlSource&, std::uint32_t index, SzlList&);    // 16#0C91
void szlModulesOfRack(const SzlSource&, std::uint32_t index, SzlList&);      // 16#0D91
void szlRacks(const SzlSource&, std::uint32_t index, SzlList&);              // 16#0092, 16#0292
void szlFaultyRacks(const SzlSource&, std::uint32_t index, SzlList&);        // 16#0692
void szlStations(const SzlSource&, std::uint32_t index, SzlList&);           // 16#0094, 16#0294
void szlFaultyStations(const SzlSource&, std::uint32_t index, SzlList&);     // 16#0694, 16#0794
void szlRecord0(const SzlSource&, std::uint32_t index, SzlList&);            // 16#00B1
void szlRecord1BySlot(const SzlSource&, std::uint32_t index, SzlList&);      // 16#00B2
void szlRecord1ByAddress(const SzlSource&, std::uint32_t index, SzlList&);   // 16#00B3

}  // namespace merker::system
