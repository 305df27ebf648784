// Memory reset by a programming device, one of its test functions.
#include "s7comm/userdata.h"

namespace merker::s7comm {

void serveMemoryReset(const Request& request) {
  request.job.plc().control(
      Control::MemoryReset, request.job.password(), [begun = request.begun()](Controlled how) {
        if (how == Controlled::Done)
          begun.done();
        else
          begun.refuse(how == Controlled::Protected ? Error::TestProtected : Error::NotInThisMode);
        begun.ended();
      });
}

}  // namespace merker::s7comm
