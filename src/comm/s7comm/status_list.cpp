// The system status list: number and index asked for, head and records answered.
#include "base/bytes.h"
#include "s7comm/userdata.h"

namespace merker::s7comm {

void serveStatusList(const Request& request) {
  if (request.data.size() != 4) return request.refuse(Error::WrongPduSize);
  const std::uint16_t number = loadWord(&request.data[0]), index = loadWord(&request.data[2]);
  request.job.plc().status(
      number, index, [number, index, begun = request.begun()](const StatusList& list) {
        if (list.error == Error::None) {
          Bytes octets;
          for (const std::uint16_t word : {number, index, list.recordLength, list.records})
            appendWord(octets, word);
          octets.insert(octets.end(), list.data.begin(), list.data.end());
          begun.answer(std::move(octets));
        } else {
          begun.refuse(list.error);
        }
        begun.ended();
      });
}

}  // namespace merker::s7comm
