// Calls in calls: blocks so short that they stand in the regions of their callers, the innermost of
// which change what their callers get back (data blocks, AR2) and may leave by a jump.
#include <fmt/format.h>

#include <random>
#include <span>
#include <string>
#include <string_view>

#include "case.h"
#include "mc7/encoding.h"
#include "source.h"
#include "stand.h"

namespace merker::differential {
namespace {

constexpr std::uint32_t kDeepest = 4;  // calls in calls
constexpr std::uint32_t kOwnData = 2;  // so many data blocks may belong to function blocks
constexpr std::uint32_t kConditions = 6;

constexpr std::string_view kChanges[] = {"AUF DB 1;",         "AUF DB 2;",      "AUF DI 1;",
                                         "AUF DI 2;",         "TDB;",           "LAR2 P#M 60.0;",
                                         "+AR2 P#2.0;",       "LAR1 P#M 64.0;", "TAR;",
                                         "L P#M 62.0; LAR2;", "LAR2 P#DBX 4.0;"};

// What shows which data blocks are open and where the address registers point, in words of M.
constexpr std::string_view kLooks[] = {"L MW 42; L DBNO; +I; T MW 42;",
                                       "L MW 44; L DINO; +I; T MW 44;",
                                       "TAR2; L MD 46; +D; T MD 46;",
                                       "TAR1; L MD 50; XOD; T MD 50;",
                                       "L DBW 0; L MW 54; +I; T MW 54;",
                                       "L DIW 6; L MW 54; XOW; T MW 54;",
                                       "L MW 56; + 1; T MW 56;",
                                       "L MW 56; T DBW 8;",
                                       "L MW 56; T DIW 10;",
                                       "L MW 56; T W [AR2,P#0.0];",
                                       "L #t; + 1; T #t;"};

class Writer {
 public:
  explicit Writer(std::uint32_t seed) : random_(seed) { chooseBlocks(); }

  std::string text() {
    std::string text;
    for (std::uint32_t number = last_; number > 0; --number) text += block(number);
    for (std::uint32_t data = 1; data <= 3; ++data) text = dataBlock(data) + text;
    return text + first();
  }

 private:
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
  std::string one(std::span<const std::string_view> of) {
    return std::string(of[below(static_cast<std::uint32_t>(of.size()))]);
  }

  void chooseBlocks() {
    last_ = 1 + below(kDeepest);
    for (std::uint32_t& function : owners_)
      if (below(2) == 0) function = 1 + below(last_);
  }
  // The data block of this function block; 0: it is none.
  std::uint32_t dataOf(std::uint32_t number) const {
    for (std::uint32_t i = 0; i < kOwnData; ++i)
      if (number != 0 && owners_[i] == number) return i + 1;
    return 0;
  }

  std::string condition() { return fmt::format("U M 40.{}; ", below(kConditions)); }

  // What stands in block `number`, within so many jumps and loops.
  std::string lines(std::uint32_t number, std::uint32_t most, std::uint32_t within = 0) {
    std::string text;
    for (std::uint32_t i = below(most); i > 0; --i) text += line(number, within) + "\n";
    return text;
  }
  std::string line(std::uint32_t number, std::uint32_t within) {
    switch (below(10)) {
      case 0:
      case 1:
      case 2:
        return one(kChanges);
      case 3:
      case 4:
        return within < 2 ? jump(number, within) : "NOP 0;";
      case 5:
      case 6:
      case 7:
        return number < last_ ? call(number) : one(kLooks);
      case 8:
        return way(number, within);
      default:
        return one(kLooks);
    }
  }
  std::string jump(std::uint32_t number, std::uint32_t within) {
    const std::string to = fmt::format("m{}", labels_++);
    const char* const operation = below(2) == 0 ? "SPB" : "SPBN";
    const std::string over = lines(number, 3, within + 1);
    return fmt::format("{}{} {}; {}\n{}: NOP 0;", condition(), operation, to, over, to);
  }
  std::string call(std::uint32_t number) {
    const std::uint32_t to = below(3) == 0 ? number + 1 + below(last_ - number) : number + 1;
    if (const std::uint32_t data = dataOf(to); data != 0)
      return fmt::format("CALL FB {}, DB {} (a := MW 56);", to, data);
    if (below(2) == 0) return fmt::format("UC FC {};", to);
    return condition() + fmt::format("CC FC {};", to);
  }
  // Out of the block, or back.
  std::string way(std::uint32_t number, std::uint32_t within) {
    const std::string to = fmt::format("m{}", labels_++);
    if (within == 0 && below(2) == 0) return condition() + "BEB;";
    if (within == 0 && below(3) == 0)
      return fmt::format("{}SPBN {}; BEA;\n{}: NOP 0;", condition(), to, to);
    if (within == 0 && below(2) == 0)
      return fmt::format("L 2;\n{}: T #n; {} L #n; LOOP {};", to, lines(number, 3, 2), to);
    return dataOf(number) != 0 ? "L #a; L #s; +I; T #s;" : one(kLooks);
  }

  std::string block(std::uint32_t number) {
    constexpr std::string_view kBegin =
        "VAR_TEMP\n t : INT;\n n : INT;\nEND_VAR\nBEGIN\nL 0; T #t;\n";
    labels_ = 0;
    const std::string body = lines(number, 7);
    if (dataOf(number) == 0)
      return fmt::format("FUNCTION FC {} : VOID\n{}{}END_FUNCTION\n", number, kBegin, body);
    return fmt::format(
        "FUNCTION_BLOCK FB {}\nVAR_INPUT\n a : INT;\nEND_VAR\nVAR\n s : INT;\n q : ARRAY[0..7] OF "
        "INT;\nEND_VAR\n{}{}END_FUNCTION_BLOCK\n",
        number, kBegin, body);
  }
  std::string dataBlock(std::uint32_t number) const {
    const std::uint32_t owner = number <= kOwnData ? owners_[number - 1] : 0;
    if (dataOf(owner) == number)
      return fmt::format("DATA_BLOCK DB {}\nFB {}\nBEGIN\nEND_DATA_BLOCK\n", number, owner);
    return fmt::format(
        "DATA_BLOCK DB {}\nSTRUCT\n w : ARRAY[0..9] OF INT;\nEND_STRUCT;\nBEGIN\n"
        "END_DATA_BLOCK\n",
        number);
  }

  // OB 1: other conditions in each cycle, and a look at everything behind the calls.
  std::string first() {
    labels_ = 0;
    std::string text =
        "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n i : ARRAY[0..19] OF BYTE;\n t : INT;\n n : "
        "INT;\nEND_VAR\nBEGIN\nL 0; T #t; L MB 40; INC 1; T MB 40;\nAUF DB 1; AUF DI 2; "
        "LAR1 P#M 68.0; LAR2 P#M 70.0;\n";
    text += lines(0, 4);
    text += call(0) + "\n";
    for (const std::string_view look : kLooks) text += fmt::format("{}\n", look);
    text += call(0);
    return text + "\nL DBNO; T MW 72; L DINO; T MW 74; TAR2 MD 76;\nEND_ORGANIZATION_BLOCK\n";
  }

  std::mt19937 random_;
  std::uint32_t last_ = 1, owners_[kOwnData] = {};
  int labels_ = 0;
};

}  // namespace

// The code alone: the data blocks are those of every case.
Case nestedCase(std::uint32_t seed) {
  Case c;
  c.seed = 4 * seed + 1;
  for (const auto& [id, block] : compiledText(Writer(seed).text(), *findModel(c.model)))
    if (id.kind != BlockKind::DB) c.blocks[id] = block.code;
  for (const std::uint16_t ob : {35, 40, 121, 122}) c.blocks[{BlockKind::OB, ob}] = {0x65, 0x00};
  return c;
}

}  // namespace merker::differential
