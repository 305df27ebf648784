// The memory of a program as blocks of S7 communication send it and receive into it: SD_i, RD_i,
// ADDR_i.
#pragma once

#include "s7comm/partner_job.h"
#include "system/arguments.h"

namespace merker::system {

// Whether a parameter has been given at all.
constexpr bool isNil(const AnyPointer& where) { return where.type == TypeCode::Void; }

// What stands there, of elementary types; a bit is one octet.
struct Taken {
  s7comm::PartnerStatus status = s7comm::PartnerStatus::Done;  // else there are none
  s7comm::Bytes octets{};
};
Taken takeValue(Arguments& a, const AnyPointer& where);
// Whether octets can be received there: else why not.
s7comm::PartnerStatus receivableAt(Arguments& a, const AnyPointer& where);
// So many octets from there on; none if it has fewer, or another length than `exact` asks for.
s7comm::PartnerStatus storeValue(Arguments& a, const AnyPointer& where, s7comm::View octets,
                                 bool exact);
// The unit of its length in the data of a PDU.
s7comm::DataUnit unitOf(const AnyPointer& where);
// The same place in the partner; nothing: it can be none there.
std::optional<s7comm::AnyItem> itemOf(const AnyPointer& where);

}  // namespace merker::system
