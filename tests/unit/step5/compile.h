#pragma once

#include <gtest/gtest.h>

#include "step5/compiler.h"

namespace merker::step5 {

inline Compilation compileText(const std::string& text, bool checks = false) {
  std::vector<source::SourceFile> files;
  files.emplace_back("t.s5", text);
  return compile(files, checks);
}

// "P1104@3:7 P1115@5:2": codes with line and column.
inline std::string problemsOf(const std::string& text, bool checks = false) {
  const Compilation c = compileText(text, checks);
  std::string list;
  for (const Problem& problem : c.problems.list()) {
    if (!list.empty()) list += ' ';
    list.append(problem.name()).append("@");
    list += std::to_string(problem.position.line) + ":" + std::to_string(problem.position.column);
  }
  return list;
}

inline std::vector<std::uint16_t> words(const Compilation& c, mc5::BlockType type,
                                        std::uint16_t number) {
  const auto found = c.program.find({type, number});
  return found == c.program.end() ? std::vector<std::uint16_t>{} : found->second.words;
}

}  // namespace merker::step5
