// What a call of FB 61 or FB 62 asks for: the parameter list, or in its place the transfer flags
// (S5-FM-24, -29, -30).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "nc/data_type.h"
#include "softplc/machine.h"

namespace merker::nc {

struct Request {
  bool write = false;                     // FB 62
  std::optional<unsigned> interfaceByte;  // nothing: none of the 65
  int count = 0;                          // ANZ
  std::string type;                       // DTY1 … DTY3 without blanks behind
  Where where{};                          // WER1 … WER3
  std::uint16_t format = 0;               // ZFPN
  std::uint16_t place = 0;                // ZIEL, QUEL
  bool operator==(const Request&) const = default;
};

Request readRequest(const sinumerik::Machine& machine, bool write,
                    std::span<const std::uint16_t> parameters);

// LESE, SCHR: the list holds the code of "U M 0.1". Nothing if it is no bit.
std::optional<bool> readSignal(sinumerik::Machine& machine, std::uint16_t code);

}  // namespace merker::nc
