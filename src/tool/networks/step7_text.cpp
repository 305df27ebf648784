#include <algorithm>

#include "base/text.h"
#include "graph7/operand_spelling.h"
#include "graph7/rules.h"
#include "graph7/source_call.h"
#include "graph7/source_statements.h"
#include "graph7/statement_text.h"
#include "networks/text.h"
#include "step7/interfaces.h"
#include "step7/mnemonic.h"

namespace merker::networks {
namespace {

// Of an OB: what the operating system writes to its local data (S7-OBI-01), in bytes.
constexpr BitAddress kStartInformation = 20;

bool hasCode(BlockId id) { return id.kind != BlockKind::DB && id.kind != BlockKind::UDT; }

// What declarations and calls need of a block.
block::Block interfaceOf(const block::Block& block) {
  block::Block out;
  out.id = block.id;
  out.symbol = block.symbol;
  out.variables = block.variables;
  out.returnType = block.returnType;
  out.instanceBytes = block.instanceBytes;
  out.instanceOf = block.instanceOf;
  out.instanceOfSystemBlock = block.instanceOfSystemBlock;
  return out;
}

class Step7Text : public Text {
 public:
  Step7Text(const source::SourceFile& file, const Surroundings& around)
      : file_(file),
        sources_(step7::BlockSplitter(file, around.symbols, problems_).split()),
        mnemonics_(around.mnemonics ? *around.mnemonics
                                    : step7::detectMnemonics(file.text(), sources_)) {
    options_.model = findCpuModel("generic");
    options_.symbols = around.symbols;
    options_.library = blocksElsewhere(around);
    interfaces_ = std::make_unique<step7::Interfaces>(sources_, options_, problems_);
    for (std::size_t i = 0; i < sources_.size(); ++i)
      if (hasCode(sources_[i].id)) add(i);
  }

  const std::vector<Block>& blocks() const override { return blocks_; }

  std::vector<graph::SourceNetwork> networks(std::size_t block) override {
    const auto operands = operandsOf(block);
    if (!operands) return {};
    return graph7::sourceNetworks(sources_[of_[block]], *operands);
  }

  std::optional<graph::Operand> operand(std::size_t block, std::string_view text) override {
    const auto operands = operandsOf(block);
    return operands ? operands->of(graph7::spelled(trim(text), *operands)) : std::nullopt;
  }

  void fit(graph::Statement& statement) override {
    if (!isJump(statement.op) || statement.target >= 0) return;
    statement.operand.kind = graph::OperandKind::Label;
    statement.operand.number = 0;
    statement.operand.code = statement.operand.text;
  }

  std::vector<graph::Argument> parameters(std::size_t block, std::string_view called) override {
    const auto operands = operandsOf(block);
    return operands ? graph7::parametersOf(graph7::spelled(trim(called), *operands), *operands)
                    : std::vector<graph::Argument>();
  }

  // Behind what is declared and behind what other networks use without a picture.
  std::uint32_t firstWire(const Block& block, std::size_t index, std::size_t network) override {
    const auto operands = operandsOf(index);
    const bool start = sources_[of_[index]].id.kind == BlockKind::OB;
    BitAddress first = start ? kStartInformation * 8 : 0;
    if (operands) first = std::max(first, operands->wires());
    for (const Network& other : block.networks)
      for (const graph::Statement& statement : other.source.statements)
        if (other.number != network && !other.tree)
          first = std::max(first, graph7::behindLocal(statement.operand));
    return first;
  }

  Style style() const override { return {"      ", 6, ";"}; }

  WriteStatement writer(const Style& style) const override {
    const graph7::StatementStyle own{mnemonics_, style.operandAt, style.indent};
    return [own](const graph::Statement& statement, const std::string& label) {
      return graph7::statementText(statement, own, label);
    };
  }

  std::vector<std::string> heading(std::size_t, const Heading& heading) const override {
    std::vector<std::string> lines{"NETWORK", "TITLE = " + heading.title};
    for (const std::string& line : heading.comment) lines.push_back("//" + line);
    return lines;
  }

  std::string numbered(std::string_view line, std::size_t) const override {
    return std::string(line);
  }

 private:
  std::optional<graph7::SourceOperands> operandsOf(std::size_t block) {
    const block::Block* declared = interfaces_->find(sources_[of_[block]].id);
    if (declared == nullptr) return std::nullopt;
    return graph7::SourceOperands(file_, *declared, mnemonics_, *interfaces_, options_);
  }

  const block::Program* blocksElsewhere(const Surroundings& around) {
    if (around.program == nullptr || around.library == nullptr)
      return around.program != nullptr ? around.program : around.library;
    for (const block::Program* program : {around.program, around.library})
      for (const auto& [id, block] : *program) elsewhere_.try_emplace(id, interfaceOf(block));
    return &elsewhere_;
  }

  void add(std::size_t index) {
    const step7::BlockSource& source = sources_[index];
    const std::uint32_t line = file_.position(source.name.begin).line;
    if (!blocks_.empty()) blocks_.back().end = std::min(blocks_.back().end, line);
    Block& block = blocks_.emplace_back();
    block.name = toString(source.id);
    block.symbol = source.name.symbol;
    block.line = line;
    block.end = file_.position(source.codeEnd).line + 1;
    block.rules = &graph7::rules();
    block.mnemonics = mnemonics_;
    of_.push_back(index);
  }

  const source::SourceFile& file_;
  Problems problems_;  // nobody sees them: the compiler tells them
  std::vector<step7::BlockSource> sources_;
  Mnemonics mnemonics_;
  block::Program elsewhere_;
  step7::CompileOptions options_;
  std::unique_ptr<step7::Interfaces> interfaces_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> of_;  // which source is this block
};

}  // namespace

std::unique_ptr<Text> step7Text(const source::SourceFile& file, const Surroundings& around) {
  return std::make_unique<Step7Text>(file, around);
}

}  // namespace merker::networks
