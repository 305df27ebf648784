"""X27 and the outside: a foreign partner that speaks 3964R (written from the technology manual 6.9.2 alone) over a pseudo
terminal and over TCP, two programs that talk RK 512 with each other, and a recording."""
import csv
import os
import socket
import time

from serial_line import *

SYNC = """DATA_BLOCK DB 50
STRUCT
  S : ARRAY [0 .. 239] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 20
STRUCT
  D : ARRAY [0 .. 199] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
"""

# MW 20 counts jobs that ended well; their number goes to DB 20 of the partner.
SENDER = SYNC + """DATA_BLOCK DB 63 SFB 63
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     MW 20
      T     DB20.DBW 0
      T     DB20.DBW 198
      CALL  SFB 63, DB 63 (SYNC_DB := 50, REQ := M 0.0, R := FALSE, LADDR := W#16#3FF, R_CPU := 1, R_TYPE := 'D', R_DBNO := 20, R_OFFSET := 0, R_CF_BYT := 255, R_CF_BIT := 0, DONE := M 1.2, ERROR := M 1.3, STATUS := MW 6, SD_1 := P#DB20.DBX0.0 BYTE 1, LEN := MW 12)
      L     200
      T     MW 12
      U     M 1.2
      SPBN  done
      L     MW 20
      +     1
      T     MW 20
done: UN    M 1.2
      UN    M 1.3
      =     M 0.0
END_ORGANIZATION_BLOCK
"""

SERVER = SYNC + """DATA_BLOCK DB 65 SFB 65
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  SFB 65, DB 65 (SYNC_DB := 50, EN_R := TRUE, R := FALSE, LADDR := W#16#3FF, L_TYPE := MB 30, L_DBNO := MW 32, L_OFFSET := MW 34, L_CF_BYT := MW 36, L_CF_BIT := MW 38, NDR := M 1.2, ERROR := M 1.3, STATUS := MW 6, LEN := MW 10)
      U     M 1.2
      SPBN  done
      L     MW 20
      +     1
      T     MW 20
done: NOP   0
END_ORGANIZATION_BLOCK
"""


IAC, SUB_END, SUB, WILL, WONT, DO, DONT, COM_PORT = 255, 240, 250, 251, 252, 253, 254, 44


class ComPortServer:
    """A server of one serial port (RFC 2217), written from the RFC alone: keeps what it is told to set, echoes characters."""

    def __init__(self, answers=lambda what, value: value):
        self.answers, self.told, self.characters, self.commands = answers, {}, bytearray(), []
        self.listener = socket.socket()
        self.listener.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        self.listener.bind(("127.0.0.1", 0))
        self.listener.listen()
        self.port = self.listener.getsockname()[1]
        self.buffer = bytearray()

    def accept(self):
        self.listener.settimeout(60)
        self.client = self.listener.accept()[0]
        self.client.settimeout(60)
        self.client.sendall(bytes([IAC, DO, COM_PORT, IAC, WILL, 1, IAC, DO, 24]))

    def byte(self):
        if not self.buffer:
            self.buffer += self.client.recv(4096)
            if not self.buffer:
                raise EOFError
        return self.buffer.pop(0)

    def step(self):
        """One character or one command."""
        one = self.byte()
        if one != IAC:
            return self.echo(one)
        command = self.byte()
        if command == IAC:
            return self.echo(IAC)
        if command != SUB:
            return self.commands.append((command, self.byte()))
        content = bytearray()
        while True:
            one = self.byte()
            if one == IAC and (one := self.byte()) == SUB_END:
                break
            content.append(one)
        what, value = content[1], bytes(content[2:])
        self.told[what] = value
        self.client.sendall(bytes([IAC, SUB, COM_PORT, what + 100]) + self.answers(what, value).replace(b"\xff", b"\xff\xff") + bytes([IAC, SUB_END]))

    def echo(self, one):
        self.characters.append(one)


class Serial(SerialCase):
    # PTP-LINE-05, PTP-LINE-12, PTP-CABLE-05
    def test_a_foreign_partner_speaks_3964R_over_a_pseudo_terminal(self):
        process, _ = self.run_it(self.project("echo", "3964R", ECHO), "pty:x27")
        self.talk(Partner(self.open("x27")))
        self.jobs(process, 4)
        self.assertEqual(self.end(process)["MW 20"], 4)
        self.assertFalse(os.path.lexists(self.folder / "x27"))

    # PTP-LINE-06, PTP-LINE-08
    def test_the_same_over_tcp_and_again_after_the_connection_was_lost(self):
        process, address = self.run_it(self.project("echo", "3964R", ECHO), "listen:0", "--serial-record", "line.csv")
        client = self.call(address)
        self.talk(Partner(client.fileno()))
        second = self.call(address)  # one connection at a time: this one is sent away
        second.settimeout(60)
        self.assertEqual(second.recv(1), b"")
        client.close()
        self.talk(Partner(self.call_again(address).fileno()))
        self.jobs(process, 8)
        values = self.end(process)
        self.assertEqual(values["MW 20"], 8)
        # The recording gives the same again in virtual time, twice the same.
        span = f"{values['seconds']:.3f}s"
        again = [self.expect(GOOD, "run", "echo", "--for", span, "--serial", "replay:line.csv", "--json", "--print", "MW 20, MW 4").json
                 for _ in range(2)]
        self.assertEqual(again[0]["MW 20"], 8)
        self.assertEqual(again[0], again[1])

    def exchange(self, first, second):
        self.jobs(first, 4)
        self.jobs(second, 4)
        sender, server = self.end(first), self.end(second)
        self.assertLessEqual(abs(sender["MW 20"] - server["MW 20"]), 1)
        self.assertLessEqual(abs(server["DB20.DBW 0"] - server["MW 20"]), 1)
        self.assertLessEqual(abs(server["DB20.DBW 0"] - server["DB20.DBW 198"]), 1)  # 128 bytes are consistent

    def pair(self):
        return (self.project("rk_send", "RK512", SENDER), self.project("rk_serve", "RK512", SERVER, "low"))

    # PTP-LINE-04
    def test_two_programs_talk_rk_512_over_a_pair_of_terminals(self):
        sender, server = self.pair()
        second, _ = self.run_it(server, "pty:x27")
        first, _ = self.run_it(sender, "device:" + str(self.folder / "x27"))
        self.exchange(first, second)

    def test_two_programs_talk_rk_512_over_tcp(self):
        sender, server = self.pair()
        second, address = self.run_it(server, "listen:0")
        first, _ = self.run_it(sender, "connect:" + address)
        self.exchange(first, second)

    ASCII = '[cpu]\nmodel = "314C-2 PtP"\n\n[[module]]\nslot = "2.1"\ndiagnostics = true\n\n[module.serial]\nprotocol = "ASCII"\nbaud = 19200\nparity = "odd"\nstop_bits = 2\n'

    def com_port(self, server):
        self.write("ascii/merker.toml", self.ASCII)
        self.write("ascii/main.awl", ECHO + "ORGANIZATION_BLOCK OB 82\nBEGIN\nNETWORK\n      L     MW 30\n      +     1\n      T     MW 30\nEND_ORGANIZATION_BLOCK\n")
        process, _ = self.run_it("ascii", f"rfc2217:127.0.0.1:{server.port}")
        self.addCleanup(server.listener.close)
        server.accept()
        self.addCleanup(server.client.close)
        return process

    # PTP-LINE-06, RFC 2217
    def test_a_server_of_serial_ports_is_set_as_the_interface_is(self):
        server = ComPortServer()
        process = self.com_port(server)
        while len(server.told) < 6:
            server.step()
        self.assertEqual(server.told, {1: (19200).to_bytes(4, "big"), 2: b"\x08", 3: b"\x02", 4: b"\x02", 5: b"\x01", 10: b"\x10"})
        self.assertEqual([number for command, number in server.commands if command == WILL], [0, 3, COM_PORT])
        text = bytes([0, 255, 255, 240, 250, 1, 13, 255])
        server.client.sendall(text.replace(b"\xff", b"\xff\xff"))
        while len(server.characters) < len(text):
            server.step()
        self.assertEqual(bytes(server.characters), text)
        self.assertIn((WONT, 24), server.commands)
        self.assertIn((DONT, 1), server.commands)
        server.client.sendall(bytes([IAC, SUB, COM_PORT, 106, 16, IAC, SUB_END]))  # BREAK
        self.jobs(process, 1)
        self.end(process)

    def test_a_server_that_does_not_do_it_is_told_and_one_that_floods_is_left(self):
        server = ComPortServer(lambda what, value: (9600).to_bytes(4, "big") if what == 1 else value)
        process = self.com_port(server)
        while len(server.told) < 6:
            server.step()
        self.assertIn("did not set its rate", process.stderr.readline())
        server.client.sendall(bytes([IAC, SUB, COM_PORT]) + bytes(100_000) + bytes([IAC, SUB_END]))
        server.client.settimeout(60)
        with self.assertRaises(ConnectionError):  # each asks for an answer, and nobody reads these
            while True:
                server.client.sendall(bytes([IAC, DO, 24]) * 10_000)
        server.accept()  # it calls again
        self.end(process)

    def test_what_is_wrong_is_told(self):
        self.project("echo", "3964R", ECHO)
        self.write("plain/merker.toml", '[cpu]\nmodel = "314C-2 PtP"\n')
        self.write("plain/main.awl", block("      NOP 0"))
        for arguments, code, text in (
                (["echo", "--serial", "usb:1"], USAGE, "is not a valid connection"),
                (["echo", "--serial", "connect:4000"], USAGE, "is not a valid connection"),
                (["echo", "--serial", "pty:x", "--for", "1s"], USAGE, "needs real time"),
                (["plain", "--serial", "listen:0"], UNREADABLE, "no serial interface"),
                (["echo", "--serial", "device:/dev/nothing", "--no-workbench"], UNREADABLE, "No such file"),
                (["echo", "--serial", "replay:main.awl", "--for", "1s"], UNREADABLE, "no recording")):
            call = self.expect(code, "run", *arguments)
            self.assertIn(text, call.err)

    def scenario(self, protocol, steps):
        self.write("line/merker.toml", f'[cpu]\nmodel = "314C-2 PtP"\n\n[[module]]\nslot = "2.1"\n\n[module.serial]\nprotocol = "{protocol}"\n')
        self.write("line/main.awl", block("      NOP 0"))
        self.write("line/line.scn", 'scenario "line"\n' + "".join(f"  {step}\n" for step in steps))

    # PTP-LINE-01, PTP-LINE-11
    def test_the_monitor_shows_faults_and_breaks(self):
        self.scenario("3964R", ["wait 50ms", "serial X27 send STX", "wait 10ms", "serial X27 disturb parity character 2", 'serial X27 send "ABC" DLE ETX 53',
                                "wait 50ms", "serial X27 cut", "wait 50ms", "serial X27 connect", "wait 50ms"])
        self.expect(GOOD, "monitor", "serial", "line", "--scenario", "line/line.scn", "--csv", "line.csv", "--pcap", "line.pcap")
        rows = list(csv.DictReader(self.read("line.csv").splitlines()))
        faults = [(row["character"], row["meaning"], row["fault"]) for row in rows if row["fault"]]
        self.assertEqual(faults, [("42", "parity fault", "parity fault"), ("", "BREAK begins", "BREAK"), ("", "BREAK ends", "BREAK")])
        self.assertIn("block refused", [row["meaning"] for row in rows])
        data, place, characters = (self.folder / "line.pcap").read_bytes(), 24, 0
        while place < len(data):
            length = int.from_bytes(data[place + 8:place + 12], "little")
            characters, place = characters + length - 12, place + 16 + length
        self.assertEqual(characters, len(rows) - 2)
        text = self.expect(GOOD, "monitor", "serial", "line", "--scenario", "line/line.scn").out
        self.assertRegex(text, r"partner  42 'B'   parity fault")
        self.assertRegex(text, r"partner     BREAK BREAK begins")

    def test_steps_that_a_partner_cannot_do_are_told(self):
        for steps, code, text in (
                (["serial X27 partner RK512", "serial X27 send 41"], PROBLEMS, "a partner RK 512 has jobs only"),
                (["serial X27 partner RK512", "serial X27 answer 41 with 42"], PROBLEMS, "a partner RK 512 has jobs only"),
                (["serial X27 disturb replace character 1"], PROBLEMS, "replace 41"),
                (["serial X27 disturb delay of X27"], PROBLEMS, "delay 5ms")):
            self.scenario("RK512", steps)
            call = self.expect(code, "test", "line")
            self.assertIn(text, call.out + call.err)

    def test_a_recording_is_checked(self):
        self.project("echo", "3964R", ECHO)
        head = "time,event,characters\n"
        for content, text in (
                (head + "0,in,02\n1,bang,\n", "line.csv:3: this is no line"), (head + "-1,in,02\n", "line.csv:2: this is no line"),
                (head + "0,in,0\n", "line.csv:2: this is no line"), (head + "5,in,02\n4,in,02\n", "line.csv:3: this is no line"),
                (head + "0,in," + "02" * 70_000 + "\n", "line.csv:2: this is no line"), ("", "no recording"), ("x" * 200_000, "no recording")):
            self.write("line.csv", content)
            self.assertIn(text, self.expect(UNREADABLE, "run", "echo", "--serial", "replay:line.csv", "--for", "1s").err)
        self.assertIn("no recording", self.expect(UNREADABLE, "run", "echo", "--serial", "replay:/dev/zero", "--for", "1s").err)
        for content in (head, head + "0,in,02", head + "0,cut,\n1,connect,\n2,faulty,41\n"):
            self.write("line.csv", content)
            self.expect(GOOD, "run", "echo", "--serial", "replay:line.csv", "--for", "1s")


if __name__ == "__main__":
    unittest.main()
