// The layout of cpu::Machine.
#include "jit/layout.h"

#include "cpu/areas.h"
#include "jit/native.h"

namespace merker::jit {
namespace {

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
constexpr int accu(int number) {
  return offset::kRegisters + static_cast<int>(offsetof(cpu::Registers, accu)) + 4 * number;
}
#define STATUS(bit) offset::kStatus + static_cast<int>(offsetof(cpu::StatusWord, bit))
// In the order of icode::Item.
constexpr std::array<int, icode::kItems> kItems = {
    accu(0),
    accu(1),
    accu(2),
    accu(3),
    offset::kRegisters + static_cast<int>(offsetof(cpu::Registers, ar1)),
    offset::kAr2,
    STATUS(er),
    STATUS(rlo),
    STATUS(sta),
    STATUS(orBit),
    STATUS(os),
    STATUS(ov),
    STATUS(cc0),
    STATUS(cc1),
    STATUS(br)};
#undef STATUS
#pragma GCC diagnostic pop

constexpr Layout::Open openBlock(int block) {
  return {block + static_cast<int>(offsetof(cpu::OpenBlock, data)),
          block + static_cast<int>(offsetof(cpu::OpenBlock, length)),
          block + static_cast<int>(offsetof(cpu::OpenBlock, writable))};
}

}  // namespace

Layout layoutOf(const CpuModel& model) {
  return {.clock = offset::kClock,
          .horizon = offset::kHorizon,
          .image = offset::kImage,
          .instructions = offset::kInstructions,
          .items = kItems,
          .images = {cpu::imageBase(model, Area::Input), cpu::imageBase(model, Area::Output),
                     cpu::imageBase(model, Area::Flag)},
          .data = openBlock(offset::kDb),
          .instance = openBlock(offset::kDi)};
}

}  // namespace merker::jit
