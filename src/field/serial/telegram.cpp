#include "serial/telegram.h"

#include <algorithm>
#include <array>

namespace merker::serial {
namespace {

std::uint8_t low(unsigned value) { return static_cast<std::uint8_t>(value & 0xFFU); }
std::uint8_t high(unsigned value) { return low(value >> 8U); }

// 'O' for a destination DX: the table of 6.5.2.2 prints "AD" there (PTP-OPEN-03).
std::uint8_t letterOf(const LinkJob& job) {
  if (job.fetch) return 'E';
  return job.type == 'X' ? 'O' : 'A';
}

std::uint8_t sourceOf(const LinkJob& job) {
  return static_cast<std::uint8_t>(job.fetch ? job.type : 'D');
}

// Byte 10: CPU number and bit of the flag, FH where there is none (PTP-RK512-11).
std::uint8_t cpuAndBit(const LinkJob& job) {
  const unsigned none = job.flag.used() ? 0U : 0xFU;
  const unsigned cpu = job.cpu == 0 ? none : job.cpu;
  const unsigned bit = job.flag.used() ? job.flag.bit : 0xFU;
  return low(cpu << 4U | bit);
}

Command refused(Command command, Event event, std::uint8_t error) {
  command.event = event;
  command.error = error;
  return command;
}

// Bytes 5 to 8: the area.
void readArea(std::span<const std::uint8_t> t, LinkJob& job, unsigned& count) {
  count = static_cast<unsigned>(t[6]) << 8U | t[7];
  if (job.inBlock()) {
    job.block = t[4];
    job.offset = static_cast<std::uint16_t>(t[5] * 2U);
  } else {
    job.offset = static_cast<std::uint16_t>(t[4] << 8U | t[5]);
  }
}

// Bytes 9 and 10; bit number F means that there is no flag.
Event readFlag(std::span<const std::uint8_t> t, LinkJob& job) {
  const unsigned bit = t[9] & 0xFU, cpu = t[9] >> 4U;
  if (t[8] != 0xFF && bit != 0xF) {
    if (bit > 7) return Event::HeaderFlag;
    job.flag = {t[8], low(bit)};
  }
  if (cpu > 4 && cpu != 0xF) return Event::HeaderCpu;
  job.cpu = cpu == 0xF ? std::uint8_t{0} : low(cpu);
  return Event::None;
}

// Letters of S7 areas; an extended data block is none (PTP-SFB65-07).
bool provides(const LinkJob& job, std::uint8_t letter) {
  constexpr std::array<char, 6> kFetched{'D', 'M', 'E', 'A', 'Z', 'T'};
  if (!job.fetch) return job.type == 'D' && letter == 'D';
  return std::find(kFetched.begin(), kFetched.end(), job.type) != kFetched.end();
}

// The order of the checks is that of the bytes (PTP-RK512-40).
Command readFirst(std::span<const std::uint8_t> t, Command command) {
  LinkJob& job = command.job;
  if (!provides(job, t[3])) return refused(command, Event::HeaderByte4, 0x10);
  unsigned count = 0;
  readArea(t, job, count);
  if (job.inBlock() && job.block == 0) return refused(command, Event::HeaderByte5, 0x14);
  command.addressed = true;
  const std::size_t bytes = std::size_t{count} * (job.inWords() ? 2 : 1);
  const std::size_t data = job.fetch ? 0 : std::min(bytes, kPart);
  if (bytes == 0 || bytes > kLongest || t.size() != command.header + data)
    return refused(command, Event::HeaderLength, 0x34);
  job.length = static_cast<std::uint16_t>(bytes);
  const Event flag = readFlag(t, job);
  return flag == Event::None ? command : refused(command, flag, 0x0C);
}

}  // namespace

Bytes firstCommand(const LinkJob& job) {
  const unsigned count = job.inWords() ? job.transferred() / 2U : job.length;
  const std::uint8_t address = job.inBlock() ? job.block : high(job.offset);
  const std::uint8_t second = job.inBlock() ? low(job.offset / 2U) : low(job.offset);
  return {0x00,   0x00,        letterOf(job), sourceOf(job), address,
          second, high(count), low(count),    job.flag.byte, cpuAndBit(job)};
}

Bytes followOnCommand(const LinkJob& job) { return {0xFF, 0x00, letterOf(job), sourceOf(job)}; }

Bytes reaction(bool followOn, std::uint8_t error) {
  return {followOn ? std::uint8_t{0xFF} : std::uint8_t{0x00}, 0x00, 0x00, error};
}

bool isReaction(std::span<const std::uint8_t> telegram) {
  return telegram.size() > 2 && telegram[2] == 0;
}

Command read(std::span<const std::uint8_t> t) {
  Command command;
  command.followOn = !t.empty() && t[0] == 0xFF;
  command.header = command.followOn ? 4 : 10;
  if (t.size() < command.header) return refused(command, Event::HeaderShort, 0x34);
  if (t[0] != 0x00 && t[0] != 0xFF) return refused(command, Event::HeaderByte1, 0x10);
  if (t[2] != 'A' && t[2] != 'O' && t[2] != 'E') return refused(command, Event::HeaderByte3, 0x16);
  command.job.fetch = t[2] == 'E';
  command.job.type = t[2] == 'O' ? 'X' : static_cast<char>(t[3]);
  return command.followOn ? command : readFirst(t, command);
}

Event eventOfReaction(std::uint8_t error) {
  struct Row {
    std::uint8_t error;
    Event event;
  };
  static constexpr Row kRows[] = {{0x0A, Event::PartnerError},      {0x0C, Event::PartnerMemory},
                                  {0x10, Event::PartnerHeader},     {0x12, Event::PartnerJob},
                                  {0x14, Event::PartnerBlock},      {0x16, Event::PartnerByte3},
                                  {0x2A, Event::PartnerNotStarted}, {0x32, Event::PartnerLocked},
                                  {0x34, Event::PartnerLength},     {0x36, Event::PartnerSequence}};
  for (const Row& row : kRows)
    if (row.error == error) return row.event;
  return Event::PartnerUnknown;
}

}  // namespace merker::serial
