#include "step7/operand_parser.h"

#include "base/text.h"
#include "step7/declaration.h"

namespace merker::step7 {

using mc7::OperandKind;

bool isComposite(TypeCode code) {
  return code == TypeCode::Array || code == TypeCode::Struct || code == TypeCode::String ||
         code == TypeCode::DateAndTime || code == TypeCode::FunctionBlock ||
         code == TypeCode::SystemFunctionBlock;
}

MemberIndex* Scope::members() const { return interfaces ? &interfaces->members() : nullptr; }

const block::Block* Scope::findBlock(BlockId id) const {
  if (interfaces) return interfaces->find(id);
  if (program)
    if (const auto found = program->find(id); found != program->end()) return &found->second;
  if (options->library)
    if (const auto found = options->library->find(id); found != options->library->end())
      return &found->second;
  return nullptr;
}

void noteForeign(const Scope& scope, std::string_view word, const Position& place) {
  if (!scope.use->foreign)
    scope.use->foreign =
        makeProblem(scope.mnemonics == Mnemonics::German ? ProblemCode::P0355 : ProblemCode::P0356,
                    place, word);
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
  // The TIA Portal marks absolute operands: %M 0.0.
  if (cursor_.peek() == '%' && isWordStart(cursor_.peek(1))) cursor_.take();
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

bool OperandParser::checkSetting(std::optional<Mnemonics> which, std::string_view word,
                                 std::size_t begin) {
  if (scope_.anyMnemonics || !which || *which == scope_.mnemonics) return true;
  if (scope_.use) {
    noteForeign(scope_, word, at(begin, begin + word.size()));
    return true;
  }
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
  if (const block::Variable* variable = scope_.findVariable(whole))
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
  if (isGlobalSymbol(whole)) return unquoted(whole, begin);
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
    case Area::None:
    case Area::CallerLocal:
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
    if (!access) return std::nullopt;
    if (access->operand.kind != OperandKind::Memory) return problem(ProblemCode::P0318, begin);
    access->openDb = db.number;
    if (scope_.use && !scope_.findBlock(db)) problem(ProblemCode::P0522, begin, toString(db));
    return access;
  }
  const block::Block* block = scope_.findBlock(db);
  if (!block) {
    while (isWordChar(cursor_.peek()) || cursor_.peek() == '.') cursor_.take();
    return problem(ProblemCode::P0506, begin, toString(db));
  }
  Place place{scope_.interfaces ? scope_.interfaces->dataType(*block) : dataTypeOf(*block), 0};
  cursor_.seek(dot);
  if (!followPath(cursor_, place, *scope_.file, problems_, scope_.members())) return std::nullopt;
  Access access;
  auto result = placed(access, Area::DataBlock, place, 0);
  result->openDb = db.number;
  return result;
}

}  // namespace merker::step7
