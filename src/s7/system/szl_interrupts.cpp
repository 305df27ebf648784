// The OBs of a CPU as SZL shows them (S7-DIAG-05): which event starts an OB (16#xy21), what is
// known of one (16#0222), which process image belongs to it (16#xy25). Records: reference manual
// "System Software for S7-300/400", 33.12 and 33.13; of 16#xy21, which it does not print: a CPU
// 315-2 PN/DP.
#include <algorithm>
#include <array>

#include "base/bytes.h"
#include "cpu/levels.h"
#include "system/szl.h"

namespace merker::system {
namespace {

// The first event that starts the OBs from `ob` on; each one behind it has the next number.
struct FirstEvent {
  std::uint8_t ob, eventClass, number;
};

constexpr std::uint8_t kInterrupt = 0x10, kFault = 0x35, kFailure = 0x39, kStartup = 0x13,
                       kSynchronous = 0x25;

constexpr FirstEvent kFirstEvents[] = {
    {1, kInterrupt, 0x01},    {10, kInterrupt, 0x11}, {20, kInterrupt, 0x21},
    {30, kInterrupt, 0x31},   {40, kInterrupt, 0x41}, {55, kInterrupt, 0x55},
    {60, kInterrupt, 0x63},   {80, kFault, 0x01},     {81, kFailure, 0x21},
    {82, kFailure, 0x42},     {83, kFailure, 0x61},   {84, kFault, 0x81},
    {85, kFault, 0xA1},       {86, kFailure, 0xC1},   {87, kFault, 0xD2},
    {88, kFault, 0x71},       {90, kInterrupt, 0x91}, {100, kStartup, 0x81},
    {101, kStartup, 0x82},    {102, kStartup, 0x85},  {121, kSynchronous, 0x21},
    {122, kSynchronous, 0x42}};

constexpr std::uint32_t kNotLoaded = 0xFE;  // in place of the priority class

FirstEvent eventOf(std::uint8_t ob) {
  const auto* const next = std::upper_bound(
      std::begin(kFirstEvents), std::end(kFirstEvents), ob,
      [](std::uint8_t number, const FirstEvent& event) { return number < event.ob; });
  const FirstEvent& first = *std::prev(next);
  return {ob, first.eventClass, static_cast<std::uint8_t>(first.number + (ob - first.ob))};
}

// Interrupts have their priority class without an OB, too; errors and startups get theirs with it.
std::uint32_t priorityShown(const SzlSource& source, const FirstEvent& event) {
  const bool loaded = cpu::hasOb(source.cpu.machine(), event.ob);
  return loaded || event.eventClass == kInterrupt ? cpu::priorityOf(event.ob) : kNotLoaded;
}

// Of OB 1: shortest and longest cycle, ms.
void cycleLimits(const SzlSource& source, SzlList& list) {
  const cpu::CycleTimes& times = source.cpu.cycle().times();
  list.word(static_cast<std::uint16_t>(times.shortest));
  list.word(static_cast<std::uint16_t>(times.longest));
}

void interruptStatus(const SzlSource& source, std::uint8_t ob, SzlList& list) {
  constexpr std::uint32_t kCycle = 1, kRunning = 0x01, kLoaded = 0x10, kDiscarded = 0x08;
  const FirstEvent event = eventOf(ob);
  const bool loaded = cpu::hasOb(source.cpu.machine(), ob);
  list.byte(event.eventClass | (ob == kCycle ? kRunning : 0u));
  list.byte(ob == kCycle ? 0x03u : event.number);  // a cycle behind the first one
  list.byte(priorityShown(source, event));
  list.byte(ob);
  list.dword(0);
  ob == kCycle ? cycleLimits(source, list) : list.dword(0);
  list.dword(0);
  list.dword(0);
  list.word(loaded ? kLoaded : 0);
  list.word(kDiscarded);  // what an event without an OB leads to
  list.dword(0);
}

bool exists(const SzlSource& source, std::uint32_t ob) {
  return ob <= 0xFF && source.cpu.machine().model->hasOrganizationBlock(ob);
}

}  // namespace

void szlStartEvents(const SzlSource& source, std::uint32_t, SzlList& list) {
  for (const std::uint8_t ob : source.cpu.machine().model->organizationBlocks) {
    const FirstEvent event = eventOf(ob);
    const bool loaded = cpu::hasOb(source.cpu.machine(), ob);
    list.byte(event.eventClass == kInterrupt ? 1 : 0);
    list.byte(event.number);
    list.byte(loaded ? cpu::priorityOf(ob) : kNotLoaded);
    list.byte(ob);
  }
}

// Of those that are loaded.
void szlLoadedEvents(const SzlSource& source, std::uint32_t, SzlList& list) {
  SzlList all;
  szlStartEvents(source, 0, all);
  for (std::size_t i = 0; i + 4 <= all.data.size(); i += 4)
    if (all.data[i + 2] != kNotLoaded) list.dword(loadDWord(&all.data[i]));
}

// INDEX: the number of the OB; 0 is the cycle, too.
void szlInterruptStatus(const SzlSource& source, std::uint32_t index, SzlList& list) {
  const std::uint32_t ob = index == 0 ? 1 : index;
  if (exists(source, ob)) interruptStatus(source, static_cast<std::uint8_t>(ob), list);
}

// There is one process image, 0, and OB 1 has its inputs and outputs: no list mentions it unless it
// is asked for.
void szlProcessImages(const SzlSource&, std::uint32_t, SzlList&) {}

void szlProcessImage(const SzlSource&, std::uint32_t image, SzlList& list) {
  if (image == 0) list.dword(0x00030100);
}

void szlProcessImageOfOb(const SzlSource&, std::uint32_t ob, SzlList& list) {
  if (ob == 1) list.dword(0x00030100);
}

}  // namespace merker::system
