// Machine instructions to intermediate code: one function per instruction, by table.
#pragma once

#include <optional>
#include <span>

#include "catalogue/cpu_model.h"
#include "icode/builder.h"
#include "mc7/listing.h"

namespace merker::translate {

// The instruction that is being translated, and what a function may use for it.
struct Lowering {
  icode::Builder& to;
  icode::Needs& needs;
  const CpuModel& model;
  const mc7::Listing& listing;
  std::uint32_t place;
  std::vector<std::array<icode::Value, 3>>& brackets;  // RLO, OR, /ER in front of each
  bool ended = false;  // the way on leads elsewhere: nothing may follow in this region

  const mc7::Instruction& instruction() const { return listing.places[place].instruction; }
  const mc7::Operand& operand() const { return instruction().operand; }
};

// False: not translated; the builder has not been touched.
using Lower = bool (*)(Lowering&);
struct Row {
  mc7::Operation operation;
  Lower lower;
};

std::span<const Row> bitRows();
std::span<const Row> moveRows();
std::span<const Row> numberRows();
std::span<const Row> shiftRows();
std::span<const Row> realRows();
std::span<const Row> jumpRows();
std::span<const Row> callRows();

// Operands. Nothing: this operand is not translated.
std::optional<icode::Value> readBit(Lowering& l);
std::optional<icode::Value> readOperand(Lowering& l, Width width);
bool writeOperand(Lowering& l, Width width, icode::Value value);
// Timer, counter or block: in a word of memory, or handed over as parameter.
std::optional<icode::Value> numberOperand(Lowering& l);
// A bit in memory as the byte around it.
struct BitPlace {
  icode::Space space = icode::Space::Input;
  std::uint32_t place = 0;                 // direct
  icode::Value offset = icode::kNoValue;   // otherwise: the byte in its space …
  icode::Value address = icode::kNoValue;  // … or anywhere
  icode::Value bit = icode::kNoValue;
  std::uint32_t direct = 0;  // bit
};
std::optional<BitPlace> bitPlace(Lowering& l, bool write);
icode::Value loadByte(Lowering& l, const BitPlace& place);
void storeByte(Lowering& l, const BitPlace& place, icode::Value byte);
// The byte with the bit as told.
icode::Value withBit(Lowering& l, const BitPlace& place, icode::Value byte, icode::Value bit);
icode::Value bitIn(Lowering& l, const BitPlace& place, icode::Value byte);

// Whether U( at this place has its ) in the same region, and nothing between that can fail.
bool bracketIsWhole(const mc7::Listing& listing, std::span<const std::uint8_t> isEntry,
                    std::uint32_t place, const icode::Builder& builder);

}  // namespace merker::translate
