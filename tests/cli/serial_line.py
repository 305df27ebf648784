"""A program at the serial interface X27 and a foreign partner that speaks 3964R, written from the technology manual 6.9.2 alone."""
import os
import re
import select
import signal
import socket
import subprocess
import time
import tty

from harness import *
from s7_client import FLAGS, WORD, Client

STX, ETX, DLE, NAK = 0x02, 0x03, 0x10, 0x15

PROJECT = """[cpu]
model = "314C-2 PtP"

[[module]]
slot = "2.1"

[module.serial]
protocol = "{protocol}"
baud = 38400
priority = "{priority}"
"""

# What was received is sent back.
ECHO = """DATA_BLOCK DB 21
STRUCT
  D : ARRAY [0 .. 1023] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 60 SFB 60
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 61 SFB 61
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      UN    M 0.0
      =     M 0.1
      CALL  SFB 61, DB 61 (EN_R := M 0.1, R := FALSE, LADDR := W#16#3FF, NDR := M 1.0, ERROR := M 1.1, STATUS := MW 4, RD_1 := P#DB21.DBX0.0 BYTE 1, LEN := MW 10)
      U     M 1.0
      SPBN  send
      L     MW 10
      T     MW 12
      SET
      S     M 0.0
send: CALL  SFB 60, DB 60 (REQ := M 0.0, R := FALSE, LADDR := W#16#3FF, DONE := M 1.2, ERROR := M 1.3, STATUS := MW 6, SD_1 := P#DB21.DBX0.0 BYTE 1, LEN := MW 12)
      U     M 1.2
      SPBN  done
      L     MW 20
      +     1
      T     MW 20
done: U     M 1.2
      O     M 1.3
      R     M 0.0
END_ORGANIZATION_BLOCK
"""

class Partner:
    """3964R over a file: sends and receives telegrams, one at a time."""

    def __init__(self, file):
        self.file, self.waiting = file, b""

    def get(self, seconds=60.0):
        end = time.monotonic() + seconds
        while not self.waiting:
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.file], [], [], left)[0]:
                raise AssertionError(f"no character within {seconds} s")
            self.waiting = os.read(self.file, 4096)
        first, self.waiting = self.waiting[0], self.waiting[1:]
        return first

    def put(self, *characters):
        os.write(self.file, bytes(characters))

    def idle(self, seconds):
        """What comes for so long is thrown away."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            if select.select([self.file], [], [], left)[0]:
                os.read(self.file, 4096)
        self.waiting = b""

    @staticmethod
    def body(data):
        doubled = b"".join(bytes([one, one]) if one == DLE else bytes([one]) for one in data) + bytes([DLE, ETX])
        check = 0
        for one in doubled:
            check ^= one
        return doubled + bytes([check])

    def send(self, data):
        for _ in range(6):
            self.put(STX)
            if self.get() != DLE:
                continue
            self.put(*self.body(data))
            if self.get() == DLE:
                return
        raise AssertionError("the telegram was not taken")

    def receive(self):
        while self.get() != STX:
            pass
        self.put(DLE)
        data, check = bytearray(), 0
        while True:
            one = self.get()
            check ^= one
            if one == DLE:
                one = self.get()
                check ^= one
                if one == ETX:
                    break
            data.append(one)
        good = self.get() == check
        self.put(DLE if good else NAK)
        if not good:
            raise AssertionError("wrong block check")
        return bytes(data)


class SerialCase(Case):
    def project(self, name, protocol, program, priority="high"):
        self.write(f"{name}/merker.toml", PROJECT.format(protocol=protocol, priority=priority))
        self.write(f"{name}/main.awl", program)
        return name

    def run_it(self, project, serial, *more):
        held = lambda: signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
        process = subprocess.Popen([os.environ["MERKER"], "run", project, "--no-workbench", "--json", "--print", "MW 20, DB20.DBW 0, DB20.DBW 198" if "rk" in project
                                    else "MW 20", "--serial", serial, "--s7", "0", *more],
                                   cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=held)
        self.addCleanup(process.kill)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        said = process.stderr.readline() + process.stderr.readline()
        where = re.search(r"^serial interface X27: (.*)$", said, re.MULTILINE)
        port = re.search(r"^S7 communication: 127\.0\.0\.1:(\d+)$", said, re.MULTILINE)
        self.assertTrue(where and port, said)
        process.port = int(port.group(1))
        return process, where.group(1)

    def jobs(self, process, count):
        """Waits until so many jobs have ended well: MW 20 counts them, in the cycle after the last character."""
        client, end = Client(process.port), time.monotonic() + 60
        while int.from_bytes(client.read(FLAGS, 20, 1, WORD), "big") < count:
            self.assertLess(time.monotonic(), end, f"fewer than {count} jobs")
            time.sleep(0.01)
        client.close()

    def end(self, process):
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=30)
        self.assertEqual(process.returncode, GOOD, out + err)
        return json.loads(out)

    def open(self, path):
        file = os.open(self.folder / path, os.O_RDWR | os.O_NOCTTY)
        self.addCleanup(os.close, file)
        tty.setraw(file)
        return file

    def call(self, address):
        host, port = address.rsplit(":", 1)
        client = socket.create_connection((host, int(port)), timeout=60)
        client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.addCleanup(client.close)
        return client

    def call_again(self, address):
        """The connection after one that was closed: whoever comes before the program has seen its end is sent away."""
        end = time.monotonic() + 60
        while time.monotonic() < end:
            client = self.call(address)
            if not select.select([client], [], [], 0.5)[0] or client.recv(1):
                return client
        self.fail("nobody is let in")

    def talk(self, partner):
        partner.idle(0.5)  # NAK of the start
        for data in (b"ABC", bytes([DLE]), bytes([1, DLE, ETX, STX, NAK]), bytes(range(256))):
            partner.send(data)
            self.assertEqual(partner.receive(), data)
