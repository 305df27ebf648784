#include "nc/function_macros.h"

#include "nc/actual_value_macros.h"
#include "nc/data_block_macros.h"

namespace merker::nc {
namespace {

using sinumerik::Alarm;
using sinumerik::Machine;
using sinumerik::Trap;
using Self = FunctionMacros;

std::optional<Trap> answer(Machine& m, std::uint16_t macro, const Error& error) {
  return error ? std::optional(macroTrap(m, macro, *error)) : std::nullopt;
}

}  // namespace

struct FunctionMacros::Row {
  std::uint16_t number;
  std::size_t words;  // of its parameter list
  bool actualValues;  // reads values that not every control has
  std::optional<Trap> (*call)(Self&, Machine&, Parameters);
};

// clang-format off
std::span<const FunctionMacros::Row> FunctionMacros::rows() {
  static constexpr Row kRows[] = {
      {11, 2, false, [](Self&, Machine& m, Parameters p) { return answer(m, 11, createDataBlocks(m, p)); }},
      {56, 0, true, [](Self& f, Machine& m, Parameters) { return answer(m, 56, readFeed(m, f.control_)); }},
      {57, 0, true, [](Self& f, Machine& m, Parameters) { return answer(m, 57, readFollowingError(m, f.control_)); }},
      {58, 0, true, [](Self& f, Machine& m, Parameters) { return answer(m, 58, readSpindleSpeed(m, f.control_)); }},
      {60, 3, false, [](Self&, Machine& m, Parameters p) { return answer(m, 60, transferBlock(m, p)); }},
      {61, 11, false, [](Self& f, Machine& m, Parameters p) { return f.exchange_.call(false, m, p); }},
      {62, 11, false, [](Self& f, Machine& m, Parameters p) { return f.exchange_.call(true, m, p); }},
      {65, 0, false, [](Self& f, Machine& m, Parameters) { return answer(m, 65, f.stack_.push(m)); }},
      {66, 0, false, [](Self& f, Machine& m, Parameters) { return answer(m, 66, f.stack_.pop(m)); }},
      {190, 4, false, [](Self& f, Machine& m, Parameters p) { return f.coupling_.transfer(m, p); }}};
  return kRows;
}
// clang-format on

FunctionMacros::FunctionMacros(const MacroOptions& options)
    : options_(options), stack_(options.flagStackDepth), exchange_(options.exchange) {}

void FunctionMacros::couple(std::shared_ptr<CouplingArea> area, Side side,
                            std::function<void()> meet) {
  coupling_.connect(std::move(area), side, std::move(meet));
}

const FunctionMacros::Row* FunctionMacros::find(std::uint16_t number) const {
  for (const Row& row : rows())
    if (row.number == number && (options_.actualValueMacros || !row.actualValues)) return &row;
  return nullptr;
}

bool FunctionMacros::has(std::uint16_t number) const { return find(number) != nullptr; }

// A call without the list of its parameters is no call of this macro.
std::optional<Trap> FunctionMacros::call(std::uint16_t number, Machine& m, Parameters parameters) {
  const Row* row = find(number);
  if (row == nullptr) return Trap{Alarm::MissingBlock, {}};
  if (parameters.size() < row->words) return Trap{Alarm::Substitution, {}};
  return row->call(*this, m, parameters);
}

void FunctionMacros::restart(Machine& m) {
  stack_.clear();
  exchange_.restart(m);
  coupling_.started();
}

void FunctionMacros::stops() {
  exchange_.clear();
  coupling_.stopped();
}

std::optional<Trap> FunctionMacros::advance(Machine& m, Instant now) {
  return exchange_.advance(m, control_, now);
}

}  // namespace merker::nc
