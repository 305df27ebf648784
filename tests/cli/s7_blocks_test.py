"""Blocks that clients load into the built program and delete from it: protection, half downloads, the memory card."""
import signal
import threading

from s7_client import *

# OB 1 with another constant in MB 30.
BLOCK = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L {};\n T MB 30;\n L MW 20;\n + 1;\n T MW 20;\nEND_ORGANIZATION_BLOCK\n"
STOP = "32 01 00 00 00 02 00 10 00 00 29 00 00 00 00 00 09 50 5F 50 52 4F 47 52 41 4D"
OB1 = "0800001P"


class Silence(Exception):
    """The client says nothing more."""


class Blocks(S7Case):
    def container(self, value):
        """OB 1 as a CPU with this program has it."""
        self.write("other/other.awl", BLOCK.format(value))
        process = self.start("other/other.awl", "--no-workbench")
        container = self.client().upload("0800001A")
        self.end(process)
        return container

    def setUp(self):
        super().setUp()
        self.other = self.container(77)
        self.write("a.awl", BLOCK.format(1) + DATA)

    def runs(self, client, value):
        self.until(lambda: client.read(FLAGS, 30) == bytes([value]))

    # S7-CYCLE-05, S7-NET-26: in RUN, with the workbench and without.
    def test_another_ob_1_in_run(self):
        for workbench in ("--no-workbench", "--port=0"):
            process = self.start("a.awl", workbench, "--engine", "jit")
            client = self.client()
            self.runs(client, 1)
            self.assertEqual(client.download(OB1, self.other), "0000")
            before = client.read(FLAGS, 20, 1, WORD)
            self.until(lambda: client.read(FLAGS, 20, 1, WORD) != before)
            self.assertEqual(client.read(FLAGS, 30), b"\x01")  # it is passive
            self.assertEqual(client.service("_INSE", client.names(OB1)), "0000")
            self.runs(client, 77)
            self.assertEqual(client.upload("0800001A"), self.other)
            self.assertEqual(client.service("_DELE", client.names("0A00001B")), "0000")
            self.assertEqual(client.read(DATA_AREA, 0, 1, BYTE, 1), 0x0A)
            self.end(process)

    # S7-LIM-04: the old block stays; 5 s without the second piece cost the client the download, not its connection.
    def test_half_a_download(self):
        process = self.start("a.awl", "--no-workbench")
        client = self.client()
        def first_alone(number):
            if number:
                raise Silence
            return True
        with self.assertRaises(Silence):
            client.download(OB1, self.other + bytes(300), pieces=first_alone)
        time.sleep(5.5)
        self.assertEqual(client.service("_INSE", client.names(OB1)), "d209")
        self.runs(client, 1)
        self.assertEqual(client.download(OB1, self.other), "0000")
        self.assertRegex(self.end(process), "^1 connection, 0 refused, 0 broken off")

    # What is linked is one of both as a whole.
    def test_two_clients_load_the_same_block(self):
        mine = self.container(55)
        self.start("a.awl", "--no-workbench")
        told = []

        def load(container):
            client = self.client()
            for _ in range(20):
                told.append(client.download(OB1, container))
                told.append(client.service("_INSE", client.names(OB1)))

        threads = [threading.Thread(target=load, args=(container,)) for container in (mine, self.other)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((len(told), set(told) - {"0000", "d209"}), (80, set()))
        self.assertIn(self.client().upload("0800001A"), (mine, self.other))

    # S7-MEM-05
    def test_protection(self):
        for level, uploaded in ((2, True), (3, False)):
            self.write("plant/merker.toml", f'[cpu]\nprotection = {level}\npassword = "secret"\n')
            self.write("plant/a.awl", BLOCK.format(1))
            process = self.start("plant", "--no-workbench")
            client = self.client()
            self.assertEqual(client.upload("0800001A") == "d241", not uploaded)
            self.assertEqual(client.download(OB1, self.other), "d241")
            self.assertEqual(client.service("_DELE", client.names("0800001B")), "d241")
            self.assertEqual(client.service("_GARB"), "d241")
            self.assertEqual(client.service("_MODU", b"EP"), "d241")
            self.assertEqual(client.enter("secret"), "0000")
            self.assertEqual(client.download(OB1, self.other), "0000")
            self.assertEqual(client.service("_INSE", client.names(OB1)), "0000")
            self.end(process)

    # S7-MEM-03, S7-MEM-04: load memory is on the card, whatever happens.
    def test_the_card_has_what_was_loaded(self):
        process = self.start("a.awl", "--no-workbench", "--card", "card")
        client = self.client()
        client.download(OB1, self.other)
        client.service("_INSE", client.names(OB1))
        self.runs(client, 77)
        process.kill()
        process.wait()
        process = self.start("--card=card", "--no-workbench")
        client = self.client()
        self.runs(client, 77)
        client.write(DATA_AREA, 0, b"\x12\x34", WORD, 1)
        client.ask(STOP)
        self.assertEqual(client.service("_MODU", b"EP"), "0000")
        self.until(lambda: client.read(FLAGS, 30) == b"\x4d")
        self.end(process)
        process = self.start("--card=card", "--no-workbench")
        client = self.client()
        client.ask(STOP)
        client.write(DATA_AREA, 0, b"\x55\x55", WORD, 1)
        client.ask("32 07 00 00 05 00 00 08 00 04 00 01 12 04 11 41 0C 00 0A 00 00 00")  # memory reset
        self.assertEqual(client.read(DATA_AREA, 0, 2, BYTE, 1).hex(), "1234")
        self.end(process)
