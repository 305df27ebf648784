// Group 1: every request is a job of the CPU, which gives it a number.
#include "s7comm/userdata.h"

namespace merker::s7comm {
namespace {

// A long one is answered in parts, under the number of its parts.
void answerTest(const Request& request, const TestAnswer& answer) {
  if (answer.error != Error::None) return request.refuse(answer.error);
  Bytes octets = testOctets(answer.data);
  const bool whole = octets.size() + kUserdataOverhead <= request.job.pdu();
  whole ? request.whole(octets) : request.answer(std::move(octets));
}

}  // namespace

void serveTest(const Request& request) {
  TestRequest test{.function = static_cast<TestFunction>(request.subfunction),
                   .password = request.job.password()};
  if (const Error error = readTest(request.data, test); error != Error::None)
    return request.refuse(error);
  request.job.plc().test(std::move(test), request.job.outlet(),
                         [begun = request.begun()](const TestAnswer& answer) {
                           Request named = begun;
                           named.sequence = answer.number;
                           answerTest(named, answer);
                           begun.ended();
                         });
}

}  // namespace merker::s7comm
