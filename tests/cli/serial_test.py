"""X27 and the outside: a foreign partner that speaks 3964R (written from the technology manual 6.9.2 alone) over a pseudo
terminal and over TCP, two programs that talk RK 512 with each other, and a recording."""
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


class Serial(SerialCase):
    # PTP-LINE-05, PTP-LINE-12, PTP-CABLE-05
    def test_a_foreign_partner_speaks_3964R_over_a_pseudo_terminal(self):
        process, _ = self.run_it(self.project("echo", "3964R", ECHO), "pty:x27")
        self.talk(Partner(self.open("x27")))
        time.sleep(0.1)
        self.assertEqual(self.end(process)["MW 20"], 4)
        self.assertFalse(os.path.lexists(self.folder / "x27"))

    # PTP-LINE-06, PTP-LINE-08
    def test_the_same_over_tcp_and_again_after_the_connection_was_lost(self):
        process, address = self.run_it(self.project("echo", "3964R", ECHO), "listen:0", "--serial-record", "line.csv")
        client = self.call(address)
        self.talk(Partner(client.fileno()))
        second = self.call(address)  # one connection at a time: this one is sent away
        second.settimeout(5)
        self.assertEqual(second.recv(1), b"")
        client.close()
        time.sleep(0.2)
        self.talk(Partner(self.call(address).fileno()))
        time.sleep(0.1)
        values = self.end(process)
        self.assertEqual(values["MW 20"], 8)
        # The recording gives the same again in virtual time, twice the same.
        span = f"{values['seconds']:.3f}s"
        again = [self.expect(GOOD, "run", "echo", "--for", span, "--serial", "replay:line.csv", "--json", "--print", "MW 20, MW 4").json
                 for _ in range(2)]
        self.assertEqual(again[0]["MW 20"], 8)
        self.assertEqual(again[0], again[1])

    def exchange(self, first, second):
        time.sleep(4)
        sender, server = self.end(first), self.end(second)
        self.assertGreater(sender["MW 20"], 3)
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


if __name__ == "__main__":
    unittest.main()
