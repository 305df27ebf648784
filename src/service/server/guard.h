// Who may ask. A page of another site can make a browser send requests to 127.0.0.1: by a name that
// points there (DNS rebinding), which the Host header shows, or straight away, which the Origin
// header shows.
#pragma once

#include <string>
#include <string_view>

namespace merker::hmi {

class Guard {
 public:
  // `local`: bound to this machine only; other addresses are reached by names nobody knows here,
  // and the certificate vouches for them. `address`: that it is bound to, a name of its own.
  Guard(bool local, bool tls, std::string token, std::string_view address = {});

  bool host(std::string_view host) const;
  // Programs that are no browsers send no origin.
  bool origin(std::string_view origin, std::string_view host) const;
  // "/ws?token=…"; takes the same time whatever is wrong.
  bool token(std::string_view target) const;
  bool tls() const { return tls_; }

 private:
  bool local_, tls_;
  std::string token_, address_;
};

// "localhost" by its number, anything else as it is.
std::string numeric(std::string_view address);
// Loopback addresses: 127.x.x.x, ::1 and localhost.
bool isLocalAddress(std::string_view address);

}  // namespace merker::hmi
