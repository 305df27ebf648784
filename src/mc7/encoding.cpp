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
constexpr std::size_t kRowCount = kRows.size();

// Row numbers grouped by a key, in the order of the rows within a group.
template <std::size_t Groups, std::size_t Entries>
struct Index {
  std::array<std::uint16_t, Groups + 1> start{};
  std::array<std::uint16_t, Entries> row{};

  std::span<const std::uint16_t> rows(std::size_t group) const {
    return std::span{row}.subspan(start[group],
                                  static_cast<std::size_t>(start[group + 1] - start[group]));
  }
};

constexpr bool beginsWith(const Encoding& row, unsigned firstByte) {
  return ((std::uint64_t{firstByte} << 40 ^ row.bits) & row.mask & 0xFF0000000000) == 0;
}
constexpr bool belongsTo(const Encoding& row, unsigned operation) {
  return static_cast<unsigned>(row.operation) == operation;
}

template <std::size_t Groups>
constexpr std::size_t countEntries(bool (*fits)(const Encoding&, unsigned)) {
  std::size_t count = 0;
  for (unsigned group = 0; group < Groups; ++group)
    for (const Encoding& row : kRows) count += fits(row, group) ? 1 : 0;
  return count;
}

template <std::size_t Groups, std::size_t Entries>
constexpr Index<Groups, Entries> makeIndex(bool (*fits)(const Encoding&, unsigned)) {
  Index<Groups, Entries> index;
  std::size_t next = 0;
  for (unsigned group = 0; group < Groups; ++group) {
    for (std::size_t i = 0; i < kRowCount; ++i)
      if (fits(kRows[i], group)) index.row[next++] = static_cast<std::uint16_t>(i);
    index.start[group + 1] = static_cast<std::uint16_t>(next);
  }
  return index;
}

constexpr std::size_t kOperations = 0
#define OPERATION(...) +1
#include "mc7/operations.inc"
#undef OPERATION
    ;
constexpr auto kByFirstByte = makeIndex<256, countEntries<256>(beginsWith)>(beginsWith);
constexpr auto kByOperation = makeIndex<kOperations, kRowCount>(belongsTo);

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
  if (operand.kind != row.operand.kind || operand.width != row.operand.width) return std::nullopt;
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
  for (const std::uint16_t i : kByOperation.rows(static_cast<std::size_t>(instruction.operation)))
    if (encode(kRows[i], instruction.operand, out)) return true;
  return false;
}

std::optional<Decoded> decode(std::span<const std::uint8_t> code) {
  if (code.size() < 2) return std::nullopt;
  const std::uint64_t bits = fetch(code);
  for (const std::uint16_t i : kByFirstByte.rows(code[0])) {
    const Encoding& row = kRows[i];
    if (row.length > code.size()) continue;
    if (const auto operand = decodeOperand(row, bits))
      return Decoded{{row.operation, *operand}, &row, row.length};
  }
  return std::nullopt;
}

}  // namespace merker::mc7
