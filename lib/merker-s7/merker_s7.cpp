#include "merker_s7.h"

#include <algorithm>
#include <cstring>

#include "blocks.h"
#include "client.h"
#include "error_text.h"
#include "variables.h"

using namespace merker::s7client;

namespace {

int readArea(S7Object object, const Elements& elements, void* data) {
  if (data == nullptr) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    return read(client.connection, elements, static_cast<std::uint8_t*>(data));
  });
}

int writeArea(S7Object object, const Elements& elements, const void* data) {
  if (data == nullptr) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    return write(client.connection, elements, static_cast<const std::uint8_t*>(data));
  });
}

int clientParameter(Client& client, int number, void* value, bool set) {
  const auto move = [&](auto& setting) {
    set ? std::memcpy(&setting, value, sizeof setting) : std::memcpy(value, &setting, sizeof setting);
    return 0;
  };
  switch (number) {
    case p_u16_RemotePort: return move(client.settings.port);
    case p_i32_PingTimeout: return move(client.settings.connectMilliseconds);
    case p_i32_SendTimeout: return move(client.settings.sendMilliseconds);
    case p_i32_RecvTimeout: return move(client.settings.receiveMilliseconds);
    case p_i32_PDURequest: return move(client.settings.pdu);
    default: return errCliInvalidParams;
  }
}

int parameter(S7Object object, int number, void* value, bool set) {
  if (value == nullptr) return errCliInvalidParams;
  return with(object,
              [&](Client& client) { return clientParameter(client, number, value, set); });
}

// All of the container, or its code or values alone.
int fetch(Client& client, const BlockNumber& block, bool full, std::uint8_t* data, int* size) {
  constexpr std::size_t kHead = 36, kCodeLengthAt = 34;
  merker::s7comm::Bytes container;
  if (const int error = upload(client.connection, block, container)) return error;
  if (container.size() < kHead) return errCliUploadSequenceFailed;
  const std::size_t begin = full ? 0 : kHead;
  const std::size_t code = static_cast<std::size_t>(container[kCodeLengthAt]) << 8 | container[kCodeLengthAt + 1];
  const std::size_t count = full ? container.size() : std::min(code, container.size() - kHead);
  if (count > static_cast<std::size_t>(*size)) return errCliBufferTooSmall;
  std::memcpy(data, container.data() + begin, count);
  *size = static_cast<int>(count);
  return 0;
}

int fetched(S7Object object, const BlockNumber& block, bool full, void* data, int* size) {
  if (data == nullptr || size == nullptr || *size < 0) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    return fetch(client, block, full, static_cast<std::uint8_t*>(data), size);
  });
}

// The time limit of one answer is another one as long as this lives.
class Patience {
 public:
  Patience(Connection& connection, int milliseconds)
      : connection_(connection), before_(connection.patience()) {
    if (milliseconds > 0) connection.setPatience(milliseconds);
  }
  ~Patience() { connection_.setPatience(before_); }
  Patience(const Patience&) = delete;

 private:
  Connection& connection_;
  const int before_;
};

// `timeout` in ms; 0: that of all answers.
int service(S7Object object, std::string_view name, std::string_view argument, int refused,
            int timeout = 0) {
  return with(object, [&](Client& client) {
    const Patience patience(client.connection, timeout);
    return callService(client.connection, name, argument, refused);
  });
}

}  // namespace

S7Object Cli_Create(void) { return reinterpret_cast<S7Object>(new (std::nothrow) Client); }

void Cli_Destroy(S7Object* object) {
  if (object == nullptr || *object == 0) return;
  auto* const client = reinterpret_cast<Client*>(*object);
  client->connection.close();
  delete client;
  *object = 0;
}

int Cli_SetConnectionType(S7Object object, uint16_t type) {
  return with(object, [&](Client& client) {
    client.settings.type = type;
    return 0;
  });
}

int Cli_ConnectTo(S7Object object, const char* address, int rack, int slot) {
  const bool place = rack >= 0 && rack < 8 && slot >= 0 && slot < 32;
  if (address == nullptr || !place) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    client.settings.address = address;
    client.settings.rack = rack;
    client.settings.slot = slot;
    return client.connection.open(client.settings);
  });
}

int Cli_Connect(S7Object object) {
  return with(object, [](Client& client) {
    return client.settings.address.empty() ? static_cast<int>(errCliInvalidParams)
                                           : client.connection.open(client.settings);
  });
}

int Cli_Disconnect(S7Object object) {
  return with(object, [](Client& client) {
    client.connection.close();
    return 0;
  });
}

int Cli_GetConnected(S7Object object, int* connected) {
  return with(object, [&](Client& client) {
    *connected = client.connection.isOpen() ? 1 : 0;
    return 0;
  });
}

int Cli_GetParam(S7Object object, int number, void* value) {
  return parameter(object, number, value, false);
}

int Cli_SetParam(S7Object object, int number, void* value) {
  return parameter(object, number, value, true);
}

int Cli_GetPduLength(S7Object object, int* requested, int* negotiated) {
  return with(object, [&](Client& client) {
    *requested = client.settings.pdu;
    *negotiated = client.connection.isOpen() ? client.connection.pdu() : 0;
    return 0;
  });
}

int Cli_GetLastError(S7Object object, int* error) {
  if (object == 0) return errLibInvalidObject;
  auto& client = *reinterpret_cast<Client*>(object);
  const std::lock_guard guard(client.lock);
  *error = client.lastError;
  return 0;
}

int Cli_ErrorText(int error, char* text, int size) {
  if (text == nullptr || size < 1) return errCliInvalidParams;
  const std::string_view sentence = errorText(error);
  const auto length = std::min(sentence.size(), static_cast<std::size_t>(size - 1));
  std::memcpy(text, sentence.data(), length);
  text[length] = 0;
  return 0;
}

int Cli_ReadArea(S7Object object, int area, int db, int start, int amount, int wordLen, void* data) {
  return readArea(object, {area, db, start, amount, wordLen}, data);
}
int Cli_WriteArea(S7Object object, int area, int db, int start, int amount, int wordLen,
                  void* data) {
  return writeArea(object, {area, db, start, amount, wordLen}, data);
}

int Cli_ReadMultiVars(S7Object object, PS7DataItem items, int count) {
  if (items == nullptr || count < 1) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    return readMany(client.connection, {items, static_cast<std::size_t>(count)});
  });
}
int Cli_WriteMultiVars(S7Object object, PS7DataItem items, int count) {
  if (items == nullptr || count < 1) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    return writeMany(client.connection, {items, static_cast<std::size_t>(count)});
  });
}

int Cli_DBRead(S7Object object, int db, int start, int size, void* data) {
  return readArea(object, {S7AreaDB, db, start, size, S7WLByte}, data);
}
int Cli_DBWrite(S7Object object, int db, int start, int size, void* data) {
  return writeArea(object, {S7AreaDB, db, start, size, S7WLByte}, data);
}

// Cli_<name>Read and Cli_<name>Write of an area without blocks.
#define AREA(name, area, element)                                              \
  int Cli_##name##Read(S7Object object, int start, int amount, void* data) {   \
    return readArea(object, {area, 0, start, amount, element}, data);          \
  }                                                                            \
  int Cli_##name##Write(S7Object object, int start, int amount, void* data) {  \
    return writeArea(object, {area, 0, start, amount, element}, data);         \
  }
AREA(EB, S7AreaPE, S7WLByte)
AREA(AB, S7AreaPA, S7WLByte)
AREA(MB, S7AreaMK, S7WLByte)
AREA(TM, S7AreaTM, S7WLTimer)
AREA(CT, S7AreaCT, S7WLCounter)
#undef AREA

int Cli_FullUpload(S7Object object, int type, int number, void* data, int* size) {
  return fetched(object, {type, number}, true, data, size);
}
int Cli_Upload(S7Object object, int type, int number, void* data, int* size) {
  return fetched(object, {type, number}, false, data, size);
}
int Cli_Download(S7Object object, int number, void* data, int size) {
  if (data == nullptr || size < 0) return errCliInvalidParams;
  const auto* const bytes = static_cast<const std::uint8_t*>(data);
  return with(object, [&](Client& client) {
    return download(client.connection, number, {bytes, bytes + size});
  });
}
int Cli_Delete(S7Object object, int type, int number) {
  return with(object, [&](Client& client) {
    return removeBlock(client.connection, {type, number});
  });
}

int Cli_PlcHotStart(S7Object object) {
  return service(object, "P_PROGRAM", "", errCliCannotStartPLC);
}
int Cli_PlcColdStart(S7Object object) {
  return service(object, "P_PROGRAM", "C ", errCliCannotStartPLC);
}
int Cli_PlcStop(S7Object object) {
  return with(object, [](Client& client) { return stopPlc(client.connection); });
}
int Cli_CopyRamToRom(S7Object object, int timeout) {
  return service(object, "_MODU", "EP", errCliCannotCopyRamToRom, timeout);
}
int Cli_Compress(S7Object object, int timeout) {
  return service(object, "_GARB", "", errCliCannotCompress, timeout);
}
