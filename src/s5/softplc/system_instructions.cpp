// LIR, TIR, TNB, TNW: direct access to memory by segment and offset (9.4.13).
#include "base/bcd.h"
#include "softplc/handlers.h"
#include "softplc/segments.h"

namespace merker::sinumerik {
namespace {

using mc5::Instruction;
using mc5::Operation;

struct Address {
  std::uint32_t segment, offset;
};

Address addressIn(std::uint32_t akku) { return {akku >> 16, akku & 0xFFFF}; }

bool enabled(Processor& p) {
  return p.environment().systemCommands || p.fail(Alarm::SystemCommandsLocked, p.opcode());
}

bool wrongSegment(Processor& p, Alarm alarm, std::uint32_t segment) {
  return p.fail(alarm, p.opcode(), 0, static_cast<std::uint16_t>(toBcd(segment, 4)));
}

bool noAnswer(Processor& p, Alarm alarm, Address a) {
  return p.fail(alarm, p.opcode(), static_cast<std::uint16_t>(a.offset),
                static_cast<std::uint16_t>(a.segment));
}

bool loadRegister(Processor& p, const Instruction&) {
  if (!enabled(p)) return false;
  const Address a = addressIn(p.registers().akku1);
  if (!readable(a.segment)) return wrongSegment(p, Alarm::SegmentLirTir, a.segment);
  const auto word = readWord(p.machine(), a.segment, a.offset);
  if (!word) return noAnswer(p, Alarm::NoAnswerLirTir, a);
  p.registers().akku1 = *word;  // bits that take no part are 0 (9.2)
  return true;
}

bool transferRegister(Processor& p, const Instruction&) {
  if (!enabled(p)) return false;
  const Address a = addressIn(p.registers().akku1);
  if (!writable(a.segment)) return wrongSegment(p, Alarm::SegmentLirTir, a.segment);
  if (writeWord(p.machine(), a.segment, a.offset, p.registers().low2())) return true;
  return noAnswer(p, Alarm::NoAnswerLirTir, a);
}

// One element of a block transfer; what a byte or a word is, the segments know.
struct Bytes {
  static constexpr std::uint32_t kSize = 1;
  static constexpr auto read = &readByte;
  static constexpr auto write = &writeByte;
};
struct Words {
  static constexpr std::uint32_t kSize = 2;
  static constexpr auto read = &readWord;
  static constexpr auto write = &writeWord;
};

// Both accumulators hold the end addresses; copying goes downwards (OP-44).
template <typename Element>
bool copyDownwards(Processor& p, Address source, Address target, std::uint32_t count) {
  Machine& m = p.machine();
  for (std::uint32_t n = 0; n < count; ++n) {
    const auto value = Element::read(m, source.segment, source.offset);
    if (!value) return noAnswer(p, Alarm::NoAnswerBlockTransfer, source);
    if (!Element::write(m, target.segment, target.offset, *value))
      return noAnswer(p, Alarm::NoAnswerBlockTransfer, target);
    source.offset -= Element::kSize;
    target.offset -= Element::kSize;
  }
  return count > 0;
}

template <typename Element>
bool copy(Processor& p, const Instruction& i) {
  if (!enabled(p)) return false;
  const Address source = addressIn(p.registers().akku2), target = addressIn(p.registers().akku1);
  if (!readable(source.segment))
    return wrongSegment(p, Alarm::SegmentBlockTransfer, source.segment);
  if (!writable(target.segment))
    return wrongSegment(p, Alarm::SegmentBlockTransfer, target.segment);
  return copyDownwards<Element>(p, source, target, i.operand.value);
}

constexpr HandlerRow kSystemRows[] = {{Operation::LOAD_REGISTER, loadRegister},
                                      {Operation::TRANSFER_REGISTER, transferRegister},
                                      {Operation::COPY_BYTES, copy<Bytes>},
                                      {Operation::COPY_WORDS, copy<Words>}};

}  // namespace

HandlerRows systemHandlers() { return kSystemRows; }

}  // namespace merker::sinumerik
