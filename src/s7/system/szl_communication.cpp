// What a CPU does for others: connections, test jobs, protection, clock (16#xy31 INDEX 1, 16#xy32;
// S7-DIAG-05). Records: reference manual "System Software for S7-300/400", 33.15 and 33.16; those
// that it does not print: the dissector of Wireshark, a CPU 315-2 PN/DP, and the list of VIPA
// SPEED7.
#include <algorithm>

#include "system/szl.h"

namespace merker::system {
namespace {

constexpr std::size_t kMeters = 8;
constexpr std::uint32_t kMpiRate = 187'500;  // bit/s, of the K bus as well (S7-NET-25)

cpu::RuntimeMeter meterOf(cpu::Cpu& cpu, std::size_t number) {
  return number < cpu.runtimeMeters().size() ? cpu.runtimeMeters()[number] : cpu::RuntimeMeter{};
}

// A bit for each meter that `is` so.
template <typename Is>
std::uint32_t meterBits(cpu::Cpu& cpu, Is is) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < kMeters; ++i)
    if (is(meterOf(cpu, i))) bits |= 1u << i;
  return bits;
}

std::uint32_t runningMeters(cpu::Cpu& cpu) {
  return meterBits(cpu, [](const cpu::RuntimeMeter& meter) { return meter.running; });
}

std::uint32_t overflownMeters(cpu::Cpu& cpu) {
  const Instant now = cpu.machine().clock;
  return meterBits(cpu, [now](const cpu::RuntimeMeter& meter) { return meter.overflow(now); });
}

// INDEX 8: the clock and the meters of 16 bits.
void timeSystem(const SzlSource& source, SzlList& list) {
  cpu::Cpu& cpu = source.cpu;
  const Instant now = cpu.machine().clock;
  list.dword(0);  // cycle of synchronisation, correction
  for (std::size_t i = 0; i < kMeters; ++i)
    list.word(static_cast<std::uint32_t>(meterOf(cpu, i).hours(now)));
  for (const std::uint8_t byte : cpu::toDateAndTime(cpu.clock().milliseconds(now))) list.byte(byte);
  list.word(runningMeters(cpu) << 8);
  list.word(overflownMeters(cpu) << 8);
}

// INDEX 0Bh: the same meters in 32 bits.
void longMeters(const SzlSource& source, SzlList& list) {
  list.word(runningMeters(source.cpu) << 8);
  list.word(overflownMeters(source.cpu) << 8);
  for (std::size_t i = 0; i < kMeters; ++i)
    list.dword(
        static_cast<std::uint32_t>(meterOf(source.cpu, i).hours(source.cpu.machine().clock)));
}

// Protection levels by the switch, by parameters (0: no password) and the one that counts; position
// of the mode switch.
void protection(const SzlSource& source, SzlList& list) {
  const cpu::Cpu& cpu = source.cpu;
  using enum cpu::SwitchPosition;
  const cpu::SwitchPosition position = cpu.modeSwitch().position();
  const std::uint32_t bySwitch = position == Run ? 2 : 1;
  const auto& parameters = cpu.parameters();
  const std::uint32_t byPassword = parameters.password.empty() ? 0u : parameters.protection;
  list.word(bySwitch);
  list.word(byPassword);
  list.word(std::max(bySwitch, byPassword));
  list.word(position == Run ? 1 : position == RunP ? 2 : position == Stop ? 3 : 4);
}

// INDEX 1: connections kept for PG and OP, those that each of them has, configured ones and how
// many of these stand, free ones and how many of these are in use, communication load.
void connectionStatus(const SzlSource& source, SzlList& list) {
  const Communication now = communicationOf(source);
  const CommunicationParameters& set = now.parameters;
  const auto beyond = [](std::uint32_t used, std::uint32_t kept) {
    return used > kept ? used - kept : 0;
  };
  const std::uint32_t kept = set.pg + set.op + set.basic;
  list.word(set.pg), list.word(set.op);
  list.word(now.used[0]), list.word(now.used[1]);
  list.word(0), list.word(0);
  list.word(beyond(now.connections(), kept));
  list.word(beyond(now.used[0], set.pg) + beyond(now.used[1], set.op) +
            beyond(now.used[2], set.basic));
  list.word(source.cpu.parameters().communicationLoad);
}

// INDEX 2: jobs of test and installation.
void testStatus(const SzlSource& source, SzlList& list) {
  list.word(communicationOf(source).testJobs);
}

// INDEX 5: no extended functions; it sends by itself, also what a program says.
void diagnosisStatus(const SzlSource&, SzlList& list) {
  for (const std::uint32_t word : {0u, 1u, 1u}) list.word(word);
}

// INDEX 9 and 0Ah: of MPI and of the K bus.
void busRate(const SzlSource&, SzlList& list) { list.dword(kMpiRate); }

// INDEX 3, 6, 7, 0Ch: panels, configured connections, global data, clock status; nothing of it.
void nothingMore(const SzlSource&, SzlList&) {}

constexpr struct {
  std::uint32_t index;
  void (*fill)(const SzlSource&, SzlList&);
} kStatusRows[] = {{1, connectionStatus}, {2, testStatus},  {3, nothingMore}, {4, protection},
                   {5, diagnosisStatus},  {6, nothingMore}, {7, nothingMore}, {8, timeSystem},
                   {9, busRate},          {10, busRate},    {11, longMeters}, {12, nothingMore}};

}  // namespace

void szlCommunication(const SzlSource& source, std::uint32_t index, SzlList& list) {
  const auto* const row =
      std::ranges::find(kStatusRows, index, [](const auto& one) { return one.index; });
  if (row == std::end(kStatusRows)) return;
  list.word(index);
  row->fill(source, list);
  list.data.resize(list.recordLength);
}

void szlProtection(const SzlSource& source, std::uint32_t index, SzlList& list) {
  if (index == 4) szlCommunication(source, index, list);
}

// Bytes of a PDU, connections, bit/s of MPI (S7-LIM-01, -05, S7-NET-25).
void szlConnections(const SzlSource& source, SzlList& list) {
  const Communication now = communicationOf(source);
  list.word(now.parameters.pdu);
  list.word(now.connections());
  list.dword(kMpiRate);
}

// Reference manual "System Software for S7-300/400", 33.20. The logical base address is that of a
// CPU 315-2 PN/DP. Without a router the own address stands for it; ports are not known.
void szlEthernet(const SzlSource& source, std::uint32_t index, SzlList& list) {
  constexpr std::uint32_t kBase = 0x07FE, kConfigured = 1;
  const auto ethernet = communicationOf(source).ethernet;
  if (!ethernet || (index != 0 && index != kBase)) return;
  const auto bytes = [&list](const auto& all) {
    for (const std::uint8_t byte : all) list.byte(byte);
  };
  list.word(kBase);
  bytes(ethernet->address), bytes(ethernet->mask), bytes(ethernet->address);
  bytes(ethernet->hardware);
  list.byte(kConfigured);
  list.data.resize(list.recordLength);
}

Communication communicationOf(const SzlSource& source) {
  if (source.communication != nullptr) return *source.communication;
  return {CommunicationParameters::of(*source.cpu.machine().model), {}, 0};
}

}  // namespace merker::system
