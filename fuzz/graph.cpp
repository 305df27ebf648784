// KOP and FUP: the networks of any machine code open or are refused with a statement of theirs;
// what opens gives its bytes back and can be said. The first byte says how long networks are.
#include "graph/fup.h"
#include "graph/kop.h"
#include "graph/read.h"
#include "graph/sentence.h"
#include "graph/write.h"
#include "graph7/network_code.h"
#include "graph7/rules.h"
#include "harness.h"

using namespace merker;

namespace {

constexpr std::size_t kLongest = 64 << 10;  // bytes, more than any block has

block::Block blockOf(std::span<const std::uint8_t> code, std::size_t networkBytes) {
  block::Block block;
  block.id = {BlockKind::FB, 1};
  block.code.assign(code.begin(), code.end());
  for (std::size_t at = 0; at < code.size(); at += networkBytes)
    block.networks.push_back({static_cast<std::uint32_t>(at), ""});
  return block;
}

void readAndWrite(const block::Block& block, const graph7::NetworkCode& code) {
  const auto network = graph::read(code.statements, graph7::rules());
  if (!network) {
    fuzz::require(network.error().statement < code.statements.size(),
                  "a refusal names a statement of the network");
    return;
  }
  const auto bytes = graph7::encode(graph::write(*network, graph7::rules()));
  fuzz::require(bytes && std::equal(bytes->begin(), bytes->end(), block.code.begin() + code.begin,
                                    block.code.begin() + code.end),
                "a network gives its bytes back");
  for (const graph::Language language : {graph::Language::German, graph::Language::English}) {
    (void)graph::sentences(*network, language, language);
    const graph::Style style{language};
    for (const graph::Picture& picture :
         {graph::kop(*network, style), graph::fup(*network, style)}) {
      (void)graph::toText(picture);
      (void)graph::toSvg(picture, "network");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2 || size > kLongest) return 0;
  const std::size_t words = data[0] == 0 ? size : data[0];
  const block::Block block = blockOf({data + 1, (size - 1) / 2 * 2}, words * 2);
  const awl::Names names(block);
  const awl::Blocks nothing = [](BlockId) { return static_cast<const block::Block*>(nullptr); };
  for (const graph7::NetworkCode& code : graph7::networks(block, names, nothing, Mnemonics::German))
    readAndWrite(block, code);
  return 0;
}
