// Services of programming devices: a group, a subfunction, octets there and back.
#pragma once

#include "connection.h"

namespace merker::s7client {

// Of all parts of the answer. 0, or an error of merker_s7.h; `refusal` is the CPU's own then.
int askUserdata(Connection& connection, int group, int subfunction, s7comm::View octets,
                s7comm::Bytes& answer, s7comm::Error* refusal = nullptr);

}  // namespace merker::s7client
