#include "compilation/system_block_calls.h"

#include <algorithm>
#include <set>

#include "cpu/start_information.h"
#include "mc7/disassembly.h"
#include "mc7/instruction.h"

namespace merker::compilation {
namespace {

using mc7::Operation;

bool isSerial(std::uint32_t number) { return number >= 60 && number <= 65; }
bool isTechnology(std::uint32_t number) {
  return (number >= 44 && number <= 49) || isSerial(number);
}

// A call in a block; `db`: the instance, -1 of a multiple instance.
struct BlockCall {
  BlockId called;
  std::int32_t db = -1;
  Position place;
};

struct CallGraph {
  std::map<BlockId, std::vector<BlockId>> edges;
  std::map<BlockId, std::vector<BlockCall>> ofSystem;  // SFBs of technology, by their caller
};

bool isInstance(const block::Block& block) {
  return block.instanceOfSystemBlock && isTechnology(static_cast<std::uint32_t>(block.instanceOf));
}

bool hasInstance(const block::Block& block) {
  return std::ranges::any_of(block.variables, [](const block::Variable& variable) {
    return variable.type && variable.type->code == TypeCode::SystemFunctionBlock &&
           isTechnology(variable.type->length);
  });
}

Position placeIn(const block::Block& block, std::uint32_t offset) {
  const auto after = std::ranges::upper_bound(block.lines, offset, {}, &block::LineEntry::offset);
  if (after == block.lines.begin()) return {block.file};
  return {block.file, (after - 1)->line, (after - 1)->column};
}

bool callsBlock(const mc7::Instruction& one) {
  return (one.operation == Operation::UC || one.operation == Operation::CC) &&
         one.operand.kind == mc7::OperandKind::Block;
}

// AUF DI 10
bool opensInstance(const mc7::Instruction& one) {
  return one.operation == Operation::OPEN && one.operand.kind == mc7::OperandKind::Block &&
         one.operand.reg == 1;
}

// From BLD 9 of a call on the first AUF DI opens the instance, later ones belong to parameters
// (code patterns, section 3).
void addCalls(const block::Block& block, CallGraph& graph) {
  std::int32_t db = -1;
  bool first = false;
  for (const mc7::Line& line : mc7::disassemble(block.code, Mnemonics::German)) {
    const auto decoded = mc7::decode(line.bytes);
    if (!decoded || line.kind != mc7::LineKind::Instruction) continue;
    const mc7::Instruction& one = decoded->instruction;
    if (one.operation == Operation::BLD && (one.operand.value == 9 || one.operand.value == 16)) {
      first = one.operand.value == 9;
      db = -1;
    }
    if (opensInstance(one) && std::exchange(first, false))
      db = static_cast<std::int32_t>(one.operand.value);
    if (!callsBlock(one)) continue;
    const BlockId called{one.operand.blockKind, static_cast<std::uint16_t>(one.operand.value)};
    graph.edges[block.id].push_back(called);
    if (called.kind == BlockKind::SFB && isTechnology(called.number))
      graph.ofSystem[block.id].push_back({called, db, placeIn(block, line.offset)});
  }
}

CallGraph callGraph(const block::Program& program) {
  CallGraph graph;
  for (const auto& [id, block] : program)
    if (!block.code.empty()) addCalls(block, graph);
  return graph;
}

void noteSecondInstances(const CallGraph& graph, Problems& problems) {
  std::map<BlockId, std::int32_t> first;
  for (const auto& [caller, calls] : graph.ofSystem)
    for (const BlockCall& call : calls) {
      if (!isSerial(call.called.number) || call.db < 0) continue;
      const std::int32_t known = first.try_emplace(call.called, call.db).first->second;
      if (known != call.db)
        problems.add(ProblemCode::P0523, call.place, toString(call.called),
                     toString(BlockId{BlockKind::DB, static_cast<std::uint16_t>(known)}));
    }
}

std::set<BlockId> reached(const CallGraph& graph, BlockId from) {
  std::set<BlockId> known{from};
  std::vector<BlockId> open{from};
  while (!open.empty()) {
    const auto edges = graph.edges.find(open.back());
    open.pop_back();
    if (edges == graph.edges.end()) continue;
    for (const BlockId called : edges->second)
      if (known.insert(called).second) open.push_back(called);
  }
  return known;
}

// The calls of the SFBs below an OB.
void addBelow(const CallGraph& graph, BlockId ob, std::map<BlockId, BlockCall>& calls) {
  for (const BlockId block : reached(graph, ob))
    if (const auto found = graph.ofSystem.find(block); found != graph.ofSystem.end())
      for (const BlockCall& call : found->second) calls.try_emplace(call.called, call);
}

void notePriorityClasses(const CallGraph& graph, const block::Program& program,
                         Problems& problems) {
  std::map<BlockId, BlockId> first;  // by SFB: the OB that reaches it, of the lowest number
  for (const auto& [id, block] : program) {
    const int priority =
        id.kind == BlockKind::OB ? cpu::priorityOf(static_cast<std::uint8_t>(id.number)) : 0;
    if (priority == 0 || priority == cpu::priorityOf(100)) continue;
    std::map<BlockId, BlockCall> calls;
    addBelow(graph, id, calls);
    for (const auto& [sfb, call] : calls) {
      const BlockId known = first.try_emplace(sfb, id).first->second;
      if (cpu::priorityOf(static_cast<std::uint8_t>(known.number)) != priority)
        problems.add(ProblemCode::P0524, call.place, toString(sfb), toString(known), toString(id));
    }
  }
}

}  // namespace

void noteSystemBlockCalls(const block::Program& program, Problems& problems) {
  const bool any = std::ranges::any_of(program, [](const auto& entry) {
    return isInstance(entry.second) || hasInstance(entry.second);
  });
  if (!any) return;
  const CallGraph graph = callGraph(program);
  noteSecondInstances(graph, problems);
  notePriorityClasses(graph, program, problems);
}

}  // namespace merker::compilation
