#include <algorithm>
#include <random>

#include "case.h"
#include "edges.h"
#include "mc7/encoding.h"
#include "mc7/listing.h"

namespace merker::differential {
namespace {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : random_(seed) {}

  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
  bool oneIn(std::uint32_t n) { return below(n) == 0; }

  // What the block mostly is made of, besides everything else: calls, or formal parameters; Short:
  // nothing that keeps it from standing in a region of its caller, as far as a row tells.
  enum class Mostly : std::uint8_t { Plain, Calls, Parameters, Short };

  std::vector<std::uint8_t> code(std::uint32_t instructions, Mostly mostly = Mostly::Plain) {
    mostly_ = mostly;
    std::vector<std::uint8_t> code;
    if (mostly != Mostly::Short) {
      if (!oneIn(4)) append(openBlock(false), code);
      if (!oneIn(4)) append(openBlock(true), code);
    }
    while (instructions > 0) {
      const std::size_t next = row();
      if (!append(next, code)) continue;
      --instructions;
      if (mostly == Mostly::Short && isOpening(next)) appendQuery(code);
    }
    code.insert(code.end(), {0x65, 0x00});  // BE
    fixJumps(code);
    return code;
  }

  bool append(std::size_t row, std::vector<std::uint8_t>& code) {
    const mc7::Encoding& encoding = mc7::encodings()[row];
    if (encoding.operation == Operation::BE || encoding.operation == Operation::BEA) return false;
    for (int attempt = 0; attempt < 8; ++attempt) {
      const Operand o = operand(encoding.operand);
      if (mc7::encode(encoding, o, code)) {
        if (encoding.operation == Operation::SPL && !oneIn(8))
          for (std::uint32_t i = 0; i < o.value; ++i) append({Operation::SPA, kJump}, code);
        if (encoding.operation == Operation::UC || encoding.operation == Operation::CC)
          appendList(encoding.operand, code);
        return true;
      }
    }
    return false;
  }

 private:
  static constexpr Operand kJump{.kind = OperandKind::Jump, .value = 2};
  // Parameters of an FC: a jump over pointers (MC7 section 7.2).
  void appendList(const Operand& o, std::vector<std::uint8_t>& code) {
    if (o.kind != OperandKind::Block || o.blockKind != BlockKind::FC || oneIn(4)) return;
    const std::uint32_t entries = 1 + below(6);
    code.insert(code.end(), {0x70, 0x0B, 0x00, static_cast<std::uint8_t>(2 + 2 * entries)});
    for (std::uint32_t i = 0; i < entries; ++i) {
      const std::uint32_t pointer = parameter();
      for (int shift = 24; shift >= 0; shift -= 8)
        code.push_back(static_cast<std::uint8_t>(pointer >> shift));
    }
  }
  // A pointer to anything, or the number of a timer, counter or block.
  std::uint32_t parameter() {
    if (oneIn(4)) return below(6) << 16;
    if (oneIn(12)) return static_cast<std::uint32_t>(random_());
    constexpr Area kAreas[] = {Area::Input,    Area::Output, Area::Flag,        Area::DataBlock,
                               Area::Instance, Area::Local,  Area::CallerLocal, Area::CallerLocal};
    return pointer(oneIn(16) ? Area::Peripheral : kAreas[below(8)],
                   8 * below(oneIn(8) ? 80 : 24) + (oneIn(3) ? below(8) : 0));
  }
  bool append(const mc7::Instruction& i, std::vector<std::uint8_t>& code) {
    return mc7::encode(i, code);
  }
  mc7::Instruction openBlock(bool instance) {
    return {Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1 + below(3), instance)};
  }
  static bool isOpening(std::size_t row) {
    const Operation o = mc7::encodings()[row].operation;
    return o >= Operation::AND_OPEN && o <= Operation::XOR_NOT_OPEN;
  }
  // One operand, and the closing bracket.
  void appendQuery(std::vector<std::uint8_t>& code) {
    append({Operation::AND, mc7::memory(Area::Flag, Width::Bit, address(Width::Bit))}, code);
    append({Operation::CLOSE, {}}, code);
  }
  static bool staysWithItsCaller(const mc7::Encoding& row) {
    constexpr Operation kNot[] = {Operation::MCR_OPEN, Operation::MCR_CLOSE, Operation::MCRA,
                                  Operation::MCRD,     Operation::CLOSE,     Operation::SPL,
                                  Operation::LOOP};
    return std::find(std::begin(kNot), std::end(kNot), row.operation) == std::end(kNot);
  }
  // Every row now and then, what programs are made of more often.
  std::size_t row() {
    const auto rows = mc7::encodings();
    for (;;) {
      const std::size_t i = below(static_cast<std::uint32_t>(rows.size()));
      const Operation o = rows[i].operation;
      if (mostly_ == Mostly::Short && !staysWithItsCaller(rows[i])) continue;
      const bool calls =
          o == Operation::UC || o == Operation::CC || o == Operation::BEB || o == Operation::BEA;
      const bool stops = o == Operation::MCR_OPEN || o == Operation::MCR_CLOSE ||
                         o == Operation::CLOSE || o == Operation::BTI || o == Operation::BTD ||
                         o == Operation::ENT || o == Operation::LEAVE;
      const OperandKind kind = rows[i].operand.kind;
      const bool parameter = kind >= OperandKind::BlockIndirect || kind == OperandKind::Parameter ||
                             kind == OperandKind::TimerParameter ||
                             kind == OperandKind::CounterParameter;
      const bool wanted =
          (mostly_ == Mostly::Calls && o == Operation::UC) ||
          ((mostly_ == Mostly::Parameters || mostly_ == Mostly::Short) && parameter);
      if ((calls || stops || parameter) && !oneIn(wanted ? 2 : 12)) continue;
      if (mostly_ == Mostly::Parameters && !parameter && oneIn(2)) continue;
      return i;
    }
  }

  Area area(Area given) {
    constexpr Area kAreas[] = {Area::Flag,      Area::Flag,     Area::Input, Area::Output,
                               Area::DataBlock, Area::Instance, Area::Local, Area::Peripheral};
    return given != Area::None ? given : kAreas[below(oneIn(4) ? 8 : 7)];
  }
  Area pointerArea() {
    constexpr Area kAreas[] = {Area::Flag, Area::DataBlock, Area::Instance, Area::Local};
    return kAreas[below(4)];
  }
  std::uint32_t address(Width width) {
    const std::uint32_t byte = oneIn(12) ? below(300) : below(24);
    return bitAddress(byte, width == Width::Bit ? below(8) : 0);
  }
  std::uint32_t number() {
    constexpr std::uint32_t kValues[] = {2,          0xFFFF,     0x8001,     0x3F800000,
                                         0xBF000000, 0x7F800000, 0x7FC00000, 0x00800000,
                                         0x4B000001, 0xC0490FDB, 100};
    if (oneIn(3)) return static_cast<std::uint32_t>(random_());
    if (oneIn(3)) return kEdges[below(std::size(kEdges))];
    return oneIn(3) ? below(256) : kValues[below(std::size(kValues))];
  }

  Operand operand(Operand o) {
    constexpr std::uint32_t kQueries[] = {0, 1, 2, 4, 5, 6, 8, 10, 12, 14};
    switch (o.kind) {
      case OperandKind::Memory:
        o.area = area(o.area);
        o.value = address(o.width);
        break;
      case OperandKind::MemoryIndirect:
        o.area = area(o.area);
        o.pointerArea = pointerArea();
        o.value = 2 * below(10);
        break;
      case OperandKind::RegisterIndirect:
        o.area = area(o.area);
        [[fallthrough]];
      case OperandKind::RegisterCrossing:
        o.reg = static_cast<std::uint8_t>(1 + below(2));
        o.value = oneIn(3) ? below(200) : 8 * below(16);
        break;
      case OperandKind::TimerIndirect:
      case OperandKind::CounterIndirect:
      case OperandKind::BlockIndirect:
        o.pointerArea = pointerArea();
        o.value = 2 * below(10);
        break;
      case OperandKind::StatusBit:
        o.value = kQueries[below(std::size(kQueries))];
        break;
      case OperandKind::Constant:
        o.value = number();
        if (bitWidth(o.format) == 16) o.value &= 0xFFFF;
        if (bitWidth(o.format) == 8) o.value &= 0xFF;
        break;
      case OperandKind::Block:
        o.value = 1 + below(3);
        break;
      case OperandKind::ShiftCount:
        o.value = oneIn(4) ? below(256) : below(34);
        break;
      case OperandKind::Jump:
        o.value = 2;
        break;
      case OperandKind::StatusWord:
      case OperandKind::None:
      case OperandKind::AddressRegister:
      case OperandKind::DataBlockInfo:
        break;
      default:
        o.value = below(4);
    }
    return o;
  }

  // Jumps lead to instructions, forwards more often than backwards.
  void fixJumps(std::vector<std::uint8_t>& code) {
    const mc7::Listing listing = mc7::list(code);
    const auto& places = listing.places;
    for (std::size_t i = 0; i < places.size(); ++i) {
      mc7::Instruction jump = places[i].instruction;
      if (!places[i].known || jump.operand.kind != OperandKind::Jump) continue;
      if (i > 0 && places[i - 1].parameters != 0) continue;
      const std::size_t first = mostly_ != Mostly::Short && oneIn(3) ? 0 : i + 1;
      const std::size_t to = first + below(static_cast<std::uint32_t>(places.size() - first));
      const auto words = (static_cast<int>(places[std::min(to, places.size() - 1)].offset) -
                          static_cast<int>(places[i].offset)) /
                         2;
      jump.operand.value = static_cast<std::uint32_t>(words);
      std::vector<std::uint8_t> bytes;
      const auto decoded = mc7::decode(std::span(code).subspan(places[i].offset));
      if (mc7::encode(*decoded->encoding, jump.operand, bytes))
        std::copy(bytes.begin(), bytes.end(), code.begin() + places[i].offset);
    }
  }

  Mostly mostly_ = Mostly::Plain;
  std::mt19937 random_;
};

// FB 2, until the nesting depth ends, with a call of FC 1 at each depth.
std::vector<std::uint8_t> callsItself() {
  std::vector<std::uint8_t> code;
  (void)mc7::encode({Operation::UC, mc7::blockOperand(BlockKind::FC, 1)}, code);
  code.insert(code.end(), {0x70, 0x0B, 0x00, 2 + 2 * 4});
  for (int i = 0; i < 4; ++i) code.insert(code.end(), {0x83, 0x00, 0x00, 0x50});  // P#M 10.0
  (void)mc7::encode({Operation::UC, mc7::blockOperand(BlockKind::FB, 2)}, code);
  code.insert(code.end(), {0x65, 0x00});  // BE
  return code;
}

void callSystem(std::vector<std::uint8_t>& code) {
  code.insert(code.begin(), {0x3D, 0x02, 0x3D, 0x03});  // UC FC 2, UC FC 3
}

}  // namespace

Case randomCase(std::uint32_t seed) {
  Generator generator(seed);
  Case c;
  c.seed = seed;
  if (generator.oneIn(8)) c.model = generator.oneIn(32) ? "generic" : "small generic";
  using Mostly = Generator::Mostly;
  c.blocks[{BlockKind::OB, 1}] =
      generator.code(4 + generator.below(60), generator.oneIn(2) ? Mostly::Calls : Mostly::Plain);
  if (c.withSystemCalls()) callSystem(c.blocks[{BlockKind::OB, 1}]);
  const bool isShort = generator.oneIn(2);
  c.blocks[{BlockKind::FC, 1}] =
      isShort ? generator.code(1 + generator.below(5), Mostly::Short)
              : generator.code(1 + generator.below(20),
                               generator.oneIn(4) ? Mostly::Plain : Mostly::Parameters);
  c.blocks[{BlockKind::FB, 2}] = isShort ? generator.code(1 + generator.below(5), Mostly::Short)
                                         : generator.code(1 + generator.below(12));
  if (isShort && generator.oneIn(12)) c.blocks[{BlockKind::FB, 2}] = callsItself();
  for (const std::uint16_t ob : std::initializer_list<std::uint16_t>{35, 40, 121, 122})
    if (!generator.oneIn(3)) c.blocks[{BlockKind::OB, ob}] = generator.code(generator.below(8));
  return c;
}

Case rowCase(std::size_t row, std::uint32_t seed) {
  Generator generator(seed);
  Case c;
  c.seed = seed;
  if (generator.oneIn(4)) c.model = "small generic";
  std::vector<std::uint8_t>& code = c.blocks[{BlockKind::OB, 1}];
  (void)mc7::encode({Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1)}, code);
  (void)mc7::encode({Operation::OPEN, mc7::blockOperand(BlockKind::DB, 2, true)}, code);
  generator.append(row, code);
  generator.append(row, code);
  code.insert(code.end(), {0x65, 0x00});
  c.blocks[{BlockKind::OB, 121}] = c.blocks[{BlockKind::OB, 122}] = {0x65, 0x00};
  return c;
}

}  // namespace merker::differential
