#include "station/machine_layout.h"

#include <cstddef>
#include <vector>

#include "cpu/areas.h"
#include "cpu/machine.h"
#include "cpu/start_information.h"

namespace merker::station {
namespace {

using cpu::Machine;
using cpu::S5Counter;
using cpu::S5Timer;
using jit::Layout;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
#define AT(type, name) static_cast<int>(offsetof(type, name))
#define REGISTER(name) (AT(Machine, registers) + AT(cpu::Registers, name))
#define STATUS(bit) (REGISTER(status) + AT(cpu::StatusWord, bit))
#define FRAME(name) AT(cpu::Frame, name)

// A vector begins with the addresses of its first entry and behind its last one.
constexpr Layout::List listAt(int vector) {
  return {vector, vector + static_cast<int>(sizeof(void*))};
}

constexpr Layout::Open openAt(int begin) {
  return {.begin = begin,
          .data = begin + AT(cpu::OpenBlock, data),
          .length = begin + AT(cpu::OpenBlock, length),
          .writable = begin + AT(cpu::OpenBlock, writable),
          .number = begin + AT(cpu::OpenBlock, number)};
}

constexpr int accu(int number) { return REGISTER(accu) + 4 * number; }

// In the order of icode::Item.
constexpr std::array<int, icode::kItems> kItems = {
    accu(0),       accu(1),    accu(2),     accu(3),     REGISTER(ar1),
    REGISTER(ar2), STATUS(er), STATUS(rlo), STATUS(sta), STATUS(orBit),
    STATUS(os),    STATUS(ov), STATUS(cc0), STATUS(cc1), STATUS(br)};

// In the order of icode::Field.
constexpr std::array<int, icode::kFields> kFields = {
    AT(S5Timer, kind),     AT(S5Timer, startEdge),  AT(S5Timer, enableEdge),
    AT(S5Timer, started),  AT(S5Timer, held),       AT(S5Timer, base),
    AT(S5Timer, frozen),   AT(S5Counter, count),    AT(S5Counter, setEdge),
    AT(S5Counter, upEdge), AT(S5Counter, downEdge), AT(S5Counter, enableEdge)};

constexpr Layout::Frame kFrame = {.bytes = sizeof(cpu::Frame),
                                  .code = FRAME(code),
                                  .resume = FRAME(resume),
                                  .first = FRAME(first),
                                  .local = FRAME(local),
                                  .localLength = FRAME(localLength),
                                  .localEnd = FRAME(localEnd),
                                  .parameters = FRAME(parameters),
                                  .parameterCount = FRAME(parameterCount),
                                  .data = FRAME(db),
                                  .ar2 = FRAME(ar2),
                                  .relayActive = FRAME(mcrActive),
                                  .relayDepth = FRAME(mcrDepth),
                                  .bracketDepth = FRAME(bracketDepth)};

// What compiled code expects of them all; it is written for hosts of 64 bits alone.
static_assert(sizeof(void*) != 8 ||
              (sizeof(cpu::OpenBlock) == Layout::kOpenBytes &&
               REGISTER(di) == REGISTER(db) + Layout::kOpenBytes &&
               FRAME(di) == FRAME(db) + Layout::kOpenBytes && FRAME(first) == FRAME(resume) + 4 &&
               FRAME(local) == FRAME(resume) + 8));
static_assert(sizeof(cpu::DataBlocks) == sizeof(std::vector<cpu::DataBlock>));
static_assert(static_cast<int>(S5Timer::Kind::Pulse) == static_cast<int>(icode::TimerKind::Pulse) &&
              static_cast<int>(S5Timer::Kind::OffDelay) ==
                  static_cast<int>(icode::TimerKind::OffDelay));

Layout::Frames framesOf(const CpuModel& model) {
  return {.top = AT(Machine, top),
          .end = listAt(AT(Machine, frames)).end,
          .callLimit = AT(Machine, callLimit),
          .position = AT(Machine, position),
          .level = listAt(AT(Machine, levels)).end,
          .levelBlocks = AT(cpu::Level, frames) - static_cast<int>(sizeof(cpu::Level)),
          .relayActive = AT(Machine, mcrActive),
          .relayOff = AT(Machine, mcrOff),
          .relays = listAt(AT(Machine, mcrStack)),
          .brackets = listAt(AT(Machine, brackets)),
          .bracketBytes = sizeof(cpu::Bracket),
          .functions = listAt(AT(Machine, functions)),
          .functionBlocks = listAt(AT(Machine, functionBlocks)),
          .localBytes = model.localBytes,
          .watchedBegin = cpu::kDateInStart,
          .watchedEnd = cpu::kDateInStart + std::tuple_size_v<cpu::DateAndTime>,
          .frame = kFrame,
          .code = {.native = AT(cpu::Code, native),
                   .mark = AT(cpu::Code, mark),
                   .localBytes = AT(cpu::Code, localBytes)},
          .dataBlocks = {.list = listAt(AT(Machine, dataBlocks)),
                         .bytes = sizeof(cpu::DataBlock),
                         .open = openAt(AT(cpu::DataBlock, open)),
                         .highest = static_cast<std::uint32_t>(model.highestDb)}};
}

}  // namespace

Layout layoutOf(const CpuModel& model) {
  return {
      .clock = AT(Machine, clock),
      .horizon = AT(Machine, horizon),
      .instructions = AT(Machine, instructions),
      .items = kItems,
      .image = AT(Machine, image),
      .images = {cpu::imageBase(model, Area::Input), cpu::imageBase(model, Area::Output),
                 cpu::imageBase(model, Area::Flag)},
      .imageLengths = {cpu::imageLength(model, Area::Input), cpu::imageLength(model, Area::Output),
                       cpu::imageLength(model, Area::Flag)},
      .data = openAt(REGISTER(db)),
      .instance = openAt(REGISTER(di)),
      .timers = {.first = listAt(AT(Machine, timers)).first, .bytes = sizeof(S5Timer)},
      .counters = {.first = listAt(AT(Machine, counters)).first, .bytes = sizeof(S5Counter)},
      .fields = kFields,
      .timerEnd = AT(S5Timer, end),
      .frames = framesOf(model)};
}

#undef AT
#undef REGISTER
#undef STATUS
#undef FRAME
#pragma GCC diagnostic pop

}  // namespace merker::station
