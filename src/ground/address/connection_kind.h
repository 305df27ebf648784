// How the two ends of a configured connection speak with each other.
#pragma once

#include <cstdint>

namespace merker {

enum class ConnectionKind : std::uint8_t {
  S7,        // S7 communication: BSEND, GET …
  Tcp,       // of a CP, for AG_SEND and AG_RECV: a stream of bytes (RFC 793)
  IsoOnTcp,  // the same with blocks of data (RFC 1006)
  Udp,       // datagrams (RFC 768)
  Mail       // of a CP 343-1 IT, for AG_SEND: each job is an e-mail (RFC 5321)
};

}  // namespace merker
