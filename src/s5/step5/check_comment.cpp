#include "step5/check_comment.h"

#include <algorithm>
#include <array>
#include <bit>

#include "address/constant.h"
#include "check/relation.h"
#include "mc5/instruction.h"
#include "mc5/range.h"
#include "mc5/s5_float.h"
#include "step5/constant_operand.h"

namespace merker::step5 {
namespace {

using block::CheckRegister;
using block::CheckTerm;
using block::CheckValue;
using block::Relation;
using mc5::OperandKind;
using mc5::Operation;

struct RegisterWord {
  std::string_view word;
  CheckRegister reg;
  unsigned width;
};
constexpr std::array kRegisters{RegisterWord{"VKE", CheckRegister::VKE, 1},
                                RegisterWord{"STA", CheckRegister::STA, 1},
                                RegisterWord{"STATUS", CheckRegister::STA, 1},
                                RegisterWord{"OR", CheckRegister::OR, 1},
                                RegisterWord{"ODER", CheckRegister::OR, 1},
                                RegisterWord{"OS", CheckRegister::OS, 1},
                                RegisterWord{"OV", CheckRegister::OV, 1},
                                RegisterWord{"A0", CheckRegister::A0, 1},
                                RegisterWord{"ANZ0", CheckRegister::A0, 1},
                                RegisterWord{"A1", CheckRegister::A1, 1},
                                RegisterWord{"ANZ1", CheckRegister::A1, 1},
                                RegisterWord{"ER", CheckRegister::ER, 1},
                                RegisterWord{"ERAB", CheckRegister::ER, 1},
                                RegisterWord{"AKKU1", CheckRegister::AKKU1, 32},
                                RegisterWord{"AKKU2", CheckRegister::AKKU2, 32},
                                RegisterWord{"STW", CheckRegister::STW, 8},
                                RegisterWord{"DBNO", CheckRegister::DBNO, 16}};

// One side of a term before the other one is known.
struct Side {
  CheckValue value;
  std::optional<mc5::Operand> operand;  // to be queried or loaded
  std::vector<std::uint16_t> open;      // A DB n before
  std::optional<mc5::Format> format;    // of a constant
};

bool isTruth(const Side& side) {
  return side.value.kind == CheckValue::Kind::Constant && !side.format && side.value.constant <= 1;
}

class Parser {
 public:
  Parser(Scanner& scanner, const mc5::Block& block, const std::vector<std::uint32_t>& words,
         const source::SymbolTable* symbols)
      : scanner_(scanner), block_(block), words_(words), symbols_(symbols) {}

  Checks parse() {
    do {
      scanner_.skipBlanks();
      if (scanner_.atEnd()) break;
      if (!term()) return std::move(result_);
      scanner_.skipBlanks();
    } while (scanner_.accept(','));
    if (!scanner_.atEnd() || result_.terms.empty()) fail();
    return std::move(result_);
  }

 private:
  bool fail() {
    if (unknown_) {
      result_.failures.push_back(*unknown_);
      return false;
    }
    result_.failures.push_back(
        {ProblemCode::P1142, scanner_.offset(), 1, std::string(scanner_.rest().substr(0, 16)), ""});
    return false;
  }

  bool term() {
    const std::size_t mark = scanner_.mark();
    auto left = side();
    scanner_.skipBlanks();
    const auto relation = sign();
    if (!left || !relation) return fail();
    scanner_.skipBlanks();
    auto right = side();
    if (!right) return fail();
    finish(*left, *right);
    finish(*right, *left);
    std::string text(scanner_.since(mark));
    result_.terms.push_back({left->value, right->value, *relation, std::move(text)});
    return true;
  }

  // STEP 5 compares with != and ><, too.
  std::optional<Relation> sign() {
    using Sign = block::RelationSign;
    static constexpr Sign kUnequal{"!=", Relation::NotEqual};
    const std::string_view rest = scanner_.rest();
    const bool unequal = rest.starts_with("!=") || rest.starts_with("><");
    const Sign* const sign = unequal ? &kUnequal : block::relationAt(rest);
    if (sign == nullptr) return std::nullopt;
    scanner_.skip(sign->text.size());
    return sign->relation;
  }

  std::optional<Side> side() {
    if (auto reg = registerSide()) return reg;
    if (auto number = numberSide()) return number;
    return operandSide();
  }

  std::optional<Side> registerSide() {
    const std::size_t mark = scanner_.mark();
    std::string word(scanner_.take([](char c) { return isLetter(c) || isDigit(c); }));
    std::transform(word.begin(), word.end(), word.begin(), upper);
    for (const RegisterWord& row : kRegisters)
      if (row.word == word && scanner_.peek() != '.') {
        Side side;
        side.value.kind = CheckValue::Kind::Register;
        side.value.reg = row.reg;
        side.value.width = row.width;
        return side;
      }
    scanner_.back(mark);
    return std::nullopt;
  }

  // 7, -12, TRUE, and the typed constants of the newer language: W#16#F2, L#-5.
  std::optional<Side> numberSide() {
    const std::size_t mark = scanner_.mark();
    const std::string word(scanner_.take([](char c) { return c != ',' && !isBlank(c); }));
    const bool typed = word.find('#') != std::string::npos && !word.starts_with("KG");
    const bool number = !word.empty() && (isDigit(word[0]) || word[0] == '-' || word[0] == '+');
    if (word == "TRUE" || word == "FALSE") return constant(word == "TRUE" ? 1 : 0);
    if (typed || number)
      if (const auto parsed = merker::parseConstant(word, Position{})) {
        Side side = constant(parsed.value().bits);
        if (parsed.value().format == ConstantFormat::Real) {  // the number, in the format of KG
          side.value.constant = mc5::fromDouble(std::bit_cast<float>(parsed.value().bits)).bits;
          side.format = mc5::Format::Float;
        }
        // A negative number is one of 16 bits, like KF.
        if (word[0] == '-') side.format = mc5::Format::Fixed;
        return side;
      }
    scanner_.back(mark);
    return std::nullopt;
  }

  static Side constant(std::uint32_t bits) {
    Side side;
    side.value.constant = bits;
    return side;
  }

  std::optional<Side> operandSide() {
    Side side;
    Failure failure;
    dataBlock(side);
    const auto operand = step5::parseOperand(scanner_, failure, symbols_);
    if (!operand && failure.code == ProblemCode::P0303) unknown_ = failure;
    if (!operand) return std::nullopt;
    side.operand = operand->value;
    if (!operand->name.empty() && !formal(operand->name, *side.operand)) return std::nullopt;
    if (operand->value.kind == OperandKind::Constant) {
      side.value.constant = operand->value.value;
      side.format = operand->value.format;
      side.operand.reset();
    }
    return side;
  }

  // "DB10.DW 5" opens the block for this term only.
  void dataBlock(Side& side) {
    const std::size_t mark = scanner_.mark();
    Failure failure;
    const auto operand = step5::parseOperand(scanner_, failure, symbols_);
    const bool block = operand && operand->value.kind == OperandKind::Block &&
                       operand->value.block == mc5::BlockType::Db;
    if (block && scanner_.accept('.') && mc5::encode({Operation::OPEN, operand->value}, side.open))
      return;
    scanner_.back(mark);
  }

  bool formal(const std::string& name, mc5::Operand& operand) const {
    for (std::size_t i = 0; i < block_.parameters.size(); ++i)
      if (block_.parameters[i].name == name) {
        const auto& parameter = block_.parameters[i];
        operand = {.kind = OperandKind::Formal, .width = parameter.width, .value = words_[i]};
        return true;
      }
    return false;
  }

  // The code that queries or loads; which one, the other side may decide.
  void finish(Side& side, const Side& other) {
    if (side.value.kind == CheckValue::Kind::Register) {
      // KF is a number of Akku-L (9.2.1): the upper half does not count.
      if (other.format == mc5::Format::Fixed && side.value.width == 32) side.value.width = 16;
      return;
    }
    if (!side.operand) return;
    mc5::Operand operand = *side.operand;
    const bool bit = asBit(operand, other);
    if (operand.kind == OperandKind::Formal) operand.width = mc5::Width::Bit;
    std::vector<std::uint16_t> code = side.open;
    if (!mc5::encode({bit ? Operation::AND : loading(operand, other), operand}, code)) {
      fail();
      return;
    }
    side.value.kind = bit ? CheckValue::Kind::BitCode : CheckValue::Kind::ValueCode;
    side.value.width = bit ? 1 : 32;
    for (const std::uint16_t word : code) {
      side.value.code.push_back(static_cast<std::uint8_t>(word >> 8));
      side.value.code.push_back(static_cast<std::uint8_t>(word));
    }
  }

  static bool asBit(const mc5::Operand& operand, const Side& other) {
    if (operand.kind == OperandKind::Timer && operand.width != mc5::Width::Bit)
      return isTruth(other);
    return operand.width == mc5::Width::Bit &&
           (operand.kind == OperandKind::Memory || operand.kind == OperandKind::Formal);
  }

  static Operation loading(const mc5::Operand& operand, const Side& other) {
    const bool cell = operand.kind == OperandKind::Timer || operand.kind == OperandKind::Counter;
    const bool coded = other.format == mc5::Format::Time || other.format == mc5::Format::Counter;
    return cell && coded ? Operation::LOAD_BCD : Operation::LOAD;
  }

  Scanner& scanner_;
  const mc5::Block& block_;
  const std::vector<std::uint32_t>& words_;
  const source::SymbolTable* symbols_;
  std::optional<Failure> unknown_;  // a symbol that is in no list
  Checks result_;
};

}  // namespace

Checks parseChecks(Scanner& scanner, const mc5::Block& block,
                   const std::vector<std::uint32_t>& words, const source::SymbolTable* symbols) {
  return Parser(scanner, block, words, symbols).parse();
}

}  // namespace merker::step5
