#include "station/mixed_engine.h"

#include <functional>

#include "icode/region.h"
#include "interpreter/compiled.h"
#include "interpreter/probing.h"
#include "lowering/translate.h"
#include "mc7/listing.h"
#include "station/translation_thread.h"

namespace merker::station {
namespace {

using interpreter::Op;
using interpreter::Translated;

class Native : public interpreter::Compiled {
 public:
  Native(std::unique_ptr<jit::NativeCode> code, std::vector<bool> entries, std::vector<Asked> asked)
      : code_(std::move(code)), entries_(std::move(entries)), asked_(std::move(asked)) {}
  bool begins(std::size_t instruction) const override { return entries_[instruction]; }
  const Op* run(cpu::Machine& m, std::size_t instruction) const override {
    return static_cast<const Op*>(code_->run(&m, instruction));
  }
  const void* const* entries() const override { return code_->entries(); }
  std::size_t size() const { return code_->size(); }
  const std::vector<Asked>& asked() const { return asked_; }

 private:
  std::unique_ptr<jit::NativeCode> code_;
  std::vector<bool> entries_;
  std::vector<Asked> asked_;
};

std::vector<bool> entriesOf(std::span<const icode::Region> regions, std::size_t instructions,
                            std::uint32_t shortest) {
  std::vector<bool> entries(instructions);
  for (const icode::Region& region : regions)
    entries[region.first] = region.instructions >= shortest;
  return entries;
}

// Instructions behind which somebody looks.
std::vector<bool> checked(const Translated& code) {
  std::vector<bool> result(code.side.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = code.side[i].checks != 0;
  return result;
}

}  // namespace

MixedEngine::MixedEngine(const CpuModel& model, bool compiles, CompilerOptions options)
    : model_(model),
      layout_(layoutOf(model)),
      interpreter_(model),
      compiles_(compiles && canCompile()),
      options_(std::move(options)) {}
MixedEngine::~MixedEngine() = default;

// Blocks with coverage count each instruction: they stay with the interpreter.
void MixedEngine::compile(Translated& code, BlockCopies& copies) const {
  if (!code.executed.empty()) return;
  const mc7::Listing listing = mc7::list(code.source->code);
  const jit::Instructions answers{code.ops.data(), sizeof(Op), code.parameters.data()};
  std::vector<icode::Region> regions;
  std::unique_ptr<jit::NativeCode> native;
  std::vector<Asked> asked;
  translate::Context context{.apart = checked(code),
                             .isOb = code.source->id.kind == BlockKind::OB,
                             .localBytes = code.localBytes,
                             .parameters = code.parameters.data(),
                             .find = [&](bool functionBlock, std::uint32_t number) {
                               return copies.callee(functionBlock, number, asked);
                             }};
  // Too many values at a time become fewer in shorter regions.
  for (std::uint32_t longest = translate::kLongestRegion; longest > 0 && native == nullptr;
       longest /= 4) {
    context.longest = longest;
    regions = translate::translate(listing, model_, context);
    if (regions.empty()) break;
    for (icode::Region& region : regions) icode::optimise(region);
    native = jit::compile(regions, listing.places.size(), answers, layout_, options_.jit);
  }
  if (native == nullptr) return setCompiled(code, nullptr);
  // Between checks regions are short; there agreement counts, not speed.
  const std::uint32_t shortest = code.side.empty() ? options_.shortestEntry : 1;
  auto entries = entriesOf(regions, code.instructionCount, shortest);
  setCompiled(code,
              std::make_shared<Native>(std::move(native), std::move(entries), std::move(asked)));
}

void MixedEngine::supply(std::shared_ptr<Translations> made) {
  if (!keepsOldCode()) supplied_ = std::move(made);  // coverage counts in the code itself
}

std::unique_ptr<cpu::Code> MixedEngine::translate(const block::Block& block) {
  if (supplied_ && supplied_->compiled() == compiles_)
    if (auto made = supplied_->take(block)) return made;
  auto made = interpreter_.translate(block);
  auto& code = static_cast<Translated&>(*made);
  code.identity = std::make_shared<const int>(0);
  linked_ = false;
  BlockCopies none([](bool, std::uint32_t) { return nullptr; });
  if (compiles_ && !callsBlocks(code)) compile(code, none);
  return made;
}

namespace {

FindCode blocksOf(const cpu::Machine& m) {
  return [&m](bool functionBlock, std::uint32_t number) {
    return static_cast<const Translated*>(
        cpu::find(functionBlock ? m.functionBlocks : m.functions, number));
  };
}

// Compiled, and with copies of the blocks as they are now.
bool isLinked(const Translated& code, const FindCode& find) {
  if (code.compiled == nullptr) return !callsBlocks(code);
  return isSame(static_cast<const Native&>(*code.compiled).asked(), find);
}

}  // namespace

void MixedEngine::link(Translated& code, BlockCopies& copies) const {
  if (compiles_ && !isLinked(code, copies.find())) compile(code, copies);
}

// Blocks that are not compiled yet all at once, as ever; of those that hold others as these were
// before a download, one after the other: until then they call them.
void MixedEngine::link(cpu::Cpu& cpu) {
  linked_ = true;
  BlockCopies copies(blocksOf(cpu.machine()));
  unsigned again = 1;
  for (const auto& one : cpu.loadMemory().code()) {
    auto& code = static_cast<Translated&>(*one);
    if (isLinked(code, copies.find())) continue;
    if (code.compiled != nullptr && again-- == 0) {
      linked_ = false;
      return;
    }
    compile(code, copies);
  }
}

namespace {

// Blocks that wait for those they called have parameters in the list.
void moveParameters(cpu::Machine& m, Translated& from, Translated& to) {
  const std::uint32_t* const first = from.parameters.data();
  const std::less_equal<> notBehind;
  for (cpu::Frame& frame : m.frames)
    if (frame.parameters != nullptr && notBehind(first, frame.parameters) &&
        notBehind(frame.parameters + 1, first + from.parameters.size()))
      frame.parameters = to.parameters.data() + (frame.parameters - first);
}

// Machine code knows where both lists are, so they come with it. Instructions have the same
// numbers: a block goes on where it stands.
void exchange(Translated& code, Translated& made, cpu::Machine& m) {
  cpu::Probe* const probe = code.probe;
  interpreter::setProbe(code, nullptr);
  moveParameters(m, code, made);
  code.ops.swap(made.ops);
  code.parameters.swap(made.parameters);
  code.uncompiled.swap(made.uncompiled);
  code.compiled.swap(made.compiled);
  code.identity.swap(made.identity);
  std::swap(code.native, made.native);
  std::swap(code.mark, made.mark);
  interpreter::setProbe(code, probe);
}

}  // namespace

void MixedEngine::exchange(const Translations& made, cpu::Cpu& cpu) {
  payback_.end();
  pays_ = false;
  compiles_ = made.compiled();
  for (const auto& one : cpu.loadMemory().code()) {
    auto& code = static_cast<Translated&>(*one);
    auto* const other = static_cast<Translated*>(made.find(*code.source));
    if (other != nullptr && code.side.empty())
      station::exchange(code, *other, cpu.machine());
    else if (!compiles_)
      setCompiled(code, nullptr);
  }
  compileTheRest(cpu);
}

// Those of the blocks that are there now.
void MixedEngine::compileTheRest(cpu::Cpu& cpu) {
  linked_ = !compiles_;
  if (!compiles_) return;
  BlockCopies copies(blocksOf(cpu.machine()));
  for (const auto& one : cpu.loadMemory().code()) {
    auto& code = static_cast<Translated&>(*one);
    if (code.compiled == nullptr) compile(code, copies);
  }
}

void MixedEngine::compile(bool on, cpu::Cpu& cpu) {
  payback_.end();
  pays_ = false;
  compiles_ = on && canCompile();
  for (const auto& code : cpu.loadMemory().code())
    if (!compiles_) setCompiled(static_cast<Translated&>(*code), nullptr);
  compileTheRest(cpu);
}

std::uint64_t MixedEngine::price(const cpu::Cpu& cpu) const {
  std::uint64_t sum = options_.begin;
  for (const auto& code : cpu.loadMemory().code())
    sum += options_.perBlock +
           options_.perInstruction * static_cast<const Translated&>(*code).instructionCount;
  return sum;
}

// A thread is worth while only for a program that keeps its own busy.
void MixedEngine::compileWhenItPays(const cpu::Cpu& cpu, bool elsewhere) {
  constexpr std::uint64_t kWorthAThread = 20'000'000;
  if (compiles_ || !canCompile()) return;
  elsewhere_ = elsewhere ? std::make_unique<TranslationThread>() : nullptr;
  compileAfter(price(cpu) + (elsewhere ? kWorthAThread : 0));
}

void MixedEngine::takeWhatPays(cpu::Cpu& cpu) {
  if (elsewhere_ == nullptr) return compile(true, cpu);
  if (!elsewhere_->begun()) elsewhere_->begin(model_, cpu.program());
  if (const auto made = elsewhere_->take()) exchange(*made, cpu);
}

// The program goes on where it stands: between two instructions.
void MixedEngine::run(cpu::Machine& m) {
  if (pays_) takeWhatPays(*m.cpu);
  if (!linked_ && compiles_) link(*m.cpu);
  if (!payback_.waits()) return interpreter_.run(m);
  const std::uint64_t before = m.instructions;
  interpreter_.run(m);
  pays_ = payback_.spend(m.instructions - before) && !keepsOldCode();
}

std::size_t MixedEngine::compiledBytes(const cpu::Cpu& cpu) {
  std::size_t bytes = 0;
  for (const auto& code : cpu.loadMemory().code())
    if (const auto& compiled = static_cast<const Translated&>(*code).compiled)
      bytes += static_cast<const Native&>(*compiled).size();
  return bytes;
}

}  // namespace merker::station
