#include "step5/code_builder.h"

#include <algorithm>

namespace merker::step5 {
namespace {

using mc5::Operation;

constexpr std::int64_t kFarthest = 127;  // words (S5-JUMP-03)
constexpr std::uint32_t kNetworkEnd = 255;

}  // namespace

CodeBuilder::CodeBuilder(const BlockSource& source, mc5::Block& block, Problems& problems)
    : source_(source), block_(block), problems_(problems) {}

Position CodeBuilder::at(std::size_t offset, std::size_t length) const {
  return source_.file->position(offset, std::max<std::size_t>(length, 1));
}

void CodeBuilder::instruction(const mc5::Instruction& instruction, std::size_t offset) {
  last_ = next();
  const Position place = at(offset, 1);
  block_.lines.push_back({next(), place.line, place.column});
  if (!mc5::encode(instruction, block_.words)) block_.words.push_back(0);  // reported already
  bracket(instruction, offset);
}

void CodeBuilder::bracket(const mc5::Instruction& instruction, std::size_t offset) {
  const Operation operation = instruction.operation;
  if (operation == Operation::AND_OPEN || operation == Operation::OR_OPEN) ++brackets_;
  if (operation != Operation::CLOSE) return;
  if (--brackets_ >= 0) return;
  problems_.add(ProblemCode::P1137, at(offset, 1));
  brackets_ = 0;
}

void CodeBuilder::closeBrackets(std::size_t offset) {
  if (brackets_ > 0) problems_.add(ProblemCode::P1138, at(offset, 1));
  brackets_ = 0;
}

void CodeBuilder::jump(const mc5::Instruction& instruction, const std::string& label,
                       std::size_t offset, std::size_t labelOffset) {
  jumps_.push_back({instruction, label, next(), network_, labelOffset});
  this->instruction(instruction, offset);
}

void CodeBuilder::label(const std::string& name, std::size_t offset) {
  constexpr std::size_t kCharacters = 4;
  if (name.size() > kCharacters)
    problems_.add(ProblemCode::P1119, at(offset, name.size()), name, name.size(), kCharacters, "");
  const bool twice = std::any_of(labels_.begin(), labels_.end(),
                                 [&](const Label& label) { return label.name == name; });
  if (twice) problems_.add(ProblemCode::P1116, at(offset, name.size()), name);
  labels_.push_back({name, next(), network_});
  block_.labels[next()] = name;
}

// BLD 255 stands between two networks (S5-MISC-04).
void CodeBuilder::network(const std::string& title, std::size_t offset) {
  closeBrackets(offset);
  if (!block_.words.empty()) {
    (void)mc5::encode({Operation::BLD, {.kind = mc5::OperandKind::Count, .value = kNetworkEnd}},
                      block_.words);
    ++network_;
  }
  block_.networks.push_back({next(), title});
}

void CodeBuilder::fillIn(const Jump& jump) {
  const auto found = std::find_if(labels_.begin(), labels_.end(),
                                  [&](const Label& label) { return label.name == jump.label; });
  const Position place = at(jump.offset, jump.label.size());
  if (found == labels_.end()) return problems_.add(ProblemCode::P1115, place, jump.label);
  if (found->network != jump.network) return problems_.add(ProblemCode::P1118, place, jump.label);
  const std::int64_t distance = std::int64_t{found->word} - jump.word;
  if (distance > kFarthest || distance < -kFarthest)
    return problems_.add(ProblemCode::P1117, place, jump.label, distance);
  mc5::Instruction instruction = jump.instruction;
  instruction.operand.value = static_cast<std::uint32_t>(distance);
  std::vector<std::uint16_t> code;
  if (mc5::encode(instruction, code))
    std::copy(code.begin(), code.end(), block_.words.begin() + jump.word);
}

void CodeBuilder::finish(std::size_t offset) {
  closeBrackets(offset);
  for (const Jump& jump : jumps_) fillIn(jump);
}

}  // namespace merker::step5
