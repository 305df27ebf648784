#include "rig.h"

#include <fmt/format.h>

#include "nc/plc_memory.h"
#include "step5/compiler.h"

namespace merker::nc {

bool Rig::start(const std::string& listing) {
  std::vector<source::SourceFile> files;
  files.emplace_back("t.s5", listing);
  auto compiled = step5::compile(files, false);
  for (const Problem& problem : compiled.problems.list())
    EXPECT_TRUE(compiled.ok()) << problem.position.line << ": " << problem.message << "\n"
                               << listing;
  options.program = std::move(compiled.program);
  options.macros = &macros;
  plc.emplace(options);
  return plc->coldStart();
}

std::string Rig::stop() {
  const auto picture = plc->programmer().stopPicture();
  if (!picture) return "";
  const auto& stack = picture->interrupt;
  const unsigned number = plc->operatingSystem().record().fineCode().number;
  if (number != 0x6114) return fmt::format("{:X}", number);
  EXPECT_NE(findMacroError(stack.akku1, stack.akku2), nullptr);
  return fmt::format("{}/{}", stack.akku1, stack.akku2);
}

unsigned Rig::flagWord(unsigned byte) const { return nc::flagWord(plc->machine(), byte); }
void Rig::setFlagWord(unsigned byte, unsigned value) { nc::setFlagWord(machine(), byte, value); }

std::uint16_t& Rig::word(std::uint16_t block, unsigned number) {
  return dataBlock(machine(), block)[number];
}

unsigned Rig::interfaceByte(unsigned n) {
  const unsigned both = word(36, (n - 1) / 2);
  return n % 2 == 1 ? both >> 8 : both & 0xFF;
}

std::string Call::text(const std::string& jump) const {
  std::string six = type;
  six.resize(6, ' ');
  const auto two = [&](std::size_t at) { return six.substr(at, 2); };
  return fmt::format(
      ":{} FB {}\nNAME :{}\n{} : {}\nNSBY : {}\nANZ : KF {:+}\nDTY1 : KC {}\nDTY2 : KC {}\n"
      "DTY3 : KC {}\nWER1 : KF {:+}\nWER2 : KF {:+}\nWER3 : KF {:+}\nZFPN : KC {}\n{} : KY {}\n",
      jump, macro, macro == 61 ? "NCD-LESE" : "NCD-SCHR", macro == 61 ? "LESE" : "SCHR", signal,
      byte, count, two(0), two(2), two(4), where[0], where[1], where[2], format,
      macro == 61 ? "ZIEL" : "QUEL", place);
}

std::string dataBlock(unsigned number, unsigned words) {
  std::string text = fmt::format("DB {}\n", number);
  for (unsigned i = 0; i < words; ++i) text += fmt::format("{} : KH = 0000;\n", i);
  return text + "\n";
}

std::string cyclic(const std::string& body) {
  return dataBlock(10, 40) + "OB 1\n" + body + ":BE\n";
}

JobRig::JobRig(const Call& call, const MacroOptions& with) : Rig(with) {
  EXPECT_TRUE(start(cyclic(call.text())));
}

std::string JobRig::run() {
  machine().flags[100] = 1;
  cycles(3);
  const HandshakeBits bits;
  if (stopped()) return stop();
  EXPECT_EQ(interfaceByte(1) >> bits.done & 1, 1u);
  return interfaceByte(1) >> bits.error & 1 ? "FEHLER" : "";
}

}  // namespace merker::nc
