// Compiled code of blocks that have those they call in themselves (lowering/callees.h): nobody can
// tell, whatever becomes of these.
#include <gtest/gtest.h>

#include "cpu/cpu.h"
#include "cpu/probe.h"
#include "program.h"
#include "station/mixed_engine.h"
#include "station/translations.h"

namespace merker::station::test {
namespace {

// FC 102 adds `step` to MW 20, by way of FC 101.
std::string adding(const std::string& step, const std::string& more = "") {
  return "FUNCTION FC 101 : VOID\nVAR_INPUT a : INT; END_VAR\nVAR_IN_OUT b : INT; END_VAR\n"
         "BEGIN\nNETWORK\n L #b; L #a; +I; T #b;" +
         more +
         "\nEND_FUNCTION\nFUNCTION FC 102 : VOID\nVAR_TEMP n : INT; END_VAR\nBEGIN\nNETWORK\n L " +
         step + "; T #n; CALL FC 101 (a := #n, b := MW 20);\nEND_FUNCTION\n" +
         ob(1, "CALL FC 102; CALL FC 102;");
}

class Copies : public testing::Test {
 protected:
  void SetUp() override {
    if (!MixedEngine::canCompile()) GTEST_SKIP() << "no compiler for this processor";
  }
  // Both do the same.
  template <typename Do>
  void both(Do act) {
    act(compiled_), act(reference_);
  }
  void begin() {
    ASSERT_TRUE(compiled_->setEngine(Engine::Compiled));
    both([](Plc& plc) { plc.cycles(3); });
  }
  void expectSame() {
    EXPECT_EQ(compiled_.read("MW 20"), reference_.read("MW 20"));
    EXPECT_EQ(compiled_->now(), reference_->now());
    EXPECT_EQ(compiled_->instructions(), reference_->instructions());
    EXPECT_EQ(compiled_->mode(), reference_->mode());
  }
  void download(const std::string& text) {
    both([&](Plc& plc) {
      EXPECT_EQ(plc->download(compileAwl(text, defaultCpuModel())), "");
      plc->advanceCycles(3);
    });
  }
  Plc compiled_{adding("1")}, reference_{adding("1")};
};

// The inner block is new, then the one between, then one is gone.
TEST_F(Copies, FollowDownloads) {
  begin();
  EXPECT_EQ(compiled_.read("MW 20"), 6u);
  download(adding("1", "+ 10; T #b;"));
  EXPECT_EQ(compiled_.read("MW 20"), 6u + 3 * 22);
  download(adding("3", "+ 10; T #b;"));
  expectSame();
  block::Program blocks = *compileAwl(adding("3"), defaultCpuModel());
  blocks.erase({BlockKind::FC, 101});
  both([&](Plc& plc) {
    EXPECT_EQ(plc->download(std::make_shared<const block::Program>(blocks)), "");
    plc->advanceCycles(2);
  });
  EXPECT_EQ(compiled_->mode(), Mode::Stop);  // 16#253C: FC missing, no OB 121
  expectSame();
}

// A block that is new is copied again: its callers do not stay with the interpreter.
TEST_F(Copies, AreMadeAgainAfterADownload) {
  begin();
  download(adding("1", "+ 10; T #b;"));
  const std::size_t after = compiled_->compiledBytes();
  Plc other(adding("1", "+ 10; T #b;"));
  ASSERT_TRUE(other->setEngine(Engine::Compiled));
  other.cycles(3);
  EXPECT_EQ(after, other->compiledBytes());
}

class StepCounter : public cpu::Probe {
 public:
  bool before(cpu::Machine&, std::uint32_t) override {
    ++count;
    return false;
  }
  void after(cpu::Machine&, const cpu::Code&, std::uint32_t) override {}
  int count = 0;
};

// Breakpoints and program status see each instruction of the block, and nothing when they are gone.
TEST_F(Copies, AProbeSeesTheBlock) {
  begin();
  StepCounter counter;
  const auto probe = [&](cpu::Probe* p) {
    ASSERT_TRUE(compiled_->cpu().loadMemory().probe({BlockKind::FC, 101}, p));
    both([](Plc& plc) { plc->advanceCycles(2); });
  };
  probe(&counter);
  EXPECT_EQ(counter.count, 2 * 2 * 5);
  probe(nullptr);
  EXPECT_EQ(counter.count, 2 * 2 * 5);
  expectSame();
}

// The frames of all three blocks are there when one fails, and the stack of local data.
TEST_F(Copies, AFaultFindsTheFrames) {
  const std::string fails = adding("1", "L 0; /I;") + ob(121, "L MW 30; + 1; T MW 30;");
  begin();
  download(fails);
  EXPECT_EQ(compiled_->mode(), Mode::Run);
  const std::string missing = adding("1", "L DBW 20;");
  download(missing);
  EXPECT_EQ(compiled_->mode(), Mode::Stop);
  const cpu::Machine &x = compiled_->cpu().machine(), &y = reference_->cpu().machine();
  ASSERT_EQ(x.frames.size(), y.frames.size());
  EXPECT_EQ(x.frames.size(), 4u);
  for (std::size_t i = 1; i < x.frames.size(); ++i) {
    EXPECT_EQ(x.frames[i].code->source->id, y.frames[i].code->source->id);
    EXPECT_EQ(x.frames[i].resume, y.frames[i].resume);
    EXPECT_EQ(x.frames[i].localEnd, y.frames[i].localEnd);
    EXPECT_EQ(x.frames[i].parameterCount, y.frames[i].parameterCount);
  }
  EXPECT_EQ(x.position, y.position);
  expectSame();
}

// The call that is one too deep is the copied one: FC 10 is the eighth block, FC 11 would be the
// ninth.
TEST_F(Copies, NestNoDeeperThanCalls) {
  begin();
  download(
      "FUNCTION FC 11 : VOID\nBEGIN\nNETWORK\n L MW 22; + 1; T MW 22;\nEND_FUNCTION\n"
      "FUNCTION FC 10 : VOID\nBEGIN\nNETWORK\n L MW 20; + 1; T MW 20; CALL FC 11; CALL FC "
      "10;\nEND_FUNCTION\n" +
      ob(1, "CALL FC 10;"));
  EXPECT_EQ(compiled_->mode(), Mode::Stop);  // 16#4575
  EXPECT_EQ(compiled_.read("MW 22"), reference_.read("MW 22"));
  expectSame();
}

// 510 bytes for each priority class: below FC 9 and FC 10 there are too few for FC 11 (16#4576).
TEST_F(Copies, TakeNoMoreLocalDataThanCalls) {
  begin();
  download(
      "FUNCTION FC 11 : VOID\nVAR_TEMP a : ARRAY [1..90] OF BYTE; END_VAR\nBEGIN\nNETWORK\n"
      " L MW 22; + 1; T MW 22;\nEND_FUNCTION\n"
      "FUNCTION FC 10 : VOID\nVAR_TEMP a : ARRAY [1..200] OF BYTE; END_VAR\nBEGIN\nNETWORK\n"
      " L MW 20; + 1; T MW 20; CALL FC 11;\nEND_FUNCTION\n"
      "FUNCTION FC 9 : VOID\nVAR_TEMP a : ARRAY [1..220] OF BYTE; END_VAR\nBEGIN\nNETWORK\n"
      " CALL FC 10;\nEND_FUNCTION\n" +
      ob(1, "CALL FC 10; CALL FC 9;"));
  EXPECT_EQ(compiled_->mode(), Mode::Stop);
  EXPECT_EQ(compiled_.read("MW 22"), reference_.read("MW 22"));
  expectSame();
}

// Behind a jump the innermost block goes on outside of its caller's region: the blocks between have
// their own frames there, with the registers that they found.
TEST_F(Copies, BlocksBetweenGiveBackTheDataBlocksThatTheyFound) {
  const std::string data = "\nSTRUCT w : INT; END_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";
  const auto fc = [](int number, const std::string& body) {
    return "FUNCTION FC " + std::to_string(number) + " : VOID\nBEGIN\nNETWORK\n" + body +
           "\nEND_FUNCTION\n";
  };
  for (const std::string change : {"AUF DB 11;", "AUF DI 11;", "TDB;", "LAR2 P#M 8.0;"})
    for (int levels = 1; levels <= 4; ++levels) {
      std::string text = "DATA_BLOCK DB 10" + data + "DATA_BLOCK DB 11" + data;
      text += fc(levels, change + " U E 0.7; SPBN e1; L 5;\ne1: NOP 0;");
      for (int level = levels - 1; level > 0; --level)
        text += fc(level, "UC FC " + std::to_string(level + 1) + ";");
      text += ob(1,
                 "AUF DB 10; AUF DI 10; LAR2 P#M 4.0; UC FC 1; L DBNO; T MW 20; L DINO; T MW 22; "
                 "TAR2 MD 24;");
      Plc compiled(text), reference(text);
      ASSERT_TRUE(compiled->setEngine(Engine::Compiled));
      for (Plc* plc : {&compiled, &reference}) plc->cycles(3);
      for (const char* operand : {"MW 20", "MW 22", "MD 24"})
        EXPECT_EQ(compiled.read(operand), reference.read(operand)) << change << levels;
      EXPECT_EQ(reference.read("MW 20"), 10u);
    }
}

}  // namespace
}  // namespace merker::station::test
