// B MW, B DW in front of L DW and T DW: tables in data blocks (9.4.12). What else may stand behind
// B is the processor's.
#include "lowering5/lowering.h"

namespace merker::translate5 {
namespace {

using icode::Item;
using icode::Opcode;
using icode::Value;
using mc5::Operation;

bool isDataWord(const mc5::Instruction& i) {
  const mc5::Operand& operand = i.operand;
  return (i.operation == Operation::LOAD || i.operation == Operation::TRANSFER) &&
         operand.kind == mc5::OperandKind::Memory && operand.area == mc5::Area::Data &&
         operand.width == mc5::Width::Word;
}

bool isConstant(mc5::Times times) { return times.shortest == times.longest; }

// The low byte is the number of the word (S5-PROC-02). The times of both come together.
bool process(Lowering& l) {
  if (l.operand().kind != mc5::OperandKind::Memory || l.next == nullptr || !l.mayLeave() ||
      !isDataWord(l.next->instruction))
    return false;
  const mc5::Times own = l.times(), next = mc5::times(*l.next->encoding, l.target.variant);
  if (!isConstant(own) || !isConstant(next)) return false;
  icode::Builder& b = l.to;
  const Value word = b.make(Opcode::Zext8, *readOperand(l));
  if (l.next->instruction.operation == Operation::LOAD) {
    const Value value = readDataAt(l, word);
    b.set(Item::Accu2, b.get(Item::Accu1));
    b.set(Item::Accu1, value);
  } else {
    writeDataAt(l, word, b.get(Item::Accu1));
  }
  b.cost(static_cast<std::uint64_t>((own.longest + next.longest).ns));
  l.words = l.decoded.words + l.next->words;
  return true;
}

constexpr Row kProcessingRows[] = {{Operation::SUBSTITUTE, process}};

}  // namespace

std::span<const Row> processingRows() { return kProcessingRows; }

}  // namespace merker::translate5
