#include "step5/code_builder.h"

#include <algorithm>

namespace merker::step5 {
namespace {

using mc5::Operation;

constexpr std::int64_t kFarthest = 127;  // words (S5-JUMP-03)
constexpr std::uint32_t kNetworkEnd = 255;

bool isNetworkEnd(const mc5::Instruction& instruction) {
  return instruction.operation == Operation::BLD && instruction.operand.value == kNetworkEnd;
}

}  // namespace

CodeBuilder::CodeBuilder(const BlockSource& source, mc5::Block& block, Problems& problems)
    : source_(source), block_(block), problems_(problems) {}

Position CodeBuilder::at(std::size_t offset, std::size_t length) const {
  return source_.file->position(offset, std::max<std::size_t>(length, 1));
}

void CodeBuilder::instruction(const mc5::Instruction& instruction, std::size_t offset) {
  beforeCode();
  last_ = next();
  const Position place = at(offset, 1);
  block_.lines.push_back({next(), place.line, place.column});
  if (!mc5::encode(instruction, block_.words)) block_.words.push_back(0);  // reported already
  bracket(instruction, offset);
  if (!isNetworkEnd(instruction)) return;
  begin("");
  separated_ = true;
}

void CodeBuilder::bracket(const mc5::Instruction& instruction, std::size_t offset) {
  const Operation operation = instruction.operation;
  if (operation == Operation::AND_OPEN || operation == Operation::OR_OPEN)
    brackets_.push_back(offset);
  if (operation != Operation::CLOSE) return;
  if (brackets_.empty())
    problems_.add(ProblemCode::P1137, at(offset, 1));
  else
    brackets_.pop_back();
}

void CodeBuilder::closeBrackets() {
  for (const std::size_t offset : brackets_) problems_.add(ProblemCode::P1138, at(offset, 2));
  brackets_.clear();
}

void CodeBuilder::jump(const mc5::Instruction& instruction, const std::string& label,
                       std::size_t offset, std::size_t labelOffset) {
  beforeCode();
  jumps_.push_back({instruction, label, next(), network_, labelOffset});
  this->instruction(instruction, offset);
}

void CodeBuilder::label(const std::string& name, std::size_t offset) {
  constexpr std::size_t kCharacters = 4;
  beforeCode();
  if (name.size() > kCharacters)
    problems_.add(ProblemCode::P1119, at(offset, name.size()), name, name.size(), kCharacters, "");
  const bool isNew = labels_.try_emplace(name, Label{next(), network_}).second;
  if (!isNew) problems_.add(ProblemCode::P1116, at(offset, name.size()), name);
  block_.labels[next()] = name;
}

void CodeBuilder::begin(const std::string& title) {
  closeBrackets();
  if (!block_.words.empty()) ++network_;
  block_.networks.push_back({next(), title});
}

// BLD 255 stands between two networks (S5-MISC-04); where the source has it, it is the one.
void CodeBuilder::network(const std::string& title) {
  ends_ = false;
  if (separated_) {
    block_.networks.back().title = title;
    separated_ = false;
    return;
  }
  if (!block_.words.empty())
    (void)mc5::encode({Operation::BLD, {.kind = mc5::OperandKind::Count, .value = kNetworkEnd}},
                      block_.words);
  begin(title);
}

void CodeBuilder::endNetwork() { ends_ = !block_.words.empty() && !separated_; }

void CodeBuilder::beforeCode() {
  if (ends_) network("");
  separated_ = false;
}

void CodeBuilder::fillIn(const Jump& jump) {
  const auto found = labels_.find(jump.label);
  const Position place = at(jump.offset, jump.label.size());
  if (found == labels_.end()) return problems_.add(ProblemCode::P1115, place, jump.label);
  const Label& label = found->second;
  if (label.network != jump.network) return problems_.add(ProblemCode::P1118, place, jump.label);
  const std::int64_t distance = std::int64_t{label.word} - jump.word;
  if (distance > kFarthest || distance < -kFarthest)
    return problems_.add(ProblemCode::P1117, place, jump.label, distance);
  mc5::Instruction instruction = jump.instruction;
  instruction.operand.value = static_cast<std::uint32_t>(distance);
  std::vector<std::uint16_t> code;
  if (mc5::encode(instruction, code))
    std::copy(code.begin(), code.end(), block_.words.begin() + jump.word);
}

void CodeBuilder::finish() {
  closeBrackets();
  for (const Jump& jump : jumps_)
    if (!problems_.cancelled()) fillIn(jump);
}

}  // namespace merker::step5
