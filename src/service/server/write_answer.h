// An answer on its way to a browser.
#pragma once

#include <boost/beast/http/write.hpp>
#include <functional>

#include "server/answer.h"
#include "server/stream.h"

namespace merker::hmi {

// `goOn` reads the next request and keeps the session, to which the rest belongs. After an error,
// or when the browser wants no further answer, nothing more is sent.
inline void writeAnswer(Stream& stream, Answer& answer, std::function<void()> goOn) {
  http::async_write(
      stream, answer,
      [&stream, &answer, goOn = std::move(goOn)](beast::error_code error, std::size_t) {
        if (!error && answer.keep_alive()) return goOn();
        beast::error_code ignored;
        beast::get_lowest_layer(stream).socket().shutdown(
            boost::asio::ip::tcp::socket::shutdown_send, ignored);
      });
}

}  // namespace merker::hmi
