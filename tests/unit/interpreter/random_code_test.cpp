// Any bytes as a program: the CPU may stop, the process may not. Meant to run under sanitizers.
#include <gtest/gtest.h>

#include <random>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

block::Block randomBlock(BlockKind kind, std::uint16_t number, std::mt19937& random, bool valid) {
  block::Block block;
  block.id = {kind, number};
  block.localBytes = static_cast<std::uint32_t>(random() % 64);
  const std::size_t length = random() % 200;
  while (block.code.size() < length) {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 6; ++i) bytes.push_back(static_cast<std::uint8_t>(random()));
    if (valid) {  // only codes that mean something, with small operands more often than large ones
      if (random() % 2 != 0) bytes[2] = 0;
      const auto decoded = mc7::decode(bytes);
      if (!decoded) continue;
      bytes.resize(decoded->length);
    }
    block.code.insert(block.code.end(), bytes.begin(), bytes.end());
  }
  if (random() % 2 != 0) block.code.resize(block.code.size() / 2 * 2);
  return block;
}

void runRandomProgram(unsigned seed, bool valid) {
  std::mt19937 random(seed);
  std::vector<block::Block> blocks;
  for (std::uint16_t n = 0; n < 4; ++n) {
    blocks.push_back(randomBlock(BlockKind::FC, n, random, valid));
    blocks.push_back(randomBlock(BlockKind::FB, n, random, valid));
    if (n != 0) blocks.push_back(dataBlock(n, random() % 40));
  }
  for (const std::uint16_t ob : std::initializer_list<std::uint16_t>{1, 35, 80, 100, 121, 122})
    if (ob == 1 || random() % 2 != 0)
      blocks.push_back(randomBlock(BlockKind::OB, ob, random, valid));
  Rig rig({});
  auto program = std::make_shared<block::Program>();
  for (block::Block& block : blocks) program->emplace(block.id, std::move(block));
  rig.cpu().load(program);
  rig.cpu().restart(cpu::Restart::ManualWarm);
  const Instant end = Instant{} + Duration::milliseconds(2);
  for (int i = 0; i < 200 && !rig.stopped() && rig.machine().clock < end; ++i) rig.cpu().step(end);
}

TEST(RandomCode, AnyBytesNeverCrash) {
  for (unsigned seed = 0; seed < 300; ++seed) runRandomProgram(seed, false);
}

TEST(RandomCode, AnyInstructionsNeverCrash) {
  for (unsigned seed = 0; seed < 600; ++seed) runRandomProgram(seed, true);
}

}  // namespace
}  // namespace merker::interpreter::test
