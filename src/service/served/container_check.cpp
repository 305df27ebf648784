#include "served/container_check.h"

#include <algorithm>

#include "base/bytes.h"
#include "block/container.h"
#include "mc7/listing.h"

namespace merker::served {
namespace {

using s7comm::Error;

Error errorOf(const Problem& problem) {
  switch (problem.code) {
    case ProblemCode::P0602:
      return Error::WrongBlockLength;
    case ProblemCode::P0603:
      return Error::WrongChecksum;
    default:
      return Error::WrongBlockStructure;
  }
}

constexpr std::size_t kLengthAt = 8, kCodeLengthAt = 34, kCodeAt = 36, kChecksumFromEnd = 10;

// 0 says that there is none: Snap7's client sends blocks so, and CPUs load them. Of a container
// whose lengths are good.
void completeChecksum(const s7comm::BlockName& name, s7comm::Bytes& container) {
  std::uint8_t* const sum = &container[container.size() - kChecksumFromEnd];
  if (loadWord(sum) != 0) return;
  block::Block code;
  code.id = idOf(name);
  const auto begin = container.begin() + kCodeAt;
  code.code.assign(begin, begin + loadWord(&container[kCodeLengthAt]));
  storeWord(sum, block::checksum(code));
}

// Of this family: the processor knows every instruction.
bool isMachineCode(const block::Block& block) {
  return std::ranges::all_of(mc7::list(block.code).places, &mc7::Place::known);
}

}  // namespace

// The character of a type is the digit of its code: OB 08h, DB 0Ah … SFB 0Fh.
BlockId idOf(const s7comm::BlockName& name) {
  const auto character = static_cast<std::uint8_t>(name.type);
  const bool ob = name.type == s7comm::BlockType::Ob;
  return {static_cast<BlockKind>(ob ? 0x08 : character - 'A' + 0x0A), name.number};
}

CheckedBlock checkedBlock(const s7comm::BlockName& name, s7comm::Bytes container) {
  if (container.size() < kCodeAt || loadDWord(&container[kLengthAt]) != container.size())
    return {Error::WrongBlockLength};
  auto read = block::readContainer(container, {});
  if (!read && read.error().code == ProblemCode::P0603) {
    completeChecksum(name, container);
    read = block::readContainer(container, {});
  }
  if (!read) return {errorOf(read.error())};
  if (read->id.kind != idOf(name).kind) return {Error::WrongBlockStructure};
  if (read->id.number != name.number) return {Error::WrongBlockNumber};
  if (!isMachineCode(*read)) return {Error::WrongBlockStructure};
  return {Error::None, std::move(*read)};
}

}  // namespace merker::served
