#include "mc7/encoding.h"

#include "mc7/field.h"
#include "mc7/operand_class.h"

namespace merker::mc7 {
namespace {

constexpr unsigned kCodeBits = 48;

// Takes the pattern apart: "0111 0aaa" gives mask 1111 1000, bits 0111 0000 and the field a.
constexpr Encoding compile(Encoding row) {
  unsigned position = kCodeBits;
  for (const char c : row.pattern) {
    if (c == ' ') continue;
    --position;
    if (c == '0' || c == '1') {
      row.mask |= std::uint64_t{1} << position;
      row.bits |= std::uint64_t{c == '1' ? 1u : 0u} << position;
      continue;
    }
    if (row.fieldCount == 0 || row.fields[row.fieldCount - 1].letter != c)
      row.fields[row.fieldCount++].letter = c;
    Field& field = row.fields[row.fieldCount - 1];
    field.shift = static_cast<std::uint8_t>(position);
    ++field.bits;
  }
  row.length = (kCodeBits - position) / 8;
  return row;
}

constexpr std::array kRows{
#define ENCODING(operation, pattern, operand, source) \
  compile({Operation::operation, pattern, #operand, operand_class::operand, source}),
#include "mc7/encodings.inc"
#undef ENCODING
};

// What decides whether a row comes into question, small enough to look through quickly: a key of
// the code or of the operand, of which the bits of the mask count.
struct Entry {
  std::uint16_t row = 0, mask = 0, bits = 0;
};

// Rows grouped by first byte or by operation, in the order of the table within a group.
template <std::size_t Groups, std::size_t Entries>
struct Index {
  std::array<std::uint16_t, Groups + 1> start{};
  std::array<Entry, Entries> entries{};

  std::span<const Entry> group(std::size_t number) const {
    return std::span{entries}.subspan(start[number],
                                      static_cast<std::size_t>(start[number + 1] - start[number]));
  }
};

// Decoding: groups are first bytes, the key is the first word.
struct ByFirstByte {
  static constexpr std::size_t kGroups = 256;
  static constexpr bool fits(const Encoding& row, std::size_t firstByte) {
    return ((std::uint64_t{firstByte} << 40 ^ row.bits) & row.mask & 0xFF0000000000) == 0;
  }
  static constexpr Entry entry(std::size_t number, const Encoding& row) {
    return {static_cast<std::uint16_t>(number), static_cast<std::uint16_t>(row.mask >> 32),
            static_cast<std::uint16_t>(row.bits >> 32)};
  }
};

// What no field changes: kind (5 bits), width (2), format of a constant (5), kind of a block (4).
constexpr std::uint16_t operandKey(const Operand& operand) {
  return static_cast<std::uint16_t>(static_cast<unsigned>(operand.kind) << 11 |
                                    static_cast<unsigned>(operand.width) << 9 |
                                    static_cast<unsigned>(operand.format) << 4 |
                                    (static_cast<unsigned>(operand.blockKind) & 0xF));
}

// Encoding: groups are operations, the key is what no field of a pattern changes.
struct ByOperation {
  static constexpr std::size_t kGroups = 0
#define OPERATION(...) +1
#include "mc7/operations.inc"
#undef OPERATION
      ;
  static constexpr bool fits(const Encoding& row, std::size_t operation) {
    return static_cast<std::size_t>(row.operation) == operation;
  }
  static constexpr Entry entry(std::size_t number, const Encoding& row) {
    return {static_cast<std::uint16_t>(number), 0xFFFF, operandKey(row.operand)};
  }
};

template <typename Grouping>
constexpr std::size_t countEntries() {
  std::size_t count = 0;
  for (std::size_t group = 0; group < Grouping::kGroups; ++group)
    for (const Encoding& row : kRows) count += Grouping::fits(row, group) ? 1 : 0;
  return count;
}

template <typename Grouping>
constexpr auto makeIndex() {
  Index<Grouping::kGroups, countEntries<Grouping>()> index;
  std::size_t next = 0;
  for (std::size_t group = 0; group < Grouping::kGroups; ++group) {
    for (std::size_t i = 0; i < kRows.size(); ++i)
      if (Grouping::fits(kRows[i], group)) index.entries[next++] = Grouping::entry(i, kRows[i]);
    index.start[group + 1] = static_cast<std::uint16_t>(next);
  }
  return index;
}

constexpr auto kByFirstByte = makeIndex<ByFirstByte>();
constexpr auto kByOperation = makeIndex<ByOperation>();

std::uint32_t fieldMask(const Field& field) {
  return static_cast<std::uint32_t>((std::uint64_t{1} << field.bits) - 1);
}

// The first six bytes of the code on top of each other, missing ones as 0.
std::uint64_t fetch(std::span<const std::uint8_t> code) {
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < 6; ++i) result = result << 8 | (i < code.size() ? code[i] : 0);
  return result;
}

void append(std::uint64_t code, unsigned length, std::vector<std::uint8_t>& out) {
  for (unsigned i = 0; i < length; ++i)
    out.push_back(static_cast<std::uint8_t>(code >> (40 - 8 * i)));
}

}  // namespace

std::optional<Operand> decodeOperand(const Encoding& row, std::uint64_t code) {
  if ((code & row.mask) != row.bits) return std::nullopt;
  Operand operand = row.operand;
  for (unsigned i = 0; i < row.fieldCount; ++i) {
    const Field& field = row.fields[i];
    const auto number = static_cast<std::uint32_t>(code >> field.shift) & fieldMask(field);
    if (!decodeField(field.letter, number, operand)) return std::nullopt;
  }
  return operand;
}

std::optional<std::uint64_t> encodeOperand(const Encoding& row, const Operand& operand) {
  if (operandKey(operand) != operandKey(row.operand)) return std::nullopt;
  std::uint64_t code = row.bits;
  for (unsigned i = 0; i < row.fieldCount; ++i) {
    const Field& field = row.fields[i];
    const auto number = encodeField(field.letter, operand);
    if (!number || *number > fieldMask(field)) return std::nullopt;
    code |= std::uint64_t{*number} << field.shift;
  }
  // Whatever the fields have no place for shows up here as a difference.
  if (decodeOperand(row, code) != operand) return std::nullopt;
  return code;
}

std::span<const Encoding> encodings() { return kRows; }

bool encode(const Encoding& row, const Operand& operand, std::vector<std::uint8_t>& out) {
  const auto code = encodeOperand(row, operand);
  if (code) append(*code, row.length, out);
  return code.has_value();
}

bool encode(const Instruction& instruction, std::vector<std::uint8_t>& out) {
  const std::uint16_t key = operandKey(instruction.operand);
  for (const Entry& entry : kByOperation.group(static_cast<std::size_t>(instruction.operation)))
    if (entry.bits == key && encode(kRows[entry.row], instruction.operand, out)) return true;
  return false;
}

std::optional<Decoded> decode(std::span<const std::uint8_t> code) {
  if (code.size() < 2) return std::nullopt;
  const std::uint64_t bits = fetch(code);
  const auto firstWord = static_cast<std::uint16_t>(bits >> 32);
  for (const Entry& entry : kByFirstByte.group(code[0])) {
    if ((firstWord & entry.mask) != entry.bits) continue;
    const Encoding& row = kRows[entry.row];
    if (row.length > code.size()) continue;
    if (const auto operand = decodeOperand(row, bits))
      return Decoded{{row.operation, *operand}, &row, row.length};
  }
  return std::nullopt;
}

}  // namespace merker::mc7
