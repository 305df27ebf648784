"""S7 servers of several stations in the workbench: the first one leads to the others as far as the lines between them are whole (S7-NET-15)."""
import re
import socket
import time

from served import Served

# The slot of the called TSAP, 0 to 31.
CALL = "0300001611E00000000500C0010AC1020100C20201{:02X}"
SETUP = bytes.fromhex("0300001902F08032010000000100080000F0000001000100F0")
MB51 = bytes.fromhex("0300001F02F080320100000002000E00000401120A10020001000083000198")
CONFIRM, REFUSE = 0xD0, 0x80

# Press and Belt on one MPI, Belt and Mill on an Ethernet; Mill has an MPI of its own.
LAB = "".join(f'[[station]]\nname = "{name}"\nfolder = "{name.lower()}"\n' for name in ("Press", "Belt", "Mill")) + """[[subnet]]
name = "MPI(1)"
kind = "mpi"
nodes = [ {station = "Press", address = 2}, {station = "Belt", address = 3} ]
[[subnet]]
name = "Ethernet(1)"
kind = "ethernet"
nodes = [ {station = "Belt", address = "192.168.0.1"}, {station = "Mill", address = "192.168.0.2"} ]
[[subnet]]
name = "MPI(2)"
kind = "mpi"
nodes = [ {station = "Mill", address = 5} ]
"""


def packet(client):
    head = client.recv(4, socket.MSG_WAITALL)
    return head + client.recv(int.from_bytes(head[2:4], "big") - 4, socket.MSG_WAITALL)


class Ways(Served):
    command = "workbench"
    arguments = ("--s7", "0")

    def target(self):
        return ["lab"]

    def prepare(self):
        lab = self.folder / "lab"
        lab.mkdir()
        (lab / "merker.toml").write_text(LAB, encoding="utf-8")
        for number, name in enumerate(("press", "belt", "mill"), 1):
            (lab / name).mkdir()
            (lab / name / "merker.toml").write_text('[cpu]\nmodel = "314C-2 PN/DP"\n', encoding="utf-8")
            (lab / name / "main.awl").write_text(
                f"ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L {number}; T MB 51;\nEND_ORGANIZATION_BLOCK\n", encoding="utf-8")

    def start(self):
        super().start()
        self.ports = {}
        while len(self.ports) < 3:
            found = re.fullmatch(r"S7 communication of (\w+): 127\.0\.0\.1:(\d+)\n", self.process.stderr.readline())
            self.ports[found.group(1)] = int(found.group(2))

    def call(self, slot, station="Press"):
        """A socket, and the answer to its call."""
        client = socket.create_connection(("127.0.0.1", self.ports[station]), timeout=20)
        self.addCleanup(client.close)
        client.sendall(bytes.fromhex(CALL.format(slot)))
        return client, packet(client)[5]

    def number(self, slot, station):
        """What the station behind this slot calls itself; nothing: the call is refused."""
        client, answer = self.call(slot, station)
        with client:
            if answer != CONFIRM:
                return None
            for request in SETUP, MB51:
                client.sendall(request)
                told = packet(client)
            return told[-1]

    def leads(self, stations, at="Press"):
        """Soon: lines are looked at between two moves, and a program that was just loaded has not said its number yet."""
        end = time.monotonic() + 20
        while (found := [self.number(slot, at) for slot in stations]) != list(stations.values()):
            self.assertLess(time.monotonic(), end, found)
            time.sleep(0.02)

    def until(self, slot, answer):
        end = time.monotonic() + 20
        while self.call(slot)[1] != answer:
            self.assertLess(time.monotonic(), end, (slot, answer))
            time.sleep(0.02)

    def test_a_way_is_as_good_as_its_lines(self):
        browser = self.browser()
        self.leads({2: 1, 3: 2, 5: 3, 7: 1})
        self.leads({2: 2}, "Belt")
        self.leads({2: 3}, "Mill")
        stands, _ = self.call(5)
        browser.call("stations.fault", subnet="MPI(1)", station="Belt", fault="break")
        self.until(3, REFUSE)
        self.until(5, REFUSE)
        while stands.recv(64):  # it is closed
            pass
        self.leads({2: 1})
        self.leads({2: 3}, "Mill")  # at its own port it is there
        browser.call("stations.fault", subnet="MPI(1)", fault="mend")
        self.until(5, CONFIRM)
        browser.call("stations.fault", subnet="Ethernet(1)", fault="break")
        self.until(5, REFUSE)
        self.leads({3: 2})
        browser.call("stations.fault", subnet="Ethernet(1)", fault="mend")
        self.until(5, CONFIRM)

    def test_a_station_without_power_leads_nowhere(self):
        browser = self.browser()
        browser.call("stations.command", station="Belt", command="powerOff")
        self.until(5, REFUSE)
        self.until(3, REFUSE)
        browser.call("stations.command", station="Belt", command="powerOn")
        self.until(5, CONFIRM)
        browser.call("stations.show", station="Mill")  # whichever is shown
        self.leads({2: 1, 3: 2, 5: 3})
        answer = browser.call("diagnosis.connections")
        self.assertTrue(answer["place"].endswith(str(self.ports["Mill"])))

    def test_stations_that_are_loaded_again(self):
        browser = self.browser()
        browser.call("stations.reload")
        self.until(5, CONFIRM)
        self.leads({2: 1, 3: 2, 5: 3})
        browser.call("stations.fault", subnet="MPI(1)", fault="break")
        self.until(5, REFUSE)


class Later(Ways):
    """The project is opened when the server runs."""
    def target(self):
        return ["--workspace", str(self.folder)]

    def start(self):
        Served.start(self)
        self.browser().call("projects.open", folder="lab")
        self.ports = {}
        for name in ("Press", "Belt", "Mill"):
            self.ports[name] = int(self.process.stderr.readline().rsplit(":", 1)[1])
        self.until(5, CONFIRM)
