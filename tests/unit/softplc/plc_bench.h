// A PLC with pieces of machine code as its blocks.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>

#include "mc5/place.h"
#include "softplc/plc.h"

namespace merker::sinumerik {

inline Instant at(std::int64_t microseconds) { return {microseconds * 1000}; }

inline Reference memory(mc5::Area area, mc5::Width width, unsigned byte, unsigned bit = 0) {
  Reference reference;
  reference.operand = mc5::placeOf({.kind = mc5::OperandKind::Memory,
                                    .area = area,
                                    .width = width,
                                    .bit = static_cast<std::uint8_t>(bit),
                                    .value = byte});
  return reference;
}
inline Reference flagByte(unsigned byte) { return memory(mc5::Area::Flag, mc5::Width::Byte, byte); }
inline Reference flagWord(unsigned byte) { return memory(mc5::Area::Flag, mc5::Width::Word, byte); }
inline Reference inputBit(unsigned byte, unsigned bit) {
  return memory(mc5::Area::Input, mc5::Width::Bit, byte, bit);
}
inline Reference dataWord(std::uint16_t db, unsigned word) {
  Reference reference = memory(mc5::Area::Data, mc5::Width::Word, word);
  reference.db = db;
  return reference;
}
// As LC loads it.
inline Reference cell(address::OperandKind kind, unsigned number) {
  Reference reference;
  reference.operand = {kind, merker::Area::None, merker::Width::Word, number};
  return reference;
}

// Codes that the tests use often (checked against the encoder in plc_bench_test).
namespace code {
constexpr unsigned kBlockEnd = 0x6500, kLoadKh = 0x3040, kTransferFlagWord = 0x1300;
constexpr unsigned kLoadConstantByte = 0x2800, kTransferFlagByte = 0x0B00, kLoadFlagByte = 0x0A00;
constexpr unsigned kLoadFlagWord = 0x1200, kAddFixed = 0x7900, kStp = 0x7003;
constexpr unsigned kJump = 0x2D00, kCallPb = 0x7500, kCallFb = 0x3D00, kOpenDb = 0x2000;
}  // namespace code

// MW n := MW n + 1.
inline std::vector<unsigned> countUp(unsigned flagWord) {
  return {code::kLoadFlagWord | flagWord, 0x2801, code::kAddFixed,
          code::kTransferFlagWord | flagWord};
}

// A piece that takes this long on the ACOP: a loop of L KB 1 (0.25 µs) would be long to run, so
// +G with 193 µs each does it.
inline std::vector<unsigned> burn(unsigned microseconds) {
  return std::vector<unsigned>(microseconds / 193, 0x600F);
}

struct PlcBench {
  static mc5::Block make(mc5::BlockType type, std::uint16_t number,
                         const std::vector<unsigned>& words) {
    mc5::Block block;
    block.id = {type, number};
    for (const unsigned word : words) block.words.push_back(static_cast<std::uint16_t>(word));
    return block;
  }
  // Code gets its BE.
  PlcBench& block(mc5::BlockType type, std::uint16_t number, std::vector<unsigned> words) {
    if (type != mc5::BlockType::Db) words.push_back(code::kBlockEnd);
    options.program[{type, number}] = make(type, number, words);
    return *this;
  }
  PlcBench& ob(std::uint16_t number, std::vector<unsigned> words) {
    return block(mc5::BlockType::Ob, number, std::move(words));
  }
  // Machine data as if the project had them; without OB 2 the alarm level is off.
  MachineData& data() {
    if (!options.machineData)
      options.machineData =
          MachineData::standard(options.program.contains({mc5::BlockType::Ob, 2}));
    return *options.machineData;
  }
  Plc& plc() {
    if (!built) built.emplace(options);
    return *built;
  }
  // Builds and cold-starts.
  Plc& run() {
    plc().coldStart();
    return plc();
  }
  bool refuses(Alarm alarm) {
    run();
    return stopped(alarm);
  }
  bool stopped(Alarm alarm) {
    return plc().mode() == Mode::Stop &&
           plc().programmer().address(0xF001) == toBcdWord(number(alarm));
  }
  static std::uint16_t toBcdWord(unsigned value) {
    return static_cast<std::uint16_t>((value / 1000) << 12 | (value / 100 % 10) << 8 |
                                      (value / 10 % 10) << 4 | value % 10);
  }
  unsigned value(const Reference& variable) { return plc().read(variable).value_or(0xDEAD); }

  Options options;
  std::optional<Plc> built;
};

}  // namespace merker::sinumerik
