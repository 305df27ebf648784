#include "server/sessions.h"

#include <boost/beast/ssl.hpp>

#include "server/http_session.h"

namespace merker::hmi {
namespace {

using Plain = beast::tcp_stream;
using Secure = beast::ssl_stream<beast::tcp_stream>;

void handshake(const std::shared_ptr<HttpSession<Secure>>& session) {
  session->limitTime(session->limits().request);
  session->stream().async_handshake(boost::asio::ssl::stream_base::server,
                                    [session](beast::error_code error) {
                                      if (!error) session->read();
                                    });
}

}  // namespace

void serve(boost::asio::ip::tcp::socket socket, Surroundings& around) {
  // All places are taken: who has been here longest without being a browser makes room, so that
  // requests that never end shut nobody out.
  const std::size_t places = around.options.limits.connections;
  if (around.connections >= 2 * places) return;  // closed at once
  if (around.connections >= places && !around.unfinished.empty()) {
    Unfinished* oldest = around.unfinished.front();
    around.unfinished.pop_front();
    oldest->giveUp();
  }
  beast::error_code ignored;
  socket.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  if (around.tls == nullptr)
    return std::make_shared<HttpSession<Plain>>(Plain(std::move(socket)), around)->read();
  handshake(
      std::make_shared<HttpSession<Secure>>(Secure(Plain(std::move(socket)), *around.tls), around));
}

}  // namespace merker::hmi
