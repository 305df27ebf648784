#include "project/address_check.h"

#include <fmt/format.h>

#include "base/text.h"
#include "mc7/disassembly.h"
#include "mc7/instruction.h"
#include "project/project.h"

namespace merker::project {
namespace {

struct Access {
  Area area;   // Input, Output, Peripheral
  bool write;  // of the periphery: PA
  std::uint32_t byte, count;
  std::string text;  // as in the source, "PEW 256"
};

std::optional<Access> accessOf(std::span<const std::uint8_t> bytes) {
  const auto decoded = mc7::decode(bytes);
  if (!decoded || decoded->instruction.operand.kind != mc7::OperandKind::Memory)
    return std::nullopt;
  const mc7::Operand& operand = decoded->instruction.operand;
  const bool periphery = operand.area == Area::Peripheral;
  if (!periphery && operand.area != Area::Input && operand.area != Area::Output)
    return std::nullopt;
  const std::string whole = mc7::text(decoded->instruction, Mnemonics::German);
  const auto blank = whole.find(' ');
  return Access{operand.area, decoded->instruction.operation == mc7::Operation::TRANSFER,
                operand.value / 8, byteCount(operand.width),
                blank == std::string::npos ? whole : std::string(trim(whole.substr(blank)))};
}

bool answers(const io::Configuration& hardware, const Access& access) {
  const bool output =
      access.area == Area::Output || (access.area == Area::Peripheral && access.write);
  for (std::uint32_t byte = access.byte; byte < access.byte + access.count; ++byte)
    if (!(output ? hardware.hasOutput(byte) : hardware.hasInput(byte))) return false;
  return true;
}

bool isError(AddressCheck check, Area area) {
  return check == AddressCheck::Error ||
         (check == AddressCheck::Standard && area == Area::Peripheral);
}

// The whole line, without the blanks around it.
Position place(const Project& project, const std::string& name, std::uint32_t line) {
  Position position{name, line, 1};
  const source::SourceFile* file = project.file(name);
  if (file == nullptr || line == 0 || line > file->lineCount()) return position;
  const std::string_view text = file->line(line), words = trim(text);
  position.column = static_cast<std::uint32_t>(words.data() - text.data()) + 1;
  position.length = static_cast<std::uint32_t>(std::max<std::size_t>(characterCount(words), 1));
  return position;
}

}  // namespace

void checkAddresses(const Project& project, const block::Program& program, Problems& problems) {
  if (!project.hardware || project.addressCheck == AddressCheck::Off) return;
  for (const auto& [id, block] : program) {
    std::uint32_t last = 0;
    for (const mc7::Line& line : mc7::disassemble(block.code, Mnemonics::German)) {
      if (line.kind != mc7::LineKind::Instruction) continue;
      const auto access = accessOf(line.bytes);
      const std::uint32_t number = block.line(line.offset);
      if (!access || number == last || answers(*project.hardware, *access)) continue;
      last = number;  // a CALL becomes several instructions of one line
      problems.add(
          isError(project.addressCheck, access->area) ? ProblemCode::P0747 : ProblemCode::P0748,
          place(project, block.file, number), access->text);
    }
  }
}

}  // namespace merker::project
