// Indications on the wire: userdata as its answers are, of type 0, asked for by nobody.
#include "s7comm/data_item.h"
#include "s7comm/session.h"
#include "s7comm/userdata.h"

namespace merker::s7comm {

// One behind the other, as long as the line takes them.
void Session::deliver() {
  while (setUp_ && (!room_ || room_())) {
    const auto one = outlet_->take();
    if (!one) return;
    send_(writeUserdata({.kind = UserdataHead::Kind::Indication,
                         .group = one->group,
                         .subfunction = one->subfunction,
                         .sequence = one->sequence,
                         .error = one->error},
                        0, one->octets));
  }
}

}  // namespace merker::s7comm
