// Both engines behind one station, changed while it works.
#include <gtest/gtest.h>

#include <thread>

#include "cpu/cpu.h"
#include "program.h"
#include "station/mixed_engine.h"
#include "station/translation_thread.h"
#include "station/translations.h"

namespace merker::station::test {
namespace {

constexpr std::string_view kProgram = R"(
      L     MW 10
      L     1
      +I
      T     MW 10
      UN    M 20.0
      =     M 20.0
)";

TEST(Engine, ChangesWhileTheProgramRuns) {
  Plc changing(kProgram), reference(kProgram);
  changing.cycles(3);
  reference.cycles(9);
  if (!changing->setEngine(Engine::Compiled)) GTEST_SKIP() << "no compiler for this processor";
  EXPECT_EQ(changing->engine(), Engine::Compiled);
  EXPECT_GT(changing->compiledBytes(), 0u);
  changing->advanceCycles(3);
  EXPECT_TRUE(changing->setEngine(Engine::Interpreter));
  EXPECT_EQ(changing->compiledBytes(), 0u);
  changing->advanceCycles(3);
  EXPECT_EQ(changing.read("MW 10"), 9u);
  EXPECT_EQ(changing->now(), reference->now());
  EXPECT_EQ(changing->instructions(), reference->instructions());
}

// What blocks have in common is written once: many small ones stay small.
TEST(Engine, SmallBlocksHaveLittleMachineCode) {
  std::string text;
  for (int i = 1; i <= 50; ++i)
    text +=
        "FUNCTION FC " + std::to_string(i) +
        " : VOID\nBEGIN\nNETWORK\n U E 0.0; U E 0.1; O M 1.0; = A 4.0; = M 1.0;\nEND_FUNCTION\n";
  Plc plc(text + ob(1, "NOP 0;"));
  if (!plc->setEngine(Engine::Compiled)) GTEST_SKIP() << "no compiler for this processor";
  EXPECT_GT(plc->compiledBytes(), 0u);
  EXPECT_LT(plc->compiledBytes(), 51 * 350u);
}

// OB 1 waits for FC 1 most of the time, which has its parameters in the code of OB 1.
constexpr std::string_view kNested = R"(
FUNCTION FC 1 : VOID
VAR_INPUT a : INT; END_VAR
VAR_IN_OUT b : INT; END_VAR
VAR_TEMP n : INT; END_VAR
BEGIN
NETWORK
      L     1000;
more: T     #n;
      L     #b;
      L     #a;
      +I    ;
      T     #b;
      L     #n;
      LOOP  more;
END_FUNCTION
FUNCTION FC 2 : VOID
BEGIN
NETWORK
      L     MW 14;
      +     1;
      T     MW 14;
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  FC 1 (a := MW 10, b := MW 12);
      CALL  FC 2;
END_ORGANIZATION_BLOCK
)";

Translations translationsOf(Station& station, Engine engine) {
  return {station.model(), engine, station.cpu().program(), nullptr};
}

TEST(Engine, IsExchangedInTheMiddleOfBlocksThatCall) {
  const CpuModel& model = *findCpuModel("generic");
  Plc changing(kNested, model), reference(kNested, model);
  for (Plc* plc : {&changing, &reference}) plc->write("MW 10", 3), plc->start();
  for (int i = 0; i < 20; ++i) {
    for (Plc* plc : {&changing, &reference}) {
      (*plc)->advanceTo((*plc)->now() + Duration{777'777});
      (*plc)->stop();
      EXPECT_EQ((*plc)->cpu().machine().frames.empty(), false);
    }
    const Engine engine = i % 2 == 0 ? Engine::Compiled : Engine::Interpreter;
    // What was there before is freed: nothing may point to it.
    if (!changing->setEngine(engine, translationsOf(*changing, engine))) GTEST_SKIP();
    EXPECT_EQ(changing->engine(), engine);
    EXPECT_EQ(changing->compiledBytes() > 0, engine == Engine::Compiled);
    for (Plc* plc : {&changing, &reference}) EXPECT_TRUE((*plc)->hotRestart());
  }
  for (Plc* plc : {&changing, &reference}) (*plc)->advanceCycles(5);
  for (const char* operand : {"MW 12", "MW 14"})
    EXPECT_EQ(changing.read(operand), reference.read(operand)) << operand;
  EXPECT_GT(changing.read("MW 14"), 5u);
  EXPECT_EQ(changing->now(), reference->now());
  EXPECT_EQ(changing->instructions(), reference->instructions());
}

TEST(Engine, TakesBlocksThatWereTranslatedBefore) {
  const CpuModel& model = defaultCpuModel();
  std::string text(kNested);
  text.replace(text.find("+     1;"), 8, "+     7;");
  const auto program = compileAwl(text, model);
  const block::Block &changed = program->at({BlockKind::FC, 2}),
                     &unchanged = program->at({BlockKind::FC, 1});
  for (const Engine engine : {Engine::Interpreter, Engine::Compiled}) {
    Plc plc(kNested, model);
    plc.cycles(3);
    if (!plc->setEngine(engine)) continue;
    const auto made = std::make_shared<Translations>(model, engine, program, &plc->program());
    EXPECT_NE(made->find(changed), nullptr);
    EXPECT_EQ(made->find(unchanged), nullptr);
    plc->supply(made);
    EXPECT_EQ(plc->download(program), "");
    plc->advanceCycles(2);
    EXPECT_EQ(made->find(changed), nullptr) << "the CPU has it";
    EXPECT_EQ(plc.read("MW 14"), 3u + 14u);
  }
}

TEST(Engine, LeavesBlocksOfAnotherEngine) {
  const CpuModel& model = defaultCpuModel();
  Plc plc(kProgram);
  if (!plc->setEngine(Engine::Compiled)) GTEST_SKIP() << "no compiler for this processor";
  const auto program = compileAwl(kNested, model);
  const auto made = std::make_shared<Translations>(model, Engine::Interpreter, program, nullptr);
  EXPECT_FALSE(plc->setEngine(Engine::Compiled, *made));
  plc->supply(made);
  EXPECT_EQ(plc->download(program), "");
  plc.cycles(2);
  EXPECT_NE(made->find(program->at({BlockKind::FC, 1})), nullptr);
  EXPECT_GT(plc->compiledBytes(), 0u);
}

TEST(Engine, TranslatesNothingForWhomNobodyWaits) {
  std::stop_source stop;
  stop.request_stop();
  const CpuModel& model = defaultCpuModel();
  const auto program = compileAwl(kNested, model);
  const Translations made(model, Engine::Compiled, program, nullptr, stop.get_token());
  EXPECT_EQ(made.find(program->at({BlockKind::FC, 1})), nullptr);
}

// A program of a few instructions pays after some thousand cycles, and nobody can tell when.
TEST(Engine, CompilesWhenItPays) {
  if (!MixedEngine::canCompile()) GTEST_SKIP() << "no compiler for this processor";
  Plc waiting(kProgram), reference(kProgram);
  waiting->compileWhenItPays(false);
  waiting.cycles(100);
  EXPECT_EQ(waiting->engine(), Engine::Interpreter);
  waiting->advanceCycles(9'900);
  EXPECT_EQ(waiting->engine(), Engine::Compiled);
  EXPECT_GT(waiting->compiledBytes(), 0u);
  reference.cycles(10'000);
  EXPECT_EQ(waiting.read("MW 10"), reference.read("MW 10"));
  EXPECT_EQ(waiting->now(), reference->now());
  EXPECT_EQ(waiting->instructions(), reference->instructions());
}

TEST(Engine, IsNotCompiledAgainstAWish) {
  Plc plc(kProgram);
  plc->compileWhenItPays(false);
  plc->setEngine(Engine::Interpreter);
  plc.cycles(10'000);
  EXPECT_EQ(plc->engine(), Engine::Interpreter);
}

// In real time the thread of the PLC takes what another one has made.
TEST(Engine, ThreadMakesTranslations) {
  const CpuModel& model = defaultCpuModel();
  const auto program = compileAwl(kNested, model);
  TranslationThread thread;
  EXPECT_FALSE(thread.begun());
  EXPECT_EQ(thread.take(), nullptr);
  thread.begin(model, program);
  std::unique_ptr<Translations> made;
  while ((made = thread.take()) == nullptr) std::this_thread::yield();
  EXPECT_EQ(made->compiled(), MixedEngine::canCompile());
  EXPECT_NE(made->find(program->at({BlockKind::FC, 1})), nullptr);
}

}  // namespace
}  // namespace merker::station::test
