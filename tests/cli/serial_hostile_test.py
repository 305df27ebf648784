"""What a hostile partner can do over TCP and a pseudo terminal: storms of connections, floods, a reader that never reads. The PLC
goes on, memory has an end, and afterwards a well-behaved partner is served."""
import os
import random
import select
import socket
import struct
import time

from serial_line import *


class Hostile(SerialCase):
    def start(self, serial):
        return self.run_it(self.project("echo", "3964R", ECHO), serial)

    def memory(self, process):
        """Resident bytes."""
        return int(pathlib.Path(f"/proc/{process.pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def alive(self, process, before, begin, jobs=0):
        self.jobs(process, jobs)
        self.assertLess(self.memory(process), before + (8 << 20))
        passed = time.monotonic() - begin
        values = self.end(process)
        self.assertGreater(values["seconds"], passed / 10)  # nothing blocks it
        return values

    def flood(self, file, count):
        """As much of so many random bytes as is taken within three seconds."""
        data, end = random.Random(26).randbytes(count), time.monotonic() + 3
        sent = 0
        while sent < count and time.monotonic() < end:
            if select.select([], [file], [], 0.1)[1]:
                sent += os.write(file, data[sent:sent + 4096])
        return sent

    def test_a_storm_of_connections(self):
        process, address = self.start("listen:0")
        begin, before = time.monotonic(), self.memory(process)
        reset = struct.pack("ii", 1, 0)
        for number in range(100):
            client = self.call(address)
            if number % 3 == 0:
                client.sendall(b"\x02\x10\x03" * 50)
            if number % 2 == 0:
                client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, reset)
            client.close()
        partner = Partner(self.call_again(address).fileno())
        partner.idle(1)
        self.talk(partner)
        self.assertEqual(self.alive(process, before, begin, 4)["MW 20"], 4)

    def test_a_flood_and_a_reader_that_never_reads(self):
        process, address = self.start("listen:0")
        begin, before = time.monotonic(), self.memory(process)
        client = self.call(address)
        client.setblocking(False)
        self.assertGreater(self.flood(client.fileno(), 100 << 20), 60_000)
        client.close()  # what it sent and nobody took yet is gone
        time.sleep(0.1)
        self.alive(process, before, begin)

    def test_the_same_over_a_pseudo_terminal_and_good_afterwards(self):
        process, _ = self.start("pty:x27")
        begin, before = time.monotonic(), self.memory(process)
        file = self.open("x27")
        os.set_blocking(file, False)
        self.flood(file, 30_000)
        os.set_blocking(file, True)
        partner = Partner(file)
        partner.idle(12)  # what waits goes over the line at its rate
        partner.send(b"OK")
        self.assertEqual(partner.receive(), b"OK")
        self.alive(process, before, begin, 1)


if __name__ == "__main__":
    unittest.main()
