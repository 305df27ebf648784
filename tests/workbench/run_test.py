import json
import os
import socket
import subprocess
import time
import unittest
import urllib.request

from served import Served


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as one:
        return one.getsockname()[1]


class Run(Served):
    def test_the_page_is_there(self):
        with urllib.request.urlopen(f"http://127.0.0.1:{self.port}/") as page:
            self.assertIn("text/html", page.headers["Content-Type"])
            self.assertIn(b"<title>Merker", page.read())

    def test_a_browser_sees_the_plc_and_changes_it(self):
        browser = self.browser()
        browser.until(lambda b: b.state.get("mode") == "RUN" and b.state["cycles"] > 3)
        self.assertEqual(browser.state["project"]["name"], "Plant")
        browser.call("watch.set", list=1, items=[{"operand": "A 0.0"}])
        browser.until_values([[0, "0", 0]])
        browser.call("variables.write", items=[{"operand": "E 0.0", "value": "1"}])
        browser.until_values([[0, "1", 1]])

    def test_two_browsers_see_the_same_state(self):
        one, two = self.browser(), self.browser()
        two.until(lambda b: b.state.get("mode") == "RUN")
        one.call("cpu.switch", position="STOP")
        two.until(lambda b: b.state.get("mode") == "STOP" and b.state["switch"] == "STOP")
        two.call("time.pace", mode="pause")
        one.until(lambda b: b.state["pace"]["mode"] == "pause")

    def test_the_server_stays_when_the_cpu_stops(self):
        browser = self.browser()
        browser.call("variables.write", items=[{"operand": "E 0.7", "value": "1"}])
        browser.until(lambda b: b.state.get("mode") == "STOP")
        self.assertIn("BCD", browser.state["stopReason"])
        browser.call("variables.write", items=[{"operand": "E 0.7", "value": "0"}])
        browser.call("cpu.start", kind="warm")
        browser.until(lambda b: b.state.get("mode") == "RUN")
        self.assertEqual(self.end(), 0)

    def test_a_connection_may_end_at_any_time(self):
        for _ in range(20):
            self.browser().close()
        self.browser().until(lambda b: b.state.get("mode") == "RUN")


class Clients(Served):
    arguments = ("--s7", "0")
    REQUEST = bytes.fromhex("0300001611E00000000500C0010AC1020100C2020102")

    def start(self):
        super().start()
        line = "-"
        while line and not line.startswith("S7 communication: "):  # warnings may stand before it
            line = self.process.stderr.readline()
        self.s7 = int(line.split(":")[2])

    def client(self):
        client = socket.create_connection(("127.0.0.1", self.s7), timeout=20)
        self.addCleanup(client.close)
        return client

    def answer(self):
        client = self.client()
        client.sendall(self.REQUEST)
        try:
            return client.recv(100)
        except ConnectionError:
            return b""

    def test_a_station_without_power_is_not_reachable(self):
        browser, client = self.browser(), self.client()
        client.sendall(self.REQUEST)
        self.assertEqual(client.recv(100)[5], 0xD0)
        browser.call("cpu.power", on=False)
        self.assertEqual(client.recv(100), b"")
        self.assertEqual(self.answer(), b"")
        browser.call("cpu.power", on=True)
        browser.until(lambda b: b.state.get("powered"))
        for _ in range(200):
            if answer := self.answer():
                break
            time.sleep(0.05)
        self.assertEqual(answer[5], 0xD0)


class Callers(Clients):
    def prepare(self):
        super().prepare()
        self.partner = socket.create_server(("127.0.0.1", 0))
        self.partner.settimeout(20)
        self.addCleanup(self.partner.close)
        with open(self.project / "merker.toml", "a", encoding="utf-8") as project:
            project.write('[cpu]\nmodel = "generic"\n[[connection]]\nid = "W#16#1"\n'
                          f'partner = "tcp://127.0.0.1:{self.partner.getsockname()[1]}"\n')

    def test_without_power_nobody_is_called(self):
        browser = self.browser()
        self.partner.accept()[0].close()
        browser.call("cpu.power", on=False)
        self.assertEqual(self.answer(), b"")
        self.partner.settimeout(0)
        try:  # what was on its way
            while True:
                self.partner.accept()[0].close()
        except BlockingIOError:
            pass
        self.partner.settimeout(3)
        with self.assertRaises(TimeoutError):
            self.partner.accept()
        browser.call("cpu.power", on=True)
        self.partner.settimeout(20)
        self.partner.accept()[0].close()


# Outside of the S7 server a CP 343-1 IT listens at ports of its own.
class Cp(Clients):
    def prepare(self):
        super().prepare()
        (self.line, self.web) = (free_port() for _ in range(2))
        with open(self.project / "merker.toml", "a", encoding="utf-8") as project:
            project.write('[cpu]\nmodel = "314C-2 DP"\n[[module]]\nslot = 4\ntype = "6GK7 343-1GX11-0XE0"\n'
                          f'web = {{ port = {self.web} }}\n[[connection]]\nkind = "tcp"\nid = 1\n'
                          f'partner = "tcp://127.0.0.1"\nactive = false\nlocal_port = {self.line}\n')

    def until_called(self, port, listens):
        """Whoever listens there takes the call."""
        end = time.monotonic() + 20
        while True:
            try:
                socket.create_connection(("127.0.0.1", port), timeout=20).close()
                called = True
            except ConnectionRefusedError:
                called = False
            if called == listens:
                return
            self.assertLess(time.monotonic(), end, (port, listens))
            time.sleep(0.02)

    def test_without_power_it_does_not_listen(self):
        browser = self.browser()
        for on in True, False, True:
            browser.call("cpu.power", on=on)
            self.until_called(self.line, on)
            self.until_called(self.web, on)
        partner = socket.create_connection(("127.0.0.1", self.line), timeout=20)
        page = socket.create_connection(("127.0.0.1", self.web), timeout=20)
        browser.call("cpu.power", on=False)
        self.assertEqual((partner.recv(1), page.recv(1)), (b"", b""))  # what stands is closed
        for one in partner, page:
            one.close()


class Values(Served):
    arguments = ("--set", "E 0.0 = 1", "--print", "A 0.0", "--json")

    def start(self):  # the address stands beside the values, not among them
        self.process = subprocess.Popen([os.environ["MERKER"], "run", "plant", "--port", "0", *self.arguments],
                                        cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(self.end)
        self.port = int(self.process.stderr.readline().split(":")[3].split("/")[0])

    def test_values_at_the_end_are_printed(self):
        self.browser().until(lambda b: b.state.get("cycles", 0) > 3)
        self.assertEqual(self.end(), 0)
        self.assertIs(json.loads(self.out)["A 0.0"], True)


class Port(Served):
    def test_a_port_in_use_is_told(self):
        call = subprocess.run([os.environ["MERKER"], "run", "plant", "--port", str(self.port)], cwd=self.folder,
                              capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(call.returncode, 4)
        self.assertIn("is in use by another program; choose another one with --port", call.stderr)

    def test_other_computers_need_token_and_certificate(self):
        for more in ((), ("--token", "x" * 16)):
            call = subprocess.run([os.environ["MERKER"], "run", "plant", "--port", "0", "--listen", "0.0.0.0", *more],
                                  cwd=self.folder, capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual(call.returncode, 2)
            self.assertIn("that needs --token, --certificate and --key", call.stderr)

    def test_a_token_that_can_be_guessed_or_not_be_typed_is_refused(self):
        for token in ("x", "a b&c=d#e-0123456789"):
            call = subprocess.run([os.environ["MERKER"], "run", "plant", "--port", "0", "--token", token],
                                  cwd=self.folder, capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual(call.returncode, 2)
            self.assertIn("a token has 16 characters or more: letters, digits, - . _ ~", call.stderr)


class Localhost(Served):
    def prepare(self):
        super().prepare()
        self.arguments = ("--listen", "localhost")

    def test_localhost_is_this_machine(self):
        self.browser().until(lambda b: b.state.get("mode") == "RUN")


class Sinumerik(Served):
    """The same server over a STEP 5 listing."""
    def prepare(self):
        self.project.mkdir()
        (self.project / "merker.toml").write_text('[project]\nname = "Press"\n[cpu]\nmodel = "SINUMERIK 810 GA3"\n', encoding="utf-8")
        (self.project / "main.s5").write_text("OB 1\n      U     E 0.0\n      =     A 0.0\n      SPA   PB 5\n      BE\n"
                                              "PB 5\n      U     E 0.1\n      =     A 0.1\n      BE\n", encoding="utf-8")

    def test_a_breakpoint_holds_in_the_first_cycle_after_a_restart(self):
        browser = self.browser()
        browser.call("breakpoints.set", file="main.s5", lines=[7, 8])
        browser.until(lambda b: b.state.get("mode") == "HALT")
        browser.call("cpu.stop")
        browser.until(lambda b: b.state.get("mode") == "STOP")
        browser.call("cpu.start", kind="warm")
        browser.until(lambda b: b.state.get("mode") == "HALT")
        self.assertEqual(browser.state["breakpoint"]["line"], 7)

    def test_what_it_does_not_have_is_named(self):
        browser = self.browser()
        for do, fields, noun in (("cpu.trigger", {"ob": 40}, "events that can be triggered"), ("program.load", {}, "memory for single blocks"),
                                 ("process.list", {}, "plants at terminals")):
            self.assertEqual(browser.ask(do, **fields)["problems"][0]["text"], f"SINUMERIK 810 GA3 has no {noun}", do)


if __name__ == "__main__":
    unittest.main()
