// The rows of a table of src/ once more as text, in a file beside the test: a figure that changes
// by mistake is seen, one that changes on purpose changes in both places (MERKER_ROWS=write writes
// the file; the change is then for reading against its source).
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace merker::test {

inline void expectRows(const std::string& file, const std::string& rows) {
  const std::string path = MERKER_SOURCE_DIR "/tests/unit/" + file;
  if (std::getenv("MERKER_ROWS") != nullptr) std::ofstream(path) << rows;
  std::ifstream written(path);
  ASSERT_TRUE(written) << path;
  std::istringstream now(rows);
  std::string expected, actual;
  while (std::getline(written, expected)) {
    ASSERT_TRUE(std::getline(now, actual)) << "missing: " << expected;
    EXPECT_EQ(actual, expected) << file;
  }
  EXPECT_FALSE(std::getline(now, actual)) << "not in " << file << ": " << actual;
}

}  // namespace merker::test
