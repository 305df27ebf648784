#include "step7/operand_parser.h"

#include "base/text.h"
#include "step7/declaration.h"

namespace merker::step7 {

using mc7::OperandKind;

Width widthOf(TypeCode code) {
  const unsigned bits = bitWidth(code);
  return bits == 1 ? Width::Bit : bits == 8 ? Width::Byte : bits == 16 ? Width::Word : Width::DWord;
}

bool isComposite(TypeCode code) {
  return code == TypeCode::Array || code == TypeCode::Struct || code == TypeCode::String ||
         code == TypeCode::DateAndTime || code == TypeCode::FunctionBlock ||
         code == TypeCode::SystemFunctionBlock;
}

const block::Block* Scope::findBlock(BlockId id) const {
  if (interfaces) return interfaces->find(id);
  if (program)
    if (const auto found = program->find(id); found != program->end()) return &found->second;
  if (options->library)
    if (const auto found = options->library->find(id); found != options->library->end())
      return &found->second;
  return nullptr;
}

std::optional<Access> OperandParser::parse() {
  cursor_.skipBlanks();
  begin_ = cursor_.pos();
  std::optional<Access> access = dispatch();
  if (access) {
    access->begin = begin_;
    access->end = cursor_.pos();
  }
  return access;
}

std::optional<Access> OperandParser::dispatch() {
  const char c = cursor_.peek();
  if (c == '"') return quoted();
  if (c == '#') {
    cursor_.take();
    const std::size_t begin = cursor_.pos();
    std::string_view name;
    if (cursor_.accept('"')) {
      while (!cursor_.atStatementEnd() && cursor_.peek() != '"') cursor_.take();
      name = cursor_.slice(begin + 1, cursor_.pos());
      cursor_.accept('"');
    } else {
      name = cursor_.word();
    }
    return local(name, begin);
  }
  if ((c == 'P' || c == 'p') && cursor_.peek(1) == '#' && cursor_.peek(2) == '#')
    return addressOf(cursor_.pos());
  if (atConstant()) return constantOperand();
  if (c == '[') return indirect(Area::None, Width::Bit, true);
  if (c == '<' || c == '>' || c == '=') {
    const std::size_t begin = cursor_.pos();
    while (cursor_.peek() == '<' || cursor_.peek() == '>' || cursor_.peek() == '=') cursor_.take();
    cursor_.skipBlanks();
    if (cursor_.peek() == '0') cursor_.take();
    std::string text;
    for (const char d : cursor_.slice(begin, cursor_.pos()))
      if (d != ' ' && d != '\t') text += d;
    std::optional<Mnemonics> which;
    if (const auto query = findStatusWord(text, which))
      return simple(mc7::number(OperandKind::StatusBit, static_cast<std::uint32_t>(*query)));
    return problem(ProblemCode::P0312, begin, text);
  }
  return word();
}

bool OperandParser::atConstant() {
  cursor_.skipBlanks();
  const char c = cursor_.peek();
  if (isDigit(c) || c == '\'' || c == '+' || c == '-') return true;
  if (!isWordStart(c)) return false;
  const std::size_t start = cursor_.pos();
  const std::string_view word = cursor_.word();
  const bool hash = cursor_.peek() == '#' && cursor_.peek(1) != '#';
  cursor_.seek(start);
  return hash || equalsIgnoreCase(word, "TRUE") || equalsIgnoreCase(word, "FALSE");
}

namespace {

// The characters that a constant may consist of, up to a separator. Blanks belong to it only where
// STEP 7 writes them: C# 100, P#M 10.0, B#(1, 2), - 5.
void passConstant(Cursor& cursor) {
  if (cursor.peek() == '\'') {
    cursor.take();
    while (!cursor.atEnd() && cursor.peek() != '\n' && cursor.peek() != '\r') {
      const char c = cursor.take();
      if (c == '$' && cursor.peek() != '\n')
        cursor.take();
      else if (c == '\'' && cursor.peek() == '\'')
        cursor.take();
      else if (c == '\'')
        break;
    }
    return;
  }
  if (cursor.peek() == '+' || cursor.peek() == '-') {
    cursor.take();
    cursor.skipBlanks();
  }
  bool pointer = false;
  for (;;) {
    const char c = cursor.peek();
    if (c == '#') {
      const char before = cursor.text()[cursor.pos() - 1];
      pointer = before == 'P' || before == 'p';
      cursor.take();
      cursor.skipBlanks();
      if (cursor.peek() == '(') {
        while (!cursor.atStatementEnd() && cursor.take() != ')') continue;
        return;
      }
      continue;
    }
    // The sign of an exponent (1.5E-3), of L#-5 and of T#-1S; the dashes of D#1998-04-14.
    if (isWordChar(c) || c == '.' || (c == ':' && cursor.peek(1) != '=') || c == '-' || c == '+') {
      cursor.take();
      continue;
    }
    if (c == ' ' && pointer) {
      const std::size_t start = cursor.pos();
      cursor.skipBlanks();
      if (isDigit(cursor.peek()) && !isDigit(cursor.text()[start - 1])) continue;
      cursor.seek(start);
    }
    return;
  }
}

}  // namespace

std::optional<Access> OperandParser::constantOperand() {
  const std::size_t begin = cursor_.pos();
  passConstant(cursor_);
  const auto value = parseConstant(cursor_.slice(begin, cursor_.pos()), at(begin, cursor_.pos()));
  if (!value) {
    problems_.add(value.error());
    return std::nullopt;
  }
  return simple(mc7::constant(value->format, value->bits));
}

std::optional<Access> OperandParser::quoted() {
  const std::size_t begin = cursor_.pos();
  cursor_.take();
  while (!cursor_.atEnd() && cursor_.peek() != '"' && cursor_.peek() != '\n') cursor_.take();
  const std::string name(cursor_.slice(begin + 1, cursor_.pos()));
  if (!cursor_.accept('"')) return problem(ProblemCode::P0301, begin, "\"");
  return symbol(name, begin);
}

std::optional<Access> OperandParser::symbol(const std::string& name, std::size_t begin) {
  using Kind = source::SymbolAddress::Kind;
  const source::Symbol* found =
      scope_.options->symbols ? scope_.options->symbols->find(name) : nullptr;
  if (!found) return problem(ProblemCode::P0303, begin, name);
  const source::SymbolAddress& address = found->address;
  switch (address.kind) {
    case Kind::Memory: {
      Access access = simple(mc7::memory(address.area, address.width, address.address));
      access.peripheralOutput = address.peripheralOutput;
      for (const Width width : {Width::Bit, Width::Byte, Width::Word, Width::DWord})
        if (width == address.width &&
            !checkRange({"", "", address.area, width}, address.address, begin))
          return std::nullopt;
      return access;
    }
    case Kind::Timer:
      return simple(mc7::number(OperandKind::Timer, address.number));
    case Kind::Counter:
      return simple(mc7::number(OperandKind::Counter, address.number));
    case Kind::VariableTable:
      return problem(ProblemCode::P0317, begin, name);
    case Kind::Block:
      break;
  }
  if (address.block.kind == BlockKind::DB && cursor_.peek() == '.')
    return insideDataBlock(address.block, begin);
  Access access = simple(mc7::blockOperand(address.block.kind, address.block.number));
  access.kind = Access::Kind::BlockName;
  return access;
}

std::optional<Access> OperandParser::local(std::string_view name, std::size_t begin) {
  const block::Variable* variable =
      scope_.block ? findMember(scope_.block->variables, name) : nullptr;
  if (variable) return localVariable(*variable, begin);
  return problem(ProblemCode::P0313, begin, std::string(name),
                 scope_.block ? toString(scope_.block->id) : std::string("the block"));
}

std::optional<Access> OperandParser::localVariable(const block::Variable& variable,
                                                   std::size_t begin) {
  Access access;
  access.variable = &variable;
  Place place{variable.type, variable.address};
  const bool function =
      scope_.block->id.kind == BlockKind::FC || scope_.block->id.kind == BlockKind::SFC;
  if (isParameterNumber(variable.type->code)) return numberParameter(variable, access);
  if (!followPath(cursor_, place, *scope_.file, problems_)) return std::nullopt;
  if (variable.section == block::Section::Temp) return placed(access, Area::Local, place, 0);
  if (function) return parameterOfFunction(variable, access, place);
  if (scope_.block->id.kind == BlockKind::FB) return instanceVariable(variable, access, place);
  return problem(ProblemCode::P0313, begin, variable.name, toString(scope_.block->id));
}

std::optional<Access> OperandParser::placed(Access access, Area area, const Place& place, int reg) {
  access.type = place.type;
  const Width width = widthOf(place.type->code);
  access.operand = reg ? mc7::registerIndirect(area, width, reg, place.address)
                       : mc7::memory(area, width, place.address);
  return access;
}

static std::uint32_t parameterIndex(const block::Block& block, const block::Variable& variable) {
  std::uint32_t index = 0;
  for (const block::Variable* parameter : block::parameters(block)) {
    if (parameter == &variable) break;
    ++index;
  }
  return index;
}

std::optional<Access> OperandParser::parameterOfFunction(const block::Variable& variable,
                                                         Access access, Place place) {
  access.type = place.type;
  if (isComposite(variable.type->code)) {
    access.kind = Access::Kind::Descriptor;
    access.descriptor = &variable;
    access.operand =
        mc7::registerCrossing(widthOf(place.type->code), 1, place.address - variable.address);
    return access;
  }
  access.operand = {.kind = OperandKind::Parameter,
                    .width = widthOf(variable.type->code),
                    .value = parameterIndex(*scope_.block, variable)};
  return access;
}

std::optional<Access> OperandParser::instanceVariable(const block::Variable& variable,
                                                      Access access, Place place) {
  if (variable.section == block::Section::InOut && isComposite(variable.type->code)) {
    access.type = place.type;
    access.kind = Access::Kind::Descriptor;
    access.descriptor = &variable;
    access.operand =
        mc7::registerCrossing(widthOf(place.type->code), 1, place.address - variable.address);
    return access;
  }
  if (place.address > 0xFFFF) return problem(ProblemCode::P0504, begin_, place.address / 8);
  return placed(access, Area::Instance, place, 2);
}

std::optional<std::uint32_t> OperandParser::copyOf(const block::Variable& variable) const {
  if (copies_)
    for (const auto& [copied, byte] : *copies_)
      if (copied == &variable) return byte;
  return std::nullopt;
}

// TIMER, COUNTER, BLOCK_*: an FC finds the number in its parameter list, an FB in a copy in its
// local data.
std::optional<Access> OperandParser::numberParameter(const block::Variable& variable,
                                                     Access access) {
  access.type = variable.type;
  const TypeCode code = variable.type->code;
  const bool timer = code == TypeCode::Timer, counter = code == TypeCode::Counter;
  const BlockKind kind = code == TypeCode::BlockFc   ? BlockKind::FC
                         : code == TypeCode::BlockFb ? BlockKind::FB
                         : code == TypeCode::BlockDb ? BlockKind::DB
                                                     : BlockKind::SDB;
  mc7::Operand& operand = access.operand;
  if (!timer && !counter) operand.blockKind = kind;
  if (const auto copy = copyOf(variable)) {
    operand.kind = timer     ? OperandKind::TimerIndirect
                   : counter ? OperandKind::CounterIndirect
                             : OperandKind::BlockIndirect;
    operand.pointerArea = Area::Local;
    operand.value = *copy;
  } else {
    operand.kind = timer     ? OperandKind::TimerParameter
                   : counter ? OperandKind::CounterParameter
                             : OperandKind::BlockParameter;
    operand.value = parameterIndex(*scope_.block, variable);
  }
  return access;
}

// P##name (S7-IND-09).
std::optional<Access> OperandParser::addressOf(std::size_t begin) {
  cursor_.seek(cursor_.pos() + 3);
  cursor_.skipBlanks();
  const std::size_t nameBegin = cursor_.pos();
  const std::string_view name = cursor_.word();
  const block::Variable* variable =
      scope_.block ? findMember(scope_.block->variables, name) : nullptr;
  if (!variable)
    return problem(ProblemCode::P0313, nameBegin, std::string(name),
                   scope_.block ? toString(scope_.block->id) : std::string("the block"));
  Access access;
  access.kind = Access::Kind::Address;
  access.variable = variable;
  const bool function = scope_.block->id.kind == BlockKind::FC;
  if (function && variable->section != block::Section::Temp) {
    access.operand =
        mc7::number(OperandKind::ParameterAddress, parameterIndex(*scope_.block, *variable));
    return access;
  }
  Place place{variable->type, variable->address};
  if (!followPath(cursor_, place, *scope_.file, problems_)) return std::nullopt;
  const Area area = variable->section == block::Section::Temp ? Area::Local : Area::Instance;
  access.type = place.type;
  access.operand = mc7::constant(ConstantFormat::Pointer, pointer(area, place.address));
  (void)begin;
  return access;
}

bool OperandParser::checkSetting(std::optional<Mnemonics> which, std::string_view word,
                                 std::size_t begin) {
  if (scope_.anyMnemonics || !which || *which == scope_.mnemonics) return true;
  problem(scope_.mnemonics == Mnemonics::German ? ProblemCode::P0314 : ProblemCode::P0315, begin,
          std::string(word));
  return false;
}

std::optional<Access> OperandParser::word() {
  const std::size_t begin = cursor_.pos();
  const std::string_view whole = cursor_.word();
  if (whole.empty()) {
    if (!cursor_.atStatementEnd()) cursor_.take();
    return problem(ProblemCode::P0316, begin);
  }
  // "MW10": letters and digits of one operand written without a blank.
  std::size_t letters = 0;
  while (letters < whole.size() && !isDigit(whole[letters])) ++letters;
  const bool allDigits = whole.find_first_not_of("0123456789", letters) == std::string_view::npos;
  const std::string_view head = allDigits ? whole.substr(0, letters) : whole;
  if (allDigits && letters < whole.size()) cursor_.seek(begin + letters);
  const auto next = [&] {
    const std::size_t saved = cursor_.pos();
    cursor_.skipBlanks();
    const char c = cursor_.peek();
    cursor_.seek(saved);
    return c;
  };
  const bool numberFollows = isDigit(next()) || next() == '[';

  std::optional<Mnemonics> which;
  if (const MemoryWord* row = findMemoryWord(head, which); row && numberFollows)
    return checkSetting(which, head, begin) ? memoryOperand(*row) : std::nullopt;
  if (numberFollows && equalsIgnoreCase(head, "T"))
    return numbered(OperandKind::Timer, OperandKind::TimerIndirect);
  if (numberFollows && (equalsIgnoreCase(head, "Z") || equalsIgnoreCase(head, "C"))) {
    which = equalsIgnoreCase(head, "Z") ? Mnemonics::German : Mnemonics::International;
    return checkSetting(which, head, begin)
               ? numbered(OperandKind::Counter, OperandKind::CounterIndirect)
               : std::nullopt;
  }
  if (numberFollows && equalsIgnoreCase(head, "DI")) return blockOperand(BlockKind::DB, true);
  if (const auto kind = blockKindFromName(head); kind && numberFollows)
    return blockOperand(*kind, false);
  if (next() == '[') {
    const bool byte = equalsIgnoreCase(head, "B"), word16 = equalsIgnoreCase(head, "W");
    if (byte || word16 || equalsIgnoreCase(head, "D"))
      return indirect(Area::None, byte ? Width::Byte : word16 ? Width::Word : Width::DWord, true);
  }
  // AUF DI "symbol", AUF DB "symbol"
  if (next() == '"' && (equalsIgnoreCase(head, "DI") || equalsIgnoreCase(head, "DB"))) {
    cursor_.skipBlanks();
    auto access = quoted();
    const bool block = access && access->kind == Access::Kind::BlockName &&
                       access->operand.blockKind == BlockKind::DB;
    if (block) access->operand.reg = equalsIgnoreCase(head, "DI") ? 1 : 0;
    if (access && !block) return problem(ProblemCode::P0304, begin, std::string(head));
    return access;
  }
  cursor_.seek(begin + whole.size());
  // A variable of the block may be written without #.
  if (const block::Variable* variable =
          scope_.block ? findMember(scope_.block->variables, whole) : nullptr)
    return localVariable(*variable, begin);
  if (equalsIgnoreCase(whole, "STW")) return simple(mc7::number(OperandKind::StatusWord, 0));
  if (equalsIgnoreCase(whole, "AR2"))
    return simple({.kind = OperandKind::AddressRegister, .reg = 2});
  if (equalsIgnoreCase(whole, "AR1"))
    return simple({.kind = OperandKind::AddressRegister, .reg = 1});
  if (const auto query = findStatusWord(whole, which)) {
    if (!checkSetting(which, whole, begin)) return std::nullopt;
    return simple(mc7::number(OperandKind::StatusBit, static_cast<std::uint32_t>(*query)));
  }
  if (const auto query = findDataBlockQuery(whole))
    return simple(mc7::number(OperandKind::DataBlockInfo, static_cast<std::uint32_t>(*query)));
  return problem(ProblemCode::P0317, begin, std::string(whole));
}

namespace {

// "17" at the cursor, at most 65535 of it used.
std::optional<std::uint32_t> unsignedNumber(Cursor& cursor) {
  cursor.skipBlanks();
  if (!isDigit(cursor.peek())) return std::nullopt;
  std::uint64_t value = 0;
  while (isDigit(cursor.peek()))
    value =
        std::min<std::uint64_t>(value * 10 + static_cast<unsigned>(cursor.take() - '0'), 1u << 24);
  return static_cast<std::uint32_t>(value);
}

}  // namespace

bool OperandParser::bitAddressAt(Width width, BitAddress& out, std::size_t begin) {
  const auto byte = unsignedNumber(cursor_);
  if (!byte) {
    problem(ProblemCode::P0316, begin);
    return false;
  }
  std::uint32_t bit = 0;
  const bool point = cursor_.peek() == '.' && isDigit(cursor_.peek(1));
  if (point) {
    cursor_.take();
    bit = *unsignedNumber(cursor_);
  }
  if (point != (width == Width::Bit)) {
    problem(point ? ProblemCode::P0212 : ProblemCode::P0211, begin);
    return false;
  }
  if (bit > 7) {
    problem(ProblemCode::P0213, begin, bit);
    return false;
  }
  out = bitAddress(*byte, bit);
  return true;
}

bool OperandParser::checkRange(const MemoryWord& row, BitAddress address, std::size_t begin) {
  const CpuModel& model = scope_.model();
  std::uint32_t bytes = 65'536;
  std::string_view what = "data byte";
  switch (row.area) {
    case Area::Input:
      bytes = model.imageBytes, what = "input byte";
      break;
    case Area::Output:
      bytes = model.imageBytes, what = "output byte";
      break;
    case Area::Flag:
      bytes = model.flagBytes, what = "flag byte";
      break;
    case Area::Peripheral:
      bytes = model.peripheralBytes, what = "periphery byte";
      break;
    case Area::Local:
      bytes = model.localBytes, what = "local data byte";
      break;
    case Area::DataBlock:
    case Area::Instance:
      bytes = model.dataBlockSize;
      break;
    default:
      break;
  }
  const std::uint32_t last = address / 8 + byteCount(row.width) - 1;
  if (last >= bytes) {
    problem(ProblemCode::P0214, begin, what, last, bytes - 1, model.name);
    return false;
  }
  if (row.area == Area::Local) localTop_ = std::max(localTop_, last + 1);
  return true;
}

std::optional<Access> OperandParser::memoryOperand(const MemoryWord& row) {
  cursor_.skipBlanks();
  Access access;
  if (cursor_.peek() == '[') {
    auto result = indirect(row.area, row.width, false);
    if (result) result->peripheralOutput = row.peripheralOutput;
    return result;
  }
  BitAddress address = 0;
  if (!bitAddressAt(row.width, address, begin_) || !checkRange(row, address, begin_))
    return std::nullopt;
  access.operand = mc7::memory(row.area, row.width, address);
  access.peripheralOutput = row.peripheralOutput;
  return access;
}

std::optional<Access> OperandParser::numbered(OperandKind direct, OperandKind indirectKind) {
  cursor_.skipBlanks();
  if (cursor_.peek() == '[') {
    mc7::Operand operand;
    if (!memoryPointer(Width::Word, operand)) return std::nullopt;
    operand.kind = indirectKind;
    return simple(operand);
  }
  const std::uint32_t value = *unsignedNumber(cursor_);
  if (cursor_.peek() == '.' && isDigit(cursor_.peek(1))) {
    cursor_.take();
    unsignedNumber(cursor_);
    return problem(ProblemCode::P0215, begin_);
  }
  const bool timer = direct == OperandKind::Timer;
  const std::uint32_t count = timer ? scope_.model().timers : scope_.model().counters;
  if (value >= count)
    return problem(ProblemCode::P0214, begin_, timer ? "timer" : "counter", value, count - 1,
                   scope_.model().name);
  return simple(mc7::number(direct, value));
}

std::optional<Access> OperandParser::blockOperand(BlockKind kind, bool instance) {
  cursor_.skipBlanks();
  if (cursor_.peek() == '[') {
    mc7::Operand operand;
    if (!memoryPointer(Width::Word, operand)) return std::nullopt;
    operand.kind = OperandKind::BlockIndirect;
    operand.blockKind = kind;
    operand.reg = instance ? 1 : 0;
    return simple(operand);
  }
  const std::uint32_t value = *unsignedNumber(cursor_);
  const BlockId id{kind, static_cast<std::uint16_t>(std::min(value, 65'535u))};
  // DB 0 and DI 0 can be opened: that closes the register (S7-INSTR-47).
  const bool closes = kind == BlockKind::DB && value == 0;
  if (value > 65'535 || (!closes && !scope_.model().allows(id)))
    return problem(ProblemCode::P0505, begin_, name(kind), value, scope_.model().name);
  if (kind == BlockKind::DB && !instance && cursor_.peek() == '.')
    return insideDataBlock(id, begin_);
  Access access = simple(mc7::blockOperand(kind, value, instance));
  access.kind = Access::Kind::BlockName;
  return access;
}

// DB5.DBW 2, DB5.name[3].x, "symbol".name
std::optional<Access> OperandParser::insideDataBlock(BlockId db, std::size_t begin) {
  const std::size_t dot = cursor_.pos();
  cursor_.take();
  cursor_.skipBlanks();
  const std::size_t wordBegin = cursor_.pos();
  const std::string_view whole = cursor_.word();
  const std::string_view head = whole.substr(0, std::min(whole.size(), std::size_t{3}));
  std::optional<Mnemonics> which;
  const MemoryWord* row = findMemoryWord(head, which);
  const bool rest = whole.find_first_not_of("0123456789", head.size()) == std::string_view::npos;
  if (row && rest && row->area == Area::DataBlock && head.size() == 3) {
    cursor_.seek(wordBegin + 3);
    auto access = memoryOperand(*row);
    if (access && access->operand.kind == OperandKind::Memory)
      access->openDb = db.number;
    else if (access)
      return problem(ProblemCode::P0318, begin);
    return access;
  }
  const block::Block* block = scope_.findBlock(db);
  if (!block) {
    while (isWordChar(cursor_.peek()) || cursor_.peek() == '.') cursor_.take();
    return problem(ProblemCode::P0506, begin, toString(db));
  }
  auto type = std::make_shared<block::Type>();
  type->code = TypeCode::Struct;
  type->members = block->variables;
  Place place{type, 0};
  cursor_.seek(dot);
  if (!followPath(cursor_, place, *scope_.file, problems_)) return std::nullopt;
  Access access;
  auto result = placed(access, Area::DataBlock, place, 0);
  result->openDb = db.number;
  return result;
}

// [MD 10], [#pointer], ["symbol"]: the operand that holds the pointer or the number (S7-IND-03,
// -04).
bool OperandParser::memoryPointer(Width width, mc7::Operand& out) {
  const std::size_t open = cursor_.pos();
  cursor_.take();
  OperandParser inner(cursor_, scope_, problems_, localTop_);
  const auto access = inner.parse();
  cursor_.skipBlanks();
  if (!access) {
    while (!cursor_.atStatementEnd() && cursor_.peek() != ']') cursor_.take();
    cursor_.accept(']');
    return false;
  }
  if (!cursor_.accept(']')) {
    problem(ProblemCode::P0301, cursor_.pos(), "]");
    return false;
  }
  const mc7::Operand& operand = access->operand;
  const bool area = operand.area == Area::Flag || operand.area == Area::DataBlock ||
                    operand.area == Area::Instance || operand.area == Area::Local;
  if (access->kind != Access::Kind::Machine || operand.kind != OperandKind::Memory || !area ||
      access->openDb >= 0 || operand.width != width) {
    problem(width == Width::DWord ? ProblemCode::P0319 : ProblemCode::P0320, open);
    return false;
  }
  out.pointerArea = operand.area;
  out.value = operand.value / 8;
  return true;
}

std::optional<Access> OperandParser::indirect(Area area, Width width, bool crossing) {
  const std::size_t open = cursor_.pos();
  cursor_.skipBlanks();
  const std::size_t bracket = cursor_.pos();
  cursor_.take();
  cursor_.skipBlanks();
  const std::string word = upper(cursor_.word());
  if (word == "AR1" || word == "AR2") return registerIndirect(area, width, crossing, word);
  if (crossing) {
    while (!cursor_.atStatementEnd() && cursor_.peek() != ']') cursor_.take();
    cursor_.accept(']');
    return problem(ProblemCode::P0321, open);
  }
  cursor_.seek(bracket);
  mc7::Operand operand{.kind = OperandKind::MemoryIndirect, .area = area, .width = width};
  if (!memoryPointer(Width::DWord, operand)) return std::nullopt;
  return simple(operand);
}

std::optional<Access> OperandParser::registerIndirect(Area area, Width width, bool crossing,
                                                      std::string_view word) {
  const std::size_t open = cursor_.pos();
  cursor_.skipBlanks();
  cursor_.accept(',');
  cursor_.skipBlanks();
  const std::size_t begin = cursor_.pos();
  while (!cursor_.atStatementEnd() && cursor_.peek() != ']') cursor_.take();
  const auto offset =
      parseConstant(trim(cursor_.slice(begin, cursor_.pos())), at(begin, cursor_.pos()));
  if (!cursor_.accept(']')) return problem(ProblemCode::P0301, cursor_.pos(), "]");
  // S7-IND-05: P#0.0 … P#4095.7; the code has room up to P#8191.7.
  if (!offset || offset->format != ConstantFormat::Pointer || offset->bits > scope_.highestOffset())
    return problem(ProblemCode::P0322, open);
  const int reg = word == "AR1" ? 1 : 2;
  return simple(crossing ? mc7::registerCrossing(width, reg, offset->bits)
                         : mc7::registerIndirect(area, width, reg, offset->bits));
}

}  // namespace merker::step7
