"""A client of S7 communication made of bytes, and the program that it calls."""
import os
import re
import signal
import socket
import struct
import subprocess
import time

from harness import *

CONNECT = bytes.fromhex("0300001611E00000000500C0010AC1020100C2020102")
SETUP = "32 01 00 00 00 01 00 08 00 00 F0 00 00 08 00 08 01 E0"
BYTE, WORD, BIT = 2, 4, 1
INPUTS, OUTPUTS, FLAGS, DATA_AREA, TIMERS = 0x81, 0x82, 0x83, 0x84, 0x1D


class Client:
    """One connection. `kind`: first byte of the called TSAP: 1 PG, 2 OP, 3 others. `record`: sees its socket; `own`: its address."""
    def __init__(self, port, kind=1, setup=True, record=lambda socket: socket, slot=2, own="127.0.0.1"):
        self.socket = record(socket.create_connection(("127.0.0.1", port), timeout=20, source_address=(own, 0)))
        self.number = 1
        self.socket.sendall(CONNECT[:-2] + bytes([kind, slot]))
        self.confirmed = self.tpdu()[1:2] == b"\xD0"
        if self.confirmed and setup:
            self.pdu = struct.unpack(">H", self.ask(SETUP)[-2:])[0]

    def some(self, count):
        data = b""
        while len(data) < count:
            more = self.socket.recv(count - len(data))
            if not more:
                raise ConnectionError("the server has closed the connection")
            data += more
        return data

    def tpdu(self):
        return self.some(struct.unpack(">H", self.some(4)[2:])[0] - 4)

    def send(self, pdu):
        pdu = bytes.fromhex(pdu) if isinstance(pdu, str) else pdu
        self.socket.sendall(struct.pack(">BBH", 3, 0, len(pdu) + 7) + b"\x02\xF0\x80" + pdu)

    def hear(self):
        return self.tpdu()[3:]

    def ask(self, pdu):
        self.send(pdu)
        return self.hear()

    def item(self, area, address, count, size, block):
        address = address if area == TIMERS else address * 8
        return struct.pack(">BBBBHHI", 0x12, 10, 0x10, size, count, block, area << 24 | int(address))

    def job(self, function, item, data=b""):
        self.number += 1
        return struct.pack(">BBHHHHBB", 0x32, 1, 0, self.number, 2 + len(item), len(data), function, 1) + item + data

    def read(self, area, address, count=1, size=BYTE, block=0):
        """The bytes, or the code of the item."""
        answer = self.ask(self.job(4, self.item(area, address, count, size, block)))
        return answer[18:] if answer[14] == 0xFF else answer[14]

    def write(self, area, address, value, size=BYTE, block=0):
        """The code of the item."""
        unit, length = (3, 1) if size == BIT else (4, 8 * len(value))
        count = len(value) // (2 if size == WORD else 1)
        item = self.item(area, address, count, size, block)
        return self.ask(self.job(5, item, struct.pack(">BBH", 0, unit, length) + value))[14]

    def test(self, function, parameters, data):
        """A request of test and installation: words behind the first one, and data. What comes back first."""
        parameters, data = bytes.fromhex(parameters), bytes.fromhex(data)
        job = struct.pack(">HH", len(parameters), len(data)) + parameters + data
        self.number += 1
        head = struct.pack(">BBHHHH", 0x32, 7, 0, self.number, 12, 4 + len(job)) + bytes.fromhex("00 01 12 08 12 41")
        return self.ask(head + bytes([function, 0, 0, 0, 0, 0]) + struct.pack(">BBH", 0xFF, 9, len(job)) + job)

    def enter(self, password):
        """The error of a password, 8 characters at most."""
        self.send_password(password)
        return self.hear()[20:22].hex()

    def send_password(self, password):
        coded = b""
        for index, character in enumerate(password.ljust(8).encode()):
            coded += bytes([character ^ 0x55 ^ (coded[index - 2] if index > 1 else 0)])
        self.send(bytes.fromhex("32 07 00 00 01 00 00 08 00 0C 00 01 12 04 11 45 01 00 FF 09 00 08") + coded)

    def upload(self, name):
        """The container of a block ("0A00001A"), or the error."""
        begun = self.ask(b"\x32\x01\0\0\0\2\0\x12\0\0\x1D" + 7 * b"\0" + b"\x09_" + name.encode())
        if begun[1] == 2:
            return begun[10:12].hex()
        container, more, number = b"", True, begun[16:20]
        while more:
            piece = self.ask(b"\x32\x01\0\0\0\3\0\x08\0\0\x1E\0\0\0" + number)
            container, more = container + piece[18:], piece[13]
        self.ask(b"\x32\x01\0\0\0\4\0\x08\0\0\x1F\0\0\0" + number)
        return container

    def download(self, name, container, pieces=lambda number: True):
        """The error that the PLC tells, "0000" if there is none; `pieces` says whether to answer what it asks."""
        code = int.from_bytes(container[34:36], "big") or 1
        lengths = f"1{len(container):06}{code:06}".encode()
        begun = self.ask(b"\x32\x01\0\0\0\2\0\x20\0\0\x1A" + 7 * b"\0" + b"\x09_" + name.encode() + b"\x0D" + lengths)
        if begun[1] == 2:
            return begun[10:12].hex()
        asked, number = self.hear(), 0
        while asked[10] == 0x1B and pieces(number):
            piece, container, number = container[:222], container[222:], number + 1
            self.send(b"\x32\x03\0\0" + asked[4:6] + struct.pack(">HHHBBHBB", 2, 4 + len(piece), 0, 0x1B, len(container) > 0,
                                                                  len(piece), 0, 0xFB) + piece)
            asked = self.hear()
        self.send(b"\x32\x03\0\0" + asked[4:6] + b"\0\1\0\0\0\0\x1C")
        return asked[12:14].hex()

    def service(self, name, argument=b""):
        """The error of a named service. Names of blocks are its argument: see `names`."""
        parameters = b"\x28" + 6 * b"\0" + b"\xFD" + struct.pack(">H", len(argument)) + argument + bytes([len(name)]) + name.encode()
        return self.ask(b"\x32\x01\0\0\0\5" + struct.pack(">HH", len(parameters), 0) + parameters)[10:12].hex()

    def names(self, *blocks):
        return bytes([len(blocks), 0]) + "".join(blocks).encode()

    def close(self):
        self.socket.close()


def job_words(how, often, event):
    """Parameters of a job: how, how often, length of the answer, five ones, event."""
    return struct.pack(">10H", 0, how, often, 14, 1, 1, 1, 1, 1, event).hex()


class S7Case(Case):
    def start(self, path="a.awl", *more, s7=("--s7", "0")):
        command = [os.environ["MERKER"], "run", path, *s7, *more]
        # What is free is free at once, with sanitizers, too: tests look at the memory.
        environment = {**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=1:thread_local_quarantine_size_kb=64"}
        process = subprocess.Popen(command, cwd=self.folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        first = process.stderr.readline()
        self.port = int(re.fullmatch(r"S7 communication: 127\.0\.0\.1:(\d+)\n", first).group(1))
        return process

    def client(self, *arguments, **more):
        client = Client(self.port, *arguments, **more)
        self.addCleanup(client.close)
        return client

    def end(self, process):
        """What is said of the connections at the end."""
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=20)
        self.code = process.returncode
        return re.search(r"S7 communication: (.*)\n", told).group(1)

    def until(self, true, seconds=20):
        end = time.monotonic() + seconds
        while not true():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)
