#include "step7/check_comment.h"

#include <cstdint>

#include "base/text.h"
#include "check/relation.h"
#include "step7/declaration.h"
#include "step7/parameter_access.h"

namespace merker::step7 {
namespace {

using block::CheckRegister;
using block::CheckTerm;
using block::CheckValue;
using block::Relation;
using mc7::OperandKind;
using mc7::Operation;

struct RegisterWord {
  std::string_view de, en;
  CheckRegister reg;
  unsigned width;
};
constexpr RegisterWord kRegisters[] = {
    {"VKE", "RLO", CheckRegister::VKE, 1},        {"STA", "STA", CheckRegister::STA, 1},
    {"OR", "OR", CheckRegister::OR, 1},           {"OS", "OS", CheckRegister::OS, 1},
    {"OV", "OV", CheckRegister::OV, 1},           {"A0", "CC0", CheckRegister::A0, 1},
    {"A1", "CC1", CheckRegister::A1, 1},          {"BIE", "BR", CheckRegister::BIE, 1},
    {"ER", "FC", CheckRegister::ER, 1},           {"AKKU1", "ACCU1", CheckRegister::AKKU1, 32},
    {"AKKU2", "ACCU2", CheckRegister::AKKU2, 32}, {"AKKU3", "ACCU3", CheckRegister::AKKU3, 32},
    {"AKKU4", "ACCU4", CheckRegister::AKKU4, 32}, {"AR1", "AR1", CheckRegister::AR1, 32},
    {"AR2", "AR2", CheckRegister::AR2, 32},       {"STW", "STW", CheckRegister::STW, 16},
    {"DBNO", "DBNO", CheckRegister::DBNO, 16},    {"DINO", "DINO", CheckRegister::DINO, 16},
};

struct Side {
  CheckValue value;
  std::optional<ConstantFormat> format;  // of a constant
  std::optional<Access> access;          // of an operand
};

class TermParser {
 public:
  TermParser(const CheckComment& comment, const Scope& scope, LocalData& localData,
             Problems& problems)
      : cursor_(scope.file->text(), comment.begin, comment.end),
        scope_(scope),
        localData_(localData),
        problems_(problems) {}

  bool parse(std::vector<CheckTerm>& out) {
    do {
      if (cursor_.atLineEnd()) break;
      if (!term(out)) return false;
    } while (cursor_.accept(','));
    if (cursor_.atLineEnd() && !out.empty()) return true;
    problems_.add(ProblemCode::P0902, here());
    return false;
  }

 private:
  Position here() { return scope_.file->position(cursor_.pos(), 1); }

  bool term(std::vector<CheckTerm>& out) {
    cursor_.skipBlanks();
    const std::size_t begin = cursor_.pos();
    CheckTerm result;
    auto left = side();
    if (!left || !relation(result.relation)) return false;
    auto right = side();
    if (!right) return false;
    if (!finish(*left, *right) || !finish(*right, *left)) return false;
    result.left = std::move(left->value);
    result.right = std::move(right->value);
    result.text = trim(cursor_.slice(begin, cursor_.pos()));
    out.push_back(std::move(result));
    return true;
  }

  bool relation(Relation& out) {
    cursor_.skipBlanks();
    const auto* const sign = block::relationAt(cursor_.slice(cursor_.pos(), cursor_.end()));
    if (sign == nullptr) {
      problems_.add(ProblemCode::P0902, here());
      return false;
    }
    cursor_.seek(cursor_.pos() + sign->text.size());
    out = sign->relation;
    return true;
  }

  bool registerWord(Side& side) {
    const std::size_t start = cursor_.pos();
    std::string word = upper(cursor_.word());
    if (word == "AKKU" || word == "ACCU" || word == "CC" || word == "A") {  // AKKU 1, CC 0
      const std::size_t saved = cursor_.pos();
      cursor_.skipBlanks();
      if (isDigit(cursor_.peek()) && !isDigit(cursor_.peek(1)) && cursor_.peek(1) != '.' &&
          word != "A")
        word += cursor_.take();
      else
        cursor_.seek(saved);
    }
    for (const RegisterWord& row : kRegisters)
      if ((word == row.de || word == row.en) && cursor_.peek() != '.') {
        // "FC 1" and "OR" as names of something else never stand in a term.
        side.value.kind = CheckValue::Kind::Register;
        side.value.reg = row.reg;
        side.value.width = row.width;
        return true;
      }
    if (word == "" && cursor_.peek() == '/') {
      cursor_.take();
      const std::string rest = upper(cursor_.word());
      if (rest == "ER" || rest == "FC") {
        side.value = {
            .kind = CheckValue::Kind::Register, .reg = CheckRegister::ER, .code = {}, .width = 1};
        return true;
      }
    }
    cursor_.seek(start);
    return false;
  }

  // A plain number may be larger than an INT: 40000 is what the accumulator shows.
  bool plainNumber(Side& side) {
    const std::size_t start = cursor_.pos();
    const auto value = readInteger(cursor_);
    const char next = cursor_.peek();
    const bool whole = value && !isWordChar(next) && next != '#' && next != '.' && next != ':';
    if (!whole || (*value >= -32768 && *value <= 32767) || *value < INT32_MIN ||
        *value > UINT32_MAX) {
      cursor_.seek(start);
      return false;
    }
    side.value.constant = static_cast<std::uint32_t>(*value);
    side.format = ConstantFormat::LongInteger;
    return true;
  }

  std::optional<Side> side() {
    Side result;
    cursor_.skipBlanks();
    if (registerWord(result) || plainNumber(result)) return result;
    std::uint32_t localTop = 0;
    auto access = OperandParser(cursor_, scope_, problems_, localTop).parse();
    if (!access) return std::nullopt;
    if (access->operand.kind == OperandKind::Constant) {
      result.value.constant = access->operand.value;
      result.format = access->operand.format;
      result.value.width = bitWidth(access->operand.format);
    } else {
      result.access = std::move(access);
    }
    return result;
  }

  // Chooses how an operand is read; of a timer or counter this depends on what it is compared with.
  bool finish(Side& side, const Side& other) {
    if (!side.access) return true;
    const Access& access = *side.access;
    const mc7::Operand& operand = access.operand;
    Operation operation = Operation::LOAD;
    bool bit = false;
    const bool timer = operand.kind == OperandKind::Timer ||
                       operand.kind == OperandKind::TimerIndirect ||
                       operand.kind == OperandKind::TimerParameter;
    const bool counter = operand.kind == OperandKind::Counter ||
                         operand.kind == OperandKind::CounterIndirect ||
                         operand.kind == OperandKind::CounterParameter;
    if (timer || counter) {
      const bool boolean =
          other.format == ConstantFormat::Boolean ||
          (timer && other.format == ConstantFormat::Integer && other.value.constant <= 1) ||
          (!other.format && other.value.kind == CheckValue::Kind::Register &&
           other.value.width == 1);
      const bool coded = other.format == (timer ? ConstantFormat::S5Time : ConstantFormat::Counter);
      bit = boolean;
      operation = boolean ? Operation::AND : coded ? Operation::LOAD_BCD : Operation::LOAD;
    } else if (operand.kind == OperandKind::StatusBit || operand.width == Width::Bit) {
      const bool memory = operand.kind != OperandKind::DataBlockInfo &&
                          operand.kind != OperandKind::ParameterAddress;
      bit = memory;
      operation = memory ? Operation::AND : Operation::LOAD;
    }
    side.value.kind = bit ? CheckValue::Kind::BitCode : CheckValue::Kind::ValueCode;
    side.value.width = bit                            ? 1
                       : operand.width == Width::Byte ? 8
                       : operand.width == Width::Word ? 16
                                                      : 32;
    return encode(operation, access, side.value.code);
  }

  bool encode(Operation operation, const Access& access, std::vector<std::uint8_t>& code) {
    const auto put = [&code](Operation what, const mc7::Operand& operand) {
      return mc7::encode({what, operand}, code);
    };
    bool good = true;
    mc7::Operand operand = access.operand;
    const auto putAll = [&](const std::vector<mc7::Instruction>& path) {
      for (const mc7::Instruction& one : path) good = put(one.operation, one.operand) && good;
    };
    if (access.kind == Access::Kind::Descriptor) {
      putAll(followPointer(scope_, {.parameter = *access.descriptor, .word = localData_.bytes(2)}));
    } else if (access.kind == Access::Kind::Number) {
      const NumberPath path = followNumber(access, localData_.bytes(2));
      putAll(path.code);
      operand = path.operand;
    } else if (access.openDb >= 0) {
      good = put(Operation::OPEN,
                 mc7::blockOperand(BlockKind::DB, static_cast<std::uint32_t>(access.openDb)));
    }
    const bool composite =
        access.type && !isElementary(access.type->code) && !isParameterNumber(access.type->code);
    if (composite || access.kind == Access::Kind::BlockName || !good || !put(operation, operand)) {
      problems_.add(ProblemCode::P0903,
                    scope_.file->position(access.begin, access.end - access.begin),
                    std::string(cursor_.slice(access.begin, access.end)));
      return false;
    }
    return true;
  }

  Cursor cursor_;
  const Scope& scope_;
  LocalData& localData_;
  Problems& problems_;
};

}  // namespace

std::optional<block::Check> parseCheckComment(const CheckComment& comment, const Scope& scope,
                                              LocalData& localData, Problems& problems) {
  block::Check check;
  if (!TermParser(comment, scope, localData, problems).parse(check.terms)) return std::nullopt;
  return check;
}

}  // namespace merker::step7
