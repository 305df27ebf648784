// MC5 code: any words can be listed, every instruction in them codes back to its words, and the PLC
// of SINUMERIK 810/820 survives them as a program: the worst is a STOP.
#include <algorithm>

#include "harness.h"
#include "mc5/encoding.h"
#include "softplc/plc.h"

using namespace merker;

namespace {

std::vector<std::uint16_t> wordsOf(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint16_t> words;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
    words.push_back(static_cast<std::uint16_t>(bytes[i] << 8 | bytes[i + 1]));
  return words;
}

void decodeAndEncode(std::span<const std::uint16_t> code) {
  for (std::size_t i = 0; i < code.size(); ++i) {
    const auto decoded = mc5::decode(code.subspan(i));
    if (!decoded) continue;
    (void)mc5::text(decoded->instruction);
    std::vector<std::uint16_t> words;
    const bool coded = mc5::encode(*decoded->encoding, decoded->instruction.operand, words);
    fuzz::require(coded && std::equal(words.begin(), words.end(),
                                      code.begin() + static_cast<std::ptrdiff_t>(i)),
                  "an instruction codes back to its words");
  }
}

// OB 1, OB 2 and FB 1 are parts of the code, DB 10 the beginning of it.
mc5::Program programOf(std::span<const std::uint16_t> code) {
  mc5::Program program;
  const auto add = [&program](mc5::BlockType type, std::uint16_t number,
                              std::span<const std::uint16_t> words) {
    mc5::Block block;
    block.id = {type, number};
    block.words.assign(words.begin(), words.end());
    if (type != mc5::BlockType::Db) block.words.push_back(0x6500);
    program[block.id] = std::move(block);
  };
  const std::size_t third = code.size() / 3;
  add(mc5::BlockType::Ob, 1, code.first(third));
  add(mc5::BlockType::Ob, 2, code.subspan(third, third));
  add(mc5::BlockType::Fb, 1, code.subspan(2 * third));
  add(mc5::BlockType::Db, 10, code.first(std::min<std::size_t>(code.size(), 16)));
  return program;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kLongest = 2000;  // words
  const auto words = wordsOf({data, std::min(size, 2 * kLongest)});
  decodeAndEncode(words);
  sinumerik::Options options;
  options.program = programOf(words);
  options.machineData = sinumerik::MachineData::standard(true);
  options.machineData->setBit({2003, 4}, true);  // LIR, TIR, TNB, TNW
  sinumerik::Plc plc(options);
  plc.coldStart();
  address::Reference alarmByte;
  alarmByte.operand = address::memory(Area::Input, Width::Byte, bitAddress(7));
  plc.write(alarmByte, 0xFF);
  plc.advanceTo(Instant{} + Duration::milliseconds(200));
  const bool stopped = plc.mode() == sinumerik::Mode::Stop;
  fuzz::require(stopped == !plc.stopReason().empty(), "a STOP has its reason");
  return 0;
}
