#include "step7/parameter_access.h"

#include "step7/block_compiler.h"

namespace merker::step7 {

using mc7::Instruction;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

namespace {

Operand local(Width width, std::uint32_t byte) {
  return mc7::memory(Area::Local, width, bitAddress(byte));
}

constexpr BitAddress kAddressInPointer = bitAddress(2);  // behind the number of the data block

}  // namespace

Operand blockInWord(std::uint32_t word, bool asInstance) {
  return {.kind = OperandKind::BlockIndirect,
          .pointerArea = Area::Local,
          .reg = static_cast<std::uint8_t>(asInstance ? 1 : 0),
          .blockKind = BlockKind::DB,
          .value = word};
}

std::vector<Instruction> followPointer(const Scope& scope, const PointerPath& path) {
  std::vector<Instruction> code;
  Operand number = mc7::registerIndirect(path.own, Width::Word, 2, path.parameter.address);
  Operand address =
      mc7::registerIndirect(path.own, Width::DWord, 2, path.parameter.address + kAddressInPointer);
  if (scope.block->id.kind == BlockKind::FC) {
    const std::uint32_t index = scope.names->parameterIndex(path.parameter);
    code.push_back({Operation::LOAD, mc7::number(OperandKind::ParameterAddress, index)});
    code.push_back({Operation::LAR1, {}});
    number = mc7::registerCrossing(Width::Word, 1, 0);
    address = mc7::registerCrossing(Width::DWord, 1, kAddressInPointer);
  }
  code.push_back({Operation::LOAD, number});
  code.push_back({Operation::TRANSFER, local(Width::Word, path.word)});
  if (path.opens) code.push_back({Operation::OPEN, blockInWord(path.word, path.asInstance)});
  code.push_back({Operation::LOAD, address});
  code.push_back({Operation::LAR1, {}});
  return code;
}

NumberPath followNumber(const Access& access, std::uint32_t word) {
  NumberPath path;
  path.code = {{Operation::LOAD,
                mc7::registerIndirect(Area::Instance, Width::Word, 2, access.variable->address)},
               {Operation::TRANSFER, local(Width::Word, word)}};
  path.operand = access.operand;
  path.operand.value = word;
  return path;
}

bool BlockCompiler::emitAll(const std::vector<Instruction>& code) {
  bool good = true;
  for (const Instruction& one : code) good = emit(one.operation, one.operand) && good;
  return good;
}

// The accumulators are as before afterwards; AR1 and the data block are not.
void BlockCompiler::followParameter(const Access& access) {
  const bool function = target_.id.kind == BlockKind::FC;
  const std::uint32_t first = localData_.bytes(10);
  const std::uint32_t word = function ? first : first + 8;
  const std::uint32_t accumulators = function ? first + 2 : first;
  (void)emit(Operation::BLD, mc7::number(OperandKind::ShiftCount, function ? 5 : 18));
  keepAccumulators(accumulators);
  (void)emitAll(followPointer(scope_, {.parameter = *access.descriptor, .word = word}));
  loadAccumulators(accumulators);
}

// T [LW n] with the number, and the code that brings it there.
Operand BlockCompiler::numberParameter(const Access& access) {
  const std::uint32_t first = localData_.bytes(10);
  const NumberPath path = followNumber(access, first + 8);
  keepAccumulators(first);
  (void)emitAll(path.code);
  loadAccumulators(first);
  return path.operand;
}

void BlockCompiler::keepAccumulators(std::uint32_t byte) {
  (void)emit(Operation::TRANSFER, local(Width::DWord, byte));
  (void)emit(Operation::TAK);
  (void)emit(Operation::TRANSFER, local(Width::DWord, byte + 4));
}

void BlockCompiler::loadAccumulators(std::uint32_t byte) {
  (void)emit(Operation::LOAD, local(Width::DWord, byte + 4));
  (void)emit(Operation::LOAD, local(Width::DWord, byte));
}

}  // namespace merker::step7
