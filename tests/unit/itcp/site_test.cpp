// The web server of a CP 343-1 IT without its sockets (S7-NET-16): pages come from the copy of the
// last cycle, whatever the CPU does meanwhile.
#include "itcp/site.h"

#include <filesystem>
#include <fstream>

#include "itcp/value_text.h"
#include "served_plc.h"

namespace merker::itcp {
namespace {

namespace fs = std::filesystem;

class Served : public ::testing::Test {
 protected:
  Served() {
    fs::create_directory(folder);
    std::ofstream(folder / "a.txt") << ":=MB 10:";
    std::ofstream(folder / "a.json") << "[:=MB 10:, :=MB 11:, :=DB5.DBD 0:, :=DB7.DBW 0:]";
    site->opened();
  }
  ~Served() override { fs::remove_all(folder); }
  std::string page(const std::string& target) {
    shown = std::make_shared<std::optional<hmi::Page>>();
    site->page(target, [shown = shown](hmi::Page page) { *shown = std::move(page); });
    return *shown ? (*shown)->bytes : "";
  }

  fs::path folder = fs::temp_directory_path() / ("merker-site-" + std::to_string(::getpid()));
  served::ServedPlc plc{"a.awl", served::kStation};
  std::shared_ptr<Site> site = std::make_shared<Site>(plc.exchange, folder.string());
  std::shared_ptr<std::optional<hmi::Page>> shown;
};

TEST_F(Served, AValueComesFromTheLastCycleWhateverRuns) {
  EXPECT_EQ(page("/a.json"), "");  // which operands these are only the PLC knows
  plc.cycles(1);
  EXPECT_EQ((*shown)->bytes, "[1, 1, 16909060, null]");
  plc.cycles(1);
  for (int i = 0; i < 100; ++i) {
    plc.plc().advanceTo(plc.plc().now() + Duration::microseconds(7));
    const std::string now = page("/a.json");
    EXPECT_EQ(now.substr(1, now.find(',') - 1), now.substr(now.find(", ") + 2, now.find(',') - 1));
  }
  site->forgetNames();
  EXPECT_EQ(page("/a.json"), "");
  plc.plc().stop();
  plc.look();
  EXPECT_NE((*shown)->bytes, "");
}

TEST_F(Served, FilesOfOtherKindsAreSentAsTheyAre) { EXPECT_EQ(page("/a.txt"), ":=MB 10:"); }

// However many look at the CPU, it is asked once.
TEST_F(Served, TheStateOfTheCpuIsAskedForOnce) {
  EXPECT_EQ(page("/cpu.json"), "");
  plc.cycles(1);
  const std::string first = (*shown)->bytes;
  EXPECT_NE(first.find("\"mode\": \"RUN\""), first.npos) << first;
  plc.plc().stop();
  EXPECT_EQ(page("/cpu.json"), first);
  site->forgetState();
  page("/cpu.json");
  plc.look();
  EXPECT_NE((*shown)->bytes.find("\"mode\": \"STOP\""), first.npos);
}

TEST_F(Served, NobodyAnswersWhenTheSiteHasGone) {
  page("/cpu.json");
  const auto kept = shown;
  site->closed();
  site.reset();
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_FALSE(*kept);
}

TEST(ValueText, OfEachKind) {
  using address::memory;
  const auto text = [](TypeCode type, Width width, s7comm::Bytes octets, std::uint32_t bytes = 0) {
    return textOf({.operand = memory(Area::Flag, width, 0), .type = type, .bytes = bytes}, octets);
  };
  EXPECT_EQ(text(TypeCode::Void, Width::Bit, {1}), "1");
  EXPECT_EQ(text(TypeCode::Void, Width::Word, {0xFF, 0xFE}), "65534");
  EXPECT_EQ(text(TypeCode::Int, Width::Word, {0xFF, 0xFE}), "-2");
  EXPECT_EQ(text(TypeCode::Real, Width::DWord, {0x41, 0x48, 0, 0}), "12.5");
  EXPECT_EQ(text(TypeCode::Real, Width::DWord, {0x3D, 0xCC, 0xCC, 0xCD}), "0.1");
  EXPECT_EQ(text(TypeCode::Char, Width::Byte, {0xFC}), "\xC3\xBC");
  EXPECT_EQ(text(TypeCode::String, Width::Byte, {5, 2, 'a', 0xE4, 'x', 'x', 'x'}, 7), "a\xC3\xA4");
  EXPECT_EQ(text(TypeCode::String, Width::Byte, {5, 9, 'a', 'b', 'c', 'd', 'e'}, 7), "abcde");
}

}  // namespace
}  // namespace merker::itcp
