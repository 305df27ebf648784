"""Whatever one browser asks for: the others are answered, the memory stays bounded, and the program can be ended. docs/safety.md"""
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import threading
import time
import unittest
import urllib.request

from served import Served
from web_socket import Browser, Closed, WebSocket

# What another browser may wait longer than one that asks an idle server on the same machine at the same time.
LONGEST_PING = 0.1
# Who is attacked has more threads that wait for a busy machine than who is not.
SHARE = 3
SECONDS = 1
MEGA = 1 << 20
# What a server may grow by while it is attacked: the messages, their values and the answers of a few browsers.
MOST_MEMORY = 400 * MEGA


def memory(pid, what="VmRSS"):
    status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    return int(re.search(rf"^{what}:\s+(\d+) kB", status, re.M).group(1)) << 10


class Pinger:
    def __init__(self, port):
        self.process = subprocess.Popen([sys.executable, str(pathlib.Path(__file__).with_name("pinger.py")), str(port)],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout.readline() == "ready\n"

    def slowest(self):
        out, _ = self.process.communicate("\n", timeout=300)
        return float(out)


@unittest.skipIf("ASAN_OPTIONS" in os.environ, "sanitizers need other times and more memory")
class Attacking(Served):
    def setUp(self):
        super().setUp()
        folder = self.folder / "quiet"
        folder.mkdir()
        self.quiet = subprocess.Popen([os.environ["MERKER"], "run", str(self.project), "--port", "0"], cwd=folder, text=True,
                                      stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.quiet_port = int(re.search(r":(\d+)/", self.quiet.stdout.readline()).group(1))
        self.addCleanup(self.end_quiet)

    def end_quiet(self):
        self.quiet.kill()
        self.quiet.communicate(timeout=60)

    def prepare(self):
        super().prepare()
        (self.project / "big.awl.txt").write_text("x" * (7 * MEGA), encoding="ascii")

    def flood(self, messages, seconds=SECONDS, read=True):
        """One browser sends these again and again; `read`: it takes what comes."""
        flooder = Browser(self.port)
        over = threading.Event()

        def send():
            try:
                while not over.is_set():
                    for message in messages:
                        flooder.send(message)
            except OSError:
                pass

        def receive():
            try:
                while flooder.socket.recv(1 << 20):
                    pass
            except OSError:
                pass

        threads = [threading.Thread(target=one, daemon=True) for one in ([send, receive] if read else [send])]
        for thread in threads:
            thread.start()
        time.sleep(seconds)
        over.set()
        try:
            flooder.socket.shutdown(socket.SHUT_RDWR)
        except OSError:  # the server has closed it
            pass
        flooder.close()
        for thread in threads:
            thread.join(60)

    def stands(self, attack, afterwards=()):
        """Another browser is answered meanwhile, the memory stays, and all of it is over with the attack.

        `afterwards`: requests that let the program run again where the attack may have stopped it."""
        pingers = [Pinger(self.port), Pinger(self.quiet_port)]
        before = memory(self.process.pid)
        try:
            attack()
        finally:
            attacked, quiet = [one.slowest() for one in pingers]
        self.assertLess(attacked, SHARE * quiet + LONGEST_PING, f"an idle server on this machine needed {quiet:.3f} s")
        self.assertLess(memory(self.process.pid, "VmHWM") - before, MOST_MEMORY)
        browser = self.browser()
        end = time.monotonic() + 60
        while browser.state.get("mode") != "RUN" and time.monotonic() < end:
            for request in afterwards:  # again, because requests of the attacker may still be under way
                browser.ask(**request)
            time.sleep(0.2)
            browser.call("ping")
        self.assertEqual(browser.state.get("mode"), "RUN")

    def request(self, do, **fields):
        return json.dumps({"id": 1, "do": do, **fields})


class LargeProgram(Attacking):
    """3 MB of machine code: to translate it for the processor of this computer takes about a second."""

    def prepare(self):
        super().prepare()
        (self.project / "merker.toml").write_text('[project]\nname = "Plant"\n[cpu]\nmodel = "generic"\n', encoding="utf-8")
        self.write("A 0.0")

    def write(self, operand):
        body = f" U E 0.0;\n U E 0.1;\n = {operand};\n L MW 20;\n + 1;\n T MW 20;\n" * 2000
        (self.project / "large.awl").write_text("".join(f"FUNCTION FC {i} : VOID\nBEGIN\nNETWORK\n{body}END_FUNCTION\n"
                                                        for i in range(1, 81)), encoding="ascii")

    def test_the_engine_changes(self):
        self.stands(lambda: self.flood([self.request("cpu.stop"), self.request("cpu.engine", engine="jit"),
                                        self.request("cpu.engine", engine="interpreter")]), afterwards=[{"do": "cpu.start"}])

    def test_it_is_loaded(self):
        browser = self.browser()
        browser.call("cpu.stop")
        browser.call("cpu.engine", engine="jit")
        browser.call("cpu.start")
        browser.until(lambda b: b.state.get("mode") == "RUN")

        def attack():
            for operand in ("A 0.1", "A 0.2"):
                self.write(operand)
                time.sleep(1.5)  # until it is seen
                browser.call("program.load")
        self.stands(attack)


class LongCycle(Attacking):
    """A cycle of some seconds, which whoever saves the CPU waits for."""

    def prepare(self):
        super().prepare()
        (self.project / "merker.toml").write_text('[project]\nname = "Plant"\n[cpu]\ncycle_monitoring = "6s"\n', encoding="utf-8")
        inner = "      T     MW 102\n      L     MW 102\n" * 50
        (self.project / "main.awl").write_text("ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      L     20000\nmore: T     MW 100\n"
                                               f"{inner}      L     MW 100\n      LOOP  more\nEND_ORGANIZATION_BLOCK\n", encoding="ascii")

    def test_the_cpu_is_saved(self):
        self.stands(lambda: self.flood([self.request("cpu.save", path="here.state", replace=True)]))


class Attacked(Attacking):
    def test_hardware_with_a_problem_in_each_row(self):
        text = "[project]\nname = \"x\"\n" + "[[module]]\nslot = 4\n" * 6000
        self.stands(lambda: self.flood([self.request("hardware.edit", text=text)]))

    def test_hardware_of_4_megabytes(self):
        self.stands(lambda: self.flood([self.request("hardware.edit", text="[[module]]\n" * 300_000)]))

    def test_symbols(self):
        row = '126,{:<24}M   {:>7}  BOOL      \r\n'
        text = "".join(row.format(f"S{i}", f"{i // 8 % 256}.{i % 8}") for i in range(60_000))
        rows = [{"symbol": f"S{i}", "operand": f"M {i // 8 % 256}.{i % 8}", "type": "BOOL"} for i in range(20_000)]
        self.stands(lambda: self.flood([self.request("symbols.import", format="asc", text=text),
                                        self.request("symbols.check", rows=rows),
                                        self.request("symbols.export", rows=rows, format="sdf")]))

    def test_a_pile_of_large_files(self):
        self.stands(lambda: self.flood([self.request("files.read", path="big.awl.txt")] * 200))

    def test_a_pile_of_large_files_that_nobody_reads(self):
        self.stands(lambda: self.flood([self.request("files.read", path="big.awl.txt")] * 200, read=False))

    def test_large_messages(self):
        padding = "x" * (4 * MEGA - 100)
        self.stands(lambda: self.flood([self.request("ping", x=padding)]))

    def test_messages_of_many_values(self):
        for part in ("[],", "{},", "0,", '"a",'):
            values = (part * (4 * MEGA // len(part) - 100))[:-1]
            few = (part * 120_000)[:-1]
            with self.subTest(part):
                self.stands(lambda: self.flood([f'{{"id": 1, "do": "ping", "x": [{values}]}}',
                                                f'{{"id": 1, "do": "ping", "x": [{few}]}}'], 2))

    def test_everything_that_can_be_watched(self):
        items = [{"operand": f"M {i // 8 % 256}.{i % 8}", "format": "BIN"} for i in range(1000)]
        lists = [self.request("watch.set", list=number, everyMs=0, items=items) for number in range(64)]
        curves = [self.request("trend.set", list=number, items=[{"operand": "MW 20"}] * 100) for number in range(5)]
        self.stands(lambda: self.flood(lists + curves))

    def test_triggered_lists(self):
        items = [{"operand": f"M {i // 8 % 256}.{i % 8}", "value": "0"} for i in range(1000)]
        self.stands(lambda: self.flood([self.request(do, list=number, point=point, items=items)
                                        for number in range(64) for point in ("begin", "end")
                                        for do in ("watch.set", "modify.set")]))

    def test_checks_of_large_texts(self):
        text = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n" + "      U     E 0.0;\n" * 150_000 + "END_FUNCTION\n"
        self.stands(lambda: self.flood([self.request("program.check", files=[{"path": "main.awl", "text": text}])]))

    def test_recordings_of_meaningless_fields(self):
        padding = "x" * (4 * MEGA - 200)
        self.stands(lambda: self.flood([self.request("record.start"), *[
            self.request("variables.write", items=[{"operand": "MW 30", "value": "1"}], x=padding)] * 50]))

    def test_requests_that_wait_for_a_compilation(self):
        padding = "x" * (4 * MEGA - 200)
        self.stands(lambda: self.flood([self.request("files.create", path="new.awl", text="//"),
                                        *[self.request("symbols.export", format="asc", x=padding)] * 100]))

    def test_cycles_one_by_one_and_steps(self):
        self.stands(lambda: self.flood([self.request("time.pace", mode="pause"), self.request("time.step", cycles=1_000_000),
                                        self.request("debug.step", kind="over"), self.request("debug.go"),
                                        self.request("time.pace", mode="fast"), self.request("time.pace", mode="real")]),
                    afterwards=[{"do": "debug.go"}, {"do": "time.pace", "mode": "real"}])

    def test_a_recording_with_everything_at_once(self):
        action = json.dumps({"at": 0, "do": "variables.write",
                             "items": [{"operand": f"MW {2 * i}", "value": "1"} for i in range(100)]})
        (self.project / "all.rec").write_text((action + "\n") * 1500, encoding="ascii")
        self.stands(lambda: self.flood([self.request("play.start", path="all.rec")]))

    def test_reconnects(self):
        def attack():
            end = time.monotonic() + SECONDS
            while time.monotonic() < end:
                try:
                    one = WebSocket(self.port)
                    one.send(self.request("files.read", path="big.awl.txt"))
                    one.close()
                except (OSError, Closed):
                    pass
        self.stands(attack)

    def test_half_a_request_shuts_nobody_out(self):
        def attack():
            held = []
            for _ in range(600):
                one = socket.create_connection(("127.0.0.1", self.port), 60)
                one.sendall(b"GET / HTTP/1.1\r\nHost: ")
                held.append(one)
            begin = time.monotonic()
            self.browser().call("ping")
            self.assertLess(time.monotonic() - begin, 3)
            for one in held:
                one.close()
        self.stands(attack)

    def test_the_page_is_there_once_however_many_ask_for_it(self):
        with urllib.request.urlopen(f"http://127.0.0.1:{self.port}/") as page:
            script = re.search(r'src="[./]*(assets/[^"]+\.js)"', page.read().decode()).group(1)
        before = memory(self.process.pid)
        held = []
        for _ in range(200):
            one = socket.create_connection(("127.0.0.1", self.port), 60)
            one.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            one.sendall(f"GET /{script} HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n\r\n".encode("ascii"))
            held.append(one)
        for one in held:
            self.assertTrue(one.recv(12).startswith(b"HTTP/1.1 200"))
        self.assertLess(memory(self.process.pid) - before, 20 * MEGA)
        for one in held:
            one.close()

    def test_many_browsers_shut_nobody_out_who_comes_later(self):
        held = []
        for _ in range(300):
            try:
                held.append(WebSocket(self.port))
            except (OSError, Closed):
                pass
        for one in held:
            one.close()
        begin = time.monotonic()
        while True:
            try:
                self.browser().call("ping")
                break
            except Closed:
                self.assertLess(time.monotonic() - begin, 5)

    def test_the_lists_of_many_browsers(self):
        """As many operands with long names as a browser may watch."""
        before = memory(self.process.pid)
        watching = [self.browser() for _ in range(30)]
        for browser in watching:
            refused = 0
            for number in range(5):
                items = [{"operand": f"{'x' * 380}{number:02}{i:04}"} for i in range(1000)]
                refused += "problems" in browser.ask("watch.set", list=number, items=items)
            self.assertEqual(refused, 3)
        self.assertLess(memory(self.process.pid, "VmHWM") - before, 200 * MEGA)
        for browser in watching:
            browser.close()
        end = time.monotonic() + 20
        while memory(self.process.pid) - before > 60 * MEGA and time.monotonic() < end:
            time.sleep(0.2)
        self.assertLess(memory(self.process.pid) - before, 60 * MEGA)

    def test_memory_is_free_again(self):
        before = memory(self.process.pid)
        for _ in range(3):
            self.flood([self.request("files.read", path="big.awl.txt")] * 50, 1, read=False)
        end = time.monotonic() + 20
        while memory(self.process.pid) - before > 60 * MEGA and time.monotonic() < end:
            time.sleep(0.2)
        self.assertLess(memory(self.process.pid) - before, 60 * MEGA)

    def test_the_end_comes_soon_whatever_waits(self):
        browser = self.browser()
        padding = "x" * (4 * MEGA - 200)
        for message in [self.request("files.read", path="big.awl.txt")] * 100 + [self.request("ping", x=padding)] * 20:
            browser.socket.settimeout(0.5)
            try:
                browser.send(message)
            except OSError:
                break
        begin = time.monotonic()
        self.assertEqual(self.end(), 0)
        self.assertLess(time.monotonic() - begin, 5)

    def test_the_end_comes_soon_while_something_compiles(self):
        browser = self.browser()
        text = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n" + "      U     E 0.0;\n" * 180_000 + "END_FUNCTION\n"
        browser.send(self.request("program.check", files=[{"path": "main.awl", "text": text}]))
        time.sleep(0.3)
        begin = time.monotonic()
        self.assertEqual(self.end(), 0)
        self.assertLess(time.monotonic() - begin, 5)


class OtherAddress(Served):
    arguments = ("--listen", "127.0.0.2")

    def test_the_address_it_listens_to_is_its_own_name(self):
        with socket.create_connection(("127.0.0.2", self.port), 60) as connection:
            connection.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.2:{self.port}\r\nConnection: close\r\n\r\n".encode("ascii"))
            self.assertTrue(connection.recv(100).startswith(b"HTTP/1.1 200 "))


class Hanging(Served):
    """The trace goes into a pipe that nobody empties: the PLC's thread stands until somebody does, as it would in an endless loop."""

    arguments = ("--trace", "pipe", "--watch", "MW 20", "--set", "MW 20 = 0")

    def start(self):
        os.mkfifo(self.folder / "pipe")
        self.pipe = None
        opener = threading.Thread(target=lambda: setattr(self, "pipe", os.open(self.folder / "pipe", os.O_RDONLY)))
        opener.start()
        super().start()
        opener.join(60)
        self.addCleanup(lambda: os.close(self.pipe) if self.pipe is not None else None)

    def hang(self):
        browser = self.browser()
        browser.call("time.pace", mode="fast")
        seen = lambda b: [event for event in b.events if event["event"] == "stalled"]
        browser.until(seen)
        self.assertEqual(seen(browser)[0]["place"], "the PLC")
        self.assertGreaterEqual(seen(browser)[0]["seconds"], 2)
        return browser, seen

    def test_browsers_are_told_and_told_again_when_it_is_over(self):
        browser, seen = self.hang()
        browser.until(lambda b: len(seen(b)) > 1 and seen(b)[-1]["seconds"] >= 4)
        os.set_blocking(self.pipe, False)
        over = threading.Event()

        def drain():
            while not over.is_set():
                try:
                    os.read(self.pipe, 1 << 20)
                except BlockingIOError:
                    time.sleep(0.01)

        thread = threading.Thread(target=drain)
        thread.start()
        try:
            browser.until(lambda b: seen(b)[-1]["seconds"] == 0)
            cycles = browser.state["cycles"]
            browser.until(lambda b: b.state["cycles"] > cycles)
            self.assertEqual(self.end(), 0)
        finally:
            over.set()
            thread.join()
        self.assertIn("the PLC has not ended for 2 s", self.err)
        self.assertIn("the PLC has ended", self.err)

    def test_it_can_be_ended_all_the_same(self):
        for wish in (signal.SIGTERM,):
            self.hang()
            begin = time.monotonic()
            self.process.send_signal(wish)
            self.out, self.err = self.process.communicate(timeout=30)
            self.assertLess(time.monotonic() - begin, 10)
            self.assertEqual(self.process.returncode, -wish)
            self.assertIn("ended although the PLC has not", self.err)


if __name__ == "__main__":
    unittest.main()
