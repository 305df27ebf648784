// Checks in the source (//=) and coverage.
#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

struct Seen {
  std::uint64_t reached;
  std::vector<std::string> failures;
};

// By line.
std::map<unsigned, Seen> checksOf(ListingBench& b) {
  std::map<unsigned, Seen> seen;
  for (const CheckResult& result : b.plc().checkResults()) {
    Seen& line = seen[result.check->position.line];
    line.reached += result.reached;
    for (const CheckFailure& failure : result.failures) line.failures.push_back(failure.text);
  }
  return seen;
}

std::vector<std::string> failuresOf(const std::string& listing) {
  ListingBench b(listing);
  b.run(50);
  std::vector<std::string> all;
  for (const auto& [line, seen] : checksOf(b)) {
    EXPECT_GT(seen.reached, 0u) << "line " << line << " was not reached";
    all.insert(all.end(), seen.failures.begin(), seen.failures.end());
  }
  return all;
}

TEST(Recorder, TermsThatHold) {
  EXPECT_EQ(failuresOf(R"(OB 1
 L  KF +5
 L  KF -7      //= AKKU1 = KF -7, AKKU2 = 5
 +F            //= AKKU1 = KF -2, A1 = 0, A0 = 1, OV = 0, OS = 0, STW = 16#40
 T  MW 100     //= MW 100 = KH FFFE, MB 100 = KH 00FF, M 101.0 = 0
 U  M 0.1      //= VKE = 1, STA = 1, ER = 1
 =  M 110.0    //= ER = 0, M 110.0 = 1
 A  DB 10      //= DBNO = 10, DW 1 = KH 1234, DB11.DW 0 = KH 00AB, DL 1 <> DR 1
 L  KT 10.2
 U  M 0.1
 SV T 1        //= T 1 = KT 10.2, T 1 = 1
 L  KG +1500000+01
 L  KG +2000000+01
 xG            //= AKKU1 ~= 3.0, AKKU1 > KH 0000
 BE            //= AKKU2 = KG +1500000+01
DB 10
0: KH = 0000
1: KH = 1234
DB 11
0: KH = 00AB
)"),
            std::vector<std::string>{});
}

TEST(Recorder, TermsThatFail) {
  EXPECT_EQ(failuresOf("OB 1\n L KB 7  //= AKKU1 = KH 0008, VKE = 1\n BE\n"),
            (std::vector<std::string>{"AKKU1 = KH 0008: is KH 0007", "VKE = 1: is 0"}));
  EXPECT_EQ(failuresOf("OB 1\n L KB 7  //= DB99.DW 0 = 0\n BE\n"),
            std::vector<std::string>{"DB99.DW 0 = 0: the operand cannot be read here"});
  EXPECT_EQ(failuresOf("OB 1\n L KG +1000000+01 //= AKKU1 ~= 2.0\n BE\n"),
            std::vector<std::string>{"AKKU1 ~= 2.0: is 1.000000e+00"});
}

// A check behind a call is judged when the block has returned.
TEST(Recorder, CallsAndBlockEnds) {
  EXPECT_EQ(failuresOf(R"(OB 1
 L KB 1
 SPA FB 1      //= AKKU1 = 3, M 100.0 = 1
NAME : UNTEN
WERT : KF +2
 U M 0.0
 SPB PB 1      //= VKE = 1
 U M 0.1
 SPB PB 1      //= AKKU1 = 9
 BE
FB 1
NAME : UNTEN
BEZ  : WERT  E/A/D/B/T/Z: D   KM/KH/KY/KC/KT/KZ/KF/KG: KF
 LW =WERT      //= AKKU1 = 2, AKKU2 = 1
 +F
 U M 0.1
 = M 100.0
 BE            //= AKKU1 = 3
PB 1
 L KB 9
 BEA           //= AKKU1 = 9
 BE
)"),
            std::vector<std::string>{});
}

// Behind SPB the passes that went on count, if there were any.
TEST(Recorder, Jumps) {
  EXPECT_EQ(failuresOf(R"(OB 1
 SPA FB 1
NAME : SCHLEIFE
 BE
FB 1
NAME : SCHLEIFE
 L KB 0
 T MW 100
M1 : L MW 100
 L KF +1
 +F
 T MW 100
 L KF +5
 <F
 SPB =M1       //= MW 100 = 5
 SPA =M2       //= MW 100 = 5
 L KB 1
M2 : BE
)"),
            std::vector<std::string>{});
}

TEST(Recorder, ProcessedInstructions) {
  EXPECT_EQ(failuresOf(R"(OB 1
 SPA FB 1
NAME : ZEIGER
 BE
FB 1
NAME : ZEIGER
 L KF +110
 T MW 100
 L KB 3
 B MW 100      //= MB 110 = 3
 T MB 30       //= MB 110 = 3, MB 30 = 0
 BE
)"),
            std::vector<std::string>{});
}

// The program runs as without checks.
TEST(Recorder, ChecksChangeNothing) {
  const auto trace = [](const char* check) {
    ListingBench b(std::string("OB 1\n O M 0.0 ") + check + "\n O M 0.1 " + check +
                   "\n = M 100.0\n L KB 1\n T DW 0 " + check + "\n BE\n");
    b.run(200);
    return b.plc().stopReason() + std::to_string(b.value("MB 100")) +
           std::to_string(b.plc().instructions()) +
           std::to_string(b.plc().diagnostics().back().time.ns);
  };
  EXPECT_EQ(trace(""), trace("//= DB36.DW 0 = 0, M 100.0 = 0, PB 100 = 0, AKKU1 = 0"));
}

TEST(Recorder, ACheckThatIsNotReached) {
  ListingBench b("OB 1\n SPA PB 1 //= AKKU1 = 0\n BE\nPB 1\n STP\n A DB 9 //= AKKU1 = 0\n BE\n");
  b.run(50);
  const auto seen = checksOf(b);
  EXPECT_EQ(seen.at(2).reached, 0u);
  EXPECT_EQ(seen.at(6).reached, 0u);
}

// STP ends a self-checking program well; a fault does not.
TEST(Recorder, StopsByWish) {
  ListingBench wish("OB 1\n STP\n BE\n"), fault("OB 1\n A DB 9\n BE\n");
  wish.run(50);
  fault.run(50);
  EXPECT_EQ(wish.plc().mode(), Mode::Stop);
  EXPECT_FALSE(wish.plc().stoppedByFault());
  EXPECT_TRUE(fault.plc().stoppedByFault());
}

TEST(Recorder, Coverage) {
  ListingBench b("OB 1\n U M 0.0\n SPB PB 1\n SPA PB 2\n SPA PB 2\n BE\nPB 1\n BE\nPB 2\n BE\n");
  b.options.coverage = true;
  b.run(130);
  const auto& executed = b.plc().executed();
  EXPECT_EQ(executed.at({mc5::BlockType::Ob, 1}).at(0), 3u);
  EXPECT_EQ(executed.at({mc5::BlockType::Pb, 2}).at(0), 6u);
  EXPECT_FALSE(executed.contains({mc5::BlockType::Pb, 1}));
}

}  // namespace
}  // namespace merker::sinumerik
