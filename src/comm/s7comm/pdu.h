// An S7 PDU: header, parameters, data.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "s7comm/error.h"

namespace merker::s7comm {

using Bytes = std::vector<std::uint8_t>;
using View = std::span<const std::uint8_t>;

enum class PduType : std::uint8_t { Job = 1, Acknowledge = 2, Answer = 3, Userdata = 7 };

struct Pdu {
  PduType type = PduType::Job;
  std::uint16_t reference = 0;  // of whoever asked; it comes back as it was
  Error error = Error::None;    // of acknowledgements and answers
  View parameters{}, data{};    // in the bytes that were read
};

constexpr std::size_t kHeader = 10, kAnswerHeader = 12;

// Nothing: the bytes are no S7 PDU, or its lengths go beyond them. Octets behind it do not count.
std::optional<Pdu> readPdu(View bytes);
Bytes writePdu(const Pdu& pdu);

}  // namespace merker::s7comm
