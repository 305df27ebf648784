// A program of STEP 5 for the functions that need no running PLC.
#pragma once

#include <gtest/gtest.h>

#include "step5/compiler.h"

namespace merker::monitor::test {

inline mc5::Program listing(const std::string& text) {
  std::vector<source::SourceFile> files;
  files.emplace_back("press.s5", text);
  auto result = step5::compile(files, false);
  for (const Problem& problem : result.problems.list())
    if (problem.severity() == Severity::Error)
      ADD_FAILURE() << problem.position.line << ": " << problem.message;
  return std::move(result.program);
}

}  // namespace merker::monitor::test
