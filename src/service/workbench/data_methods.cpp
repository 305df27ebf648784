// Data blocks variable by variable, as the data view of a programming device shows them, and the
// assignment list and the structure of the program (S7-EDIT-22).
#include "awl/data_text.h"
#include "cpu/cpu.h"
#include "monitor/assignment_list.h"
#include "monitor/data_rows.h"
#include "monitor/data_structures.h"
#include "monitor/display_format.h"
#include "workbench/elsewhere.h"
#include "workbench/program_rows.h"
#include "workbench/structure_rows.h"
#include "workbench/symbol_rows.h"

namespace merker::workbench {
namespace data_methods {
namespace {

using monitor::Feature;

// What the CPU has in a data block now; nothing if it has no such block.
using NowBytes = std::optional<std::vector<std::uint8_t>>;

NowBytes bytesNow(const Call& call, BlockId id) {
  const station::BlockCpu* cpu = call.plc().blockCpu();
  if (cpu == nullptr || id.kind != BlockKind::DB) return {};
  const cpu::DataBlock* found = cpu->cpu().machine().dataBlocks.find(id.number);
  return found == nullptr || !found->loaded ? NowBytes{} : found->data;
}

struct FormatName {
  std::string_view declared, shown;
};
// How the values of STEP 5 are shown that have another format than HEX.
constexpr FormatName kFormats[] = {{"KF", "DEC"}, {"KG", "KG"},   {"KT", "S5TIME"},
                                   {"KM", "BIN"}, {"KS", "CHAR"}, {"KZ", "COUNTER"}};

std::string_view formatOf(const monitor::DataValue& value) {
  if (!value.path.empty()) return "AUTO";
  const auto at = std::ranges::find(kFormats, value.type, &FormatName::declared);
  return at == std::end(kFormats) ? "HEX" : at->shown;
}

Json rowOf(BlockId id, monitor::DataValue value) {
  const bool word = value.path.empty();
  return {
      {"operand", fmt::format("DB{}.{}", id.number, word ? value.place : value.path)},
      {"format", formatOf(value)},
      {"address", word ? std::to_string(value.byte) : fmt::format("{}.{}", value.byte, value.bit)},
      {"path", word ? value.place : value.path},
      {"type", std::move(value.type)},
      {"section", std::move(value.section)},
      {"initial", std::move(value.initial)},
      {"actual", std::move(value.actual)},
      {"comment", std::move(value.comment)}};
}

// The word of the listing as its actual value is shown. Texts and numbers of several words are not
// shown as one.
std::string initialOf(const monitor::DataValue& value, const mc5::Block& block) {
  if (value.code.size() != 4) return {};  // digits of one word
  const auto format = monitor::parseFormat(formatOf(value));
  const address::Reference word{.text = value.place,
                                .operand = address::memory(Area::DataBlock, Width::Word, 0)};
  return format ? monitor::show(word, block.words[value.byte], *format) : std::string();
}

monitor::DataValues listedValues(const mc5::Block& block) {
  monitor::DataValues data = monitor::dataValues(block);
  for (monitor::DataValue& value : data.values) value.initial = initialOf(value, block);
  return data;
}

Json answerOf(const monitor::BlockCode& code, monitor::DataValues data,
              const ProjectFolder& folder) {
  Json rows = Json::array();
  for (monitor::DataValue& value : data.values) rows.push_back(rowOf(code.id(), std::move(value)));
  return {{"block", toString(code.id())},
          {"file", folder.relative(code.file())},
          {"assignments", ""},
          {"without", Json::array()},
          {"rows", std::move(rows)},
          {"more", data.more},
          {"structures", Json::array()}};
}

Json structuresOf(const block::Block& block, const source::SymbolTable& symbols) {
  Json list = Json::array();
  for (auto& [path, type] : monitor::dataStructures(block, symbols))
    list.push_back({{"path", std::move(path)}, {"type", std::move(type)}});
  return list;
}

// What BEGIN has to say so that the block begins with these values.
awl::Assignments assignmentsOf(const block::Block& block, std::span<const std::uint8_t> actual) {
  block::Block declared = block;
  declared.actualData = block.initialData;
  return awl::assignments(declared, actual, block.actualData);
}

Answer shown(const monitor::BlockCode& code, const NowBytes& now,
             const source::SymbolTable& symbols, const ProjectFolder& folder) {
  if (code.id().kind != BlockKind::DB)
    return refused(ProblemCode::P1308, toString(code.id()), "it is no data block");
  if (code.s7() == nullptr) return answerOf(code, listedValues(*code.s5()), folder);
  const block::Block& block = *code.s7();
  const bool same = now && now->size() == block.actualData.size();
  const std::span<const std::uint8_t> actual = same ? *now : block.actualData;
  Json answer = answerOf(code, monitor::dataValues(block, actual), folder);
  awl::Assignments begin = assignmentsOf(block, actual);
  answer["assignments"] = std::move(begin.text);
  answer["without"] = std::move(begin.without);
  answer["structures"] = structuresOf(block, symbols);
  if (block.instanceOf >= 0)
    answer["instanceOf"] =
        fmt::format("{} {}", block.instanceOfSystemBlock ? "SFB" : "FB", block.instanceOf);
  return answer;
}

struct Sides {
  OfflineRef offline;
  ProgramRef online;
  BuildRef build;

  const compilation::Build& of(bool cpu) const { return cpu ? *build : *offline->build; }
  monitor::ProgramCode code(bool cpu) const {
    if (of(cpu).isListing()) return of(cpu).listings;
    return cpu ? *online : *offline->build->program;
  }
};

// The values are copied in the thread of the PLC, the rows are made beside it.
Answer show(const Call& call) {
  const std::string name = call.fields.text("block");
  const bool cpu = call.fields.choice("side", {"offline", "online"}, 0) == 1;
  if (!call.fields.good()) return call.fields.problems();
  const Sides sides{call.shared.offlineRef(), call.plc().program(), call.plc().buildRef()};
  NowBytes now;
  if (cpu)
    if (const auto id =
            monitor::findBlock(name, {sides.code(true), sides.build->project.symbols, {}}))
      now = bytesNow(call, *id);
  return elsewhere(call, call.shared.clerk, [=](const Aside& aside) -> Answer {
    const monitor::ProgramCode program = sides.code(cpu);
    const source::SymbolTable& symbols = sides.of(cpu).project.symbols;
    const auto id = monitor::findBlock(name, {program, symbols, {}});
    if (!id) return one(id.error());
    return shown(*program.find(*id), now, symbols, aside.folder);
  });
}

Json bytesOf(const monitor::AssignmentList& list) {
  Json rows = Json::array();
  for (const monitor::AssignmentByte& byte : list.bytes) {
    unsigned bits = 0;
    for (unsigned i = 0; i < byte.bits.size(); ++i) bits |= byte.bits[i] ? 1u << i : 0u;
    constexpr std::string_view kAreas[] = {"E", "A", "M"};
    const auto area = byte.area == Area::Input ? 0u : byte.area == Area::Output ? 1u : 2u;
    rows.push_back({{"area", kAreas[area]},
                    {"byte", byte.byte},
                    {"bits", bits},
                    {"byByte", byte.byByte},
                    {"byWord", byte.byWord},
                    {"byDWord", byte.byDWord}});
  }
  return rows;
}

Answer assignments(const Call& call) {
  return elsewhere(
      call, call.shared.clerk, [offline = call.shared.offlineRef()](const Aside&) -> Answer {
        const compilation::Build& build = *offline->build;
        const auto list = monitor::crossReferences(build.code(), build.project.symbols,
                                                   {.library = build.library.get()});
        const monitor::AssignmentList assigned = monitor::assignmentList(list);
        Json unused = Json::array();
        for (const source::Symbol& one : monitor::unusedSymbols(list, build.project.symbols))
          unused.push_back(toJson(symbolRow(one, build.project.symbols.language())));
        return Json{{"bytes", bytesOf(assigned)},
                    {"timers", assigned.timers},
                    {"counters", assigned.counters},
                    {"unused", std::move(unused)},
                    {"withoutSymbol", monitor::operandsWithoutSymbol(list)}};
      });
}

Answer structure(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [offline = call.shared.offlineRef()](const Aside&) -> Answer {
                     return Json{{"blocks", structureRows(*offline->build)}};
                   });
}

constexpr Method kMethods[] = {
    {"program.data", Needs::able(Feature::Blocks), show, Kind::Compiled},
    {"program.assignments", Needs::able(Feature::References), assignments, Kind::Compiled},
    {"program.structure", Needs::able(Feature::References), structure, Kind::Compiled},
};

}  // namespace
}  // namespace data_methods

std::span<const Method> dataMethods() { return data_methods::kMethods; }

}  // namespace merker::workbench
