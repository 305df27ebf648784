#include "userdata.h"

#include "merker_s7.h"
#include "s7comm/data_item.h"

namespace merker::s7client {
namespace {

using s7comm::Bytes;
using s7comm::Error;
using s7comm::ItemCode;
using s7comm::Pdu;

constexpr std::uint8_t kFirst = 0x11, kMore = 0x12, kRequest = 0x40;
constexpr std::size_t kAnswerParameters = 12;

// 00 01 12, length, method, type and group, subfunction, sequence number.
Bytes userdataParameters(int group, int subfunction, std::uint8_t sequence, bool more) {
  Bytes parameters = {0, 1, 0x12, static_cast<std::uint8_t>(more ? 8 : 4), more ? kMore : kFirst,
                      static_cast<std::uint8_t>(kRequest | group),
                      static_cast<std::uint8_t>(subfunction), sequence};
  if (more) parameters.resize(kAnswerParameters);
  return parameters;
}

Bytes userdataItem(s7comm::View octets) {
  Bytes data;
  if (octets.empty())
    s7comm::writeDataItem(data, {ItemCode::Missing, s7comm::DataUnit::None, {}});
  else
    s7comm::writeDataItem(data, {ItemCode::Done, s7comm::DataUnit::Octets, octets});
  return data;
}

int meaningOf(Error error) {
  switch (error) {
    case Error::NeedsPassword: return errCliNeedPassword;
    case Error::WrongPassword: return errCliInvalidPassword;
    case Error::PasswordStands:
    case Error::NoPassword: return errCliNoPasswordToSetOrClear;
    case Error::FunctionNotAvailable: return errCliFunNotAvailable;
    case Error::NoSuchBlock:
    case Error::NoBlocks:
    case Error::NoSuchList:
    case Error::NoInformation: return errCliItemNotAvailable;
    case Error::WrongTime: return errCliInvalidValue;
    default: return errCliFunctionRefused;
  }
}

}  // namespace

int askUserdata(Connection& connection, int group, int subfunction, s7comm::View octets,
                Bytes& answer, Error* refusal) {
  constexpr std::size_t kSequenceAt = 7, kMoreAt = 9, kErrorAt = 10, kLongest = 1 << 20;
  std::uint8_t sequence = 0;
  for (bool more = false;;) {
    const std::uint16_t reference = connection.nextReference();
    const Bytes parameters = userdataParameters(group, subfunction, sequence, more);
    const Bytes data = userdataItem(more ? s7comm::View{} : octets);
    Pdu said;
    const Bytes request = s7comm::writePdu({s7comm::PduType::Userdata, reference, Error::None, parameters, data});
    if (const int error = connection.exchange(request, reference, said)) return error;
    if (said.type != s7comm::PduType::Userdata || said.parameters.size() < kAnswerParameters)
      return errCliInvalidPlcAnswer;
    const auto error = static_cast<Error>(said.parameters[kErrorAt] << 8 | said.parameters[kErrorAt + 1]);
    if (refusal != nullptr) *refusal = error;
    if (error != Error::None) return meaningOf(error);
    s7comm::View rest = said.data;
    const auto item = s7comm::readDataItem(rest);
    if (!item || answer.size() + item->octets.size() > kLongest) return errCliInvalidPlcAnswer;
    answer.insert(answer.end(), item->octets.begin(), item->octets.end());
    more = said.parameters[kMoreAt] != 0;
    sequence = said.parameters[kSequenceAt];
    if (!more) return 0;
    if (item->octets.empty()) return errCliInvalidPlcAnswer;
  }
}

}  // namespace merker::s7client
