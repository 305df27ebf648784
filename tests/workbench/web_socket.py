"""A WebSocket client (RFC 6455), as small as the tests need it."""
import base64
import json
import os
import socket
import struct
import time


class Closed(Exception):
    """The server closed the connection; `code` is its reason, None without a close frame."""

    def __init__(self, code):
        super().__init__(f"closed with {code}")
        self.code = code


class Refused(Exception):
    def __init__(self, status):
        super().__init__(f"HTTP {status}")
        self.status = status


class WebSocket:
    def __init__(self, port, path="/ws", headers=None, context=None, timeout=60):
        raw = socket.create_connection(("127.0.0.1", port), timeout)
        self.socket = context.wrap_socket(raw, server_hostname="127.0.0.1") if context else raw
        self.buffer = b""
        self.headers = {"Host": f"127.0.0.1:{port}", "Connection": "Upgrade", "Upgrade": "websocket",
                        "Sec-WebSocket-Key": base64.b64encode(os.urandom(16)).decode(), "Sec-WebSocket-Version": "13"}
        self.headers.update(headers or {})
        lines = [f"GET {path} HTTP/1.1"] + [f"{name}: {value}" for name, value in self.headers.items() if value is not None]
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode("latin-1"))
        head = self._until(b"\r\n\r\n")
        status = int(head.split(b" ", 2)[1])
        if status != 101:
            self.socket.close()
            raise Refused(status)

    def _more(self):
        data = self.socket.recv(1 << 16)
        if not data:
            raise Closed(None)
        self.buffer += data

    def _until(self, end):
        while end not in self.buffer:
            self._more()
        head, self.buffer = self.buffer.split(end, 1)
        return head

    def _take(self, count):
        while len(self.buffer) < count:
            self._more()
        data, self.buffer = self.buffer[:count], self.buffer[count:]
        return data

    def send_frame(self, opcode, payload, final=True, masked=True):
        mask = os.urandom(4)
        size = len(payload)
        head = bytes([(0x80 if final else 0) | opcode])
        flag = 0x80 if masked else 0
        if size < 126:
            head += bytes([flag | size])
        elif size < 1 << 16:
            head += bytes([flag | 126]) + struct.pack(">H", size)
        else:
            head += bytes([flag | 127]) + struct.pack(">Q", size)
        if masked:
            payload = bytes(a ^ b for a, b in zip(payload, mask * (size // 4 + 1))) if size < 4096 else self._masked(payload, mask)
            head += mask
        self.socket.sendall(head + payload)

    @staticmethod
    def _masked(payload, mask):
        size = len(payload)
        key = int.from_bytes((mask * (size // 4 + 1))[:size], "little")
        return (int.from_bytes(payload, "little") ^ key).to_bytes(size, "little")

    def send(self, text):
        self.send_frame(1, text.encode())

    def receive(self):
        """The next text message; pings are answered."""
        text = b""
        while True:
            first, second = self._take(2)
            size = second & 0x7F
            if size == 126:
                size, = struct.unpack(">H", self._take(2))
            elif size == 127:
                size, = struct.unpack(">Q", self._take(8))
            payload = self._take(size)
            opcode = first & 0x0F
            if opcode == 8:
                raise Closed(struct.unpack(">H", payload[:2])[0] if len(payload) >= 2 else None)
            if opcode == 9:
                self.send_frame(10, payload)
            elif opcode in (0, 1):
                text += payload
                if first & 0x80:
                    return text.decode()

    def close(self):
        self.socket.close()


class Browser(WebSocket):
    """Requests and events of the protocol of docs/workbench-protocol.md."""

    def __init__(self, port, **options):
        super().__init__(port, **options)
        self.last, self.events, self.state = 0, [], {}

    def _keep(self, message):
        if message.get("event") == "state":
            self.state.update(message)
        else:
            self.events.append(message)

    def ask(self, do, **fields):
        """The answer, with `result` or `problems`."""
        self.last += 1
        self.send(json.dumps({"id": self.last, "do": do, **fields}))
        while True:
            message = json.loads(self.receive())
            if "event" not in message:
                assert message["id"] == self.last, message
                return message
            self._keep(message)

    def call(self, do, **fields):
        answer = self.ask(do, **fields)
        assert "result" in answer, (do, answer)
        return answer["result"]

    def problems(self, do, **fields):
        answer = self.ask(do, **fields)
        assert "problems" in answer, (do, answer)
        return [problem["code"] for problem in answer["problems"]]

    def until(self, condition, seconds=60):
        """Takes events until the condition holds for the state and the events seen so far."""
        end = time.monotonic() + seconds
        while not condition(self):
            assert time.monotonic() < end, (self.state, self.events[-3:])
            self._keep(json.loads(self.receive()))
        return self

    def until_values(self, values):
        """Until the last values of a watch list are these; events of other kinds may come in between."""
        seen = lambda: [event["values"] for event in self.events if "values" in event]
        return self.until(lambda _: seen()[-1:] == [values])
