#include <algorithm>
#include <array>
#include <charconv>
#include <span>

#include "base/text.h"
#include "source/symbol_table.h"
#include "source/symbol_text.h"

namespace merker::source {
namespace {

using Kind = SymbolAddress::Kind;

constexpr SymbolAddress memory(Area area, Width width, bool output = false) {
  SymbolAddress address;
  address.area = area;
  address.width = width;
  address.peripheralOutput = output;
  return address;
}
constexpr SymbolAddress ofKind(Kind kind) {
  SymbolAddress address;
  address.kind = kind;
  return address;
}
constexpr SymbolAddress block(BlockKind kind) {
  SymbolAddress address;
  address.kind = Kind::Block;
  address.block.kind = kind;
  return address;
}

constexpr SymbolAddress data(Width width, BitAddress address = 0) {
  SymbolAddress result = memory(Area::DataBlock, width);
  result.address = address;
  return result;
}

struct Row {
  std::string_view german, international;
  SymbolAddress address;  // its number 0
};

// Inputs, outputs and flags are those of both families; flags have other English words in STEP 5.
struct FlagWords {
  std::string_view bit, byte, word, dword;
};

constexpr std::array<Row, 12> images(const FlagWords& flag) {
  return {Row{"E", "I", memory(Area::Input, Width::Bit)},
          Row{"EB", "IB", memory(Area::Input, Width::Byte)},
          Row{"EW", "IW", memory(Area::Input, Width::Word)},
          Row{"ED", "ID", memory(Area::Input, Width::DWord)},
          Row{"A", "Q", memory(Area::Output, Width::Bit)},
          Row{"AB", "QB", memory(Area::Output, Width::Byte)},
          Row{"AW", "QW", memory(Area::Output, Width::Word)},
          Row{"AD", "QD", memory(Area::Output, Width::DWord)},
          Row{"M", flag.bit, memory(Area::Flag, Width::Bit)},
          Row{"MB", flag.byte, memory(Area::Flag, Width::Byte)},
          Row{"MW", flag.word, memory(Area::Flag, Width::Word)},
          Row{"MD", flag.dword, memory(Area::Flag, Width::DWord)}};
}

template <std::size_t A, std::size_t B>
constexpr std::array<Row, A + B> joined(const std::array<Row, A>& first,
                                        const std::array<Row, B>& second) {
  std::array<Row, A + B> rows{};
  std::copy(first.begin(), first.end(), rows.begin());
  std::copy(second.begin(), second.end(), rows.begin() + A);
  return rows;
}

// Every operand that a symbol may stand for (S7-SYM-09 to -14, -16; mnemonics S7-MNE-11).
constexpr auto kOperands =
    joined(images({"M", "MB", "MW", "MD"}),
           std::array{
               Row{"PEB", "PIB", memory(Area::Peripheral, Width::Byte)},
               Row{"PEW", "PIW", memory(Area::Peripheral, Width::Word)},
               Row{"PED", "PID", memory(Area::Peripheral, Width::DWord)},
               Row{"PAB", "PQB", memory(Area::Peripheral, Width::Byte, true)},
               Row{"PAW", "PQW", memory(Area::Peripheral, Width::Word, true)},
               Row{"PAD", "PQD", memory(Area::Peripheral, Width::DWord, true)},
               Row{"T", "T", ofKind(Kind::Timer)},
               Row{"Z", "C", ofKind(Kind::Counter)},
               Row{"OB", "OB", block(BlockKind::OB)},
               Row{"FB", "FB", block(BlockKind::FB)},
               Row{"FC", "FC", block(BlockKind::FC)},
               Row{"DB", "DB", block(BlockKind::DB)},
               Row{"SFB", "SFB", block(BlockKind::SFB)},
               Row{"SFC", "SFC", block(BlockKind::SFC)},
               Row{"UDT", "UDT", block(BlockKind::UDT)},
               Row{"VAT", "VAT", ofKind(Kind::VariableTable)},
           });

// STEP 5 (9.3.3, 9.4.1; docs/compatibility.md says why PB is the block). The words of its English
// edition stand beside the German ones.
constexpr BitAddress kRight = 8;  // DR is the second byte of its word
constexpr auto kStep5Operands = joined(images({"F", "FY", "FW", "FD"}),
                                       std::array{
                                           Row{"D", "D", data(Width::Bit)},
                                           Row{"DL", "DL", data(Width::Byte)},
                                           Row{"DR", "DR", data(Width::Byte, kRight)},
                                           Row{"DW", "DW", data(Width::Word)},
                                           Row{"DD", "DD", data(Width::DWord)},
                                           Row{"PY", "PY", memory(Area::Peripheral, Width::Byte)},
                                           Row{"PW", "PW", memory(Area::Peripheral, Width::Word)},
                                           Row{"T", "T", ofKind(Kind::Timer)},
                                           Row{"Z", "C", ofKind(Kind::Counter)},
                                           Row{"OB", "OB", block(BlockKind::OB)},
                                           Row{"PB", "PB", block(BlockKind::PB)},
                                           Row{"SB", "SB", block(BlockKind::SB)},
                                           Row{"FB", "FB", block(BlockKind::FB)},
                                           Row{"DB", "DB", block(BlockKind::DB)},
                                       });

std::span<const Row> rowsOf(Language language) {
  return language == Language::Step5 ? std::span<const Row>(kStep5Operands) : kOperands;
}

bool isData(const SymbolAddress& address) {
  return address.kind == Kind::Memory && address.area == Area::DataBlock;
}

// Without its number.
SymbolAddress base(SymbolAddress address) {
  const bool byte = isData(address) && address.width == Width::Byte;
  address.address = byte ? address.address % 16 : 0;
  address.number = 0;
  address.block.number = 0;
  return address;
}

void setNumber(SymbolAddress& address, std::uint16_t number, unsigned bit) {
  // Bits 8 to 15 of a data word are in its left byte (S5-BLK-10).
  if (isData(address))
    address.address += number * 16u + (address.width == Width::Bit ? (bit + 8) % 16 : 0);
  else if (address.kind == Kind::Memory)
    address.address = bitAddress(number, bit);
  else if (address.kind == Kind::Block)
    address.block.number = number;
  else
    address.number = number;
}

// Decimal digits from the front of `text`, at most 65535.
std::optional<std::uint16_t> takeNumber(std::string_view& text) {
  std::uint16_t value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end.ec != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end.ptr - text.data()));
  return value;
}

bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

}  // namespace

Result<SymbolAddress> parseSymbolAddress(std::string_view text, const Position& at,
                                         Language language) {
  const std::string_view written = trim(text);
  const auto letters = static_cast<std::size_t>(
      std::find_if_not(written.begin(), written.end(), isLetter) - written.begin());
  const std::string_view operand = written.substr(0, letters);
  std::string_view rest = trim(written.substr(letters));
  const auto rows = rowsOf(language);
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
    return equalsIgnoreCase(r.german, operand) || equalsIgnoreCase(r.international, operand);
  });
  const bool step5 = language == Language::Step5;
  if (row == rows.end())
    return makeProblem(step5 ? ProblemCode::P1104 : ProblemCode::P0804, at, written);

  SymbolAddress address = row->address;
  // S7-SYM-06: DB100.DBW10 is no block, and no symbol can stand for it.
  if (address.kind == Kind::Block && rest.find('.') != std::string_view::npos)
    return makeProblem(step5 ? ProblemCode::P1104 : ProblemCode::P0804, at, written);
  const bool isBit = address.kind == Kind::Memory && address.width == Width::Bit;
  const auto number = takeNumber(rest);
  std::optional<std::uint16_t> bit = 0;
  if (isBit) {
    const bool point = rest.starts_with('.');
    if (point) rest.remove_prefix(1);
    bit = point ? takeNumber(rest) : std::nullopt;
  }
  // S7-ADDR-02: a bit operand has a byte and a bit number 0..7; S5-DB: a data word has 16.
  if (!number || !bit || *bit > (isData(address) ? 15 : 7) || !rest.empty())
    return makeProblem(ProblemCode::P0805, at, written, row->german, isBit ? "1.0" : "1");
  setNumber(address, *number, *bit);
  return address;
}

std::string_view operandName(const SymbolAddress& address, Mnemonics mnemonics, Language language) {
  for (const Row& row : rowsOf(language))
    if (row.address == base(address))
      return mnemonics == Mnemonics::German ? row.german : row.international;
  return "?";
}

std::string operandNumber(const SymbolAddress& address) {
  if (address.kind == Kind::Block) return std::to_string(address.block.number);
  if (address.kind != Kind::Memory) return std::to_string(address.number);
  if (isData(address)) {
    const std::string word = std::to_string(address.address / 16);
    const bool bit = address.width == Width::Bit;
    return bit ? word + '.' + std::to_string((address.address + 8) % 16) : word;
  }
  const std::string byte = std::to_string(address.address / 8);
  return address.width == Width::Bit ? byte + '.' + std::to_string(address.address % 8) : byte;
}

}  // namespace merker::source
