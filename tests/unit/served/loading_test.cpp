// Blocks that clients load into a CPU and delete from it.
#include "block/container.h"
#include "cpu/switch_panel.h"
#include "served/passive_blocks.h"
#include "served_plc.h"
#include "station/translations.h"

namespace merker::served {
namespace {

using s7comm::BlockName;
using s7comm::BlockType;
using s7comm::Error;
using s7comm::FileSystem;

constexpr BlockName kOb1{BlockType::Ob, 1, FileSystem::Passive};
constexpr BlockName kDb5{BlockType::Db, 5, FileSystem::Passive};
constexpr BlockName kFc1{BlockType::Fc, 1, FileSystem::Passive};
const char* const kHead =
    "DATA_BLOCK DB 5\nSTRUCT\n a : DWORD := DW#16#01020304;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";

// The blocks of a source, as containers.
Bytes containerOf(const std::string& source, BlockKind kind, std::uint16_t number) {
  const auto build = compilation::build(project::load("b.awl", {}, {{"b.awl", source}}), false);
  return block::writeContainer(build.program->at({kind, number}));
}
Bytes ob1(const std::string& code) {
  return containerOf(std::string(kHead) + "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n" +
                         "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + code +
                         "\nEND_ORGANIZATION_BLOCK\n",
                     BlockKind::OB, 1);
}
Bytes db5(const std::string& value) {
  return containerOf("DATA_BLOCK DB 5\nSTRUCT\n a : DWORD := DW#16#" + value +
                         ";\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
                         "ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n",
                     BlockKind::DB, 5);
}
Bytes fc1() {
  return containerOf(
      "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n L 7;\n T MB 21;\nEND_FUNCTION\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n",
      BlockKind::FC, 1);
}

class Loading : public ::testing::Test {
 protected:
  Loading() {
    plc.exchange.opened();
    plc.cycles(1);
  }
  // Over the next end of a cycle.
  template <class Ask>
  Error now(const Ask& ask) {
    std::optional<Error> told;
    ask([&told](Error error) { told = error; });
    for (int i = 0; i < 3 && !told; ++i) plc.cycles(1), plc.look();
    EXPECT_TRUE(told);
    return told.value_or(Error::CannotBeDone);
  }
  Error admit(const BlockName& name, std::size_t octets) {
    return now([&](auto done) { plc.exchange.admit(name, octets, {}, done); });
  }
  Error keep(const BlockName& name, const Bytes& container, const std::string& password = {}) {
    return now([&](auto done) { plc.exchange.keep(name, container, password, done); });
  }
  Error link(const std::vector<BlockName>& names) {
    return now([&](auto done) { plc.exchange.link(names, {}, done); });
  }
  Error remove(const std::vector<BlockName>& names) {
    return now([&](auto done) { plc.exchange.remove(names, {}, done); });
  }
  Error upload(const BlockName& name, Bytes* container = nullptr) {
    return now([&](auto done) {
      plc.exchange.block(name, {}, [=](Error error, const Bytes& octets) {
        if (container != nullptr) *container = octets;
        done(error);
      });
    });
  }
  Bytes db() { return plc.read({.memory = Memory::DataBlock, .block = 5, .octets = 4})->octets; }
  std::uint8_t flag(std::uint32_t number) { return plc.read(flags(number, 1))->octets.at(0); }

  ServedPlc plc = ServedPlc::station();
};

// S7-LIM-04, S7-CYCLE-05: passive until they are linked, then all of them in the same cycle.
TEST_F(Loading, blocksCountWhenTheyAreLinked) {
  EXPECT_EQ(keep(kFc1, fc1()), Error::None);
  EXPECT_EQ(keep(kOb1, ob1(" CALL FC 1;\n")), Error::None);
  plc.cycles(2);
  EXPECT_EQ(flag(21), 0);
  EXPECT_EQ(upload({BlockType::Fc, 1, FileSystem::Active}), Error::NoSuchBlock);
  EXPECT_EQ(upload(kFc1), Error::None);
  EXPECT_EQ(link({kFc1, kOb1}), Error::None);
  plc.cycles(2);
  EXPECT_EQ(flag(21), 7);
  EXPECT_EQ(plc.plc().mode(), controller::Mode::Run);
  Bytes container;
  EXPECT_EQ(upload({BlockType::Fc, 1, FileSystem::Active}, &container), Error::None);
  EXPECT_EQ(container, fc1());
  EXPECT_EQ(upload(kFc1), Error::NoSuchBlock);  // it is no longer passive
}

TEST_F(Loading, allOrNone) {
  EXPECT_EQ(keep(kOb1, ob1(" CALL FC 1;\n")), Error::None);
  EXPECT_EQ(link({kOb1, kFc1}), Error::NoSuchBlock);
  plc.cycles(2);
  EXPECT_EQ(plc.plc().mode(), controller::Mode::Run);
  EXPECT_EQ(upload(kOb1), Error::None);
}

// Load memory and work memory get its values (S7-MEM-04), also where load memory had them.
TEST_F(Loading, aDataBlockBringsItsValues) {
  plc.writeNow({.memory = Memory::DataBlock, .block = 5, .begin = 0, .octets = 1}, {9});
  EXPECT_EQ(keep(kDb5, db5("01020304")), Error::None);
  EXPECT_EQ(db(), (Bytes{9, 2, 3, 4}));
  EXPECT_EQ(link({kDb5}), Error::None);
  EXPECT_EQ(db(), (Bytes{1, 2, 3, 4}));
  EXPECT_EQ(keep(kDb5, db5("AABBCCDD")), Error::None);
  EXPECT_EQ(link({kDb5}), Error::None);
  EXPECT_EQ(db(), (Bytes{0xAA, 0xBB, 0xCC, 0xDD}));
}

TEST_F(Loading, deletedBlocksAreGone) {
  EXPECT_EQ(remove({{BlockType::Db, 5, FileSystem::Active}, kFc1}), Error::NoSuchBlock);
  EXPECT_EQ(upload({BlockType::Db, 5, FileSystem::Active}), Error::None);
  EXPECT_EQ(remove({{BlockType::Db, 5, FileSystem::Both}}), Error::None);
  EXPECT_EQ(upload({BlockType::Db, 5, FileSystem::Active}), Error::NoSuchBlock);
  EXPECT_EQ(keep(kFc1, fc1()), Error::None);
  EXPECT_EQ(remove({{BlockType::Fc, 1, FileSystem::Active}}), Error::NoSuchBlock);
  EXPECT_EQ(remove({kFc1}), Error::None);
  EXPECT_EQ(link({kFc1}), Error::NoSuchBlock);
}

// Listed, but made from the configuration, or part of the operating system.
TEST_F(Loading, whatBelongsToTheCpuIsNotDeleted) {
  EXPECT_EQ(remove({{BlockType::Sdb, 2, FileSystem::Both}}), Error::AccessRefused);
  EXPECT_EQ(remove({{BlockType::Sfc, 14, FileSystem::Both}}), Error::AccessRefused);
  EXPECT_EQ(remove({{BlockType::Sdb, 99, FileSystem::Both}}), Error::NoSuchBlock);
}

TEST_F(Loading, whatMayNotCome) {
  EXPECT_EQ(admit(kFc1, 100), Error::None);
  EXPECT_EQ(admit({BlockType::Ob, 2, FileSystem::Passive}, 100), Error::WrongBlockNumber);
  EXPECT_EQ(admit({BlockType::Db, 0, FileSystem::Passive}, 100), Error::WrongBlockNumber);
  EXPECT_EQ(admit({BlockType::Sfc, 1, FileSystem::Passive}, 100), Error::WrongBlockNumber);
  EXPECT_EQ(admit(kFc1, 300'000), Error::BlockTooLarge);
}

TEST_F(Loading, aContainerIsChecked) {
  const auto kept = [&](auto change, const BlockName& name = kFc1) {
    Bytes container = fc1();
    change(container);
    return keep(name, container);
  };
  EXPECT_EQ(kept([](Bytes& bytes) { bytes.resize(20); }), Error::WrongBlockLength);
  EXPECT_EQ(kept([](Bytes& bytes) { bytes.push_back(0); }), Error::WrongBlockLength);
  EXPECT_EQ(kept([](Bytes& bytes) { bytes[35] += 2; }), Error::WrongBlockLength);
  EXPECT_EQ(kept([](Bytes& bytes) { bytes[36] ^= 1; }), Error::WrongChecksum);
  EXPECT_EQ(kept([](Bytes& bytes) { bytes[0] = 0; }), Error::WrongBlockStructure);
  EXPECT_EQ(kept([](Bytes& bytes) { bytes[7] = 2; }), Error::WrongBlockNumber);
  const BlockName fb1{BlockType::Fb, 1, FileSystem::Passive};
  EXPECT_EQ(kept([](Bytes&) {}, fb1), Error::WrongBlockStructure);
  const auto withoutChecksum = [](Bytes& bytes) {
    bytes[bytes.size() - 10] = bytes[bytes.size() - 9] = 0;
  };
  EXPECT_EQ(kept(withoutChecksum), Error::None);
  // Code of another family: no such instruction.
  EXPECT_EQ(kept([&](Bytes& bytes) {
              bytes[36] = bytes[37] = 0xFF;
              withoutChecksum(bytes);
            }),
            Error::WrongBlockStructure);
}

// 48 KB of work memory: a fourth DB of 15 KB does not fit.
TEST_F(Loading, workMemoryIsFinite) {
  const std::string code = " ARRAY [1..15000] OF BYTE;\n";
  Error last = Error::None;
  for (std::uint16_t number = 10; number < 14 && last == Error::None; ++number) {
    const BlockName name{BlockType::Db, number, FileSystem::Passive};
    const std::string text = "DATA_BLOCK DB " + std::to_string(number) + "\nSTRUCT\n a :" + code +
                             "END_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
                             "ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n";
    EXPECT_EQ(keep(name, containerOf(text, BlockKind::DB, number)), Error::None);
    last = link({name});
    EXPECT_EQ(last, number == 13 ? Error::NoMemory : Error::None);
  }
}

// System data take no work memory, but load memory.
TEST_F(Loading, linkedBlocksTakeLoadMemory) {
  const CpuModel& model = controller::capability<station::BlockCpu>(plc.plc())->model();
  ProgramChange change{.engine = {}, .model = &model};
  const auto makeReady = [&](std::size_t blocks) {
    block::Program program;
    for (std::uint16_t number = 0; number < blocks; ++number) {
      block::Block& one = program[{BlockKind::SDB, number}];
      one.id = {BlockKind::SDB, number};
      one.actualData.resize(60'000);
    }
    change.error = Error::None;
    change.before = std::make_shared<const block::Program>(std::move(program));
    change.linked = {std::make_shared<block::Block>(*block::readContainer(fc1(), {}))};
    change.makeReady();
    return change.error;
  };
  EXPECT_EQ(makeReady(model.loadMemory / 60'100), Error::None);
  EXPECT_EQ(makeReady(model.loadMemory / 60'000 + 1), Error::NoMemory);
}

TEST_F(Loading, loadMemoryAndBlocksAreFinite) {
  const CpuModel& model = controller::capability<station::BlockCpu>(plc.plc())->model();
  PassiveBlocks passive;
  const auto block = std::make_shared<block::Block>(*block::readContainer(fc1(), {}));
  const auto keepSo = [&](std::uint16_t number, std::size_t octets, std::size_t code) {
    auto other = std::make_shared<block::Block>(*block);
    other->id.number = number;
    other->code.resize(code);
    return passive.keep(plc.plc(), other, octets, {});
  };
  EXPECT_EQ(keepSo(1, model.loadMemory - 10, 2), Error::None);
  EXPECT_EQ(keepSo(2, 11, 2), Error::NoMemory);
  EXPECT_EQ(passive.admit(plc.plc(), {BlockType::Fc, 2, FileSystem::Passive}, 11, {}),
            Error::NoMemory);
  EXPECT_EQ(keepSo(2, 10, 2), Error::None);
  EXPECT_EQ(keepSo(1, 20, 2), Error::None);  // in place of the old one
  EXPECT_EQ(keepSo(3, 20, model.blockSize + 2), Error::BlockTooLarge);
}

// docs/safety.md: code is translated in the thread of the connections.
TEST_F(Loading, thePlcTranslatesNothing) {
  PassiveBlocks passive;
  const auto block = std::make_shared<const block::Block>(*block::readContainer(fc1(), {}));
  EXPECT_EQ(passive.keep(plc.plc(), block, 100, {}), Error::None);
  ProgramChange change = passive.link(plc.plc(), {kFc1}, {});
  change.makeReady();
  EXPECT_NE(change.translations->find(*block), nullptr);
  EXPECT_TRUE(passive.carryOut(plc.plc(), change));
  EXPECT_EQ(change.translations->find(*block), nullptr);  // the CPU has it
}

TEST_F(Loading, whatIsLoadedMeanwhileIsNotLost) {
  PassiveBlocks passive;
  const auto block = std::make_shared<const block::Block>(*block::readContainer(fc1(), {}));
  passive.keep(plc.plc(), block, 100, {});
  ProgramChange change = passive.link(plc.plc(), {kFc1}, {});
  change.makeReady();
  EXPECT_EQ(remove({{BlockType::Db, 5, FileSystem::Active}}), Error::None);
  EXPECT_FALSE(passive.carryOut(plc.plc(), change));
  EXPECT_EQ(upload({BlockType::Fc, 1, FileSystem::Active}), Error::NoSuchBlock);
}

// S7-SIM-11.
TEST_F(Loading, notWithTheModeSwitchAtRun) {
  controller::capability<cpu::SwitchPanel>(plc.plc())->setSwitch(cpu::SwitchPosition::Run);
  EXPECT_EQ(admit(kFc1, 100), Error::NeedsPassword);
  EXPECT_EQ(remove({{BlockType::Db, 5, FileSystem::Active}}), Error::NeedsPassword);
}

TEST_F(Loading, memoryResetAndCopyNeedStop) {
  using s7comm::Control;
  using s7comm::Controlled;
  const auto control = [&](Control wish) {
    Controlled how = Controlled::Refused;
    now([&](auto done) {
      plc.exchange.control(wish, {}, [&how, done](Controlled told) {
        how = told;
        done(Error::None);
      });
    });
    return how;
  };
  EXPECT_EQ(control(Control::Compress), Controlled::Done);
  EXPECT_EQ(control(Control::CopyRamToRom), Controlled::Refused);
  EXPECT_EQ(control(Control::MemoryReset), Controlled::Refused);
  plc.writeNow({.memory = Memory::DataBlock, .block = 5, .begin = 0, .octets = 1}, {9});
  EXPECT_EQ(control(Control::Stop), Controlled::Done);
  EXPECT_EQ(control(Control::CopyRamToRom), Controlled::Done);
  EXPECT_EQ(keep(kFc1, fc1()), Error::None);
  EXPECT_EQ(control(Control::MemoryReset), Controlled::Done);
  EXPECT_EQ(db(), (Bytes{9, 2, 3, 4}));
  EXPECT_EQ(link({kFc1}), Error::NoSuchBlock);
}

TEST(LoadingElsewhere, aMachineWithoutSuchBlocks) {
  ServedPlc plc = ServedPlc::control();
  PassiveBlocks passive;
  EXPECT_EQ(passive.admit(plc.plc(), kFc1, 100, {}), Error::FunctionNotAvailable);
  EXPECT_EQ(passive.link(plc.plc(), {kFc1}, {}).error, Error::FunctionNotAvailable);
  EXPECT_EQ(passive.remove(plc.plc(), {kFc1}, {}).error, Error::FunctionNotAvailable);
}

}  // namespace
}  // namespace merker::served
