"""Wireshark's dissector judges what the S7 server answers: nothing is malformed, and it is what Wireshark calls it."""
from s7_client import *
from wireshark import BAD, Capture, Recorded


class Judged(S7Case):
    def setUp(self):
        super().setUp()
        self.write("a.awl", PROGRAM + DATA)
        self.start("a.awl", "--no-workbench")
        self.capture = Capture(self.folder / "s7.pcap")
        self.addCleanup(self.capture.close)

    def recorded(self, kind=1):
        client = Client(self.port, kind, record=lambda socket: Recorded(socket, self.capture))
        self.addCleanup(client.close)
        return client

    def judge(self, expected):
        """So many frames of S7 communication, none of them wrong."""
        self.assertEqual(self.capture.ask(BAD), [])
        self.assertEqual(len(self.capture.ask("s7comm")), expected)

    def test_variables(self):
        client = self.recorded()
        for area in (INPUTS, OUTPUTS, FLAGS, 0x80):
            client.read(area, 0, 3)
        client.read(TIMERS, 1, 2, TIMERS)
        for size in (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12):
            client.read(DATA_AREA, 0, 1, size, 1)
        client.write(FLAGS, 30, b"\x01", BIT)
        client.write(FLAGS, 30, b"\x01\x02\x03")
        client.read(DATA_AREA, 0, 1, BYTE, 7)
        client.ask(client.job(4, client.item(DATA_AREA, 0, 0xFFFF, BYTE, 1)))
        client.ask("32 01 00 00 00 02 00 32 00 00 04 04 12 0A 10 01 00 01 00 00 81 00 00 07 "
                   "12 0A 10 02 00 01 00 00 81 00 00 00 12 0A 10 1D 00 01 00 00 1D 00 00 01 12 0A 10 02 00 03 00 01 84 00 00 00")
        client.close()
        self.judge(2 * 23)
        codes = self.capture.ask("s7comm.header.rosctr == 3 && s7comm.param.func == 4", "s7comm.data.returncode")
        self.assertEqual(codes[:4], ["0xff", "0xff", "0xff", "0xff"])
        self.assertEqual(codes[-1], "0xff,0xff,0xff,0xff")

    def test_what_is_refused(self):
        client = self.recorded()
        client.ask("32 01 00 00 00 02 00 10 00 00 28 00 00 00 00 00 00 FD 00 00 05 5F 47 41 52 43")  # no such service
        client.ask("32 07 00 00 05 00 00 08 00 0C 00 01 12 04 11 43 03 00 FF 09 00 08 30 38 30 30 30 30 32 41")  # there is no OB 2
        client.close()
        self.judge(6)
        self.assertEqual(self.capture.ask("s7comm.header.rosctr == 2", "s7comm.header.errcod"), ["0x04"])

    # Every list, its parts, the clock, stop and start.
    def test_programming_devices(self):
        client = self.recorded()
        szl = "32 07 00 00 05 00 00 08 00 08 00 01 12 04 11 44 01 00 FF 09 00 04"
        lists = client.ask(f"{szl} 00 00 00 00")[34:]
        numbers = [lists[i:i + 2].hex() for i in range(0, len(lists), 2)]
        self.assertIn("0424", numbers)
        requests = 1
        for number in numbers:
            answer = client.ask(f"{szl} {number} 00 00")
            requests += 1
            while answer[19]:
                answer = client.ask(f"32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 44 01 {answer[17]:02X} 00 00 00 00 0A 00 00 00")
                requests += 1
        client.ask("32 07 00 00 01 00 00 08 00 04 00 01 12 04 11 47 01 00 0A 00 00 00")
        client.ask("32 07 00 00 02 00 00 08 00 0E 00 01 12 04 11 47 02 00 FF 09 00 0A 00 19 24 12 31 23 59 59 99 93")
        for _ in range(2):
            client.ask("32 01 00 00 00 02 00 10 00 00 29 00 00 00 00 00 09 50 5F 50 52 4F 47 52 41 4D")
        for _ in range(2):
            client.ask("32 01 00 00 00 02 00 14 00 00 28 00 00 00 00 00 00 FD 00 00 09 50 5F 50 52 4F 47 52 41 4D")
        client.close()
        self.judge(2 * (1 + requests + 6))

    def test_blocks(self):
        client = self.recorded()
        client.ask("32 07 00 00 05 00 00 08 00 04 00 01 12 04 11 43 01 00 0A 00 00 00")
        client.ask("32 07 00 00 05 00 00 08 00 06 00 01 12 04 11 43 02 00 FF 09 00 02 30 38")
        client.ask("32 07 00 00 05 00 00 08 00 0C 00 01 12 04 11 43 03 00 FF 09 00 08 30 38 30 30 30 30 31 41")
        client.ask("32 01 00 00 00 02 00 12 00 00 1D 00 00 00 00 00 00 00 09 5F 30 38 30 30 30 30 31 41")
        pieces = 0
        while client.ask("32 01 00 00 00 03 00 08 00 00 1E 00 00 00 00 00 00 01")[13]:
            pieces += 1
        client.ask("32 01 00 00 00 04 00 08 00 00 1F 00 00 00 00 00 00 01")
        # the head of SDB 0, in one piece
        client.ask("32 01 00 00 00 05 00 12 00 00 1D 00 00 00 00 00 00 00 09 24 30 42 30 30 30 30 30 41")
        self.assertEqual(client.ask("32 01 00 00 00 06 00 08 00 00 1E 00 00 00 00 00 00 02")[13:22].hex(), "00002400fb70700101")
        client.ask("32 01 00 00 00 07 00 08 00 00 1F 00 00 00 00 00 00 02")
        client.close()
        self.judge(2 * (1 + 4 + pieces + 2 + 3))
        self.assertEqual(self.capture.ask("s7comm.blockinfo.blocktype", "s7comm.blockinfo.block_num")[-1:], ["1"])

    # A variable table that is looked at, modified and forced: values and codes come as indications.
    def test_variable_tables(self):
        client = self.recorded()
        client.test(0x02, job_words(1, 0, 0x0300), "0003 02010000 0014 73010001 0000 00010000 0000")
        client.test(0x0E, job_words(0, 1, 0), "0201")
        self.assertEqual(client.hear()[15:18], b"\x01\x02\x01")
        client.test(0x08, job_words(0, 1, 0), "0001 01010000001E 0009 0001 5500")
        self.assertEqual(client.hear()[-4:], b"\x00\x01\xFF\x00")
        client.test(0x09, "0000 0100 0002 0004 0001 0001 0001 0001 0001 0000", "0001 200100000002 0009 0001 0100")
        client.hear()
        for function, data in ((0x10, "0000 0000"), (0x11, "0201"), (0x0D, "0201"), (0x0F, "00010201"), (0x0F, "00010202")):
            client.test(function, job_words(0, 1, 0), data)
        self.assertEqual(client.test(0x16, job_words(0, 0, 0), "")[20:22].hex(), "0000")
        client.close()
        self.judge(2 * 11)  # what comes together is one frame
        values = self.capture.ask("s7comm.param.userdata.type == 0 && s7comm.param.userdata.subfunc == 2",
                                  "s7comm.data.returncode", "s7comm.resp.data")
        self.assertRegex(values[0], r"^0xff(,0xff)+\t[0-9a-f]{4},00053fc0,")
        jobs = self.capture.ask("s7comm.param.userdata.type == 8 && s7comm.param.userdata.subfunc == 16", "s7comm.tis.job.function")
        self.assertEqual(jobs, ["9,2"])

    # S7-NET-26: MW 20 counts cycles.
    def test_cyclic_reads(self):
        client = self.recorded()
        items = client.item(FLAGS, 20, 1, WORD, 0) + client.item(DATA_AREA, 0, 4, BYTE, 1)
        subscribe = "32 07 00 00 05 00 00 08 00 20 00 01 12 04 11 42 {:02X} 00 FF 09 00 1C 00 02 00 01" + items.hex()
        answers = [client.ask(subscribe.format(1))]
        answers += [client.hear() for _ in range(3)]
        self.assertEqual([answer[15:18].hex() for answer in answers], ["820101"] + 3 * ["020101"])
        self.assertGreater(len({answer[32:34] for answer in answers}), 2)
        on_change = client.ask(subscribe.format(5))
        while on_change[15] != 0x82:  # the first job goes on
            on_change = client.hear()
        self.assertEqual(on_change[16:18].hex(), "0502")
        areas = client.ask("32 07 00 00 05 00 00 08 00 16 00 01 12 04 11 42 05 00 FF 09 00 12 00 01 00 01 12 0C B0 02 02 00 01 00 00 02 00 01 00 02")
        while areas[15] != 0x82:
            areas = client.hear()
        self.assertEqual(areas[26:].hex(), "0001" "ff090006" "ff0005" "ff3fc0")
        for job in (1, 2, 3):
            client.send(f"32 07 00 00 05 00 00 08 00 06 00 01 12 04 11 42 04 00 FF 09 00 02 05 {job:02X}")
            while client.hear()[15] != 0x82:
                pass
        client.close()
        self.assertEqual(self.capture.ask(BAD), [])
        counts = ",".join(self.capture.ask("s7comm.param.userdata.type == 0", "s7comm.param.itemcount")).split(",")
        self.assertGreaterEqual(counts.count("2"), 4)  # indications of the first job, and those of the second

    def test_messages(self):
        self.write("b.awl", """ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     MW 20;
      T     MW 22;
      U     M 0.0;
      X     M 0.1;
      SPBN  end;
      U     M 0.0;
      =     M 0.1;
      CALL  SFC 17 (SIG := M 0.0, ID := W#16#EEEE, EV_ID := DW#16#1234, SD := P#M 20.0 BYTE 3, RET_VAL := MW 30);
end:  NOP   0;
END_ORGANIZATION_BLOCK
""")
        self.start("b.awl", "--no-workbench")
        client, writer = self.recorded(), self.client()
        head = "32 07 00 00 05 00 00 08 00 {:02X} 00 01 12 04 11 44 {} 00 FF 09 00 {:02X} "
        def ask(subfunction, data):
            length = len(bytes.fromhex(data))
            return client.ask(head.format(length + 4, subfunction, length) + data)
        ask("13", "00 01 12 08 1A 00 01 34 00 00 00 04")
        ask("02", "83 00 4D 65 72 6B 65 72 20 20 09 00")
        writer.write(FLAGS, 0, b"\x01")
        coming = client.hear()
        self.assertEqual(coming[15:17].hex(), "0411")
        self.assertEqual(ask("13", "00 01 12 08 1A 00 03 34 00 00 12 34")[15:17].hex(), "8413")
        client.ask("32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 44 13 03 00 00 00 00 0A 00 00 00")
        client.send(head.format(16, "0B", 12) + "09 01 12 08 19 00 00 00 12 34 00 01")
        self.assertEqual(sorted(client.hear()[15:17].hex() for _ in range(2)), ["040c", "840b"])
        writer.ask("32 01 00 00 00 02 00 10 00 00 29 00 00 00 00 00 09 50 5F 50 52 4F 47 52 41 4D")
        self.assertEqual(sorted(client.hear()[15:17].hex() for _ in range(2)), ["0000", "0403"])  # STOP, its entry
        client.close()
        self.assertEqual(self.capture.ask(BAD), [])
        self.assertEqual(len(self.capture.ask("s7comm")), 2 * 6)  # what comes together is one frame
        self.assertEqual(self.capture.ask("s7comm.param.userdata.subfunc == 0x11", "s7comm.alarm.event_id"), ["0x00001234"])
        self.assertEqual(self.capture.ask("s7comm.alarm.query.dataset_length", "s7comm.alarm.event_id"), ["0x00001234"])

    # A block down, linked, deleted; what is refused; the tests of a service at a time.
    def test_blocks_for_the_plc(self):
        client = self.recorded()
        container = client.upload("0800001A")
        self.assertEqual(client.download("0800001P", container), "0000")
        self.assertEqual(client.service("_INSE", client.names("0800001P")), "0000")
        self.assertEqual(client.download("0800001P", container[:-10] + b"\xff" + container[-9:]), "d235")
        self.assertEqual(client.service("_INSE", client.names("0800001P")), "d209")
        self.assertEqual(client.service("_GARB"), "0000")
        self.assertEqual(client.service("_MODU", b"EP"), "8404")
        client.ask("32 07 00 00 05 00 00 08 00 04 00 01 12 04 11 41 0C 00 0A 00 00 00")
        self.assertEqual(client.service("_DELE", client.names("0A00001B")), "0000")
        client.close()
        self.assertEqual(self.capture.ask(BAD), [])
        said = self.capture.ask("s7comm.param.func == 0x1C && s7comm.header.rosctr == 1", "s7comm.data.blockcontrol.errorcode")
        self.assertEqual(said, ["0x0000", "0xd235"])
        self.assertEqual(len(self.capture.ask("s7comm.param.func == 0x1B && s7comm.header.rosctr == 1")),
                         2 * -(-len(container) // 222))
        # With function and reason, as CPUs answer.
        self.assertIn("0xd2", self.capture.ask("s7comm.header.rosctr == 3 && s7comm.param.func == 0x28", "s7comm.header.errcls"))

    # Block status in its two forms; the stacks of a CPU that a fault has stopped.
    def test_blocks_are_watched(self):
        client = self.recorded()
        block = "0000 0001 0000 00FF 0001 0001 0001 0001 0001 0600 0008 0001 0000 0040"
        for number, function, lines in ((1, 0x13, "8002007F 0000007F 00020001"), (3, 0x01, "800F 800F 8001")):
            client.test(function, block, lines)
            client.test(0x0E, job_words(0, 1, 0), f"{function:02X}{number:02X}")
            self.assertEqual(client.hear()[15:18], bytes([1, function, number]))
        client.test(0x03, job_words(0, 1, 0), "0000")
        client.write(INPUTS, 0, b"\x80")
        self.until(lambda: client.test(0x03, job_words(0, 1, 0), "0000")[20:22] == b"\0\0")
        client.test(0x04, job_words(0, 1, 0), "0000")
        client.test(0x05, job_words(0, 1, 0), "0100")
        client.close()
        self.assertEqual(self.capture.ask(BAD), [])
        told = self.capture.ask("s7comm.param.userdata.type == 0", "s7comm.diagdata.req.startaddr_awl")
        self.assertEqual(told, ["0", "0"])
        stopped = self.capture.ask("s7comm.tis.stw", "s7comm.tis.continued.blocktype", "s7comm.ob.number")
        self.assertEqual(len(stopped), 1)
        local = self.capture.ask("s7comm.tis.lstack.size && s7comm.param.userdata.type == 8", "s7comm.tis.interrupted.blocktype")
        self.assertEqual(local, ["8"])

    # S7-STATE-07: in HALT at the first instruction, then at the one behind it.
    def test_breakpoints(self):
        client = self.recorded()
        place = "0000 0000 0000 0026 0001 0001 0001 0001 0001 0600 0008 0001 0000"
        client.test(0x0A, place, "0000")
        self.assertEqual(client.hear()[15:18], b"\x01\x0A\x01")
        client.test(0x0B, "0000 0000", "0100")
        self.assertEqual(client.hear()[15:18], b"\x01\x0A\x01")
        client.test(0x0F, job_words(0, 1, 0), "0001 0A01")
        client.test(0x0B, "0000 0000", "0000")
        before = client.read(FLAGS, 20, 1, WORD)
        self.until(lambda: client.read(FLAGS, 20, 1, WORD) != before)
        client.close()
        self.assertEqual(self.capture.ask(BAD), [])
        told = self.capture.ask("s7comm.param.userdata.type == 0 && s7comm.param.userdata.subfunc == 10", "s7comm.tis.interrupted.blocktype",
                                "s7comm.tis.interrupted.address", "s7comm.tis.breakpoint.blocktype", "s7comm.tis.breakpoint.address")
        self.assertEqual([row.split("\t")[0] for row in told], ["8", "8"])
        self.assertEqual(told[0].split("\t")[1:], ["0", "8", "0"])
        self.assertNotEqual(told[1].split("\t")[1], "0")

    def test_connections(self):
        clients = [self.recorded(kind) for kind in [1, 2] + 10 * [3]]
        before = self.capture.frames
        refused = self.recorded(3)
        self.assertFalse(refused.confirmed)
        refused.close()
        self.assertGreater(self.capture.frames, before)
        for client in clients:
            client.close()
        self.assertEqual(self.capture.ask(BAD), [])
        self.assertEqual(len(self.capture.ask("cotp.type == 0x0d")), 12)
        self.assertEqual(len(self.capture.ask("cotp.type == 0x08")), 1)

    def test_the_judge_sees_what_is_wrong(self):
        self.capture.add(False, bytes.fromhex("0300001f02f080320100000002000e00000401120a10020001000083000000"))
        self.capture.add(True, bytes.fromhex("0300001a02f0803203000000020002000500000401ff04010812"))  # 33 octets
        self.assertEqual(len(self.capture.ask("s7comm")), 2)
        self.assertNotEqual(self.capture.ask(BAD), [])
