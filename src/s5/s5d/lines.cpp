#include "s5d/lines.h"

#include <span>

#include "mc5/instruction.h"
#include "mc5/parameter_list.h"
#include "step5/call_list.h"

namespace merker::s5d {
namespace {

constexpr std::uint16_t kNetworkEnd = 0x10FF;  // BLD 255

class Lines {
 public:
  Lines(const mc5::Program& program, const mc5::Block& block) : program_(program), block_(block) {}

  std::vector<CommentLine> read() {
    const std::span<const std::uint16_t> code(block_.words);
    for (std::uint32_t at = 0; at < code.size();) {
      const auto decoded = mc5::decode(code.subspan(at));
      const std::uint32_t next = at + (decoded ? decoded->words : 1);
      if (code[at] == kNetworkEnd) {
        begin(next);
        at = next;
        continue;
      }
      add(at);
      at = decoded ? parameters(decoded->instruction, next) : next;
    }
    return std::move(result_);
  }

  std::vector<std::uint32_t> starts{0};

 private:
  void begin(std::uint32_t at) {
    starts.push_back(at);
    ++network_;
    line_ = 0;
  }

  void add(std::uint32_t at) { result_.push_back({at, network_, ++line_}); }

  // Of a block that is not there each word of the list is a line.
  std::uint32_t parameters(const mc5::Instruction& call, std::uint32_t next) {
    const auto list = step5::callList(program_, block_, call, next);
    const auto end =
        mc5::callsFunctionBlock(call) ? mc5::endOfList(block_.words, next) : std::nullopt;
    if (end) add(next + 1);  // NAME
    if (!list) {
      for (std::uint32_t at = next + 1; end && at < *end; ++at) add(at);
      return end.value_or(next);
    }
    for (const step5::ListedParameter& parameter : list->parameters) add(parameter.offset);
    return list->end;
  }

  const mc5::Program& program_;
  const mc5::Block& block_;
  std::vector<CommentLine> result_;
  std::uint32_t network_ = 1, line_ = 0;
};

}  // namespace

std::vector<CommentLine> commentLines(const mc5::Program& program, const mc5::Block& block) {
  if (block.id.type != mc5::BlockType::Db) return Lines(program, block).read();
  std::vector<CommentLine> lines;
  for (std::uint32_t at = 0; at < block.words.size(); ++at) lines.push_back({at, 0, at});
  return lines;
}

std::vector<std::uint32_t> networkStarts(const mc5::Program& program, const mc5::Block& block) {
  Lines lines(program, block);
  (void)lines.read();
  return std::move(lines.starts);
}

}  // namespace merker::s5d
