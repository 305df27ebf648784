// A program as a listing in the manual's form; compiling it gives the same words.
#include <fmt/format.h>

#include <algorithm>

#include "mc5/constant.h"
#include "mc5/resident_blocks.h"
#include "step5/block_source.h"
#include "step5/compiler.h"
#include "step5/declaration.h"

namespace merker::step5 {
namespace {

using mc5::Block;
using mc5::BlockType;
using mc5::OperandKind;
using mc5::Parameter;

// The operand of a printed instruction: "E 10.3" of "U     E 10.3".
std::string operandOf(const mc5::Instruction& instruction) {
  const std::string text = mc5::text(instruction);
  const std::size_t blank = text.find(' ');
  const std::size_t start = text.find_first_not_of(' ', blank);
  return start == std::string::npos ? std::string() : text.substr(start);
}

std::string actualText(const Parameter& parameter, std::span<const std::uint16_t> words) {
  if (parameter.kind == mc5::ParameterKind::Data) {
    std::uint32_t value = words[0];
    if (parameter.format == mc5::Format::Float) value = value << 16 | words[1];
    return mc5::constantText(
        {.kind = OperandKind::Constant, .format = parameter.format, .value = value});
  }
  const auto decoded = mc5::decode(words.first(1));
  return decoded ? operandOf(decoded->instruction) : fmt::format("KH {:04X}", words[0]);
}

class Printer {
 public:
  Printer(const mc5::Program& program, const Block& block) : program_(program), block_(block) {}

  std::string print() {
    head();
    if (block_.id.type == BlockType::Db)
      data();
    else
      code();
    return std::move(out_);
  }

 private:
  template <typename... Arguments>
  void put(fmt::format_string<Arguments...> pattern, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(out_), pattern, std::forward<Arguments>(arguments)...);
  }

  void head() {
    put("{}", toString(block_.id));
    if (!block_.name.empty()) put("   {}", block_.name);
    if (block_.library != 0) put("   BIB={}", block_.library);
    put("\n");
    for (const Parameter& parameter : block_.parameters) declaration(parameter);
  }

  void declaration(const Parameter& parameter) {
    const std::string type = typeText(parameter);
    put("BEZ  : {:<4}  E/A/D/B/T/Z: {}", parameter.name, type.substr(0, 1));
    const bool data = parameter.kind == mc5::ParameterKind::Data;
    if (type.size() > 2)
      put("  {}: {}", data ? "KM/KH/KY/KC/KT/KZ/KF/KG" : "BI/BY/W/D", type.substr(2));
    put("\n");
  }

  void data() {
    for (std::size_t i = 0; i < block_.words.size(); ++i) {
      const mc5::Format format = i < block_.formats.size() ? block_.formats[i] : mc5::Format::Hex;
      const bool pair = format == mc5::Format::Float && i + 1 < block_.words.size();
      std::uint32_t value = block_.words[i];
      const std::size_t word = i;
      if (pair) value = value << 16 | block_.words[++i];
      const std::string text = mc5::constantText(
          {.kind = OperandKind::Constant, .format = pair ? format : plain(format), .value = value});
      put("{:>5}: {}\n", word, text);
    }
  }

  static mc5::Format plain(mc5::Format format) {
    return format == mc5::Format::Float ? mc5::Format::Hex : format;
  }

  void code() {
    findTargets();
    for (std::uint32_t at = 0; at < block_.words.size();) {
      network(at);
      at = instruction(at);
    }
  }

  void network(std::uint32_t at) {
    for (const mc5::Network& network : block_.networks)
      if (network.offset == at) put("NETZWERK {} {}\n", ++networks_, network.title);
  }

  // BLD 255 in front of a network is written by NETZWERK.
  bool endsNetwork(std::uint32_t at) const {
    if (at == 0 || block_.words[at] != 0x10FF) return false;
    for (const mc5::Network& network : block_.networks)
      if (network.offset == at + 1) return true;
    return false;
  }

  std::uint32_t instruction(std::uint32_t at) {
    if (endsNetwork(at)) return at + 1;
    const auto decoded = mc5::decode(std::span(block_.words).subspan(at));
    const std::string label = targets_.contains(at) ? targets_.at(at) : std::string();
    if (!decoded) {
      put("{:<4} : illegal {:04X}\n", label, block_.words[at]);
      return at + 1;
    }
    put("{:<4} : {}\n", label, statement(at, decoded->instruction));
    const std::uint32_t next = at + decoded->words;
    return callsFb(decoded->instruction) ? list(decoded->instruction, next) : next;
  }

  static bool callsFb(const mc5::Instruction& instruction) {
    return instruction.operand.kind == OperandKind::Block &&
           instruction.operand.block == BlockType::Fb;
  }

  std::string statement(std::uint32_t at, const mc5::Instruction& instruction) const {
    const mc5::Operand& operand = instruction.operand;
    const std::string_view name = mc5::info(instruction.operation).name;
    if (operand.kind == OperandKind::Jump) {
      const std::uint32_t target = at + operand.value;
      if (targets_.contains(target)) return fmt::format("{:<5} ={}", name, targets_.at(target));
    }
    if (operand.kind == OperandKind::Formal) {
      const auto words = parameterWords(block_.parameters);
      for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == operand.value)
          return fmt::format("{:<5} ={}", name, block_.parameters[i].name);
    }
    return mc5::text(instruction);
  }

  const Block* functionBlock(std::uint32_t number) const {
    const auto id = static_cast<std::uint16_t>(number);
    const auto found = program_.find({BlockType::Fb, id});
    return found != program_.end() ? &found->second : mc5::findResident(id);
  }

  // The parameter list behind a call; the jump over it is not shown (S5-FB-06).
  std::uint32_t list(const mc5::Instruction& call, std::uint32_t at) {
    const Block* fb = functionBlock(call.operand.value);
    if (fb == nullptr) return at;
    std::uint32_t count = 0;
    for (const Parameter& parameter : fb->parameters) count += wordCount(parameter);
    const bool jump = at < block_.words.size() && block_.words[at] == (0x2D00u | (count + 1));
    if (!jump || at + 1 + count > block_.words.size()) return at;
    put("NAME : {}\n", fb->name);
    ++at;
    for (const Parameter& parameter : fb->parameters) {
      put("{:<4} : {}\n", parameter.name,
          actualText(parameter, std::span(block_.words).subspan(at)));
      at += wordCount(parameter);
    }
    return at;
  }

  // Labels of the source where there are any, else M001 and so on.
  void findTargets() {
    targets_ = block_.labels;
    std::vector<std::uint32_t> starts;
    for (std::uint32_t at = 0; at < block_.words.size();) {
      starts.push_back(at);
      const auto decoded = mc5::decode(std::span(block_.words).subspan(at));
      at += decoded ? decoded->words : 1;
    }
    for (const std::uint32_t at : starts) target(at, starts);
  }

  void target(std::uint32_t at, const std::vector<std::uint32_t>& starts) {
    const auto decoded = mc5::decode(std::span(block_.words).subspan(at));
    if (!decoded || decoded->instruction.operand.kind != OperandKind::Jump) return;
    const std::uint32_t word = at + decoded->instruction.operand.value;
    if (std::binary_search(starts.begin(), starts.end(), word) && !targets_.contains(word))
      targets_[word] = fmt::format("M{:03}", ++made_);
  }

  const mc5::Program& program_;
  const Block& block_;
  std::string out_;
  std::map<std::uint32_t, std::string> targets_;
  unsigned networks_ = 0, made_ = 0;
};

}  // namespace

std::string listing(const mc5::Program& program) {
  std::string text;
  for (const auto& [id, block] : program) text += Printer(program, block).print() + "\n";
  return text;
}

}  // namespace merker::step5
