#include <random>
#include <stdexcept>

#include "../edges.h"
#include "case.h"
#include "mc5/disassembly.h"
#include "mc5/encoding.h"
#include "mc5/range.h"

namespace merker::differential5 {
namespace {

using mc5::BlockType;
using mc5::Encoding;
using mc5::Operand;
using mc5::OperandKind;
using mc5::Operation;
struct Random : std::mt19937 {
  using std::mt19937::mt19937;
  std::uint32_t operator()() { return static_cast<std::uint32_t>(std::mt19937::operator()()); }
};
using Words = std::vector<std::uint16_t>;

constexpr std::uint16_t kBlockEnd = 0x6500, kTransferMd = 0x1B00 + 40, kIncrement = 0x1100;
constexpr std::uint32_t kWords[] = {0, 1, 5, 6};  // operands meet each other again and again

bool oneIn(Random& random, unsigned n) { return random() % n == 0; }

// What ends the cycle or the run: now and then only.
bool isRare(Operation o) {
  return o == Operation::STP || o == Operation::STS || (o >= Operation::SUBSTITUTE) ||
         o == Operation::END || o == Operation::END_ALWAYS;
}

std::uint32_t operandValue(const Operand& operand, Random& random) {
  switch (operand.kind) {
    case OperandKind::Memory:
      if (oneIn(random, 200)) return random() & 0xFF;
      return operand.area == mc5::Area::Data ? random() % 8 : kWords[random() % 4];
    case OperandKind::Timer:
    case OperandKind::Counter:
      return random() % (oneIn(random, 300) ? 64 : 4);
    case OperandKind::Constant:
      return oneIn(random, 2) ? random() : random() % 3;
    case OperandKind::Count:
      return oneIn(random, 300) ? random() & 0xFF : 1 + random() % 12;
    case OperandKind::Jump:  // into the middle of an instruction, too
      return oneIn(random, 12) ? static_cast<std::uint32_t>(-static_cast<int>(random() % 12))
                               : 1 + random() % 9;
    case OperandKind::Block:
      return operand.block == BlockType::Db ? 20 + random() % (oneIn(random, 60) ? 3 : 2)
                                            : random() % (oneIn(random, 60) ? 4 : 3);
    case OperandKind::None:
      return 0;
    case OperandKind::Formal:
      return 1 + random() % 2;
  }
  return 0;
}

// The pattern says which numbers the row can hold; of those that it refuses another one is taken.
void append(const Encoding& row, Random& random, Words& code) {
  for (int i = 0; i < 50; ++i) {
    Operand operand = row.operand;
    operand.value = operandValue(operand, random);
    const bool cell = operand.kind == OperandKind::Timer || operand.kind == OperandKind::Counter;
    const unsigned bits = cell || operand.area == mc5::Area::Data ? 16 : 8;
    if (operand.width == mc5::Width::Bit && (cell || operand.kind == OperandKind::Memory))
      operand.bit = static_cast<std::uint8_t>(random() % bits);
    if (operand.area == mc5::Area::Input && oneIn(random, 2)) operand.area = mc5::Area::Output;
    if (operand.format == mc5::Format::Byte || operand.format == mc5::Format::SignedByte)
      operand.value &= 0xFF;
    else if (operand.kind == OperandKind::Constant && operand.format != mc5::Format::Float)
      operand.value &= 0xFFFF;
    if (mc5::encode(row, operand, code)) return;
  }
  throw std::logic_error("no operand found for " + std::string(row.pattern));
}

const Encoding& anyRow(Random& random) {
  return mc5::encodings()[random() % mc5::encodings().size()];
}

// Behind the call of an FB, over a jump: operands for its formal ones, as codes of one word.
void appendParameters(Random& random, Words& code) {
  code.push_back(0x2D03);
  for (int i = 0; i < 2;) {
    const Encoding& row = anyRow(random);
    const bool names = row.operation == Operation::AND || row.operation == Operation::LOAD ||
                       (row.operation == Operation::OPEN && oneIn(random, 4));
    if (row.length != 1 || row.operand.kind == OperandKind::Formal || !names) continue;
    append(row, random, code);
    ++i;
  }
}

void appendAny(Random& random, Words& code) {
  for (;;) {
    const Encoding& row = anyRow(random);
    if (isRare(row.operation) && !oneIn(random, 40)) continue;
    if (row.operand.kind == OperandKind::Formal && !oneIn(random, 20)) continue;
    append(row, random, code);
    if (row.operand.kind == OperandKind::Block && row.operand.block == BlockType::Fb &&
        !oneIn(random, 4))
      appendParameters(random, code);
    return;
  }
}

// In an FB with instructions that take formal operands.
void appendFormal(Random& random, Words& code) {
  for (;;) {
    const Encoding& row = anyRow(random);
    if (row.operand.kind == OperandKind::Formal) return append(row, random, code);
  }
}

// Brackets that fit, as programs have them; others come by chance.
void appendBrackets(Random& random, Words& code) {
  code.push_back(oneIn(random, 2) ? 0xBA00 : 0xBB00);
  for (unsigned n = random() % 4; n-- > 0;)
    code.push_back(static_cast<std::uint16_t>(0x8000 | (random() & 0x2F00) | random() % 4));
  if (oneIn(random, 3)) appendAny(random, code);
  if (oneIn(random, 4)) appendBrackets(random, code);
  code.push_back(0xBF00);
}

void appendLong(std::uint32_t number, Words& code) {
  code.insert(code.end(), {0x3800, static_cast<std::uint16_t>(number >> 16),
                           static_cast<std::uint16_t>(number)});
}

// AKKU 1 and 2 from numbers that arithmetic minds, and some status.
void appendLoads(Random& random, Words& code) {
  for (int i = 0; i < 2; ++i) {
    const std::uint32_t number =
        oneIn(random, 2) ? differential::kEdges[random() % std::size(differential::kEdges)]
                         : random();
    if (oneIn(random, 3))
      appendLong(number, code);
    else
      code.insert(code.end(), {0x3040, static_cast<std::uint16_t>(number)});
  }
}

// B MW or B DW with a number that mostly lies in the data block, and what it processes.
void appendProcessing(Random& random, Words& code) {
  const bool isData = oneIn(random, 3);
  const auto place = static_cast<std::uint16_t>(isData ? random() % 4 : 30 + 2 * (random() % 3));
  const auto transfer = static_cast<std::uint16_t>((isData ? 0x3300 : 0x1300) | place);
  if (!oneIn(random, 3))
    code.insert(code.end(), {0x3040, static_cast<std::uint16_t>(random() % 12), transfer});
  code.push_back(static_cast<std::uint16_t>((isData ? 0x6E00 : 0x4E00) | place));
  if (oneIn(random, 4)) return appendAny(random, code);
  code.push_back(static_cast<std::uint16_t>((oneIn(random, 2) ? 0x3200 : 0x3300) | random() % 4));
}

Words randomCode(Random& random, std::size_t instructions) {
  Words code;
  while (instructions-- > 0) {
    if (oneIn(random, 15)) appendProcessing(random, code);
    oneIn(random, 10) ? appendBrackets(random, code) : appendAny(random, code);
    if (oneIn(random, 6)) code.push_back(static_cast<std::uint16_t>(kTransferMd + random() % 40));
    if (oneIn(random, 12)) appendLoads(random, code);
  }
  code.push_back(kBlockEnd);
  return code;
}

// One of two has formal operands.
Words functionBlock(Random& random) {
  Words code = randomCode(random, random() % 12);
  code.pop_back();
  for (unsigned n = oneIn(random, 2) ? random() % 5 : 0; n-- > 0;) {
    appendFormal(random, code);
    if (oneIn(random, 2)) appendAny(random, code);
  }
  const Words rest = randomCode(random, random() % 12);
  code.insert(code.end(), rest.begin(), rest.end());
  return code;
}

// Accumulator, VKE and what jumps see of the displays, each kept in flags.
void appendLook(unsigned number, Words& code) {
  const auto md = static_cast<std::uint16_t>(kTransferMd + 8 * number);
  constexpr std::uint16_t kPlus = 0x1502, kMinus = 0x2502, kOverflow = 0x0D02;
  code.insert(code.end(), {md, static_cast<std::uint16_t>(0x9800 | (80 + number)), kPlus,
                           kIncrement + 1, kMinus, kIncrement + 2, kOverflow, kIncrement + 4,
                           0x600C, 0x0003, kIncrement + 8, static_cast<std::uint16_t>(md + 4)});
}

mc5::Block block(BlockType type, std::uint16_t number, Words words) {
  mc5::Block b;
  b.id = {type, number};
  b.words = std::move(words);
  return b;
}

void add(Case& c, BlockType type, std::uint16_t number, Words words) {
  c.program[{type, number}] = block(type, number, std::move(words));
}

void addData(Case& c, Random& random) {
  for (std::uint16_t number = 20; number < 22; ++number) {
    Words words(number == 20 ? 8 : 3 + random() % 8);
    for (auto& word : words) word = static_cast<std::uint16_t>(random());
    add(c, BlockType::Db, number, std::move(words));
  }
}

// A DB is open, most of the time.
Words opened(Random& random, const Words& code) {
  Words words;
  if (!oneIn(random, 8)) words.push_back(static_cast<std::uint16_t>(0x2000 | (20 + random() % 2)));
  appendLoads(random, words);
  words.insert(words.end(), code.begin(), code.end());
  return words;
}

}  // namespace

Case randomCase(std::uint32_t seed) {
  Random random(seed);
  Case c;
  c.seed = seed;
  add(c, BlockType::Ob, 1, opened(random, randomCode(random, 10 + random() % 60)));
  add(c, BlockType::Ob, 2, opened(random, randomCode(random, random() % 12)));
  if (oneIn(random, 2)) add(c, BlockType::Ob, 20, randomCode(random, random() % 12));
  for (std::uint16_t number = 0; number < 3; ++number) {
    add(c, BlockType::Pb, number, randomCode(random, random() % 12));
    add(c, BlockType::Sb, number, randomCode(random, random() % 12));
    add(c, BlockType::Fb, number, functionBlock(random));
  }
  addData(c, random);
  return c;
}

Case rowCase(std::size_t row, std::uint32_t seed, std::optional<std::size_t> edge) {
  Random random(seed);
  Case c;
  c.seed = seed;
  Words code;
  for (unsigned i = 0; i < 4; ++i) {
    if (edge) {
      for (const std::size_t place : {*edge + 2 * i + 1, *edge + i})
        appendLong(differential::kEdges[place % std::size(differential::kEdges)], code);
    } else {
      appendLoads(random, code);
    }
    code.push_back(static_cast<std::uint16_t>(0x8000 | (random() & 0x2F00) | random() % 4));
    append(mc5::encodings()[row], random, code);
    appendLook(i, code);
  }
  code.push_back(kBlockEnd);
  add(c, BlockType::Ob, 1, opened(random, code));
  for (const BlockType type : {BlockType::Pb, BlockType::Sb, BlockType::Fb})
    for (std::uint16_t number = 0; number < 3; ++number) add(c, type, number, {kBlockEnd});
  addData(c, random);
  return c;
}

Case writingCase(std::uint32_t seed) {
  constexpr std::uint16_t kTir = 0x4800, kProgramSegment = 5;
  constexpr std::uint16_t kFirst = mc5::kHeaderWords, kPatched = 6;  // OB 1 lies at the beginning
  Case c;
  c.seed = seed;
  add(c, BlockType::Ob, 1,
      {0x3040, kIncrement + 2, 0x3800, kProgramSegment, 2 * (kFirst + kPatched), kTir,
       kIncrement + 1, kTransferMd, kIncrement + 1, kIncrement + 1, kTransferMd + 4, kBlockEnd});
  return c;
}

Case callingCase(std::uint32_t seed) {
  constexpr std::uint16_t kCall = 0x3D00, kOverList = 0x2D03, kOpen = 0x2000 + 20;
  constexpr std::uint16_t kBit = 0x8100 + 30, kWord = 0x1200 + 30;  // U M 30.1, L MW 30
  Case c;
  c.seed = seed;
  Random random(seed);
  Words code;
  for (int i = 0; i < 20; ++i)
    code.insert(code.end(), {kOpen, kCall, kOverList, kBit, kWord, kIncrement + 1});
  code.push_back(kBlockEnd);
  add(c, BlockType::Ob, 1, code);
  add(c, BlockType::Fb, 0, {0x0701, 0x9A00 + 30, 0x4602, kTransferMd, kBlockEnd});  // U =1, L =2
  addData(c, random);
  return c;
}

std::string listing(const Case& c) {
  std::string text;
  for (const auto& [id, b] : c.program) {
    if (id.type == BlockType::Db) continue;
    text += "block type " + std::to_string(static_cast<int>(id.type)) + " number " +
            std::to_string(id.number) + '\n';
    for (const mc5::Line& line : mc5::disassemble(b.words)) text += mc5::toString(line) + '\n';
  }
  return text;
}

}  // namespace merker::differential5
