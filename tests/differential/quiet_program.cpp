#include "quiet_program.h"

#include <fmt/format.h>

#include <iterator>
#include <random>
#include <string_view>

namespace merker::differential {
namespace {

// {0} and {1} bits of M, {2} a timer or counter, {3} a time of S5 in ms, {4} a word of M, {5} a
// label.
constexpr std::string_view kLines[] = {
    // timers: with an end that nobody waits for, again and again, with their time read
    "U M {0}\nL S5T#{3}MS\nSE T {2}\nU T {2}\n= A {1}\n",
    "U M {0}\nL S5T#{3}MS\nSV T {2}\nU T {2}\n= M {1}\n",
    "U M {0}\nL S5T#{3}MS\nSA T {2}\nU T {2}\n= A {1}\n",
    "UN M {0}\nL S5T#{3}MS\nSS T {2}\nU M {1}\nR T {2}\nU T {2}\n= A {0}\n",
    "UN T {2}\nL S5T#{3}MS\nSE T {2}\nU T {2}\nFP M {0}\n= M {1}\n",
    "UN T {2}\nL S5T#{3}MS\nSI T {2}\nU T {2}\nZV Z {2}\n",
    "L T {2}\nT MW {4}\n",
    "LC T {2}\nT MW {4}\n",
    "L T {2}\nL 1\n<=I\n= A {1}\n",
    "L {2}\nT MW 90\nL T [MW 90]\nT MW {4}\n",
    "CALL FC 11 (t := T {2}, w := MW {4})\n",
    // edges, counters, arithmetic: most come to rest
    "U M {0}\nFP M {1}\n= A {0}\n",
    "U A {0}\nZR Z {2}\nU Z {2}\n= M {1}\n",
    "L MW {4}\nL 100\n<I\nSPBN {5}\nL MW {4}\nINC 1\nT MW {4}\n{5}: NOP 0\n",
    "U M {0}\nUN M {1}\n= M {1}\n",
    "L MW {4}\nL 3\n+I\nT MW {4}\n",
    "UN M {0}\n= A {1}\nU A {1}\n= M {1}\n",
    // local data that nobody has written
    "L LW 40\nT MW {4}\nL MW {4}\nL 1\nUW\nT LW 40\n",
    "U L 42.0\nUN L 42.1\n= L 42.1\n= M {1}\n",
    "UN L 44.3\n= L 44.3\n",
    // the start information of OB 1
    "L LB 18\nT MB 70\n",
    "L LB 18\nL B#16#5\n<I\n= M {1}\n",
    "L LW 6\nT MW {4}\n",
    "L LD 8\nT MD 72\n",
    "L LB 1\nT MB 71\n",
    "L P#18.0\nT MD 76\nL LB [MD 76]\nT MB 70\n",
    "LAR1 P#16.0\nL LB [AR1,P#2.0]\nT MB 70\n",
    "LAR1 P#L 18.0\nL B [AR1,P#0.0]\nT MB 70\n",
    "LAR1 P#L 44.0\nL B [AR1,P#0.0]\nT MB 70\n",
    "T LB 18\nL MB 0\n",
    "U L 18.3\n= M {1}\n",
    "CALL FC 10 (i := #start[18], q := MB 70)\n",
    "CALL FC 10 (i := MB 60, q := MB 70)\n",
    "CALL FC 12 (p := #start)\n",
    "CALL SFC 20 (SRCBLK := P#L 16.0 BYTE 4, RET_VAL := MW 80, DSTBLK := P#M 84.0 BYTE 4)\n",
    "CALL SFC 20 (SRCBLK := P#M 0.0 BYTE 4, RET_VAL := MW 80, DSTBLK := P#M 84.0 BYTE 4)\n",
    "CALL SFC 21 (BVAL := MW {4}, RET_VAL := MW 80, BLK := P#M 84.0 BYTE 4)\n",
    // the clock, interrupts, run-time meters
    "CALL SFC 64 (RET_VAL := MD 92)\n",
    "CALL SFC 64 (RET_VAL := MD 92)\nL MD 92\nL L#40\n<D\n= M {1}\n",
    "CALL SFC 1 (RET_VAL := MW 80, CDT := #stamp)\nL #tick\nT MB 70\n",
    "CALL SFC 6 (RET_VAL := MW 80, TOP_SI := P#M 120.0 BYTE 20, START_UP_SI := P#M 140.0 BYTE "
    "20)\n",
    "CALL SFC 4 (NR := B#16#0, RET_VAL := MW 80, CQ := M {0}, CV := MW {4})\n",
    "U M {0}\nFP M {1}\nSPBN {5}\nCALL SFC 32 (OB_NR := 20, DTIME := T#{3}MS, SIGN := MW {4}, "
    "RET_VAL := MW "
    "80)\n{5}: NOP 0\n",
    "CALL SFC 34 (OB_NR := 20, RET_VAL := MW 80, STATUS := MW {4})\n",
    "CALL SFC 43\n",
    "U M {0}\nSPBN {5}\nCALL SFC 47 (WT := 700)\n{5}: NOP 0\n",
    "U M {0}\nSPBN {5}\nCALL SFC 39 (MODE := B#16#2, OB_NR := 35, RET_VAL := MW 80)\n{5}: NOP 0\n",
    "CALL SFC 41 (RET_VAL := MW 80)\n",
    "CALL SFB 4, DB 10 (IN := M {0}, PT := T#{3}MS, Q := A {1}, ET := MD 96)\n",
    "CALL SFB 3, DB 11 (IN := M {0}, PT := T#{3}MS, Q := A {1})\n",
    "CALL SFB 5, DB 12 (IN := M {0}, PT := T#{3}MS, Q := A {1})\n",
    "CALL SFB 0, DB 13 (CU := M {0}, R := M {1}, PV := 3, Q := A {1})\n",
    // periphery and errors
    "L PEW 2\nT MW {4}\n",
    "L MW {4}\nT PAW 6\n",
    "L B#16#1\nT PAB 5\nL B#16#2\nT AB 5\n",
    "U M {0}\nSPBN {5}\nAUF DB 1\nL DBW 90\n{5}: NOP 0\n",
    "U M {0}\nSPBN {5}\nAUF DB 99\n{5}: NOP 0\n",
    "CALL SFC 36 (PRGFLT_SET_MASK := DW#16#4, ACCFLT_SET_MASK := DW#16#4, RET_VAL := MW 80, "
    "PRGFLT_MASKED "
    ":= MD 72, ACCFLT_MASKED := MD 76)\nAUF DB 1\nL DBW 90\nT MW {4}\n",
    // data blocks, clock memory
    "AUF DB 1\nL DBW 2\nT DBW 4\nU DBX 0.1\n= M {1}\n",
    "U M {0}\n= DB1.DBX 0.1\n",
    "U M 100.0\nFP M {1}\nZV Z {2}\n",
    "L MB 100\nT AB 7\n",
    // comes and goes in each cycle but the one in which clock memory, or OB 35, has written
    "L MB 100\nL 0\n==I\nX M {0}\n= M {0}\nL 0\nT MB 100\n",
    "UN M 50.0\nX M {0}\n= M {0}\nCLR\n= M 50.0\n",
    "U M 100.3\n= A {1}\n",
};

// The functions and data blocks that lines name.
struct Named {
  std::string_view name, text;
};
constexpr Named kNamed[] = {
    {"FC 10", R"(FUNCTION FC 10 : VOID
VAR_INPUT
  i : BYTE;
END_VAR
VAR_OUTPUT
  q : BYTE;
END_VAR
BEGIN
L #i
T #q
END_FUNCTION
)"},
    {"FC 11", R"(FUNCTION FC 11 : VOID
VAR_INPUT
  t : TIMER;
END_VAR
VAR_OUTPUT
  w : WORD;
END_VAR
BEGIN
LC #t
T #w
END_FUNCTION
)"},
    {"FC 12", R"(FUNCTION FC 12 : VOID
VAR_INPUT
  p : ANY;
END_VAR
BEGIN
L P##p
LAR1
L D [AR1,P#6.0]
LAR1
L B [AR1,P#18.0]
T MB 70
END_FUNCTION
)"},
    {"DB 10", "DATA_BLOCK DB 10\nSFB 4\nBEGIN\nEND_DATA_BLOCK\n"},
    {"DB 11", "DATA_BLOCK DB 11\nSFB 3\nBEGIN\nEND_DATA_BLOCK\n"},
    {"DB 12", "DATA_BLOCK DB 12\nSFB 5\nBEGIN\nEND_DATA_BLOCK\n"},
    {"DB 13", "DATA_BLOCK DB 13\nSFB 0\nBEGIN\nEND_DATA_BLOCK\n"},
};

class Writer {
 public:
  explicit Writer(std::uint32_t seed) : random_(seed) {}
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }

  std::string lines(std::uint32_t most) {
    std::string text;
    for (std::uint32_t i = 0, count = 1 + below(most); i < count; ++i)
      text += fmt::format(fmt::runtime(kLines[below(std::size(kLines))]), bit(), bit(), below(4),
                          10 * (1 + below(12)), 20 + 2 * below(8), fmt::format("m{}", labels_++));
    return text;
  }

 private:
  std::string bit() { return fmt::format("{}.{}", below(2), below(4)); }

  std::mt19937 random_;
  int labels_ = 0;
};

// With the local data that the lines name.
std::string block(std::string_view head, const std::string& lines) {
  constexpr std::string_view kLocal =
      "VAR_TEMP\nstart : ARRAY[0..19] OF BYTE;\nstamp : DATE_AND_TIME;\ntick : BYTE;\n"
      "rest : ARRAY[0..29] OF BYTE;\nEND_VAR";
  return fmt::format("{}\n{}\nBEGIN\n{}END_ORGANIZATION_BLOCK\n", head, kLocal, lines);
}

std::string namedIn(const std::string& text) {
  std::string blocks =
      "DATA_BLOCK DB 1\nSTRUCT\na : ARRAY[0..9] OF BYTE;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  for (const Named& one : kNamed)
    if (text.find(one.name) != std::string::npos) blocks += one.text;
  return blocks;
}

}  // namespace

std::string quietProgram(std::uint32_t seed) {
  Writer writer(seed);
  std::string text = block("ORGANIZATION_BLOCK OB 1", writer.lines(6));
  if (writer.below(4) == 0)
    text += block("ORGANIZATION_BLOCK OB 35", "SET\n= M 50.0\n" + writer.lines(2));
  if (writer.below(4) == 0) text += block("ORGANIZATION_BLOCK OB 121", "");
  if (writer.below(4) == 0) text += block("ORGANIZATION_BLOCK OB 122", "");
  if (writer.below(8) == 0) text += block("ORGANIZATION_BLOCK OB 85", "");
  text += block("ORGANIZATION_BLOCK OB 20", "L MW 36\n+ 1\nT MW 36\n");
  return namedIn(text) + text;
}

}  // namespace merker::differential
