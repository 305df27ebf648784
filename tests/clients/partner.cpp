// Snap7's partner, moved by lines on its standard input: what Merker's BSEND and BRCV are judged
// with.
//   active PORT LOCAL PARTNER    calls a port of 127.0.0.1, with these TSAPs (hexadecimal)
//   passive PORT LOCAL PARTNER   waits there
//   send R_ID COUNT    so many bytes, 1, 2, 3 … 255, 0, 1 …: "sent" or "failed CODE"
//   receive            "got R_ID COUNT SUM", the sum of byte * (1 + place % 7); "none" after 10 s
//   leave              the connection is given up: "left"
// And Snap7's server, what GET and PUT are judged with:
//   server PORT          DB 1 is 400 bytes, 0, 1, 2 …, the flags are 100, 101 …
//   bytes PLACE COUNT    of DB 1, hexadecimal
#include <dlfcn.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "s7_partner.h"
#include "s7_server.h"

// A passive partner always waits at port 102, which not everybody may use: it gets another one.
static unsigned short placeToWait = 0;
extern "C" int bind(int socket, const sockaddr* address, socklen_t length) {
  using Bind = int (*)(int, const sockaddr*, socklen_t);
  static const auto next = reinterpret_cast<Bind>(dlsym(RTLD_NEXT, "bind"));
  sockaddr_in place = *reinterpret_cast<const sockaddr_in*>(address);
  if (place.sin_family == AF_INET && ntohs(place.sin_port) == 102)
    place.sin_port = htons(placeToWait);
  return next(socket, reinterpret_cast<const sockaddr*>(&place), length);
}

static TSnap7Partner* start(bool active) {
  unsigned port = 0, local = 0, remote = 0;
  std::cin >> std::dec >> port >> std::hex >> local >> remote >> std::dec;
  auto* const partner = new TSnap7Partner(active);
  auto number = static_cast<uint16_t>(port);
  uint32_t never = 3'600'000;  // it would ask by ping
  partner->SetParam(p_u32_KeepAliveTime, &never);
  if (active) partner->SetParam(p_u16_RemotePort, &number);
  placeToWait = number;
  const int code = partner->StartTo("127.0.0.1", "127.0.0.1", static_cast<word>(local),
                                    static_cast<word>(remote));
  std::cout << (code == 0 ? "started" : "failed") << ' ' << std::hex << code << std::dec
            << std::endl;
  return partner;
}

static void sendBytes(TSnap7Partner& partner) {
  unsigned rid = 0, count = 0;
  std::cin >> rid >> count;
  std::vector<unsigned char> bytes(count);
  for (unsigned i = 0; i < count; ++i) bytes[i] = static_cast<unsigned char>(i + 1);
  const int code = partner.BSend(rid, bytes.data(), static_cast<int>(count));
  if (code == 0) std::cout << "sent" << std::endl;
  if (code != 0) std::cout << "failed " << std::hex << code << std::dec << std::endl;
}

static void receiveBytes(TSnap7Partner& partner) {
  std::vector<unsigned char> bytes(65'536);
  longword rid = 0;
  int count = 0;
  if (partner.BRecv(rid, bytes.data(), count, 10'000) != 0) {
    std::cout << "none" << std::endl;
    return;
  }
  unsigned long long sum = 0;
  for (int i = 0; i < count; ++i) sum += bytes[static_cast<unsigned>(i)] * (1ull + i % 7);
  std::cout << "got " << rid << ' ' << count << ' ' << sum << std::endl;
}

static unsigned char dataBlock[400], flags[100];

static void serve() {
  unsigned short port = 0;
  std::cin >> port;
  for (unsigned i = 0; i < sizeof dataBlock; ++i) dataBlock[i] = static_cast<unsigned char>(i);
  for (unsigned i = 0; i < sizeof flags; ++i) flags[i] = static_cast<unsigned char>(100 + i);
  auto* const server = new TSnap7Server;
  server->SetParam(p_u16_LocalPort, &port);
  server->RegisterArea(srvAreaDB, 1, dataBlock, sizeof dataBlock);
  server->RegisterArea(srvAreaMK, 0, flags, sizeof flags);
  std::cout << "started " << std::hex << server->StartTo("127.0.0.1") << std::dec << std::endl;
}

static void showBytes() {
  unsigned place = 0, count = 0;
  std::cin >> place >> count;
  for (unsigned i = place; i < place + count && i < sizeof dataBlock; ++i)
    std::printf("%02x", dataBlock[i]);
  std::printf("\n");
  std::fflush(stdout);
}

int main() {
  TSnap7Partner* partner = nullptr;
  for (std::string word; std::cin >> word;) {
    if (word == "active" || word == "passive") partner = start(word == "active");
    if (word == "server") serve();
    if (word == "bytes") showBytes();
    if (word == "server" || word == "bytes") continue;
    if (partner == nullptr) return 2;
    if (word == "send") sendBytes(*partner);
    if (word == "receive") receiveBytes(*partner);
    if (word == "leave") {
      partner->Stop();
      std::cout << "left" << std::endl;
    }
  }
  std::_Exit(0);  // its threads wait for nothing any more
}
