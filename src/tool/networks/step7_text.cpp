#include "graph7/rules.h"
#include "graph7/source_statements.h"
#include "networks/text.h"
#include "step7/interfaces.h"
#include "step7/mnemonic.h"

namespace merker::networks {
namespace {

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
    const step7::BlockSource& source = sources_[of_[block]];
    const block::Block* declared = interfaces_->find(source.id);
    if (declared == nullptr) return {};
    const graph7::SourceOperands operands(file_, *declared, mnemonics_, *interfaces_, options_);
    return graph7::sourceNetworks(source, operands);
  }

 private:
  const block::Program* blocksElsewhere(const Surroundings& around) {
    if (around.program == nullptr || around.library == nullptr)
      return around.program != nullptr ? around.program : around.library;
    for (const block::Program* program : {around.program, around.library})
      for (const auto& [id, block] : *program) elsewhere_.try_emplace(id, interfaceOf(block));
    return &elsewhere_;
  }

  void add(std::size_t index) {
    const step7::BlockSource& source = sources_[index];
    Block& block = blocks_.emplace_back();
    block.name = toString(source.id);
    block.symbol = source.name.symbol;
    block.line = file_.position(source.name.begin).line;
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
