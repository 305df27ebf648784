// Whatever the words of a program are, the PLC only stops (S5-BLK, chapter 8.4).
#include <random>

#include "listing_bench.h"
#include "mc5/range.h"

namespace merker::sinumerik {
namespace {

constexpr unsigned kSeed = 19940711;

mc5::Program randomProgram(std::mt19937& random) {
  mc5::Program program;
  const auto add = [&](mc5::BlockType type, std::uint16_t number, std::size_t words) {
    mc5::Block block;
    block.id = {type, number};
    for (std::size_t i = 0; i < words; ++i)
      block.words.push_back(static_cast<std::uint16_t>(random()));
    if (type != mc5::BlockType::Db) block.words.push_back(0x6500);
    program[block.id] = std::move(block);
  };
  for (const auto ob : {1, 2, 20}) add(mc5::BlockType::Ob, static_cast<std::uint16_t>(ob), 40);
  for (std::uint16_t n = 0; n < 4; ++n) {
    add(mc5::BlockType::Pb, n, random() % 30);
    add(mc5::BlockType::Fb, n, random() % 60);
    add(mc5::BlockType::Db, static_cast<std::uint16_t>(10 + n), random() % 60);
  }
  return program;
}

// Words that begin an instruction with an operand in its range, most of the time: else programs
// end before they have begun.
void prefer(mc5::Program& program, std::mt19937& random) {
  const auto good = [](std::uint16_t word) {
    const std::uint16_t code[] = {word, 0, 0};
    const auto decoded = mc5::decode(code);
    return decoded && mc5::inRange(decoded->instruction) &&
           decoded->instruction.operation != mc5::Operation::STS;
  };
  for (auto& [id, block] : program)
    for (std::size_t i = 0; id.type != mc5::BlockType::Db && i + 1 < block.words.size(); ++i)
      while (!good(block.words[i]) && random() % 64 != 0)
        block.words[i] = static_cast<std::uint16_t>(random());
}

TEST(RandomCode, NothingWorseThanAStop) {
  std::mt19937 random(kSeed);
  std::uint64_t instructions = 0;
  for (int i = 0; i < 3000; ++i) {
    Options options;
    options.program = randomProgram(random);
    if (i % 4 != 0) prefer(options.program, random);
    options.machineData = MachineData::standard(true);
    for (unsigned bit = 0; bit < 8; ++bit)
      options.machineData->setBit({2003, bit}, (random() & 1) != 0);
    Plc plc(options);
    plc.coldStart();
    for (int step = 1; step < 10; ++step) {
      plc.advanceTo(ms(step * 23));
      plc.write(*step5::parseVariable("EB 7"), random() & 0xFF);
    }
    EXPECT_EQ(plc.now(), plc.mode() == Mode::Stop ? ms(207) : std::max(plc.now(), ms(207)));
    instructions += plc.instructions();
    if (plc.mode() != Mode::Stop) continue;
    EXPECT_FALSE(plc.stopReason().empty());
    EXPECT_FALSE(toString(plc.programmer().stopPicture()->interrupt).empty());
    plc.warmStart();  // damaged memory is found, nothing more
    plc.advanceTo(ms(300));
  }
  EXPECT_GT(instructions, 200'000u);
}

// The same inputs give the same trace.
TEST(RandomCode, SameTraceEachTime) {
  const auto trace = [] {
    std::mt19937 random(kSeed);
    std::string text;
    for (int i = 0; i < 50; ++i) {
      Options options;
      options.program = randomProgram(random);
      prefer(options.program, random);
      Plc plc(options);
      plc.onCycle([&text](Plc& p) { text += std::to_string(p.now().ns) + ' '; });
      plc.coldStart();
      plc.advanceTo(ms(500));
      text += plc.stopReason();
      for (const DiagnosticEntry& entry : plc.diagnostics())
        text += std::to_string(entry.time.ns) + entry.text;
      for (const std::uint8_t byte : plc.machine().flags) text += static_cast<char>(byte);
    }
    return text;
  };
  EXPECT_EQ(trace(), trace());
}

}  // namespace
}  // namespace merker::sinumerik
