#include "s7comm/services.h"

#include <algorithm>
#include <iterator>

#include "s7comm/userdata.h"

namespace merker::s7comm {
namespace {

constexpr Service kServices[] = {
    // function, name, waits, before the setup
    {0xF0, "setup communication", true, true, serveSetup},
    {0x04, "read variables", true, false, serveRead},
    {0x05, "write variables", false, false, serveWrite},
    {0x1A, "request download", true, false, serveRequestDownload},
    {0x1D, "start upload", true, false, serveStartUpload},
    {0x1E, "upload", true, false, serveUpload},
    {0x1F, "end upload", true, false, serveEndUpload},
    {0x28, "program invocation", true, false, serveProgramInvocation},
    {0x29, "stop", true, false, serveStop},
};

}  // namespace

const Service* findService(std::uint8_t function) {
  const auto* const found = std::ranges::find(kServices, function, &Service::function);
  return found == std::end(kServices) ? nullptr : found;
}

void Job::answer(View answerParameters, View answerData, Error error) const {
  if (error != Error::None) guard().refused(error);
  session->send_(writePdu({PduType::Answer, reference, error, answerParameters, answerData}));
}

// S7 CPUs acknowledge what they refuse, without parameters (seen: 32 02 … 00 00 00 00 81 04).
void Job::refuse(Error error) const {
  guard().refused(error);
  session->send_(writePdu({PduType::Acknowledge, reference, error, {}, {}}));
}

void Job::userdata(const UserdataHead& head, View octets) const {
  if (head.error != Error::None) guard().refused(head.error);
  session->send_(writeUserdata(head, reference, octets));
}

}  // namespace merker::s7comm
