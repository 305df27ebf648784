#include "nc/request.h"

#include "mc5/instruction.h"
#include "nc/interface_byte.h"
#include "nc/plc_memory.h"
#include "softplc/operand_access.h"

namespace merker::nc {
namespace {

using sinumerik::Machine;

// Words of the parameter list, LESE or SCHR being word 0.
enum Word : std::size_t {
  kByte = 1,
  kCount,
  kType,
  kWhere = kType + 3,
  kFormat = kWhere + 3,
  kPlace
};
constexpr int kByNumber = 0, kByCode = 128;  // ANZ: how MB 242 or MW 241 tell the interface byte

std::string typeName(std::span<const std::uint16_t> words) {
  std::string name;
  for (const std::uint16_t word : words) {
    name += static_cast<char>(highByte(word));
    name += static_cast<char>(lowByte(word));
  }
  name.erase(name.find_last_not_of(' ') + 1);
  return name;
}

int fixedPoint(std::uint16_t word) { return static_cast<std::int16_t>(word); }

void takeFlags(const Machine& m, bool byCode, Request& request) {
  const unsigned number = m.flags[242];
  if (byCode)
    request.interfaceByte = interfaceNumber(flagWord(m, 241));
  else if (number >= 1 && number <= kInterfaceBytes)
    request.interfaceByte = number;
  request.count = m.flags[243];
  request.where = {fixedPoint(flagWord(m, 244)), fixedPoint(flagWord(m, 248)),
                   fixedPoint(flagWord(m, 250))};
  request.format = flagWord(m, 252);
  request.place = flagWord(m, 254);
}

void takeList(std::span<const std::uint16_t> p, Request& request) {
  request.interfaceByte = interfaceNumber(p[kByte]);
  request.count = fixedPoint(p[kCount]);
  for (std::size_t i = 0; i < request.where.size(); ++i)
    request.where[i] = fixedPoint(p[kWhere + i]);
  request.format = p[kFormat];
  request.place = p[kPlace];
}

}  // namespace

Request readRequest(const Machine& m, bool write, std::span<const std::uint16_t> p) {
  Request request;
  request.write = write;
  request.type = typeName(p.subspan(kType, 3));
  const int count = fixedPoint(p[kCount]);
  if (count == kByNumber || count == kByCode)
    takeFlags(m, count == kByCode, request);
  else
    takeList(p, request);
  return request;
}

std::optional<bool> readSignal(Machine& m, std::uint16_t code) {
  const auto decoded = mc5::decode({&code, 1});
  if (!decoded || decoded->instruction.operation != mc5::Operation::AND) return std::nullopt;
  const mc5::Operand& operand = decoded->instruction.operand;
  if (operand.kind != mc5::OperandKind::Memory) return std::nullopt;
  return sinumerik::read(m, operand) != 0;
}

}  // namespace merker::nc
