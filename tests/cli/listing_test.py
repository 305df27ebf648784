from harness import *


class List(Case):
    def setUp(self):
        super().setUp()
        self.write("a.awl", PROGRAM + DATA)

    def test_blocks_with_lengths_and_version(self):
        lines = self.expect(GOOD, "list", "a.awl").lines
        self.assertRegex(lines[0], r"block .*name .*load .*work .*local .*version .*checksum")
        rows = {line[:10].strip(): line.split() for line in lines[1:]}
        self.assertEqual(set(rows), {"OB 1", "DB 1"})
        self.assertIn("1.2", rows["OB 1"])

    def test_json(self):
        blocks = {row["block"]: row for row in self.expect(GOOD, "list", "a.awl", "--json", "--code").json["blocks"]}
        ob = blocks["OB 1"]
        self.assertGreater(ob["load_bytes"], ob["work_bytes"])
        self.assertEqual(ob["version"], "1.2")
        self.assertNotEqual(ob["checksum"], 0)
        self.assertEqual(sum(len(line["bytes"]) // 2 for line in ob["code"]), ob["work_bytes"])

    def test_code_in_both_mnemonics(self):
        german = self.expect(GOOD, "list", "a.awl", "--code").out
        english = self.expect(GOOD, "list", "a.awl", "--code", "--mnemonics", "en").out
        self.assertRegex(german, r"(?m)^  0000: C000 +U +E 0\.0$")
        self.assertRegex(english, r"(?m)^  0000: C000 +A +I 0\.0$")
        self.assertRegex(german, r"SE +T 1")
        self.assertRegex(english, r"SD +T 1")

    def test_problems(self):
        self.write("bad.awl", PROGRAM + "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n      FLY\nEND_FUNCTION\n")
        call = self.expect(PROBLEMS, "list", "bad.awl")
        self.assertIn("OB 1", call.out)
        self.assertIn("bad.awl:", call.err)


class MachineCode(Case):
    def test_assemble_and_back(self):
        source = "U     E 0.0\nL     5\nL     W#16#ABCD\n+I\nSPB   3\nT     MW 10\nL     DW#16#12345678\nBE\n"
        code = self.expect(GOOD, "assemble", "--mc7", text=source).out
        self.assertEqual(code.splitlines()[0], "C000")
        self.assertEqual(code.splitlines()[1], "3003 0005")
        self.assertEqual(len(code.splitlines()), 8)
        listing = self.expect(GOOD, "disassemble", "--mc7", text=code).lines
        words = [line.split(None, 2)[2].split() for line in listing]
        self.assertEqual(words, [line.split() for line in source.splitlines()])

    def test_both_mnemonics_are_read_and_written(self):
        german = self.expect(GOOD, "assemble", "--mc7", text="U E 0.0\nSE T 1\nSPB 3\nZV Z 1\n").out
        english = self.expect(GOOD, "disassemble", "--mc7", "--mnemonics", "en", text=german).out
        for text in ("A     I 0.0", "SD    T 1", "JC    3", "CU    C 1"):
            self.assertIn(text, english)

    def test_the_listing_of_disassemble_is_assembled_again(self):
        code = "C000\n1C01\n2401\n3003 0005\n3807 1234 5678\n7500\n6500\n"  # among them SE of both settings
        for mnemonics in ("de", "en"):
            listing = self.expect(GOOD, "disassemble", "--mc7", "--mnemonics", mnemonics, text=code).out
            back = self.expect(GOOD, "assemble", "--mc7", "--mnemonics", mnemonics, text=listing).out
            self.assertEqual(back.split(), code.split(), listing)

    def test_parameter_lists_and_words_without_awl_come_back(self):
        """docs/formats/disassembly.md: entries of a list, the first word of an ANY, P##."""
        code = ("1001\n4160 0000\n3000 1002\n7E66 0002\nFBCB 0002\n3D05\n700B 000E\n8700 00A0\n8300 0190\n8400 0011\n"
                "0007 0000\n1234 0000\n1234 5678\n1002\n6500\n")
        for mnemonics in ("de", "en"):
            listing = self.expect(GOOD, "disassemble", "--mc7", "--mnemonics", mnemonics, text=code).out
            back = self.expect(GOOD, "assemble", "--mc7", "--mnemonics", mnemonics, text=listing).out
            self.assertEqual(back, code, listing)
        alone = self.expect(GOOD, "assemble", "--mc7", text="P#V 20.0\nP#DBX 2.1\n7\nDW#16#12345678\nL ANY#16#1002\n").out
        self.assertEqual(alone, "8700 00A0\n8400 0011\n0007 0000\n1234 5678\n3000 1002\n")
        self.assertIn("standard input:1:1: error:", self.expect(PROBLEMS, "assemble", "--mc7", text="70000\n").err)
        self.assertIn("standard input:1:1: error:", self.expect(PROBLEMS, "assemble", "--mc7", text="P#Q\n").err)

    def test_a_setting_takes_its_own_words_only(self):
        self.assertIn("P0314", self.expect(PROBLEMS, "assemble", "--mc7", "--mnemonics", "de", text="A I 0.0\n").err)
        self.assertIn("P0315", self.expect(PROBLEMS, "assemble", "--mc7", "--mnemonics", "en", text="U E 0.0\n").err)
        self.expect(USAGE, "assemble", "--mc7", "--mnemonics", "fr")

    def test_the_caret_stands_under_the_word(self):
        err = self.expect(PROBLEMS, "assemble", "--mc7", text="U E 0.0\n  SPA  99999 // far\n").err
        self.assertIn("standard input:2:8: error: 99999 words are too far; SPA can jump -32768..32767 [P0352]", err)
        self.assertIn("\n       ^~~~~\n", err)

    def test_illegal_words_and_the_rest_goes_on(self):
        lines = self.expect(GOOD, "disassemble", "--mc7", text="FF07 6500 C0").lines
        self.assertRegex(lines[0], r"^0000: FF07 +illegal$")
        self.assertRegex(lines[1], r"^0002: 6500 +BE$")
        self.assertIn("illegal", lines[2])

    def test_a_binary_file(self):
        self.write("code.bin", bytes.fromhex("c0006500"))
        self.assertEqual(len(self.expect(GOOD, "disassemble", "--mc7", "code.bin").lines), 2)
        self.write("noise.bin", bytes(range(256)) * 300)
        self.expect(GOOD, "disassemble", "--mc7", "noise.bin")
        self.assertEqual(self.expect(GOOD, "disassemble", "--mc7", text="").out, "")

    def test_a_block_of_a_memory_card(self):
        """docs/formats/block.md, example FC 2; a block that is cut off is refused."""
        block = bytes.fromhex("7070 0101 010C 0002 0000 0064 00000000 00000000 0000 0000 0000 0000 000C 0006 0000 000A"
                              "FB80 0002 FB92 0004 6500 01 0200 0400 0000 0101 0102 00 0100 0800 0000"
                              "4558414D504C4500 44454D4F00000000 4D4F544F52000000 0100 2B33 0000000000000000")
        self.write("fc2.mc7", block)
        lines = self.expect(GOOD, "disassemble", "--mc7", "fc2.mc7").lines
        self.assertEqual([line.split(None, 2)[2].split() for line in lines], [["U", "#P0"], ["=", "#P1"], ["BE"]])
        self.write("cut.mc7", block[:-1])
        self.assertIn("[P0602]", self.expect(PROBLEMS, "disassemble", "--mc7", "cut.mc7").err)

    def test_input_has_the_limit_of_a_source(self):
        """docs/safety.md: no more than 16 MB, whether it is a file or comes from somewhere without an end."""
        self.write("long.bin", bytes((16 << 20) + 2))
        self.assertIn("long.bin: error: the file is larger than 16 MB",
                      self.expect(PROBLEMS, "disassemble", "--mc7", "long.bin").err)
        for command in ("assemble", "disassemble"):
            with open("/dev/zero", "rb") as endless:
                call = subprocess.run([os.environ["MERKER"], command, "--mc5"], stdin=endless, capture_output=True, timeout=60, check=False)
            self.assertEqual(call.returncode, PROBLEMS)
            self.assertRegex(call.stderr, rb"^standard input: error: .* \[P0103\]\n$")
        self.expect(UNREADABLE, "disassemble", "--mc7", "missing.bin")

    def test_text_that_is_no_hexadecimal(self):
        call = self.expect(PROBLEMS, "disassemble", "--mc7", text="C000\nhello\n")
        self.assertRegex(call.err, r"^standard input:2:1: error: .*\[P0690\]")

    def test_bad_instructions_have_their_place_and_the_rest_goes_on(self):
        self.write("a.txt", "U E 0.0\n\n// a comment\nFLY 5\nBE  // the end\n")
        call = self.expect(PROBLEMS, "assemble", "--mc7", "a.txt")
        self.assertEqual(call.lines, ["C000", "6500"])
        self.assertRegex(call.err, r"^a\.txt:4:1: error: ")


class Bench(Case):
    def test_numbers(self):
        self.write("a.awl", PROGRAM)
        self.assertEqual(len(self.expect(GOOD, "bench", "a.awl", "--for", "50ms").lines), 3)
        values = self.expect(GOOD, "bench", "a.awl", "--for", "50ms", "--json").json
        self.assertEqual(set(values), {"instructions_per_second", "cycles_per_second", "translation_seconds"})
        self.assertGreater(values["instructions_per_second"], values["cycles_per_second"])
        self.assertGreater(values["cycles_per_second"], 0)

    def test_a_fault(self):
        self.write("a.awl", block("      L     W#16#FFFF\n      BTI"))
        self.assertIn("STOP", self.expect(FAULT, "bench", "a.awl", "--for", "50ms").err)

    def test_a_program_that_stops_the_cpu(self):
        self.write("stp.awl", block("      L     MW 10\n      +     1\n      T     MW 10\n      L     100\n      ==I\n"
                                    "      SPBN  end\n      CALL  SFC 46\nend:  NOP   0"))
        self.assertIn("the program stopped the CPU after 99 cycles", self.expect(GOOD, "bench", "stp.awl", "--for", "5s").err)

    def test_an_endless_ob_1_ends_after_its_time(self):
        self.write("loop.awl", block("here: SPA   here"))
        call = self.expect(GOOD, "bench", "loop.awl", "--for", "50ms", "--json", timeout=60)
        self.assertGreater(call.json["instructions_per_second"], 0)
        self.assertEqual(call.json["cycles_per_second"], 0)
        self.assertIn("OB 1 did not end", call.err)
