// Group 1: every request is a job of the CPU, which gives it a number.
#include "s7comm/userdata.h"

namespace merker::s7comm {

void serveTest(const Request& request) {
  TestRequest test{.function = static_cast<TestFunction>(request.subfunction),
                   .password = request.job.password()};
  if (const Error error = readTest(request.data, test); error != Error::None)
    return request.refuse(error);
  request.job.plc().test(std::move(test), request.job.outlet(),
                         [begun = request.begun()](const TestAnswer& answer) {
                           Request named = begun;
                           named.sequence = answer.number;
                           answer.error == Error::None ? named.whole(testOctets(answer.data))
                                                       : named.refuse(answer.error);
                           begun.ended();
                         });
}

}  // namespace merker::s7comm
