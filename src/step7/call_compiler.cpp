#include "step7/call_compiler.h"

#include <algorithm>
#include <bit>

#include "base/text.h"
#include "step7/initial_value.h"

namespace merker::step7 {

using block::Section;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

namespace {

// Composite values up to this size are moved by load and transfer, larger ones by SFC 20.
constexpr std::uint32_t kInlineBytes = 64;

bool needsNoDataBlock(const Access& access) {
  const Operand& operand = access.operand;
  return access.kind == Access::Kind::Machine && operand.kind == OperandKind::Memory &&
         access.openDb < 0 && operand.area != Area::DataBlock && operand.area != Area::Instance;
}

}  // namespace

bool CallCompiler::compile(std::size_t begin) {
  if (!target()) return false;
  CallParameters parameters(c_, target_);
  auto actuals = parameters.read();
  if (!actuals) return false;
  actuals_ = std::move(*actuals);
  (void)begin;
  if (target_.isFunction())
    callFunction();
  else
    callFunctionBlock();
  return true;
}

bool CallCompiler::target() {
  Cursor& cursor = c_.cursor();
  cursor.skipSpace();
  const std::size_t begin = cursor.pos();
  const std::size_t before = c_.problems().size();
  if (cursor.accept('#') || !cursor.peekWord("FC")) {
    const std::string_view name = cursor.word();
    if (const block::Variable* variable = findMember(c_.scope().block->variables, name);
        variable && !variable->type->members.empty())
      return instanceTarget(*variable, begin);
    cursor.seek(begin);
  }
  const auto access = c_.operand();
  if (!access) return false;
  const auto place = c_.at(begin, cursor.pos());
  const BlockKind kind = access->operand.blockKind;
  if (access->kind != Access::Kind::BlockName || kind == BlockKind::DB || kind == BlockKind::UDT) {
    c_.problems().add(ProblemCode::P0518, place);
    return false;
  }
  if (kind == BlockKind::OB) {  // S7-BLK-17
    c_.problems().add(ProblemCode::P0510, place);
    return false;
  }
  target_.id = {kind, static_cast<std::uint16_t>(access->operand.value)};
  target_.block = c_.scope().findBlock(target_.id);
  if (!target_.block) {
    c_.problems().add(ProblemCode::P0506, place, toString(target_.id));
    return false;
  }
  return target_.isFunction() || (instanceDataBlock(begin) && c_.problems().size() == before);
}

bool CallCompiler::instanceTarget(const block::Variable& variable, std::size_t begin) {
  const TypeCode code = variable.type->code;
  const bool instance = code == TypeCode::FunctionBlock || code == TypeCode::SystemFunctionBlock;
  if (!instance) {
    c_.problems().add(ProblemCode::P0518, c_.at(begin, c_.cursor().pos()));
    return false;
  }
  target_.id = {code == TypeCode::FunctionBlock ? BlockKind::FB : BlockKind::SFB,
                variable.type->length};
  target_.block = c_.scope().findBlock(target_.id);
  target_.instance = &variable;
  return target_.block != nullptr;
}

// CALL FB 1, DB 2: the data block must be an instance of this FB (S7-FB-05, S7-FB-07, S7-PAR-11).
bool CallCompiler::instanceDataBlock(std::size_t begin) {
  Cursor& cursor = c_.cursor();
  if (!cursor.accept(',')) {
    c_.problems().add(ProblemCode::P0519, c_.at(begin, cursor.pos()), toString(target_.id));
    return false;
  }
  cursor.skipSpace();
  const std::size_t dbBegin = cursor.pos();
  const auto access = c_.operand();
  if (!access) return false;
  const auto place = c_.at(dbBegin, cursor.pos());
  if (access->kind != Access::Kind::BlockName || access->operand.blockKind != BlockKind::DB ||
      access->operand.value == 0) {
    c_.problems().add(ProblemCode::P0519, place, toString(target_.id));
    return false;
  }
  const BlockId id{BlockKind::DB, static_cast<std::uint16_t>(access->operand.value)};
  const block::Block* db = c_.scope().findBlock(id);
  if (!db) {
    c_.problems().add(ProblemCode::P0520, place, toString(id), toString(target_.id));
    return false;
  }
  if (db->instanceOf != target_.id.number ||
      db->instanceOfSystemBlock != (target_.id.kind == BlockKind::SFB)) {
    c_.problems().add(ProblemCode::P0521, place, toString(id), toString(target_.id));
    return false;
  }
  target_.instanceDb = id.number;
  return true;
}

// --- building blocks

Access CallCompiler::machine(const Operand& operand) {
  Access access;
  access.operand = operand;
  return access;
}

// `byte` bytes behind the beginning of `access`, with another width.
Access CallCompiler::part(const Access& access, std::uint32_t byte, Width width) {
  Access result = access;
  result.operand.value += byte * 8;
  result.operand.width = width;
  return result;
}

void CallCompiler::move(Width width, const Access& from, const Access& to) {
  c_.access(width == Width::Bit ? Operation::AND : Operation::LOAD, from);
  c_.access(width == Width::Bit ? Operation::ASSIGN : Operation::TRANSFER, to);
}

void CallCompiler::loadConstant(Width width, std::uint32_t value) {
  put(Operation::LOAD, width == Width::Byte   ? mc7::constant(ConstantFormat::Byte, value & 0xFF)
                       : width == Width::Word ? mc7::constant(ConstantFormat::Word, value & 0xFFFF)
                                              : mc7::constant(ConstantFormat::DWord, value));
}

// The notation in which a disassembler shows a value of this type.
static ConstantFormat notationOf(TypeCode type) {
  switch (type) {
    case TypeCode::Byte:
      return ConstantFormat::Byte;
    case TypeCode::Char:
      return ConstantFormat::Characters;
    case TypeCode::Int:
      return ConstantFormat::Integer;
    case TypeCode::DInt:
      return ConstantFormat::LongInteger;
    case TypeCode::Real:
      return ConstantFormat::Real;
    case TypeCode::Date:
      return ConstantFormat::Date;
    case TypeCode::TimeOfDay:
      return ConstantFormat::TimeOfDay;
    case TypeCode::Time:
      return ConstantFormat::Time;
    case TypeCode::S5Time:
      return ConstantFormat::S5Time;
    default:
      return bitWidth(type) > 16 ? ConstantFormat::DWord : ConstantFormat::Word;
  }
}

void CallCompiler::storeConstant(TypeCode type, std::uint32_t bits, const Operand& to) {
  if (type == TypeCode::Bool) {
    put(bits ? Operation::SET : Operation::CLR);
    put(Operation::ASSIGN, to);
    return;
  }
  const std::uint32_t mask = bitWidth(type) >= 32 ? ~0u : (1u << bitWidth(type)) - 1;
  put(Operation::LOAD, mc7::constant(notationOf(type), bits & mask));
  put(Operation::TRANSFER, to);
}

Operand CallCompiler::constantInLocal(TypeCode type, std::uint32_t bits) {
  const Width width = widthOf(type);
  const Operand place = local(width, c_.allocate(byteCount(width)));
  storeConstant(type, bits, place);
  return place;
}

// A copy in local data of a value that the called block cannot reach by itself.
Operand CallCompiler::staged(const Access& access, Width width, bool copyIn, bool copyOut) {
  const Operand place = local(width, c_.allocate(byteCount(width)));
  if (copyIn) move(width, access, machine(place));
  if (copyOut) afterwards_.push_back({place, access});
  return place;
}

// Copies of BOOL values go through the VKE; the called block and the caller find theirs unchanged.
bool CallCompiler::touchesResult() const {
  return std::any_of(actuals_.begin(), actuals_.end(), [this](const auto& entry) {
    const auto& [formal, actual] = entry;
    if (formal->type->code != TypeCode::Bool || !actual.access) return false;
    return !target_.isFunction() || !needsNoDataBlock(*actual.access);
  });
}

void CallCompiler::keepResult() {
  if (keeps_) put(Operation::ASSIGN, local(Width::Bit, result_));
}

void CallCompiler::returnResult() {
  if (keeps_) put(Operation::AND, local(Width::Bit, result_));
}

// --- POINTER and ANY

void CallCompiler::descriptorAddress(const Actual& actual, std::uint32_t dbByte,
                                     std::uint32_t pointerByte) {
  const Access& access = *actual.access;
  const Operand& operand = access.operand;
  const Operand db = local(Width::Word, dbByte), place = local(Width::DWord, pointerByte);
  const auto addOffset = [&](std::uint32_t offset) {
    if (offset) put(Operation::ADD_CONSTANT, mc7::constant(ConstantFormat::LongInteger, offset));
    put(Operation::TRANSFER, place);
  };
  if (access.kind == Access::Kind::Descriptor) {  // own composite parameter
    const std::uint32_t copy = c_.parameterCopy(*access.descriptor);
    put(Operation::LOAD, local(Width::Word, copy));
    put(Operation::TRANSFER, db);
    put(Operation::LOAD, local(Width::DWord, copy + 2));
    return addOffset(operand.value);
  }
  if (operand.kind == OperandKind::RegisterIndirect) {  // own instance: AR2 carries its offset
    put(Operation::LOAD, mc7::number(OperandKind::DataBlockInfo,
                                     static_cast<std::uint32_t>(mc7::DataBlockQuery::DiNumber)));
    put(Operation::TRANSFER, db);
    put(Operation::TAR2);
    return addOffset(operand.value);
  }
  if (operand.kind == OperandKind::Parameter) {  // own parameter of a function: its actual operand
    loadConstant(Width::Word, 0);
    put(Operation::TRANSFER, db);
    put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, operand.value));
    return addOffset(0);
  }
  Area area = operand.area;
  const bool openBlock = access.openDb < 0 && (area == Area::DataBlock || area == Area::Instance);
  if (openBlock) {
    const auto query =
        area == Area::DataBlock ? mc7::DataBlockQuery::DbNumber : mc7::DataBlockQuery::DiNumber;
    put(Operation::LOAD,
        mc7::number(OperandKind::DataBlockInfo, static_cast<std::uint32_t>(query)));
  } else {
    loadConstant(Width::Word, static_cast<std::uint32_t>(std::max(access.openDb, 0)));
  }
  put(Operation::TRANSFER, db);
  if (area == Area::Local) area = Area::CallerLocal;
  if (area == Area::Instance) area = Area::DataBlock;
  loadConstant(Width::DWord, pointer(area, operand.value));
  put(Operation::TRANSFER, place);
}

std::uint32_t CallCompiler::copyOfOwn(const Access& access, std::uint32_t bytes) {
  const block::Variable& own = *access.variable;
  if (own.section == Section::Temp) return own.address / 8;
  const std::uint32_t byte = c_.allocate(bytes);
  Access from = access;
  if (c_.scope().block->id.kind == BlockKind::FC) {
    put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, access.operand.value));
    put(Operation::LAR1);
    from = machine(mc7::registerCrossing(Width::Word, 1, 0));
  }
  for (std::uint32_t i = 0; i < bytes; i += 2)
    move(Width::Word, part(from, i, Width::Word), machine(local(Width::Word, byte + i)));
  return byte;
}

namespace {

struct AnyHeader {
  TypeCode type = TypeCode::Byte;
  std::uint32_t count = 1;
};

// Type code and repetition factor of a variable or operand (S7-IND-13, S7-IND-15).
AnyHeader anyHeader(const Access& access) {
  if (!access.type) {
    static constexpr TypeCode kByWidth[] = {TypeCode::Bool, TypeCode::Byte, TypeCode::Word,
                                            TypeCode::DWord};
    return {kByWidth[static_cast<int>(access.operand.width)], 1};
  }
  const block::Type& type = *access.type;
  if (isElementary(type.code) || type.code == TypeCode::DateAndTime) return {type.code, 1};
  if (type.code == TypeCode::Array &&
      (isElementary(type.element->code) || type.element->code == TypeCode::DateAndTime)) {
    std::uint32_t count = 1;
    for (const block::Dimension& dimension : type.dimensions) count *= dimension.count();
    return {type.element->code, count};
  }
  return {TypeCode::Byte, block::sizeInBytes(type)};
}

}  // namespace

// Builds a POINTER (6 bytes) or ANY (10 bytes) in local data; returns its byte.
std::uint32_t CallCompiler::descriptor(const Actual& actual, bool any) {
  if (actual.access && actual.access->variable && actual.access->type &&
      actual.access->type->code == (any ? TypeCode::Any : TypeCode::Pointer))
    return copyOfOwn(*actual.access, any ? 10 : 6);
  const std::uint32_t byte = c_.allocate(any ? 10 : 6);
  const std::uint32_t db = byte + (any ? 4 : 0);
  const auto word = [&](std::uint32_t at, std::uint32_t value) {
    loadConstant(Width::Word, value);
    put(Operation::TRANSFER, local(Width::Word, at));
  };
  const auto header = [&](TypeCode type, std::uint32_t count) {
    if (!any) return;
    word(byte, 0x1000u | static_cast<std::uint32_t>(type));
    word(byte + 2, count);
  };
  if (actual.nil || actual.isPointer) {
    const bool counted = actual.anyType != TypeCode::Void;
    header(actual.nil ? TypeCode::Void
           : counted  ? actual.anyType
                      : TypeCode::Byte,
           actual.nil ? 0
           : counted  ? actual.anyCount
                      : 1u);
    word(db, actual.db);
    loadConstant(Width::DWord, actual.pointer);
    put(Operation::TRANSFER, local(Width::DWord, db + 2));
    return byte;
  }
  const Operand& operand = actual.access->operand;
  if (operand.kind == OperandKind::Timer || operand.kind == OperandKind::Counter ||
      operand.kind == OperandKind::Block) {
    const TypeCode type = operand.kind == OperandKind::Timer     ? TypeCode::Timer
                          : operand.kind == OperandKind::Counter ? TypeCode::Counter
                          : operand.blockKind == BlockKind::FB   ? TypeCode::BlockFb
                          : operand.blockKind == BlockKind::FC   ? TypeCode::BlockFc
                                                                 : TypeCode::BlockDb;
    header(type, 1);  // S7-IND-14
    loadConstant(Width::DWord, 0);
    put(Operation::TRANSFER, local(Width::DWord, db));
    word(db + 4, operand.value);
    return byte;
  }
  const AnyHeader content = anyHeader(*actual.access);
  header(content.type, content.count);
  descriptorAddress(actual, db, db + 2);
  return byte;
}

// --- functions

std::uint32_t CallCompiler::elementaryEntry(const block::Variable& formal, const Actual& actual) {
  const Access& access = *actual.access;
  const TypeCode type = formal.type->code;
  Operand place = access.operand;
  if (actual.isConstant())
    place = constantInLocal(type, access.operand.value);
  else if (!needsNoDataBlock(access))
    place = staged(access, widthOf(type),
                   formal.section == Section::Input || formal.section == Section::InOut,
                   formal.section != Section::Input);
  const Area area = place.area == Area::Local ? Area::CallerLocal : place.area;
  return pointer(area, place.value);
}

// The entry of the parameter list behind the call (MC7 section 7.2).
std::uint32_t CallCompiler::entry(const block::Variable& formal, const Actual& actual) {
  const TypeCode code = formal.type->code;
  if (isElementary(code)) return elementaryEntry(formal, actual);
  if (isParameterNumber(code)) return actual.access->operand.value << 16;
  return pointer(Area::CallerLocal, descriptor(actual, code == TypeCode::Any) * 8);
}

void CallCompiler::callFunction() {
  put(Operation::BLD, mc7::number(OperandKind::ShiftCount, 1));
  keeps_ = touchesResult();
  if (keeps_) result_ = c_.allocate(1);
  keepResult();
  std::vector<std::uint32_t> entries;
  for (const block::Variable* formal : block::parameters(*target_.block))
    entries.push_back(entry(*formal, actuals_.at(formal)));
  returnResult();
  put(Operation::UC, mc7::blockOperand(target_.id.kind, target_.id.number));
  put(Operation::SPA,
      mc7::number(OperandKind::Jump, static_cast<std::uint32_t>(2 * entries.size() + 2)));
  for (const std::uint32_t value : entries) c_.builder().parameterEntry(value);
  if (!afterwards_.empty()) {
    keepResult();
    for (const CopyBack& copy : afterwards_) move(copy.from.width, machine(copy.from), copy.to);
    returnResult();
    // A jump to the next instruction ends the chain as the call did: /ER 0, STA 1 (S7-INSTR-105).
    if (keeps_) put(Operation::SPBI, mc7::number(OperandKind::Jump, 2));
  }
  put(Operation::BLD, mc7::number(OperandKind::ShiftCount, 2));
}

// --- function blocks

Operand CallCompiler::instanceOperand(BitAddress address, Width width) const {
  if (target_.instance)
    return mc7::registerIndirect(Area::Instance, width, 2, target_.instance->address + address);
  return mc7::memory(Area::Instance, width, address);
}

void CallCompiler::collectBytes(BitAddress instance, const Operand& from, std::uint32_t bytes) {
  std::uint32_t byte = 0;
  while (byte < bytes) {
    const Width width = bytes - byte >= 4   ? Width::DWord
                        : bytes - byte >= 2 ? Width::Word
                                            : Width::Byte;
    const TypeCode type = width == Width::DWord  ? TypeCode::DWord
                          : width == Width::Word ? TypeCode::Word
                                                 : TypeCode::Byte;
    transfers_.push_back({instance + byte * 8, local(width, from.value / 8 + byte), type});
    byte += byteCount(width);
  }
}

void CallCompiler::collectComposite(const block::Variable& formal, const Actual& actual) {
  if (formal.section == Section::InOut)
    return collectBytes(formal.address, local(Width::Byte, descriptor(actual, false)), 6);
  const std::uint32_t bytes = block::sizeInBytes(*formal.type);
  if (formal.section != Section::Input) return;
  if (bytes > kInlineBytes) return copyBlock(formal, actual, true);
  const std::uint32_t place = c_.allocate(bytes);
  for (std::uint32_t byte = 0; byte < bytes; byte += 2)
    move(Width::Word, part(*actual.access, byte, Width::Word),
         machine(local(Width::Word, place + byte)));
  collectBytes(formal.address, local(Width::Byte, place), bytes);
}

void CallCompiler::collectInput(const block::Variable& formal, const Actual& actual) {
  const TypeCode code = formal.type->code;
  if (isParameterNumber(code)) {
    const Access& access = *actual.access;
    if (!access.variable) {
      transfers_.push_back({formal.address,
                            mc7::constant(ConstantFormat::Word, access.operand.value),
                            TypeCode::Word});
    } else if (access.operand.pointerArea == Area::Local) {  // own parameter of an FB
      transfers_.push_back(
          {formal.address, local(Width::Word, c_.parameterCopy(*access.variable)), TypeCode::Word});
    } else {  // of an FC: the number stands in the first word of its entry
      const std::uint32_t byte = c_.allocate(4);
      put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, access.operand.value));
      put(Operation::TRANSFER, local(Width::DWord, byte));
      transfers_.push_back({formal.address, local(Width::Word, byte), TypeCode::Word});
    }
    return;
  }
  if (code == TypeCode::Any || code == TypeCode::Pointer) {
    const std::uint32_t byte = descriptor(actual, code == TypeCode::Any);
    return collectBytes(formal.address, local(Width::Byte, byte), code == TypeCode::Any ? 10 : 6);
  }
  if (!isElementary(code)) return collectComposite(formal, actual);
  if (formal.section == Section::Output) return;
  const Access& access = *actual.access;
  const bool direct = actual.isConstant() || needsNoDataBlock(access);
  transfers_.push_back(
      {formal.address, direct ? access.operand : staged(access, widthOf(code), true, false), code});
}

void CallCompiler::collectOutputs() {
  for (const block::Variable* formal : block::parameters(*target_.block)) {
    const auto found = actuals_.find(formal);
    if (found == actuals_.end() || formal->section == Section::Input || !found->second.access)
      continue;
    const Access& to = *found->second.access;
    const TypeCode code = formal->type->code;
    if (isElementary(code)) {
      const Width width = widthOf(code);
      const Operand from = instanceOperand(formal->address, width);
      if (needsNoDataBlock(to)) {
        fromInstance_.push_back({from, to});
      } else {
        const Operand place = local(width, c_.allocate(byteCount(width)));
        fromInstance_.push_back({from, machine(place)});
        afterwards_.push_back({place, to});
      }
    } else if (formal->section == Section::Output && isComposite(code)) {
      const std::uint32_t bytes = block::sizeInBytes(*formal->type);
      if (bytes > kInlineBytes) continue;
      const std::uint32_t place = c_.allocate(bytes);
      for (std::uint32_t byte = 0; byte < bytes; byte += 2) {
        const Operand word = local(Width::Word, place + byte);
        fromInstance_.push_back(
            {instanceOperand(formal->address + byte * 8, Width::Word), machine(word)});
        afterwards_.push_back({word, part(to, byte, Width::Word)});
      }
    }
  }
}

void CallCompiler::transferIn(const Transfer& transfer) {
  const Width width = widthOf(transfer.type);
  const Operand to = instanceOperand(transfer.address, width);
  if (transfer.from.kind == OperandKind::Constant)
    storeConstant(transfer.type, transfer.from.value, to);
  else
    move(width, machine(transfer.from), machine(to));
}

void CallCompiler::switchToInstance() {
  if (target_.instance) return;
  put(Operation::SWAP_DB);
  put(Operation::OPEN,
      mc7::blockOperand(BlockKind::DB, static_cast<std::uint32_t>(target_.instanceDb), true));
}

void CallCompiler::switchBack() {
  if (!target_.instance) put(Operation::SWAP_DB);
}

void CallCompiler::callFunctionBlock() {
  put(Operation::BLD, mc7::number(OperandKind::ShiftCount, 3));
  keeps_ = touchesResult();
  if (keeps_) result_ = c_.allocate(1);
  ar2_ = c_.allocate(4);
  keepResult();
  for (const block::Variable* formal : block::parameters(*target_.block))
    if (const auto found = actuals_.find(formal); found != actuals_.end())
      collectInput(*formal, found->second);
  collectOutputs();
  switchToInstance();
  for (const Transfer& transfer : transfers_) transferIn(transfer);
  put(Operation::TAR2, local(Width::DWord, ar2_));
  if (!target_.instance)
    put(Operation::LAR2, mc7::constant(ConstantFormat::Pointer, pointer(Area::DataBlock, 0)));
  else if (target_.instance->address)
    put(Operation::ADD_AR2, mc7::number(OperandKind::Pointer, target_.instance->address));
  returnResult();
  put(Operation::UC, mc7::blockOperand(target_.id.kind, target_.id.number));
  put(Operation::LAR2, local(Width::DWord, ar2_));
  keepResult();
  for (const CopyBack& copy : fromInstance_) move(copy.from.width, machine(copy.from), copy.to);
  switchBack();
  for (const CopyBack& copy : afterwards_) move(copy.from.width, machine(copy.from), copy.to);
  for (const auto& [formal, actual] : actuals_)
    if (formal->section == Section::Output && isComposite(formal->type->code) &&
        block::sizeInBytes(*formal->type) > kInlineBytes)
      copyBlock(*formal, actual, false);
  returnResult();
  if (keeps_) put(Operation::SPBI, mc7::number(OperandKind::Jump, 2));
  put(Operation::BLD, mc7::number(OperandKind::ShiftCount, 4));
}

// A large composite value between its variable and the instance, by SFC 20 BLKMOV.
void CallCompiler::copyBlock(const block::Variable& formal, const Actual& actual, bool in) {
  const block::Block* service = c_.scope().findBlock({BlockKind::SFC, 20});
  if (!service) {
    c_.problems().add(ProblemCode::P0506, c_.at(actual.begin, actual.end),
                      toString(BlockId{BlockKind::SFC, 20}));
    return;
  }
  Actual inside;
  Access place;
  place.type = formal.type;
  place.operand = target_.instance ? instanceOperand(formal.address, Width::Byte)
                                   : mc7::memory(Area::DataBlock, Width::Byte, formal.address);
  place.openDb = target_.instance ? -1 : target_.instanceDb;
  inside.access = place;
  const std::uint32_t own = descriptor(actual, true), instance = descriptor(inside, true);
  const std::uint32_t result = c_.allocate(2);
  const auto parameters = block::parameters(*service);
  put(Operation::UC, mc7::blockOperand(BlockKind::SFC, 20));
  put(Operation::SPA,
      mc7::number(OperandKind::Jump, static_cast<std::uint32_t>(2 * parameters.size() + 2)));
  for (const block::Variable* parameter : parameters) {
    const std::uint32_t byte = parameter->section == Section::Return          ? result
                               : (parameter->section == Section::Input) == in ? own
                                                                              : instance;
    c_.builder().parameterEntry(pointer(Area::CallerLocal, byte * 8));
  }
}

}  // namespace merker::step7
