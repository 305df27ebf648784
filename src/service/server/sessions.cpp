#include "server/sessions.h"

#include "server/http_session.h"
#include "server/page_session.h"

namespace merker::hmi {

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
  const auto session = std::make_shared<HttpSession>(Stream(std::move(socket), around.tls), around);
  session->limitTime(around.options.limits.request);
  session->stream().handshake([session](beast::error_code error) {
    if (!error) session->read();
  });
}

// Whoever has been here longest makes room.
void servePages(boost::asio::ip::tcp::socket socket,
                const std::shared_ptr<PageSurroundings>& around) {
  if (around->sessions.size() >= 2 * around->limits.connections) return;  // closed at once
  if (around->sessions.size() >= around->limits.connections) around->sessions.front()->giveUp();
  beast::error_code ignored;
  socket.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  std::make_shared<PageSession>(std::move(socket), around)->read();
}

}  // namespace merker::hmi
