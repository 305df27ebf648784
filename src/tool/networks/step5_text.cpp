#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "graph5/rules.h"
#include "graph5/source_statements.h"
#include "graph5/statement_text.h"
#include "networks/text.h"

namespace merker::networks {
namespace {

class Step5Text : public Text {
 public:
  Step5Text(const source::SourceFile& file, const Surroundings& around)
      : file_(file), symbols_(around.symbols), sources_(step5::findBlocks(file, problems_)) {
    for (std::size_t i = 0; i < sources_.size(); ++i)
      if (sources_[i].id.type != mc5::BlockType::Db) add(i);
  }

  const std::vector<Block>& blocks() const override { return blocks_; }

  std::vector<graph::SourceNetwork> networks(std::size_t block) override {
    return graph5::sourceNetworks(sources_[of_[block]], symbols_);
  }

  std::optional<graph::Operand> operand(std::size_t, std::string_view text) override {
    return graph5::sourceOperand(trim(text), symbols_);
  }

  void fit(graph::Statement& statement) override {
    const bool calls = statement.op == graph::Op::UC || statement.op == graph::Op::CC;
    if (!calls) return;
    if (auto block = graph5::sourceBlock(statement.operand.text, symbols_))
      statement.operand = std::move(*block);
  }

  std::vector<graph::Argument> parameters(std::size_t, std::string_view) override { return {}; }

  std::uint32_t firstWire(const Block&, std::size_t, std::size_t) override { return 0; }

  Style style() const override { return {" : ", 5, ""}; }

  WriteStatement writer(const Style& style) const override {
    return [column = style.operandAt](const graph::Statement& statement, const std::string&) {
      return graph5::statementText(statement, column);
    };
  }

  std::vector<std::string> heading(std::size_t network, const Heading& heading) const override {
    std::vector<std::string> lines{fmt::format("NETZWERK {}", network)};
    if (!heading.title.empty()) lines[0] += "  " + heading.title;
    for (const std::string& line : heading.comment) lines.push_back("!" + line);
    return lines;
  }

  std::string numbered(std::string_view line, std::size_t network) const override {
    const std::size_t word = line.find_first_not_of(" \t");
    const std::size_t behind = std::min(line.find_first_of(" \t", word), line.size());
    const std::size_t number = std::min(line.find_first_not_of(" \t", behind), line.size());
    const std::size_t end = std::min(line.find_first_not_of("0123456789", number), line.size());
    if (end == number) return std::string(line);
    return fmt::format("{}{}{}", line.substr(0, number), network, line.substr(end));
  }

 private:
  void add(std::size_t index) {
    const step5::BlockSource& source = sources_[index];
    Block& block = blocks_.emplace_back();
    block.name = mc5::toString(source.id);
    block.symbol = source.name;
    block.line = file_.position(source.offset).line;
    block.end = index + 1 < sources_.size() ? file_.position(sources_[index + 1].offset).line
                                            : file_.lineCount() + 1;
    block.rules = &graph5::rules();
    of_.push_back(index);
  }

  const source::SourceFile& file_;
  const source::SymbolTable* symbols_;
  Problems problems_;  // nobody sees them: the compiler tells them
  std::vector<step5::BlockSource> sources_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> of_;  // which source is this block
};

}  // namespace

std::unique_ptr<Text> step5Text(const source::SourceFile& file, const Surroundings& around) {
  return std::make_unique<Step5Text>(file, around);
}

}  // namespace merker::networks
