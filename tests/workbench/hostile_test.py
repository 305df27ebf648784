"""What no browser would send: the connection is refused or closed, and the PLC goes on."""
import errno
import json
import os
import random
import socket
import struct
import unittest

from served import Served
from web_socket import Closed, Refused, WebSocket


class Hostile(Served):
    def alive(self):
        self.assertIsNone(self.process.poll(), "the server ended")
        browser = self.browser()
        browser.until(lambda b: b.state.get("mode") == "RUN")
        cycles = browser.state["cycles"]
        browser.until(lambda b: b.state["cycles"] > cycles)

    def raw(self, data, timeout=60):
        """The answer to these bytes, until the server closes. It may close before it has read all of them."""
        with socket.create_connection(("127.0.0.1", self.port), timeout) as connection:
            answer = b""
            try:
                connection.sendall(data)
                connection.shutdown(socket.SHUT_WR)
            except OSError as error:
                self.assertIn(error.errno, (errno.EPIPE, errno.ECONNRESET, errno.ENOTCONN))
            try:
                while part := connection.recv(1 << 16):
                    answer += part
            except ConnectionError:
                pass
            return answer

    def status(self, data):
        answer = self.raw(data)
        return int(answer.split(b" ", 2)[1]) if answer.startswith(b"HTTP/1.1 ") else None


class Http(Hostile):
    def request(self, target="/", method="GET", host=None, more=""):
        host = f"127.0.0.1:{self.port}" if host is None else host
        return self.status(f"{method} {target} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n{more}\r\n".encode("latin-1"))

    def test_only_the_page_is_served(self):
        self.assertEqual(self.request(), 200)
        for target in ("/../merker.toml", "/..%2f..%2fetc/passwd", "//etc/passwd", "/main.awl", "/%00", "/index.html/", "*",
                       "http://evil.example/", "/ws"):
            self.assertIn(self.request(target), (400, 404), target)
        for method in ("POST", "PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "BREW"):
            self.assertIn(self.request(method=method), (400, 405), method)

    def test_other_names_of_this_machine_are_refused(self):  # DNS rebinding
        for host in ("evil.example", f"evil.example:{self.port}", "127.0.0.1.evil.example", ""):
            self.assertEqual(self.request(host=host), 421, host)
        self.assertEqual(self.request(host=f"localhost:{self.port}"), 200)

    def test_requests_of_other_pages_are_refused(self):
        self.assertEqual(self.request(more="Origin: http://evil.example\r\n"), 403)
        self.assertEqual(self.request(more=f"Origin: http://127.0.0.1:{self.port}\r\n"), 200)

    def test_broken_requests_are_refused(self):
        self.assertEqual(self.request(more="X: " + "a" * 20000 + "\r\n"), 431)
        self.assertEqual(self.request(method="POST", more="Content-Length: 1000000000\r\n"), 413)
        for data in (b"\r\n\r\n", b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"\x16\x03\x01\x02\x00\x01\x00",
                     b"GET / HTTP/1.1\r\nHost: a\r\nHost\r\n\r\n", b"GET /\x00 HTTP/1.1\r\n\r\n"):
            self.assertIn(self.status(data), (None, 400, 421), data)
        self.alive()

    def test_noise_does_no_harm(self):
        noise = random.Random(1)
        for _ in range(100):
            self.raw(bytes(noise.randrange(256) for _ in range(noise.randrange(400))))
        self.alive()

    def test_many_connections_do_no_harm(self):
        held = [socket.create_connection(("127.0.0.1", self.port), 60) for _ in range(300)]
        for one in held:
            one.close()
        self.alive()


class Sockets(Hostile):
    def closed(self, socket_):
        """The code that the server closes with."""
        try:
            while True:
                socket_.receive()
        except Closed as closed:
            return closed.code
        except ConnectionError:
            return None

    def test_pages_of_other_sites_get_no_socket(self):
        for headers in ({"Origin": "http://evil.example"}, {"Origin": "null"}, {"Host": "evil.example"},
                        {"Origin": "http://127.0.0.1:1"}):
            with self.assertRaises(Refused):
                WebSocket(self.port, headers=headers)
        WebSocket(self.port, headers={"Origin": f"http://127.0.0.1:{self.port}"}).close()
        with self.assertRaises(Refused):
            WebSocket(self.port, path="/other")

    def test_what_breaks_the_framing_is_closed(self):
        for code, send in ((1009, lambda s: s.send_frame(1, b" " * ((4 << 20) + 1))),
                           (1007, lambda s: s.send_frame(1, b"\xff\xfe")),
                           (1003, lambda s: s.send_frame(2, b"{}")),
                           (1002, lambda s: s.send_frame(1, b"{}", masked=False)),
                           (1002, lambda s: s.send_frame(11, b"")),
                           (1002, lambda s: s.send_frame(9, b"x" * 126)),
                           (1002, lambda s: s.send_frame(0, b"{}"))):
            connection = WebSocket(self.port)
            try:
                send(connection)
            except ConnectionError:
                pass
            self.assertIn(self.closed(connection), (code, None))
            connection.close()
        self.alive()

    def test_a_huge_length_allocates_nothing(self):
        connection = WebSocket(self.port)
        connection.socket.sendall(bytes([0x81, 0xFF]) + struct.pack(">Q", 1 << 62) + b"abcd")
        self.assertIn(self.closed(connection), (1002, 1009, None))
        self.alive()

    def test_the_largest_message_is_answered(self):
        browser = self.browser()
        text = "//" + "x" * (4 << 20)
        head = '{"id": 1, "do": "files.create", "path": "big.awl", "text": "'
        browser.send(head + text[:(4 << 20) - len(head) - 2] + '"}')
        while "id" not in (message := json.loads(browser.receive())):
            pass
        self.assertIn("result", message)

    def test_whatever_a_message_says_there_is_an_answer(self):
        browser = self.browser()
        noise = random.Random(2)
        request = json.dumps({"id": 1, "do": "watch.set", "list": 1, "items": [{"operand": "MW 10", "format": "HEX"}]})
        for _ in range(300):
            text = list(request)
            for _ in range(noise.randrange(1, 4)):
                text[noise.randrange(len(text))] = noise.choice('{}[]",:0x\\\u00e4')
            browser.send("".join(text))
            while "event" in json.loads(browser.receive()):
                pass
        browser.send("[" * 100000)
        self.alive()

    def test_browsers_are_counted(self):
        held = [WebSocket(self.port) for _ in range(64)]
        one_more = WebSocket(self.port)
        self.assertEqual(self.closed(one_more), 1013)
        one_more.close()
        held.pop().close()
        for one in held:
            one.close()

    def test_a_browser_that_does_not_read_holds_nobody_up(self):
        slow, other = self.browser(), self.browser()
        slow.send(json.dumps({"id": 1, "do": "trend.set", "list": 1, "items": [{"operand": "MW 20"}] * 100}))
        other.until(lambda b: b.state.get("mode") == "RUN")
        begin = other.state["time"]
        other.until(lambda b: b.state["time"] > begin + 2_000_000_000)


if __name__ == "__main__":
    unittest.main()
