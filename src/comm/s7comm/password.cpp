// The password of a connection: 8 characters, filled up with blanks, each changed by the one two
// places before. That hides nothing from anybody who listens.
#include <string>

#include "s7comm/userdata.h"

namespace merker::s7comm {
namespace {

constexpr std::size_t kPasswordOctets = 8;
constexpr std::uint8_t kChange = 0x55;

std::string decoded(View octets) {
  std::string text;
  for (std::size_t i = 0; i < octets.size(); ++i)
    text += static_cast<char>(octets[i] ^ kChange ^ (i < 2 ? 0 : octets[i - 2]));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

void serveEnterPassword(const Request& request) {
  if (request.data.size() != kPasswordOctets) return request.refuse(Error::WrongPassword);
  if (!request.job.password().empty()) return request.refuse(Error::PasswordStands);
  if (!request.job.guard().mayTry()) return request.refuse(Error::WrongPassword);
  const std::string text = decoded(request.data);
  request.job.plc().enter(text, [begun = request.begun(), text](Error error) {
    if (error == Error::None) begun.job.password() = text;
    const auto answer = [begun, error] {
      error == Error::None ? begun.done() : begun.refuse(error);
      begun.ended();
    };
    error == Error::WrongPassword ? begun.job.guard().wrong(answer) : answer();
  });
}

void serveCancelPassword(const Request& request) {
  if (request.job.password().empty()) return request.refuse(Error::PasswordStands);
  request.job.password().clear();
  request.done();
}

}  // namespace merker::s7comm
