"""S7 communication with the built program: values of both families, connections, what clients do to harm."""
import json
import os
import random
import resource

from s7_client import *

LISTING = "DB 5\n 0: KH = 0102\nOB 1\n U E 0.0\n = A 0.0\n L MB 110\n L KF +1\n +F\n T MB 110\n BE\n"


class Values(S7Case):
    # S7-NET-26: MW 20 counts cycles, DB 1 begins with 5 and 1.5.
    def served(self, *more):
        self.write("a.awl", PROGRAM + DATA)
        process = self.start("a.awl", *more)
        client = self.client()
        self.assertEqual(client.pdu, 240)
        self.assertEqual(client.read(DATA_AREA, 0, 6, BYTE, 1).hex(), "00053fc00000")
        self.assertEqual(client.write(DATA_AREA, 0, b"\x12\x34", WORD, 1), 0xFF)
        self.assertEqual(client.read(DATA_AREA, 0, 1, WORD, 1).hex(), "1234")
        self.assertEqual(client.read(DATA_AREA, 0, 1, WORD, 7), 0x0A)
        self.assertEqual(client.read(FLAGS, 4000), 0x05)
        before = client.read(FLAGS, 20, 1, WORD)
        self.until(lambda: client.read(FLAGS, 20, 1, WORD) != before)
        self.assertEqual(client.write(INPUTS, 0, b"\x01", BIT), 0xFF)
        self.until(lambda: client.read(OUTPUTS, 0) == b"\x03")  # A 0.1: two seconds later
        client.close()
        self.assertRegex(self.end(process), r"^1 connection, 0 refused, 0 broken off, \d+ requests$")
        self.assertEqual(self.code, GOOD)

    def test_without_workbench(self):
        self.served("--no-workbench")

    def test_with_workbench(self):
        self.served("--port", "0")

    # In STOP values are still there, and the program does not end.
    def test_a_fault_stops_the_plc_and_not_the_server(self):
        self.write("a.awl", PROGRAM)
        process = self.start("a.awl", "--no-workbench")
        client = self.client()
        client.write(INPUTS, 0, b"\x80")
        old = b""
        def stands():
            nonlocal old
            last, old = old, client.read(FLAGS, 20, 1, WORD)
            time.sleep(0.05)
            return last == old
        self.until(stands)
        self.assertEqual(client.write(FLAGS, 30, b"\x55"), 0xFF)
        self.assertEqual(client.read(FLAGS, 30), b"\x55")
        self.end(process)
        self.assertEqual(self.code, FAULT)

    def test_a_sinumerik(self):
        self.write("a.s5", LISTING)
        process = self.start("a.s5", "--no-workbench")
        client = self.client()
        self.assertEqual(client.read(DATA_AREA, 0, 2, BYTE, 5).hex(), "0102")
        self.assertEqual(client.write(DATA_AREA, 1, b"\x77", BYTE, 5), 0xFF)
        self.assertEqual(client.read(DATA_AREA, 0, 1, WORD, 5).hex(), "0177")
        before = client.read(FLAGS, 110)
        self.until(lambda: client.read(FLAGS, 110) != before)
        self.end(process)


class Control(S7Case):
    STOP = "32 01 00 00 00 02 00 10 00 00 29 00 00 00 00 00 09 50 5F 50 52 4F 47 52 41 4D"
    START = "32 01 00 00 00 02 00 14 00 00 28 00 00 00 00 00 00 FD 00 00 09 50 5F 50 52 4F 47 52 41 4D"

    # S7-NET-26
    def test_stop_and_start(self):
        self.write("a.awl", PROGRAM)
        for workbench in ("--no-workbench", "--port=0"):
            process = self.start("a.awl", workbench)
            client = self.client()
            self.assertEqual(client.ask(self.STOP)[10:].hex(), "000029")
            before = client.read(FLAGS, 20, 1, WORD)
            self.assertEqual(client.read(FLAGS, 20, 1, WORD), before)
            self.assertEqual(client.ask(self.STOP)[10:].hex(), "84022907")
            self.assertEqual(client.ask(self.START)[10:].hex(), "000028")
            self.until(lambda: client.read(FLAGS, 20, 1, WORD) != before)
            self.end(process)

    # S7-MEM-05: variables are not protected.
    def test_a_protected_cpu_is_not_stopped(self):
        self.write("plant/merker.toml", '[cpu]\nprotection = 2\npassword = "secret"\n')
        self.write("plant/a.awl", PROGRAM)
        self.start("plant", "--no-workbench")
        client = self.client()
        self.assertEqual(client.ask(self.STOP)[10:12].hex(), "d241")
        self.assertEqual(client.write(FLAGS, 30, b"\x55"), 0xFF)
        self.assertEqual(client.enter("wrong"), "d602")
        self.assertEqual(client.enter("secret"), "0000")
        self.assertEqual(self.client().ask(self.STOP)[10:12].hex(), "d241")  # another connection
        self.assertEqual(client.ask(self.STOP)[10:].hex(), "000029")


class Places(S7Case):
    def test_wrong_places(self):
        self.write("a.awl", PROGRAM)
        for place in ("x", "70000", "-1", "127.0.0.1:", "nowhere:102", "1.2.3:4"):
            self.assertIn(f"'{place}' is not a valid place", self.expect(USAGE, "run", "a.awl", "--s7", place).err)
        self.assertIn("--s7 needs real time", self.expect(USAGE, "run", "a.awl", "--s7", "0", "--for", "1s").err)
        with socket.create_server(("127.0.0.1", 0)) as other:
            port = other.getsockname()[1]
            said = self.expect(UNREADABLE, "run", "a.awl", "--no-workbench", "--s7", str(port)).err
        self.assertIn(f"--s7: port {port} of 127.0.0.1 cannot be used", said)

    def test_only_a_wish_opens_it_to_others_and_that_is_said(self):
        self.write("a.awl", PROGRAM)
        command = [os.environ["MERKER"], "run", "a.awl", "--no-workbench", "--s7", "0.0.0.0:0"]
        process = subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        self.assertIn("0.0.0.0:", process.stderr.readline())
        self.assertIn("warning: S7 communication has no encryption", process.stderr.readline())


class Settings(S7Case):
    def project(self, *lines):
        self.write("plant/merker.toml", "[communication]\n" + "\n".join(lines) + "\n")
        self.write("plant/a.awl", PROGRAM)

    # S7-LIM-05
    def test_connections_of_the_project(self):
        self.project("connections = 3", "pg = 1", "op = 1", "pdu = 480")
        for workbench in ("--no-workbench", "--port=0"):
            self.start("plant", workbench)
            clients = [self.client(kind) for kind in (3, 3, 1, 2)]
            self.assertEqual([client.confirmed for client in clients], [True, False, True, True])
            self.assertEqual(clients[0].pdu, 480)

    def test_connections_of_another_model_and_unlimited_ones(self):
        self.write("a.awl", PROGRAM)
        self.start("a.awl", "--no-workbench", "--cpu", "312C")
        self.assertEqual([self.client(3).confirmed for _ in range(5)], 4 * [True] + [False])
        self.project('connections = "unlimited"')
        self.start("plant", "--no-workbench")
        self.assertTrue(all(self.client(3).confirmed for _ in range(100)))

    def test_another_rack_or_slot(self):
        self.project("strict_slot = true")
        self.start("plant", "--no-workbench")
        self.assertFalse(self.client(slot=3).confirmed)
        self.assertFalse(self.client(slot=0x22).confirmed)
        self.assertTrue(self.client().confirmed)

    # A file opens no port to others.
    def test_the_address_of_the_project(self):
        self.project('address = "127.0.0.1:0"')
        self.start("plant", "--no-workbench", s7=())
        self.assertEqual(self.client().read(FLAGS, 30).hex(), "00")
        self.project('address = "0.0.0.0:0"')
        self.assertIn("merker.toml:2:11: error: 'address' must be a port of this computer",
                      self.expect(PROBLEMS, "check", "plant").err)


class Diagnosis(S7Case):
    # S7-LIM-05: who is connected at the end, who was refused and why.
    def test_connections(self):
        self.write("plant/merker.toml", "[communication]\nconnections = 3\nstrict_slot = true\n")
        self.write("plant/a.awl", PROGRAM)
        said = {}
        for form in ("--json", "--cpu=314C-2 PtP"):
            command = [os.environ["MERKER"], "diag", "plant", "--s7", "127.0.0.1:0", "--for", "3s", form]
            process = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.addCleanup(lambda: (process.kill(), process.communicate()))
            self.port = int(process.stderr.readline().rsplit(":", 1)[1])
            client = self.client()
            self.assertEqual(len(client.read(FLAGS, 0, 10)), 10)
            self.assertFalse(self.client(slot=3).confirmed)
            self.assertTrue(self.client(3).confirmed)
            self.assertFalse(self.client(3).confirmed)
            said[form], _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, GOOD)
        told = json.loads(said["--json"])["communication"]
        self.assertEqual((told["connections"], told["refused"], told["confirmed"], told["beyond"]), (3, 2, 2, False))
        self.assertEqual([one["why"] for one in told["refusals"]], ["resource", "slot"])
        mine = [one for one in told["clients"] if one["kind"] == "PG"]
        self.assertEqual((mine[0]["pdu"], mine[0]["requests"]), (240, 2))
        self.assertGreater(mine[0]["received"], 40)
        text = said["--cpu=314C-2 PtP"]
        self.assertRegex(text, r"S7 communication at 127\.0\.0\.1:\d+: 2 of 3 connections in use; kept: PG 1, OP 1, others 0\n")
        self.assertRegex(text, r"\n127\.0\.0\.1:\d+ +PG +240 +\d+ +2 ")
        self.assertRegex(text, r"refused \d+ s ago: 127\.0\.0\.1: it called another rack or slot\n")

    # S7-MEM-05: who is denied what it asks, and who is broken off, with the reason; one row for each.
    def test_incidents(self):
        self.write("plant/merker.toml", '[cpu]\nprotection = 3\npassword = "secret"\n')
        self.write("plant/a.awl", PROGRAM)
        command = [os.environ["MERKER"], "diag", "plant", "--s7", "127.0.0.1:0", "--for", "3s"]
        said = {}
        for form in ("--json", "--cpu=314C-2 PtP"):
            process = subprocess.Popen([*command, form], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.addCleanup(lambda: (process.kill(), process.communicate()))
            self.port = int(process.stderr.readline().rsplit(":", 1)[1])
            client = self.client()
            self.assertEqual(client.upload("0800001A"), "d241")
            self.assertEqual(client.service("_GARB"), "d241")
            self.assertEqual(client.enter("wrong"), "d602")
            self.assertEqual(self.client(setup=False).ask(SETUP[:-5] + "00 32")[10:12].hex(), "8500")
            for words in (b"GET / HTTP/1.0\r\n\r\n", CONNECT + bytes.fromhex("03 00 00 09 02 F0 80 00 00")):
                with socket.create_connection(("127.0.0.1", self.port), timeout=20) as other:
                    other.sendall(words)
                    while other.recv(100):
                        pass
            said[form], _ = process.communicate(timeout=60)
        told = json.loads(said["--json"])["communication"]
        self.assertEqual((told["refused"], told["broken"], told["denied"]), (0, 2, 4))
        self.assertEqual({one["why"]: one["times"] for one in told["refusals"]},
                         {"protection": 2, "password": 1, "setup": 1, "transport": 1, "protocol": 1})
        self.assertEqual({one["partner"] for one in told["refusals"]}, {"127.0.0.1"})
        text = said["--cpu=314C-2 PtP"]
        self.assertIn(" requests, 4 of them denied; connections: 0 refused, 2 broken off\n", text)
        self.assertRegex(text, r"refused \d+ s ago: 127\.0\.0\.1: a request needed the password \(2 times\)\n")
        self.assertRegex(text, r"refused \d+ s ago: 127\.0\.0\.1: broken off, no ISO on TCP\n")

    def test_wrong_use(self):
        self.write("a.awl", PROGRAM)
        self.write("a.scn", 'scenario "a"\n  wait 1s\n')
        self.assertIn("--s7 needs real time", self.expect(USAGE, "diag", "a.awl", "--s7", "0", "--scenario", "a.scn").err)


class Hostile(S7Case):
    def setUp(self):
        super().setUp()
        self.write("a.awl", PROGRAM)
        self.process = self.start("a.awl", "--no-workbench")

    def memory(self):
        """Resident bytes."""
        return int(pathlib.Path(f"/proc/{self.process.pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def well(self):
        """A well-behaved client is served, and the PLC works."""
        client = self.client()
        before = client.read(FLAGS, 20, 1, WORD)
        self.until(lambda: client.read(FLAGS, 20, 1, WORD) != before)
        client.close()

    # S7-LIM-05
    def test_the_thirteenth_connection_is_refused(self):
        clients = [self.client(kind) for kind in [1, 2] + 10 * [3]]
        self.assertTrue(all(client.confirmed for client in clients))
        for kind in (1, 2, 3):
            self.assertFalse(self.client(kind).confirmed)
        clients[3].close()
        self.until(lambda: self.client(3).confirmed)
        self.assertRegex(self.end(self.process), r"^13 connections, [3-9]\d* refused, ")

    def test_what_was_asked_before_nonsense_is_answered(self):
        client = self.client()
        client.read(FLAGS, 30)  # from now on values are there without a cycle
        request = client.job(4, client.item(FLAGS, 30, 1, BYTE, 0))
        frames = [struct.pack(">BBH", 3, 0, len(pdu) + 7) + b"\x02\xF0\x80" + pdu for pdu in (request, b"nonsense")]
        client.socket.sendall(b"".join(frames))
        self.assertEqual(client.hear()[14:15].hex(), "ff")
        with self.assertRaises(ConnectionError):
            client.hear()
        self.well()

    def test_a_client_that_never_reads(self):
        before = self.memory()
        for _ in range(3):
            client = self.client(3)
            request = client.job(4, client.item(FLAGS, 0, 200, BYTE, 0))
            frame = struct.pack(">BBH", 3, 0, len(request) + 7) + b"\x02\xF0\x80" + request
            client.socket.settimeout(1)
            with self.assertRaises(TimeoutError):
                while True:
                    client.socket.sendall(100 * frame)
        self.well()
        self.assertLess(self.memory(), before + (32 << 20))

    def test_counts_that_are_too_large(self):
        client = self.client()
        for size in (BYTE, WORD, 8):
            self.assertEqual(client.ask(client.job(4, client.item(DATA_AREA, 0, 0xFFFF, size, 1)))[10:12].hex(),
                             "8500" if size == BYTE else "0000")
        self.assertEqual(client.read(FLAGS, 0, 2).hex(), "0000")

    def test_half_open_connections(self):
        idle = [socket.create_connection(("127.0.0.1", self.port), timeout=20) for _ in range(20)]
        half = self.client(3)
        half.socket.sendall(bytes.fromhex("0300001F02F080"))
        for one in idle:
            self.assertEqual(one.recv(1), b"")
            one.close()
        self.assertEqual(half.socket.recv(1), b"")
        self.well()
        self.assertRegex(self.end(self.process), "^2 connections, 0 refused, 21 broken off")

    # Passwords of an address are looked at one after the other; the right one is right behind ten wrong ones, too.
    def test_guessing_passwords(self):
        self.end(self.process)
        self.write("plant/merker.toml", '[cpu]\nprotection = 3\npassword = "secret"\n')
        self.write("plant/a.awl", PROGRAM)
        self.process = self.start("plant", "--no-workbench")
        guessing = [self.client(3) for _ in range(10)]
        for client in guessing:
            client.send_password("wrong")
        self.assertEqual({client.hear()[20:22].hex() for client in guessing}, {"d602"})
        self.assertEqual(guessing[0].enter("secret"), "0000")
        self.assertEqual(self.client(own="127.0.0.2").enter("secret"), "0000")
        self.assertRegex(self.end(self.process), ", 10 denied$")

    # Without descriptors nobody comes in; with some again who waits does.
    def test_no_descriptors_left(self):
        used = len(os.listdir(f"/proc/{self.process.pid}/fd"))
        before = resource.prlimit(self.process.pid, resource.RLIMIT_NOFILE)
        resource.prlimit(self.process.pid, resource.RLIMIT_NOFILE, (used + 2, before[1]))
        waiting = [socket.create_connection(("127.0.0.1", self.port), timeout=20) for _ in range(6)]
        time.sleep(0.5)
        resource.prlimit(self.process.pid, resource.RLIMIT_NOFILE, before)
        self.well()
        for one in waiting:
            one.close()

    # Whoever has waited longest without a setup makes room for the next one.
    def test_silent_sockets_keep_nobody_out(self):
        silent = [socket.create_connection(("127.0.0.1", self.port), timeout=20) for _ in range(100)]
        self.assertEqual(silent[0].recv(1), b"")
        self.well()
        for one in silent:
            one.close()

    # Nor by asking for a connection without setting it up.
    def test_connections_without_a_setup_keep_nobody_out(self):
        waiting = [self.client(3, setup=False) for _ in range(30)]
        self.assertTrue(all(client.confirmed for client in waiting))
        self.well()
        with self.assertRaises(ConnectionError):
            waiting[0].hear()
        for client in waiting:
            client.close()

    def test_storms_and_noise(self):
        before, noise = self.memory(), random.Random(20)
        reset = struct.pack("ii", 1, 0)
        for number in range(200):
            client = socket.create_connection(("127.0.0.1", self.port), timeout=20)
            if number % 3:
                client.sendall(CONNECT + noise.randbytes(noise.randrange(400)))
            if number % 2:
                client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, reset)
            client.close()
        for _ in range(50):
            client = self.client(3)
            client.send(b"\x32" + noise.randbytes(noise.randrange(300)))
            client.close()
        self.well()
        self.assertLess(self.memory(), before + (32 << 20))

    def test_no_s7_at_all(self):
        with socket.create_connection(("127.0.0.1", self.port), timeout=20) as client:
            client.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
            try:
                self.assertEqual(client.recv(100), b"")
            except ConnectionResetError:
                pass
        self.well()
