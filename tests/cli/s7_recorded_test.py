"""Requests as programming devices and panels send them, recorded: they name numbers that another CPU gave, and each is answered."""
from s7_client import *

SZL = "32 07 00 00 05 00 00 08 00 08 00 01 12 04 11 44 01 00 FF 09 00 04"
MORE = "32 07 00 00 06 00 00 0C 00 04 00 01 12 08 12 44 01 {:02X} 00 00 00 00 0A 00 00 00"


class Recorded(S7Case):
    def setUp(self):
        super().setUp()
        self.write("a.awl", PROGRAM + DATA)
        self.process = self.start("a.awl", "--no-workbench")
        self.asked = self.client()

    def answer(self, pdu):
        """What is answered; indications in between are passed over."""
        self.asked.send(pdu)
        heard = self.asked.hear()
        while heard[1] == 1 or (heard[1] == 7 and heard[15] < 0x80):
            heard = self.asked.hear()
        return heard

    def error(self, pdu):
        heard = self.answer(pdu)
        return (heard[20:22] if heard[1] == 7 else heard[10:12]).hex()

    # An answer of other lengths: more is asked for than there is.
    def test_parts_of_lists(self):
        for number in range(1, 20):
            self.assertEqual(self.error(f"{SZL} 00 {(0x11, 0x1C, 0xA0)[number % 3]:02X} 00 00"), "0000")
            self.assertEqual(self.error(MORE.format(number)), "0000")

    # A variable table, read time and again; the job of another CPU has number 3.
    def test_a_variable_table(self):
        self.assertEqual(self.asked.test(0x02, job_words(1, 0, 0x0200), "0002 01060000 0000 11010000 0008")[20:22].hex(), "0000")
        for function, data in ((0x0E, "0203"), (0x0E, "0203"), (0x0F, "00010203")):
            self.asked.send(self.request(function, data))
            heard = self.asked.hear()
            while heard[15] != 0x81:
                heard = self.asked.hear()
            self.assertEqual((heard[16], heard[20:22].hex()), (function, "0000"))

    def request(self, function, data):
        words, data = bytes.fromhex(job_words(0, 1, 0)), bytes.fromhex(data)
        job = struct.pack(">HH", len(words), len(data)) + words + data
        return (b"\x32\x07\0\0\x6F\x03" + struct.pack(">HH", 12, 4 + len(job)) + bytes.fromhex("00 01 12 08 12 41")
                + bytes([function, 0, 0, 0, 0, 0]) + struct.pack(">BBH", 0xFF, 9, len(job)) + job)

    # A panel of an S7-400: areas of data blocks on change, modified and ended by the number of another CPU.
    def test_cyclic_reads(self):
        subscribe = "32 07 00 00 0F 00 00 08 00 {:02X} 00 01 12 04 11 42 {:02X} {:02X} FF 09 00 {:02X} 00 01 01 01 {}"
        one, three = "12 07 B0 01 05 00 01 00 00", "12 11 B0 03 02 00 01 00 00 02 00 01 00 02 04 00 01 00 00"
        self.assertEqual(self.answer(subscribe.format(4 + 13, 5, 0, 13, one))[26:34].hex(), "0001ff090006ff00")
        modified = self.answer(subscribe.format(4 + 23, 7, 9, 23, three))
        self.assertEqual(modified[20:22].hex() + modified[26:32].hex(), "0000" + "0001ff09000b")
        self.assertEqual(self.error("32 07 00 00 35 00 00 08 00 06 00 01 12 04 11 42 04 00 FF 09 00 02 05 09"), "0000")

    def test_an_upload(self):
        self.assertEqual(self.error("32 01 00 00 09 00 00 12 00 00 1D 00 00 00 00 00 00 00 09 5F 30 38 30 30 30 30 31 41"), "0000")
        for _ in range(4):
            self.assertEqual(self.error("32 01 00 00 0A 00 00 08 00 00 1E 00 00 00 00 00 00 07"), "0000")
        self.assertEqual(self.error("32 01 00 00 0B 00 00 08 00 00 1F 00 00 00 00 00 00 07"), "0000")

    # The PLC asks for the pieces of a block: who plays a record back answers another question, or none.
    def test_a_download(self):
        begin = b"\x32\x01\0\0\x0C\0\0\x20\0\0\x1A" + 7 * b"\0" + b"\x09_0800001P\x0D1000100000010"
        self.assertEqual(self.error(begin), "0000")
        self.assertEqual(self.asked.hear()[10], 0x1B)
        self.asked.send(b"\x32\x03\0\0\x0B\x01\0\2\0\x68\0\0\x1B\0\0\x64\0\xFB" + 100 * b"\x70")
        ended = self.asked.hear()
        self.assertEqual((ended[10], ended[12:14].hex()), (0x1C, "d219"))
        self.asked.send("32 03 00 00 0B 02 00 01 00 00 00 00 1C")
        self.assertEqual(self.error(begin), "0000")
        self.assertEqual(self.error("32 01 00 00 0D 00 00 1A 00 00 28 00 00 00 00 00 00 FD 00 0A 01 00 30 38 30 30 30 30 31 50 "
                                    "05 5F 49 4E 53 45"), "d209")

    # All functions, all groups and subfunctions there can be.
    def test_everything_is_answered(self):
        for group in range(16):
            for subfunction in range(0x20):
                heard = self.answer(f"32 07 00 00 05 00 00 08 00 04 00 01 12 04 11 4{group:X} {subfunction:02X} 00 0A 00 00 00")
                self.assertEqual((heard[1], heard[15], heard[16]), (7, 0x80 | group, subfunction))
        for function in range(0x100):
            heard = self.answer(f"32 01 00 00 05 00 00 09 00 00 {function:02X} 00 00 00 00 00 00 00 00")
            self.assertIn(heard[1], (2, 3))
            self.assertNotEqual(heard[10:12].hex(), "0000")

