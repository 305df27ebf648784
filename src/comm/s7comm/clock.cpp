// The clock of the PLC: 00, 19h, then DATE_AND_TIME.
#include <algorithm>

#include "s7comm/userdata.h"

namespace merker::s7comm {
namespace {

constexpr std::size_t kClockOctets = 10;

}  // namespace

void serveReadClock(const Request& request) {
  request.job.plc().clock([begun = request.begun()](const std::optional<ClockTime>& time) {
    if (time) {
      Bytes octets = {0, 0x19};
      octets.insert(octets.end(), time->begin(), time->end());
      begun.answer(std::move(octets));
    } else {
      begun.refuse(Error::FunctionNotAvailable);
    }
    begun.ended();
  });
}

void serveSetClock(const Request& request) {
  if (request.data.size() != kClockOctets) return request.refuse(Error::WrongTime);
  ClockTime time{};
  std::copy_n(request.data.begin() + 2, time.size(), time.begin());
  request.job.plc().setClock(time, request.job.password(), [begun = request.begun()](Error error) {
    error == Error::None ? begun.done() : begun.refuse(error);
    begun.ended();
  });
}

}  // namespace merker::s7comm
