#include "diagram/diagram.h"

#include <fmt/format.h>

#include "diagram/written_blocks.h"
#include "graph/fup.h"
#include "graph/kop.h"
#include "graph/read.h"
#include "graph5/network_code.h"
#include "graph5/rules.h"
#include "graph7/network_code.h"
#include "graph7/rules.h"
#include "mc5/block_id.h"
#include "mc5/disassembly.h"
#include "mc7/disassembly.h"
#include "networks/operand_names.h"

namespace merker::diagram {
namespace {

graph::Style styleOf(Mnemonics mnemonics) {
  constexpr int kPage = 100;  // columns
  return {graph7::namesIn(mnemonics), kPage};
}

// The mnemonic of a statement is that of its last instruction: before it stands the way to its
// operand. A CALL shows what it calls.
std::string statementText(const block::Block& block, const graph::Statement& statement,
                          std::uint32_t end, Mnemonics mnemonics) {
  if (statement.op == graph::Op::CALL) return "CALL  " + statement.operand.text;
  const auto code = std::span(block.code).subspan(statement.offset, end - statement.offset);
  const auto lines = mc7::disassemble(code, mnemonics);
  std::string mnemonic;
  for (const mc7::Line& line : lines)
    if (line.kind != mc7::LineKind::Parameter) mnemonic = line.text;
  if (lines.size() == 1 && statement.operand.text.empty()) return mnemonic;
  return fmt::format("{:<5} {}", mnemonic.substr(0, mnemonic.find(' ')), statement.operand.text);
}

NetworkDiagram read(const graph::Statements& statements, const graph::Rules& rules) {
  NetworkDiagram out;
  out.rules = &rules;
  auto network = graph::read(statements, rules);
  if (network)
    out.network = std::move(*network);
  else
    out.refusal = network.error();
  return out;
}

NetworkDiagram diagramOf(const block::Block& block, const graph7::NetworkCode& code,
                         Mnemonics mnemonics) {
  NetworkDiagram out = read(code.statements, graph7::rules());
  out.label = code.label;
  out.mnemonics = mnemonics;
  for (std::size_t i = 0; i < code.statements.size(); ++i) {
    const bool last = i + 1 == code.statements.size();
    const std::string text = statementText(
        block, code.statements[i], last ? code.end : code.statements[i + 1].offset, mnemonics);
    out.statements.push_back(code.labels[i].empty() ? text
                                                    : fmt::format("{}: {}", code.labels[i], text));
  }
  return out;
}

networks::OperandNames namesOf(const compilation::Build& build, const Options& options) {
  using networks::OperandForm;
  return {options.symbols ? OperandForm::Symbolic : OperandForm::Written, &build.project.symbols};
}

BlockDiagram diagramOf(const compilation::Build& build, const block::Block& block,
                       Mnemonics mnemonics, const networks::OperandNames& symbols) {
  const awl::Blocks blocks = [&build](BlockId id) -> const block::Block* {
    for (const auto* program : {build.program.get(), build.library.get()})
      if (program != nullptr)
        if (const auto at = program->find(id); at != program->end()) return &at->second;
    return nullptr;
  };
  const awl::Names names(block);
  BlockDiagram out{toString(block.id), block.symbol, {}};
  for (graph7::NetworkCode& code : graph7::networks(block, names, blocks, mnemonics)) {
    networks::rename(code.statements, symbols);
    NetworkDiagram& network = out.networks.emplace_back(diagramOf(block, code, mnemonics));
    network.number = out.networks.size();
    if (network.number <= block.networks.size())
      network.title = block.networks[network.number - 1].title;
  }
  return out;
}

NetworkDiagram diagramOf(const mc5::Block& block, const graph5::NetworkCode& code) {
  NetworkDiagram out = read(code.statements, graph5::rules());
  for (std::size_t i = 0; i < code.statements.size(); ++i) {
    const bool last = i + 1 == code.statements.size();
    const std::uint32_t at = code.statements[i].offset,
                        end = last ? code.end : code.statements[i + 1].offset;
    const auto lines = mc5::disassemble(std::span(block.words).subspan(at, end - at));
    out.statements.push_back(lines.empty() ? std::string() : lines.front().text);
  }
  return out;
}

BlockDiagram diagramOf(const mc5::Block& block, const networks::OperandNames& symbols) {
  BlockDiagram out{mc5::toString(block.id), block.name, {}};
  for (graph5::NetworkCode& code : graph5::networks(block)) {
    networks::rename(code.statements, symbols);
    NetworkDiagram& network = out.networks.emplace_back(diagramOf(block, code));
    network.number = out.networks.size();
    if (network.number <= block.networks.size())
      network.title = block.networks[network.number - 1].title;
  }
  return out;
}

std::string withSingleBlanks(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' || (!out.empty() && out.back() != ' ')) out += c;
  return out;
}

// How the network is drawn if `wanted` is asked for: what KOP cannot draw is FUP.
View shownAs(const NetworkDiagram& network, View wanted) {
  if (!network.network) return View::Awl;
  return wanted == View::Kop && !graph::fitsKop(*network.network, *network.rules) ? View::Fup
                                                                                  : wanted;
}

// Of a network that has a picture.
graph::Picture draw(const NetworkDiagram& network, View view) {
  const graph::Style style = styleOf(network.mnemonics);
  return view == View::Kop ? graph::kop(*network.network, style)
                           : graph::fup(*network.network, style);
}

Shown asAwl(const NetworkDiagram& network, graph::Refusal refusal) {
  const std::size_t at = refusal.statement;
  const std::string_view text = at < network.statements.size()
                                    ? std::string_view(network.statements[at])
                                    : std::string_view();
  return {View::Awl, network.statements,
          fmt::format("statement {} ({}): {}", at + 1, withSingleBlanks(text),
                      graph::text(refusal.reason))};
}

void write(graph::Picture& picture, const std::string& text) {
  picture.add({graph::ShapeKind::Text, 0, picture.h, graph::columns(text), 0, text, 0});
  picture.h += 2;
}

}  // namespace

std::vector<BlockDiagram> diagrams(const compilation::Build& build, const Options& options) {
  const networks::OperandNames names = namesOf(build, options);
  std::vector<BlockDiagram> out;
  auto written = writtenBlocks(build);
  const auto in = [&](const std::string& block) {
    const auto own = written.mnemonics.find(block);
    return options.mnemonics.value_or(own == written.mnemonics.end() ? Mnemonics::German
                                                                     : own->second);
  };
  const auto add = [&](BlockDiagram block) {
    const auto at = written.faulty.find(block.name);
    out.push_back(at == written.faulty.end() ? std::move(block) : std::move(at->second));
    if (at != written.faulty.end()) written.faulty.erase(at);
  };
  if (build.program != nullptr)
    for (const auto& [id, block] : *build.program)
      if (!block.code.empty()) add(diagramOf(build, block, in(toString(id)), names));
  for (const auto& [id, block] : build.listings)
    if (id.type != mc5::BlockType::Db) add(diagramOf(block, names));
  for (auto& [name, block] : written.faulty) out.push_back(std::move(block));
  return out;
}

Shown asText(const NetworkDiagram& network, View wanted) {
  const View view = shownAs(network, wanted);
  if (view == View::Awl) return asAwl(network, network.refusal);
  auto lines = graph::toText(draw(network, view));
  if (!lines) return asAwl(network, {0, lines.error()});
  return {view, std::move(*lines), {}};
}

graph::Picture drawAll(const std::vector<BlockDiagram>& blocks, View view) {
  graph::Picture out;
  for (const BlockDiagram& block : blocks) {
    write(out,
          block.symbol.empty() ? block.name : fmt::format("{} \"{}\"", block.name, block.symbol));
    for (const NetworkDiagram& network : block.networks) {
      write(out, fmt::format("Network {}: {}", network.number, network.title));
      const View shown = shownAs(network, view);
      if (shown == View::Awl) {
        for (const std::string& statement : network.statements) {
          write(out, statement);
          --out.h;
        }
      } else {
        out.place(draw(network, shown), 0, out.h);
      }
      ++out.h;
    }
  }
  return out;
}

}  // namespace merker::diagram
