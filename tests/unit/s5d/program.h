#pragma once

#include <gtest/gtest.h>

#include "s5d/program.h"
#include "step5/compiler.h"

namespace merker::s5d {

inline mc5::Program programOf(const std::string& text) {
  const step5::Compilation c = step5::compile({source::SourceFile("t.s5", text)}, false);
  for (const Problem& p : c.problems.list())
    if (p.severity() == Severity::Error) ADD_FAILURE() << p.name() << " line " << p.position.line;
  return c.program;
}

inline std::vector<std::uint8_t> fileOf(const std::string& text) {
  return writeProgram(programOf(text), "TEST", Encoding::Cp437);
}

// The program as a listing, after it was an S5D file.
inline std::string cameBack(const std::string& text, Encoding codePage = Encoding::Cp437) {
  const auto file = writeProgram(programOf(text), "TEST", codePage);
  return step5::listing(readProgram(file, codePage).program);
}

}  // namespace merker::s5d
