// USEND on the wire: one PDU for all its areas, which nobody answers (Wireshark's dissector of S7
// communication; docs/compatibility.md).
#pragma once

#include <optional>
#include <span>

#include "s7comm/partner_job.h"
#include "s7comm/pdu.h"

namespace merker::s7comm {

bool isNotice(const Pdu& pdu);
Bytes writeNotice(std::uint16_t reference, std::uint32_t rid, std::span<const SentArea> areas);
// Nothing: its lengths are wrong.
std::optional<Notice> readNotice(const Pdu& pdu);

}  // namespace merker::s7comm
