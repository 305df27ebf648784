// Userdata: the services of programming devices, by group and subfunction.
#include "base/bytes.h"
#include "s7comm/services.h"

namespace merker::s7comm {
namespace {

// 00 01 12, length, method, type and group, subfunction, sequence number.
constexpr std::size_t kUserdataHead = 8;
constexpr std::uint8_t kAnswerMethod = 0x12, kAnswerType = 0x80, kAnswerLength = 8;

bool isUserdata(View p) {
  return p.size() >= kUserdataHead && p[0] == 0 && p[1] == 1 && p[2] == kAnswerMethod &&
         p.size() - 4 >= p[3] && p[3] >= 4;
}

// No data unit, no more of them, and why.
void refuseUserdata(const Job& job, Error error) {
  const View p = job.parameters;
  Bytes answer = {p[0], p[1], p[2], kAnswerLength, kAnswerMethod};
  answer.insert(answer.end(),
                {static_cast<std::uint8_t>(kAnswerType | (p[5] & 0x0F)), p[6], p[7], 0, 0});
  appendWord(answer, static_cast<std::uint32_t>(error));
  constexpr std::uint8_t kNothing[] = {static_cast<std::uint8_t>(ItemCode::Missing), 0, 0, 0};
  job.userdata(answer, kNothing);
}

}  // namespace

void serveUserdata(const Job& job) {
  if (!isUserdata(job.parameters)) return job.refuse(Error::WrongPduSize);
  refuseUserdata(job, Error::FunctionNotAvailable);
}

}  // namespace merker::s7comm
