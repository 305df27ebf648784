#include "list_view.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "graph/sentence.h"
#include "graph7/rules.h"

namespace merker::app {
namespace {

using diagram::BlockDiagram;
using diagram::NetworkDiagram;
using diagram::Shown;
using diagram::View;

constexpr std::string_view kViews[] = {"KOP", "FUP", "AWL"};

std::string_view name(View view) { return kViews[static_cast<std::size_t>(view)]; }

// What stands behind the title where it is not what was asked for.
std::string remark(const Shown& shown, View wanted) {
  if (shown.view == View::Awl) return fmt::format("AWL, {}", shown.why);
  if (shown.view != wanted)
    return fmt::format("{}, which {} cannot show", name(shown.view), name(wanted));
  return {};
}

void print(const NetworkDiagram& network, const Shown& shown, View wanted) {
  std::cout << fmt::format("Network {}: {}\n", network.number, network.title);
  if (const std::string text = remark(shown, wanted); !text.empty())
    std::cout << fmt::format("({})\n", text);
  if (!network.label.empty()) std::cout << network.label << ":\n";
  for (const std::string& line : shown.lines)
    std::cout << (shown.view == View::Awl ? "  " : "") << line << '\n';
  std::cout << '\n';
}

using Counts = std::array<std::size_t, 3>;

void print(const Counts& counts) {
  const std::size_t all = counts[0] + counts[1] + counts[2];
  std::string text = fmt::format("{} network{}", all, all == 1 ? "" : "s");
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) text += fmt::format(", {} {}", counts[i], kViews[i]);
  std::cout << text << '\n';
}

nlohmann::json drawnJson(const BlockDiagram& block, const NetworkDiagram& network, View wanted) {
  const Shown shown = diagram::asText(network, wanted);
  nlohmann::json out = {{"block", block.name},
                        {"network", network.number},
                        {"title", network.title},
                        {"view", name(shown.view)},
                        {"lines", shown.lines}};
  if (shown.view == View::Awl) {
    out["reason"] = shown.why;
    return out;
  }
  const graph::Language language = graph7::namesIn(network.mnemonics);
  out["sentences"] = graph::sentences(*network.network, language, language);
  return out;
}

}  // namespace

void printView(const Build& build, View view, const diagram::Options& options) {
  Counts counts{};
  for (const BlockDiagram& block : diagram::diagrams(build, options)) {
    std::cout << fmt::format("{}{}\n\n", block.name,
                             block.symbol.empty() ? "" : fmt::format(" \"{}\"", block.symbol));
    for (const NetworkDiagram& network : block.networks) {
      const Shown shown = diagram::asText(network, view);
      print(network, shown, view);
      ++counts[static_cast<std::size_t>(shown.view)];
    }
  }
  print(counts);
}

nlohmann::json viewToJson(const Build& build, View view, const diagram::Options& options) {
  nlohmann::json out = nlohmann::json::array();
  for (const BlockDiagram& block : diagram::diagrams(build, options))
    for (const NetworkDiagram& network : block.networks)
      out.push_back(drawnJson(block, network, view));
  return out;
}

int writeView(const Build& build, View view, const diagram::Options& options,
              const std::string& path) {
  const auto picture = diagram::drawAll(diagram::diagrams(build, options), view);
  std::ofstream file(path, std::ios::binary);
  file << graph::toSvg(picture, name(view));
  file.close();
  if (file) return exitCode(build);
  std::cerr << "merker list: cannot write " << path << ": " << std::strerror(errno) << '\n';
  return 4;
}

}  // namespace merker::app
