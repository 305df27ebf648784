#include "graph7/operand_code.h"

#include <array>

#include "base/bytes.h"

namespace merker::graph7 {
namespace {

constexpr std::size_t kOperandBytes = 11;

}  // namespace

std::string pack(std::span<const std::uint8_t> before, const mc7::Operand& o) {
  std::array<std::uint8_t, kOperandBytes> bytes{static_cast<std::uint8_t>(o.kind),
                                                static_cast<std::uint8_t>(o.area),
                                                static_cast<std::uint8_t>(o.width),
                                                static_cast<std::uint8_t>(o.pointerArea),
                                                o.reg,
                                                static_cast<std::uint8_t>(o.format),
                                                static_cast<std::uint8_t>(o.blockKind)};
  storeDWord(&bytes[7], o.value);
  std::string packed(bytes.begin(), bytes.end());
  packed.append(before.begin(), before.end());
  return packed;
}

OperandCode unpack(const std::string& packed) {
  OperandCode out;
  if (packed.size() < kOperandBytes) return out;
  const std::vector<std::uint8_t> bytes(packed.begin(), packed.end());
  out.operand = {.kind = static_cast<mc7::OperandKind>(bytes[0]),
                 .area = static_cast<Area>(bytes[1]),
                 .width = static_cast<Width>(bytes[2]),
                 .pointerArea = static_cast<Area>(bytes[3]),
                 .reg = bytes[4],
                 .format = static_cast<ConstantFormat>(bytes[5]),
                 .blockKind = static_cast<BlockKind>(bytes[6]),
                 .value = loadDWord(&bytes[7])};
  out.before.assign(bytes.begin() + kOperandBytes, bytes.end());
  return out;
}

}  // namespace merker::graph7
