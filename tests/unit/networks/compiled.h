// The networks of a program as its machine code has them, and statements in a form in which those
// of machine code and of text can be compared.
#pragma once

#include <fmt/format.h>

#include <map>

#include "compilation/build.h"
#include "graph5/network_code.h"
#include "graph5/rules.h"
#include "graph7/network_code.h"
#include "graph7/rules.h"

namespace merker::networks {

// Operands are named in the order in which they appear; what the two ways keep in `code` differs.
class Outline {
 public:
  std::string of(const graph::Statements& statements) {
    std::string out;
    for (const graph::Statement& statement : statements) {
      out += fmt::format("{}{} {}", statement.intruded ? "!" : "", graph::name(statement.op),
                         operand(statement));
      if (statement.target >= 0) out += fmt::format(" -> {}", statement.target);
      out += "\n";
    }
    return out;
  }

 private:
  std::string operand(const graph::Statement& statement) {
    const graph::Operand& operand = statement.operand;
    if (statement.op == graph::Op::OTHER || statement.op == graph::Op::CALL) return {};
    if (operand.kind == graph::OperandKind::None) return {};
    if (operand.kind == graph::OperandKind::Forbidden) return "?";
    if (operand.kind == graph::OperandKind::Label) return "label";
    const bool byNumber = operand.kind == graph::OperandKind::Wire ||
                          operand.kind == graph::OperandKind::Status ||
                          operand.kind == graph::OperandKind::Count;
    const std::string key =
        fmt::format("{} {} ", static_cast<int>(operand.kind), byNumber ? operand.number : 0) +
        operand.code;
    return fmt::format("{}.{}", static_cast<int>(operand.kind),
                       names_.try_emplace(key, names_.size()).first->second);
  }
  std::map<std::string, std::size_t> names_;
};

struct Compiled {
  graph::Statements statements;
  const graph::Rules* rules = nullptr;
};

inline std::vector<Compiled> compiledNetworks(const compilation::Build& build,
                                              const std::string& name) {
  std::vector<Compiled> out;
  const awl::Blocks blocks = [&build](BlockId id) -> const block::Block* {
    for (const auto* program : {build.program.get(), build.library.get()})
      if (program != nullptr)
        if (const auto at = program->find(id); at != program->end()) return &at->second;
    return nullptr;
  };
  if (build.program != nullptr)
    for (const auto& [id, block] : *build.program)
      if (toString(id) == name)
        for (graph7::NetworkCode& code :
             graph7::networks(block, awl::Names(block), blocks, Mnemonics::German))
          out.push_back({std::move(code.statements), &graph7::rules()});
  for (const auto& [id, block] : build.listings)
    if (mc5::toString(id) == name)
      for (graph5::NetworkCode& code : graph5::networks(block))
        out.push_back({std::move(code.statements), &graph5::rules()});
  return out;
}

}  // namespace merker::networks
