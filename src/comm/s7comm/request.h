// The side that asks: PDUs of requests, and what their answers say.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "s7comm/item.h"
#include "s7comm/session.h"

namespace merker::s7comm {

Bytes setupRequest(std::uint16_t reference, const Offer& wanted);
Bytes readRequest(std::uint16_t reference, std::span<const AnyItem> items);
// A value for each item, as many octets as it has.
Bytes writeRequest(std::uint16_t reference, std::span<const AnyItem> items,
                   std::span<const Bytes> values);

// Nothing: this is no such answer, or an error is all it has.
std::optional<Offer> setupAnswer(const Pdu& answer);
std::optional<std::vector<Value>> readAnswer(const Pdu& answer);
std::optional<std::vector<ItemCode>> writeAnswer(const Pdu& answer);

}  // namespace merker::s7comm
