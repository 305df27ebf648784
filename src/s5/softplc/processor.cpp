#include "softplc/processor.h"

#include "mc5/encoding.h"
#include "mc5/range.h"
#include "softplc/formal_operands.h"
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockType;

// A parameter in BCD, as the fine coding shows it (S5-ERR-14).
std::uint16_t bcdWord(std::uint32_t value) {
  std::uint32_t result = 0;
  for (unsigned shift = 0; shift < 16; shift += 4, value /= 10) result |= value % 10 << shift;
  return static_cast<std::uint16_t>(result);
}

bool isCell(const mc5::Operand& operand) {
  return operand.kind == mc5::OperandKind::Timer || operand.kind == mc5::OperandKind::Counter;
}

bool stopsTimer(mc5::Operation operation) {
  return operation == mc5::Operation::TIMER_SI || operation == mc5::Operation::TIMER_SE;
}

// With VKE = 0 these only take note of it.
bool clearsEdge(mc5::Operation operation, mc5::OperandKind kind) {
  using mc5::Operation;
  return operation == Operation::TIMER_SV || operation == Operation::TIMER_SS ||
         operation == Operation::COUNT_UP || operation == Operation::COUNT_DOWN ||
         operation == Operation::ENABLE ||
         (operation == Operation::SET_BIT && kind == mc5::OperandKind::Counter);
}

}  // namespace

Processor::Processor(Machine& machine, const Environment& environment)
    : machine_(machine), environment_(environment), cache_(machine.blocks.program().size()) {}

bool Processor::begin(std::uint8_t ob) {
  const Entry& entry = machine_.blocks.find({BlockType::Ob, ob});
  if (!entry.present) return false;
  Level level;
  level.ob = ob;
  level.frames.push_back({.block = {BlockType::Ob, ob},
                          .start = entry.start,
                          .next = entry.start,
                          .parameters = 0,
                          .data = {}});
  machine_.levels.push_back(std::move(level));
  ++levels_;
  return true;
}

// Decoded code is kept as long as its words are the same: TIR and TNW may write code.
std::optional<mc5::Decoded> Processor::fetch(std::uint32_t word) {
  const auto& memory = machine_.blocks.program();
  if (word >= memory.size()) return std::nullopt;
  const auto at = [&](std::uint32_t i) {
    return word + i < memory.size() ? memory[word + i] : std::uint16_t{0};
  };
  Cached& cached = cache_[word];
  const bool same = cached.encoding != nullptr && cached.first == at(0) && cached.second == at(1) &&
                    cached.third == at(2);
  if (!same) {
    const auto decoded = mc5::decode(std::span(memory).subspan(word));
    if (!decoded) return std::nullopt;
    cached = {decoded->instruction,
              decoded->encoding,
              at(0),
              at(1),
              at(2),
              static_cast<std::uint8_t>(decoded->words)};
  }
  return mc5::Decoded{cached.instruction, cached.encoding, cached.words};
}

std::optional<mc5::Decoded> Processor::fetchNext() {
  Frame& frame = machine_.frame();
  run_.current = frame.next;  // a jump counts from itself, not from the B before it
  auto decoded = fetch(frame.next);
  if (decoded) frame.next += decoded->words;
  return decoded;
}

Outcome Processor::step() {
  Frame& frame = machine_.frame();
  run_.current = frame.next;
  run_.trapped = run_.levelEnded = false;
  run_.depth = 0;
  const auto& memory = machine_.blocks.program();
  run_.opcode = run_.current < memory.size() ? memory[run_.current] : std::uint16_t{0};
  const auto decoded = fetch(run_.current);
  if (!decoded) {
    frame.next = run_.current + 1;  // the step counter points behind what was read (S5-ERR-T2)
    fail(run_.current < memory.size() ? Alarm::IllegalCode : Alarm::NoAnswerProgram, run_.opcode);
    return Outcome::Trapped;
  }
  frame.next += decoded->words;
  ++instructions_;
  execute(*decoded);
  if (run_.trapped) return Outcome::Trapped;
  return run_.levelEnded ? Outcome::LevelEnded : Outcome::Next;
}

bool Processor::execute(const mc5::Decoded& decoded) {
  const mc5::Operand& operand = decoded.instruction.operand;
  if (!mc5::inRange(decoded.instruction))
    return foreignCell(decoded) || refuse(decoded.instruction);
  if (operand.kind == mc5::OperandKind::Timer &&
      operand.value > environment_.lastTimer)  // S5-MD-02
    return fail(Alarm::TimerCounter, run_.opcode, 0, bcdWord(operand.value));
  const bool done = handler(decoded.instruction)(*this, decoded.instruction);
  charge(*decoded.encoding, done);
  return done;
}

bool Processor::refuse(const mc5::Instruction& instruction) {
  return fail(isCell(instruction.operand) ? Alarm::TimerCounter : Alarm::IllegalParameter,
              run_.opcode, 0, bcdWord(instruction.operand.value));
}

// Behind B a number beyond the last cell: where VKE is 0 the coprocessor does the instruction
// alone. It does not look at the number and clears control bits of another cell (9.3.4,
// S5-TIMER-13).
bool Processor::foreignCell(const mc5::Decoded& decoded) {
  const mc5::Instruction& i = decoded.instruction;
  if (run_.depth == 0 || vke() || !isCell(i.operand) || i.operand.width == mc5::Width::Bit)
    return false;
  const std::size_t number = i.operand.value % kCells;
  if (stopsTimer(i.operation)) {
    machine_.timers[number].clearControlBits();
  } else if (clearsEdge(i.operation, i.operand.kind)) {
    mc5::Instruction other = i;
    other.operand.value = static_cast<std::uint32_t>(number);
    (void)handler(other)(*this, other);
  } else {
    return false;
  }
  displays().orBit = displays().chain = false;
  charge(*decoded.encoding, false);
  return true;
}

void Processor::charge(const mc5::Encoding& encoding, bool done) {
  const mc5::Times times = mc5::times(encoding, environment_.variant);
  machine_.clock = machine_.clock + (done ? times.longest : times.shortest);
}

bool Processor::substitute(const mc5::Instruction& instruction) {
  if (++run_.depth > 2) return fail(Alarm::Substitution, run_.opcode);
  const mc5::Encoding* const row = rowOf(instruction);
  std::vector<std::uint16_t> code;
  if (row == nullptr) return fail(Alarm::Substitution, run_.opcode);
  if (mc5::encode(*row, instruction.operand, code)) run_.substituted = code.front();
  return execute({instruction, row, row->length});
}

bool Processor::fail(Alarm alarm, std::uint16_t word1, std::uint16_t word2, std::uint16_t word3) {
  if (!run_.trapped) run_.trap = {alarm, {word1, word2, word3}};
  run_.trapped = true;
  if (run_.depth > 0 && run_.trap.alarm == Alarm::NoAnswerPeriphery)  // S5-ERR-13
    run_.trap = {Alarm::NoAnswerSubstitution, {word1, run_.substituted, word3}};
  return false;
}

void Processor::jump(std::int32_t words) {
  machine_.frame().next = run_.current + static_cast<std::uint32_t>(words);
}

std::optional<std::uint16_t> Processor::parameter(std::uint32_t index) const {
  const Frame& frame = machine_.levels.back().frames.back();
  const auto& memory = machine_.blocks.program();
  const std::uint64_t word = std::uint64_t{frame.parameters} + index - 1;
  if (frame.parameters == 0 || index == 0 || word >= memory.size()) return std::nullopt;
  return memory[word];
}

// Behind the call of an FB stands a jump over its parameter list (S5-FB-06).
bool Processor::call(mc5::BlockId block) {
  auto& frames = machine_.level().frames;
  if (block.type == BlockType::Fb && environment_.macros && environment_.macros->has(block.number))
    return callMacro(block.number);
  const Entry& entry = machine_.blocks.find(block);
  if (!entry.present) return fail(Alarm::MissingBlock, run_.opcode, 0, bcdWord(block.number));
  if (frames.size() >= kNesting) return fail(Alarm::BlockStack, run_.opcode);
  const bool list = block.type == BlockType::Fb;
  frames.push_back({.block = block,
                    .start = entry.start,
                    .next = entry.start,
                    .parameters = list ? frames.back().next + 1 : 0,
                    .data = frames.back().data});
  displays().os = displays().orBit = displays().chain = false;  // OP-24
  return true;
}

bool Processor::callMacro(std::uint16_t number) {
  ++macroCalls_;
  const auto& memory = machine_.blocks.program();
  const std::uint32_t jumpWord = machine_.frame().next;
  std::span<const std::uint16_t> list;
  if (jumpWord + 1 < memory.size() && memory[jumpWord] >> 8 == 0x2D) {
    const std::uint32_t count = (memory[jumpWord] & 0xFF) - 1u;
    if (jumpWord + 1 + count <= memory.size())
      list = std::span(memory).subspan(jumpWord + 1, count);
  }
  const auto trap = environment_.macros->call(number, machine_, list);
  displays().orBit = displays().chain = false;
  if (!trap) return true;
  run_.trap = *trap;
  run_.trapped = true;
  return false;
}

void Processor::leave() {
  auto& frames = machine_.level().frames;
  frames.pop_back();
  displays().os = displays().orBit = displays().chain = false;  // OP-24
  if (!frames.empty()) return;
  ended_ = std::move(machine_.levels.back());
  machine_.levels.pop_back();
  run_.levelEnded = true;
}

bool Processor::executeAll(std::span<const std::uint16_t> code) {
  while (!code.empty() && !run_.trapped) {
    const auto decoded = mc5::decode(code);
    if (!decoded) return false;
    run_.depth = 0;
    execute(*decoded);
    code = code.subspan(decoded->words);
  }
  return !run_.trapped;
}

std::optional<Registers> Processor::probe(std::span<const std::uint16_t> code, bool firstScan) {
  const Registers registers = machine_.registers();
  const Frame frame = machine_.frame();
  const Instant clock = machine_.clock;
  const Running running = run_;
  if (firstScan) displays().chain = displays().orBit = false;
  run_ = {};
  const bool readable = executeAll(code);
  std::optional<Registers> seen;
  if (readable) seen = machine_.registers();
  machine_.registers() = registers;
  machine_.frame() = frame;
  machine_.clock = clock;
  run_ = running;
  return seen;
}

}  // namespace merker::sinumerik
