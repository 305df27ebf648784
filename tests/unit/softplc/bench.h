// A machine on which pieces of machine code run.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>

#include "softplc/processor.h"

namespace merker::sinumerik {

struct Bench {
  Bench() : machine(8192, 3072), processor(machine, environment) {}

  void block(mc5::BlockType type, std::uint16_t number, std::initializer_list<unsigned> words) {
    mc5::Block b;
    b.id = {type, number};
    for (const unsigned word : words) b.words.push_back(static_cast<std::uint16_t>(word));
    ASSERT_TRUE(machine.blocks.load(b));
  }
  // Runs OB 1 with this code (BE is added) to its end or a trap.
  Outcome run(std::initializer_list<unsigned> words) {
    std::vector<unsigned> code(words);
    code.push_back(0x6500);
    mc5::Block b;
    b.id = {mc5::BlockType::Ob, 1};
    for (const unsigned word : code) b.words.push_back(static_cast<std::uint16_t>(word));
    EXPECT_TRUE(machine.blocks.load(b));
    return runOb();
  }
  Outcome runOb() {
    machine.levels.clear();
    EXPECT_TRUE(processor.begin(1));
    return goOn();
  }
  Outcome goOn() {
    for (int i = 0; i < 100'000; ++i) {
      if (!machine.levels.empty()) last = machine.registers();
      const Outcome outcome = processor.step();
      if (outcome != Outcome::Next) return outcome;
    }
    return Outcome::Next;
  }
  bool flag(unsigned byte, unsigned bit) const { return (machine.flags[byte] >> bit & 1) != 0; }
  unsigned flagWord(unsigned byte) const {
    return machine.flags[byte] << 8u | machine.flags[byte + 1];
  }

  Machine machine;
  Environment environment;
  Processor processor;
  Registers last;  // before BE
};

}  // namespace merker::sinumerik
