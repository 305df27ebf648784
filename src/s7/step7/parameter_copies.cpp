// Parameters that a block copies to its local data before its first statement.
#include <algorithm>

#include "step7/block_compiler.h"

namespace merker::step7 {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

// Descriptors of composite parameters and numbers of parameter types cannot be addressed where they
// arrive; the block copies those it uses to its local data before its first statement.
void BlockCompiler::reserveParameterCopies() {
  copies_.clear();
  const bool function = target_.id.kind == BlockKind::FC;
  for (const block::Variable& variable : target_.variables) {
    const TypeCode code = variable.type->code;
    const bool composite = isComposite(code) && variable.section != block::Section::Temp &&
                           (function || variable.section == block::Section::InOut);
    const bool number = !function && isParameterNumber(code);
    if (!composite && !number) continue;
    const std::uint32_t byte = (allocated_ + 1) & ~1u;
    copies_.emplace_back(&variable, byte);
    allocated_ = byte + (composite ? 6 : 2);
  }
  copiesEnd_ = allocated_;
}

std::uint32_t BlockCompiler::parameterCopy(const block::Variable& variable) {
  if (std::find(usedCopies_.begin(), usedCopies_.end(), &variable) == usedCopies_.end())
    usedCopies_.push_back(&variable);
  allocatedTop_ = std::max(allocatedTop_, copiesEnd_);
  for (const auto& [copied, byte] : copies_)
    if (copied == &variable) return byte;
  return 0;
}

static std::uint32_t indexOf(const block::Block& block, const block::Variable& variable) {
  const auto list = block::parameters(block);
  return static_cast<std::uint32_t>(std::find(list.begin(), list.end(), &variable) - list.begin());
}

std::vector<std::uint8_t> BlockCompiler::prologue() {
  std::vector<std::uint8_t> code;
  if (usedCopies_.empty()) return code;
  const auto put = [&code](Operation operation, const Operand& operand = {}) {
    (void)mc7::encode({operation, operand}, code);
  };
  const auto localData = [](Width width, std::uint32_t byte) {
    return mc7::memory(Area::Local, width, byte * 8);
  };
  // The accumulators and AR1 stay as the caller left them.
  const std::uint32_t saved = (allocatedTop_ + 1) & ~1u;
  allocatedTop_ = saved + 12;
  put(Operation::TRANSFER, localData(Width::DWord, saved));
  put(Operation::TAK);
  put(Operation::TRANSFER, localData(Width::DWord, saved + 4));
  put(Operation::TAR1, localData(Width::DWord, saved + 8));
  for (const block::Variable* variable : usedCopies_) {
    const std::uint32_t byte = parameterCopy(*variable);
    const auto from = [&](Width width, std::uint32_t offset) {
      return mc7::registerIndirect(Area::Instance, width, 2, variable->address + offset * 8);
    };
    if (target_.id.kind == BlockKind::FC) {
      put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, indexOf(target_, *variable)));
      put(Operation::LAR1);
      put(Operation::LOAD, mc7::registerCrossing(Width::Word, 1, 0));
      put(Operation::TRANSFER, localData(Width::Word, byte));
      put(Operation::LOAD, mc7::registerCrossing(Width::DWord, 1, bitAddress(2)));
      put(Operation::TRANSFER, localData(Width::DWord, byte + 2));
      continue;
    }
    put(Operation::LOAD, from(Width::Word, 0));
    put(Operation::TRANSFER, localData(Width::Word, byte));
    if (isParameterNumber(variable->type->code)) continue;
    put(Operation::LOAD, from(Width::DWord, 2));
    put(Operation::TRANSFER, localData(Width::DWord, byte + 2));
  }
  put(Operation::LAR1, localData(Width::DWord, saved + 8));
  put(Operation::LOAD, localData(Width::DWord, saved + 4));
  put(Operation::LOAD, localData(Width::DWord, saved));
  return code;
}

}  // namespace merker::step7
