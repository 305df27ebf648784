// What all fuzz targets share. Each target is one file with LLVMFuzzerTestOneInput; libFuzzer or
// replay.cpp calls it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace merker::fuzz {

inline std::string_view text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// A property that every input must have; a fuzzer reports an abort with its input.
inline void require(bool holds, const char* property) {
  if (holds) return;
  std::fprintf(stderr, "not true: %s\n", property);
  std::abort();
}

}  // namespace merker::fuzz
