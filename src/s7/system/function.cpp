#include "system/function.h"

#include <algorithm>
#include <bit>
#include <charconv>

#include "system/call.h"

namespace merker::system {
namespace {

struct Row {
  BlockKind kind;
  std::uint16_t number;
  std::string_view name;
  bool (*run)(const Invocation&);
  std::string_view parameters;
  BlockLibrary library;
};

template <typename Which, void (*function)(Which&)>
bool answer(const Invocation& invocation) {
  Which call(invocation);
  function(call);
  return call.good();
}

// Of functions.inc and library.inc: all FCs are of a library.
constexpr BlockLibrary libraryOf(BlockKind kind) {
  return kind == BlockKind::FC ? BlockLibrary::Standard : BlockLibrary::Cpu;
}

constexpr Row kRows[] = {
#define FUNCTION(kind, number, name, function, requirement, parameters) \
  {BlockKind::kind,                                                     \
   number,                                                              \
   name,                                                                \
   answer<Call<BlockKind::kind, number>, function>,                     \
   parameters,                                                          \
   libraryOf(BlockKind::kind)},
#define CP_FUNCTION(kind, number, name, function, requirement, parameters) \
  {BlockKind::kind,                                                        \
   number,                                                                 \
   name,                                                                   \
   answer<Call<BlockKind::kind, kCpRow + number>, function>,               \
   parameters,                                                             \
   BlockLibrary::NetCp},
#define CODE(kind, number, code, text)
#define CODES(kind, number, group)
#define GROUP_CODE(group, code, text)
#include "system/cp_library.inc"
#include "system/functions.inc"
#include "system/library.inc"
#undef FUNCTION
#undef CP_FUNCTION
#undef CODE
#undef CODES
#undef GROUP_CODE
};

block::Section section(std::string_view word) {
  using enum block::Section;
  struct Word {
    std::string_view word;
    block::Section section;
  };
  constexpr Word kWords[] = {
      {"in", Input}, {"out", Output}, {"inout", InOut}, {"return", Return}, {"stat", Static}};
  const auto* found = std::find_if(std::begin(kWords), std::end(kWords),
                                   [&](const Word& w) { return w.word == word; });
  return found->section;
}

// "16#300", "20000" (a TIME in ms), "2.0" (a REAL); nothing: 0
std::uint32_t initialValue(std::string_view text) {
  if (text.find('.') != std::string_view::npos) {
    float real = 0;
    std::from_chars(text.data(), text.data() + text.size(), real);
    return std::bit_cast<std::uint32_t>(real);
  }
  constexpr std::string_view kHex = "16#";
  const bool hex = text.starts_with(kHex);
  if (hex) text.remove_prefix(kHex.size());
  std::uint32_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value, hex ? 16 : 10);
  return value;
}

// RETURN stands behind IN in the parameter list, and at the end of a row.
void numberEntries(std::vector<Parameter>& list) {
  const auto count = [&](block::Section section) {
    return std::count_if(list.begin(), list.end(),
                         [&](const Parameter& p) { return p.section == section; });
  };
  const auto inputs = static_cast<std::size_t>(count(block::Section::Input));
  const auto returns = static_cast<std::size_t>(count(block::Section::Return));
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i].entry = list[i].section == block::Section::Input    ? i
                    : list[i].section == block::Section::Return ? inputs
                                                                : i + returns;
}

std::vector<Parameter> parametersOf(std::string_view text) {
  std::vector<Parameter> list;
  while (!text.empty()) {
    std::string_view one = take(text, "; ");
    const block::Section where = section(take(one, " "));
    const std::string_view name = take(one, " ");
    const std::string_view type = take(one, " := ");
    list.push_back({name, where, typeFromName(type).value_or(TypeCode::Void), initialValue(one)});
  }
  numberEntries(list);
  return list;
}

bool lacks(const CpuModel& model, const Row& row) {
  if (row.library != BlockLibrary::Cpu) return false;
  const auto& list = row.kind == BlockKind::SFC ? model.lacksSfcs : model.lacksSfbs;
  return std::find(list.begin(), list.end(), row.number) != list.end();
}

void addRows(const CpuModel& model, BlockLibrary library, std::vector<Function>& all) {
  const auto known = [&](const Row& row) {
    return std::ranges::any_of(all, [&](const Function& other) {
      return other.kind == row.kind && other.number == row.number;
    });
  };
  for (const Row& row : kRows)
    if (row.library == library && !lacks(model, row) && !known(row))
      all.push_back(
          {row.kind, row.number, row.name, parametersOf(row.parameters), row.run, row.library});
}

}  // namespace

std::vector<Function> allFunctions(const CpuModel& model, const Libraries& libraries) {
  std::vector<Function> all;
  addRows(model, BlockLibrary::Cpu, all);
  for (const BlockLibrary library : libraries) addRows(model, library, all);
  return all;
}

}  // namespace merker::system
