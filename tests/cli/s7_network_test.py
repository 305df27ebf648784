"""S7 servers of several stations: a programming device reaches each CPU at its own port (S7-NET-01, S7-NET-26)."""
import contextlib

from s7_client import *

LAB = """[[station]]
name = "Press"
folder = "press"
[[station]]
name = "Belt"
folder = "belt"
[[station]]
name = "Mill"
folder = "mill"
[[global_data]]
circle = 1
from = "Press/MB 100:2"
to = ["Belt/MB 200"]
rate = 1
[[subnet]]
kind = "mpi"
nodes = [ {station = "Press", address = 2}, {station = "Belt", address = 3} ]
"""


class NetworkS7(S7Case):
    def lab(self):
        self.write("lab/merker.toml", LAB)
        for name, number in ("press", 1), ("belt", 2):
            self.write(f"lab/{name}/merker.toml", '[cpu]\nmodel = "314C-2 PtP"\n')
            self.write(f"lab/{name}/main.awl", PROGRAM + block(f"      L     {number}\n      T     MW 50", 100))
        self.write("lab/mill/merker.toml", '[cpu]\nmodel = "SINUMERIK 810 GA3"\n')
        self.write("lab/mill/main.s5", "OB 1\n L KB 3\n T MB 51\n BE\n")

    def serve(self, count=3):
        command = [os.environ["MERKER"], "run", "lab", "--s7", "0", "--no-workbench"]
        process = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        self.ports = {}
        while len(self.ports) < count:
            line = process.stderr.readline()
            self.assertNotEqual(line, "")
            found = re.fullmatch(r"S7 communication of (\w+): 127\.0\.0\.1:(\d+)\n", line)
            if found:
                self.ports[found.group(1)] = int(found.group(2))
        return process

    def at(self, station):
        client = Client(self.ports[station])
        self.addCleanup(client.close)
        return client

    # S7-NET-15, S7-NET-01: one port, and the station by its address.
    def test_all_at_the_first_port(self):
        self.lab()
        process = self.serve()
        for slot, station in (2, b"\x01"), (3, b"\x02"), (7, b"\x01"):
            client = Client(self.ports["Press"], slot=slot)
            self.addCleanup(client.close)
            self.assertEqual(client.read(FLAGS, 51), station, slot)
        for _ in range(100):  # and it stays so with many
            with contextlib.closing(Client(self.ports["Press"], slot=3)) as client:
                self.assertEqual(client.read(FLAGS, 51), b"\x02")
        pieces = Client.__new__(Client)  # the call comes byte by byte
        pieces.socket, pieces.number = socket.create_connection(("127.0.0.1", self.ports["Press"]), timeout=20), 1
        for byte in CONNECT[:-2] + b"\x01\x03":
            pieces.socket.sendall(bytes([byte]))
            time.sleep(0.001)
        self.assertEqual(pieces.tpdu()[1:2], b"\xD0")
        pieces.ask(SETUP)
        self.assertEqual(pieces.read(FLAGS, 51), b"\x02")
        pieces.close()
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)

    # S7-NET-15: a station on PROFIBUS is behind its master.
    def test_an_intelligent_slave_behind_its_master(self):
        self.lab()
        stations = "".join(f'[[station]]\nname = "{name}"\nfolder = "{name.lower()}"\n' for name in ("Press", "Belt"))
        self.write("lab/merker.toml", stations + """[[subnet]]
kind = "profibus"
nodes = [ {station = "Press", address = 2, master = true} ]
[[slave]]
station = "Belt"
address = 12
modules = [ {output = 40, local = 40} ]
""")
        for name in "press", "belt":
            self.write(f"lab/{name}/merker.toml", '[cpu]\nmodel = "314C-2 DP"\n')
        self.serve(2)
        for slot, station in (2, b"\x01"), (12, b"\x02"):
            client = Client(self.ports["Press"], slot=slot)
            self.addCleanup(client.close)
            self.until(lambda: client.read(FLAGS, 51) == station)

    def test_each_at_its_port(self):
        self.lab()
        process = self.serve()
        self.assertEqual(list(self.ports), ["Press", "Belt", "Mill"])
        press, belt, mill = self.at("Press"), self.at("Belt"), self.at("Mill")
        self.assertEqual([one.read(FLAGS, 51) for one in (press, belt)], [b"\x01", b"\x02"])
        self.until(lambda: mill.read(FLAGS, 51) == b"\x03")
        self.assertEqual(press.write(FLAGS, 100, b"\x12\x34"), 0xFF)
        self.until(lambda: belt.read(FLAGS, 200, 2) == b"\x12\x34")  # by global data
        self.assertEqual(belt.write(FLAGS, 30, b"\x55"), 0xFF)
        self.assertEqual(press.read(FLAGS, 30), b"\x00")
        self.assertEqual(belt.write(INPUTS, 0, b"\x80"), 0xFF)  # Belt goes to STOP, and is served all the same
        self.until(lambda: belt.read(FLAGS, 20, 1, WORD) == (time.sleep(0.05), belt.read(FLAGS, 20, 1, WORD))[1])
        before = press.read(FLAGS, 20, 1, WORD)
        self.until(lambda: press.read(FLAGS, 20, 1, WORD) != before)
        for one in press, belt, mill:
            one.close()
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=20)
        self.assertEqual(process.returncode, FAULT)
        self.assertRegex(told, r"S7 communication of Belt: 1 connection, 0 refused")

    def test_what_does_not_go(self):
        self.lab()
        self.assertIn("the first one must be at most 65533", self.expect(USAGE, "run", "lab", "--s7", "65534").err)
        self.assertIn("--s7 and --trace exclude each other",
                      self.expect(USAGE, "run", "lab", "--s7", "0", "--trace", "t.csv", "--watch", "Press/MW 20").err)
        self.assertIn("--s7 needs real time", self.expect(USAGE, "run", "lab", "--s7", "0", "--for", "1s").err)
        self.write("lab/merker.toml", "".join(f'[[station]]\nname = "S{i}"\nfolder = "press"\n' for i in range(65)))
        self.assertIn("--s7 serves at most 64 stations", self.expect(USAGE, "run", "lab", "--s7", "0").err)
