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

void end(const Request& begun, Error error) {
  error == Error::None ? begun.done() : begun.refuse(error);
  begun.ended();
}

void look(const Request& begun, const std::string& text) {
  begun.job.plc().enter(text, [begun, text](Error error) {
    if (error == Error::None) begun.job.password() = text;
    if (error == Error::WrongPassword) begun.job.guard().wrong();
    end(begun, error);
  });
}

}  // namespace

void serveEnterPassword(const Request& request) {
  if (request.data.size() != kPasswordOctets) return request.refuse(Error::WrongPassword);
  if (!request.job.password().empty()) return request.refuse(Error::PasswordStands);
  request.job.guard().turn([begun = request.begun(), text = decoded(request.data)](bool mayLook) {
    mayLook ? look(begun, text) : end(begun, Error::WrongPassword);
  });
}

void serveCancelPassword(const Request& request) {
  if (request.job.password().empty()) return request.refuse(Error::PasswordStands);
  request.job.password().clear();
  request.done();
}

}  // namespace merker::s7comm
