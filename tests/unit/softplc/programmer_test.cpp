// Functions of the programmer, memory and addresses (chapters 3.1, 9.1).
#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockId;
using mc5::BlockType;

address::Reference variable(const char* name) { return *step5::parseVariable(name); }

mc5::Block block(BlockType type, unsigned number, std::size_t words, std::uint16_t value = 0) {
  mc5::Block b;
  b.id = {type, static_cast<std::uint16_t>(number)};
  b.words.assign(words, value);
  if (type != BlockType::Db) b.words.back() = 0x6500;
  return b;
}

// FB 61 and FB 11 as resident macros that do nothing.
struct NoMacros : Macros {
  bool has(std::uint16_t n) const override { return n == 61 || n == 11; }
  std::optional<Trap> call(std::uint16_t, Machine&, std::span<const std::uint16_t>) override {
    return std::nullopt;
  }
};

constexpr const char* kOb1 = "OB 1\n BE\n";

// S5-PG-01, S5-DB-12: status and control of variables; the system's blocks take no values.
TEST(Programmer, StatusAndControl) {
  ListingBench b(std::string(kOb1) + "DB 10\n0: KH = 0000\n");
  b.run(10);
  Programmer pg = b.plc().programmer();
  EXPECT_EQ(pg.control(variable("DB10.DW 0"), 5), "");
  EXPECT_EQ(pg.status(variable("DB10.DW 0")), 5u);
  EXPECT_NE(pg.control(variable("DB10.DW 1"), 5), "");
  EXPECT_NE(pg.control(variable("DB1.DW 0"), 5), "");
  EXPECT_NE(pg.control(variable("DB36.DW 0"), 5), "");
  EXPECT_EQ(pg.control(variable("DB1.DW 9"), 0x8000), "");
  EXPECT_EQ(b.value("DB1.D 9.15"), 1u);
  EXPECT_EQ(pg.control(variable("MW 100"), 0x1234), "");
  EXPECT_EQ(pg.status(variable("MB 101")), 0x34u);
}

// S5-DB-10: the blocks of the system, some of them options.
TEST(Programmer, SystemBlocks) {
  for (const bool options : {false, true}) {
    ListingBench b(kOb1);
    b.options.systemBlocks = {.softwareCams = options, .adarCoupling = options};
    b.run(10);
    std::vector<unsigned> found;
    for (const DirectoryEntry& entry : b.plc().programmer().directory())
      if (entry.id.type == BlockType::Db) found.push_back(entry.id.number);
    EXPECT_EQ(found, options ? (std::vector<unsigned>{1, 36, 37, 39, 40, 71})
                             : (std::vector<unsigned>{1, 36, 37, 40}));
  }
}

// S5-DB-11, S5-PG-02, S5-BLK-01, S5-FB-19: what is in EPROM stays as it is.
TEST(Programmer, ResidentBlocksAreProtected) {
  NoMacros macros;
  ListingBench b(kOb1);
  b.options.macros = &macros;
  b.run(10);
  Programmer pg = b.plc().programmer();
  EXPECT_EQ(pg.erase({BlockType::Db, 36}).substr(0, 14), "70 DB im EPROM");
  EXPECT_EQ(pg.erase({BlockType::Db, 1}).substr(0, 14), "70 DB im EPROM");
  EXPECT_NE(pg.erase({BlockType::Fb, 61}), "");
  EXPECT_EQ(pg.load(block(BlockType::Fb, 61, 3)).substr(0, 27), "Baustein bereits im EPROM (");
  EXPECT_TRUE(b.plc().machine().blocks.find({BlockType::Db, 1}).present);
  const auto macro = pg.read({BlockType::Fb, 11});
  ASSERT_TRUE(macro.has_value());
  EXPECT_EQ(macro->name, "EINR-DB");
  EXPECT_TRUE(macro->words.empty());
}

// S5-PG-01, S5-BLK-03: transfer, reading back and deleting, between two cycles.
TEST(Programmer, BlocksComeAndGo) {
  ListingBench b("OB 1\n" + burn(5) + " BE\n");
  b.run(2);  // in OB 1
  Programmer pg = b.plc().programmer();
  EXPECT_EQ(pg.load(block(BlockType::Pb, 255, 4, 0xFFFF)), "");
  EXPECT_FALSE(b.plc().machine().blocks.find({BlockType::Pb, 255}).present);
  b.plc().settle();
  EXPECT_TRUE(b.plc().machine().blocks.find({BlockType::Pb, 255}).present);
  const auto back = pg.read({BlockType::Pb, 255});
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->words, (std::vector<std::uint16_t>{0xFFFF, 0xFFFF, 0xFFFF, 0x6500}));
  EXPECT_EQ(pg.erase({BlockType::Pb, 255}), "");
  EXPECT_FALSE(pg.read({BlockType::Pb, 255}).has_value());
  EXPECT_NE(pg.erase({BlockType::Pb, 255}), "");
  EXPECT_EQ(pg.load(block(BlockType::Pb, 0, 4)), "");
  for (const auto& [type, number] : {std::pair{BlockType::Db, 0u}, std::pair{BlockType::Ob, 64u},
                                     std::pair{BlockType::Pb, 256u}})
    EXPECT_NE(pg.load(block(type, number, 4)), "") << number;
  EXPECT_EQ(pg.load(block(BlockType::Db, 99, 2048)), "");  // S5-DB-01
  EXPECT_NE(pg.load(block(BlockType::Db, 98, 2049)), "");
}

// S5-DB-16, S5-SCHED-13, S5-MEM-08: 6 kB of data, 16 kB of program (COP 12, extended 48 and 38).
TEST(Programmer, MemoryIsLimited) {
  struct Case {
    mc5::Variant variant;
    bool extension;
    unsigned program, data;  // words
  };
  for (const Case& c :
       {Case{mc5::Variant::Acop, false, 8192, 3072}, Case{mc5::Variant::Cop, false, 6144, 3072},
        Case{mc5::Variant::Acop, true, 24576, 3072 + 32 * 512}}) {
    ListingBench b(kOb1);  // 6 words
    b.options.variant = c.variant;
    b.options.memoryExtension = c.extension;
    b.data().setWord(9, 32);
    b.run(10);
    Programmer pg = b.plc().programmer();
    EXPECT_NE(pg.load(block(BlockType::Pb, 1, c.program - 10)), "");
    EXPECT_EQ(pg.load(block(BlockType::Pb, 1, c.program - 11)), "");
    unsigned left = c.data, number = 100;
    for (; left > 2053; left -= 2053) EXPECT_EQ(pg.load(block(BlockType::Db, number++, 2048)), "");
    EXPECT_NE(pg.load(block(BlockType::Db, number, left - 4)), "") << left;
    EXPECT_EQ(pg.load(block(BlockType::Db, number, left - 5)), "") << left;
    EXPECT_TRUE(b.plc().coldStart());  // the system's blocks have their own room
  }
}

// S5-MEM-01, S5-MEM-02, S5-MEM-03, S5-MEM-04: segment switch E000 and words of a segment.
TEST(Programmer, AddressesOfASegment) {
  ListingBench b(std::string(kOb1) + "DB 10\n0: KH = ABCD\n");
  b.run(10);
  Programmer pg = b.plc().programmer();
  EXPECT_EQ(pg.address(0xE000), 5);
  EXPECT_EQ(pg.address(0), 0x7070);
  EXPECT_EQ(pg.address(5), 0x6500);
  EXPECT_TRUE(pg.correctAddress(0xE000, 6));
  EXPECT_EQ(pg.address(0xE000), 6);
  EXPECT_EQ(pg.address(5), 0xABCD);
  EXPECT_TRUE(pg.correctAddress(5, 0x1234));
  EXPECT_EQ(b.value("DB10.DW 0"), 0x1234u);
  EXPECT_FALSE(pg.correctAddress(0xE000, 7));
  EXPECT_FALSE(pg.correctAddress(0xE000, 2));
  EXPECT_EQ(pg.address(0xE000), 6);
  EXPECT_FALSE(pg.correctAddress(0xF000, 1));
  b.plc().coldStart();
  EXPECT_EQ(pg.address(0xE000), 5);
}

// S5-MEM-05, S5-MEM-06: F00C … F011 lead to the lists, an entry to the block.
TEST(Programmer, BlockLists) {
  for (const auto variant : {mc5::Variant::Acop, mc5::Variant::Cop}) {
    ListingBench b(std::string(kOb1) + "PB 3\n BE\nDB 10\n0: KH = ABCD\n");
    b.options.variant = variant;
    b.run(10);
    Programmer pg = b.plc().programmer();
    pg.correctAddress(0xE000, 1);
    const auto swapped = [](unsigned word) { return (word & 0xFF) << 8 | word >> 8; };
    const auto entry = [&](unsigned list, unsigned number, unsigned half) {
      const unsigned start = pg.address(static_cast<std::uint16_t>(list)).value();
      return swapped(pg.address(static_cast<std::uint16_t>(start + 2 * number + half)).value());
    };
    const auto& blocks = b.plc().machine().blocks;
    const bool cop = variant == mc5::Variant::Cop;
    EXPECT_EQ(entry(0xF011, 3, 0), blocks.find({BlockType::Pb, 3}).start * (cop ? 1 : 2));
    EXPECT_EQ(entry(0xF00C, 1, 0), blocks.find({BlockType::Ob, 1}).start * (cop ? 1 : 2));
    EXPECT_EQ(entry(0xF00E, 10, 0), blocks.find({BlockType::Db, 10}).start * 2);
    EXPECT_EQ(entry(0xF011, 3, 1), cop ? 0x1000u : 0x1400u);
    EXPECT_EQ(entry(0xF00E, 10, 1), cop ? 0x1400u : 0x1280u);
    EXPECT_EQ(entry(0xF011, 4, 0), 0u);
    EXPECT_NE(pg.address(0xF00D).value(), 0u);
    EXPECT_NE(pg.address(0xF010).value(), 0u);
  }
}

// S5-MEM-07, S5-PG-01, S5-FM-02: the directory shows addresses with the offset of the variant.
TEST(Programmer, Directory) {
  struct Case {
    mc5::Variant variant;
    Software software;
    bool extension;
    unsigned data, resident, program;
  };
  NoMacros macros;
  for (const Case& c :
       {Case{mc5::Variant::Acop, Software::Sw2, false, 0x1400, 0x0800, 0x2000},
        Case{mc5::Variant::Acop, Software::Sw2, true, 0x1400, 0x0800, 0x2000 + 8 * 0x20},
        Case{mc5::Variant::Acop, Software::Sw1, false, 0x2000, 0x6000, 0},
        Case{mc5::Variant::Cop, Software::Sw1, false, 0x8000, 0x8000, 0}}) {
    ListingBench b(std::string(kOb1) + "DB 10\n0: KH = ABCD\n");
    b.options.variant = c.variant;
    b.options.software = c.software;
    b.options.memoryExtension = c.extension;
    b.options.macros = &macros;
    b.run(10);
    unsigned residents = 0;
    for (const DirectoryEntry& entry : b.plc().programmer().directory()) {
      const auto& blocks = b.plc().machine().blocks;
      if (entry.id == BlockId{BlockType::Ob, 1}) {
        EXPECT_EQ(entry.address, c.program + 5);
        EXPECT_EQ(entry.words, 6u);
      }
      if (entry.id == BlockId{BlockType::Db, 10}) {
        EXPECT_EQ(entry.address, c.data + blocks.find(entry.id).start);
      }
      if (!entry.resident) continue;
      ++residents;
      EXPECT_GE(entry.address, c.resident);
      EXPECT_LT(entry.address, c.resident + 32);
    }
    EXPECT_EQ(residents, 2u);
  }
}

// S5-PG-03, S5-PG-04: AG-Stop is alarm 6149, AG-Start clears it.
TEST(Programmer, StartAndStop) {
  ListingBench b(kOb1);
  b.run(10);
  b.plc().programmer().stop();
  EXPECT_TRUE(b.stopped(Alarm::ProgrammerStop));
  EXPECT_FALSE(b.plc().stoppedByFault());
  EXPECT_TRUE(b.pending(kPlcStop));
  EXPECT_TRUE(b.plc().programmer().start());
  b.runTo(70);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  EXPECT_FALSE(b.pending(kPlcStop));
}

// S5-PG-01, S5-ERR-07: compression shows its bits while it waits for the end of the cycle.
TEST(Programmer, Compression) {
  ListingBench b("OB 1\n" + burn(5) + " BE\n");
  b.run(2);
  Programmer pg = b.plc().programmer();
  EXPECT_EQ(pg.compress(), "");
  EXPECT_TRUE(b.control(ControlBit::SCHTAE) && b.control(ControlBit::BSTSCH));
  b.plc().settle();
  EXPECT_FALSE(b.control(ControlBit::SCHTAE) || b.control(ControlBit::BSTSCH));
  EXPECT_FALSE(b.control(ControlBit::SPABBR));
  b.plc().stop();
  b.plc().machine().blocks.program()[0] = 0;
  EXPECT_NE(pg.compress(), "");
  EXPECT_TRUE(b.control(ControlBit::SPABBR));
}

// S5-OB-22: the areas end where they end.
TEST(Programmer, AreasEnd) {
  ListingBench b(kOb1);
  b.run(10);
  for (const char* inside : {"E 127.7", "A 127.7", "M 255.7", "T 31", "Z 31", "MD 252", "EW 126"})
    EXPECT_TRUE(b.plc().read(variable(inside)).has_value()) << inside;
  for (const char* outside : {"E 128.0", "A 128.0", "M 256.0", "T 32", "Z 32", "MD 253", "E 0.8"})
    EXPECT_FALSE(b.plc().read(variable(outside)).has_value()) << outside;
}

}  // namespace
}  // namespace merker::sinumerik
