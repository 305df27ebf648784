// The state that compiled STEP 5 works on, and where it lies in it.
#pragma once

#include <cstdint>

#include "jit/native.h"
#include "sinumerik/machine.h"

namespace merker::cnc {

// The registers of the running level and where the rest stands.
struct Seat {
  Instant clock, horizon;
  std::uint64_t instructions = 0;
  void* images = nullptr;
  std::uint32_t akku1 = 0, akku2 = 0, unused = 0;
  sinumerik::Displays displays;
  void* data = nullptr;
  std::uint32_t readable = 0, writable = 0;  // bytes
  void* cells = nullptr;
};

jit::Layout layoutOf(const sinumerik::Machine& m);
void takeData(Seat& seat, sinumerik::Machine& m);  // the open data block of the running block
std::uint32_t bytesBetween(const void* from, const void* to);

}  // namespace merker::cnc
